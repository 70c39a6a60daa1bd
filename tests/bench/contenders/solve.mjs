// Solves the mode problems of a design in JavaScript, for the contenders: order 4 with real rates that differ.

/**
 * One mode of one component: `q(u) cos(n v)` or `q(u) sin(n v)`, where for `n > 0`, with the rates `r > p`, `far = exp(-r)`, `near = exp(-p)`,
 *
 *     q(u) = a0 exp(-r u) + a1 far exp(r u) + a2 exp(-p u) + a3 near exp(p u)
 *
 * and for `n = 0` the cubic `a0 + a1 u + a2 u^2 + a3 u^3`. All modes are objects of one shape, and flat, which engines like.
 */

/** The modes of the components of a design's first part. */
export function solve(design) {
  const { shape } = design.parts[0];
  return [shape.x, shape.y, shape.z].map(({ order, s, t, w, modes }) => {
    if (order !== 4) throw new Error("the contenders solve equations of order 4");
    const solved = [];
    for (const { n, cos, sin } of modes) {
      if (cos) solved.push(solveMode(s, t, w, n, false, cos));
      if (sin) solved.push(solveMode(s, t, w, n, true, sin));
    }
    return solved;
  });
}

function solveMode(s, t, w, n, sine, { start = 0, end = 0, start_u = 0, end_u = 0 }) {
  if (n === 0) {
    const rise = end - start;
    return mode(n, sine, 0, 0, [start, start_u, 3 * rise - 2 * start_u - end_u, start_u + end_u - 2 * rise]);
  }
  const root = Math.sqrt(t * t - 4 * s * w);
  const r = n * Math.sqrt((t + root) / (2 * s));
  const p = n * Math.sqrt((t - root) / (2 * s));
  if (!(r > p && p > 0)) throw new Error("the contenders solve equations with two real rates");
  const far = Math.exp(-r);
  const near = Math.exp(-p);
  const factors = gauss([
    [1, far, 1, near, start],
    [-r, r * far, -p, p * near, start_u],
    [far, 1, near, 1, end],
    [-r * far, r, -p * near, p, end_u],
  ]);
  return mode(n, sine, r, p, factors);
}

function mode(n, sine, r, p, [a0, a1, a2, a3]) {
  return { n, sine, r, p, far: Math.exp(-r), near: Math.exp(-p), a0, a1, a2, a3 };
}

/** Solves a system given as rows with the right-hand side at the end. */
function gauss(rows) {
  const n = rows.length;
  for (let i = 0; i < n; i++) {
    let best = i;
    for (let j = i + 1; j < n; j++) if (Math.abs(rows[j][i]) > Math.abs(rows[best][i])) best = j;
    [rows[i], rows[best]] = [rows[best], rows[i]];
    for (let j = i + 1; j < n; j++) {
      const factor = rows[j][i] / rows[i][i];
      for (let k = i; k <= n; k++) rows[j][k] -= factor * rows[i][k];
    }
  }
  const solution = new Array(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    let sum = rows[i][n];
    for (let k = i + 1; k < n; k++) sum -= rows[i][k] * solution[k];
    solution[i] = sum / rows[i][i];
  }
  return solution;
}
