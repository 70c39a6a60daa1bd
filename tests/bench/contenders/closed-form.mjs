// The closed form at every vertex, with its derivatives: what a program does that knows the solution and no tables.

import { Circle } from "./circle.mjs";
import { solve } from "./solve.mjs";

/** Position and unit normal of every vertex of a grid. */
export function closedForm(design, rows, columns) {
  const positions = new Float32Array(3 * rows * columns);
  const normals = new Float32Array(3 * rows * columns);
  const sum = { q: 0, du: 0, dv: 0 };

  function run() {
    const components = solve(design);
    const [x, y, z] = components;
    const circle = new Circle(components);
    let at = 0;
    for (let i = 0; i < rows; i++) {
      const u = i / (rows - 1);
      for (let j = 0; j < columns; j++) {
        const v = (2 * Math.PI * j) / (columns - 1);
        circle.at(v);
        evaluate(x, u, circle, sum);
        const { q: px, du: xu, dv: xv } = sum;
        evaluate(y, u, circle, sum);
        const { q: py, du: yu, dv: yv } = sum;
        evaluate(z, u, circle, sum);
        const { q: pz, du: zu, dv: zv } = sum;
        const nx = yu * zv - zu * yv;
        const ny = zu * xv - xu * zv;
        const nz = xu * yv - yu * xv;
        const scale = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
        positions[at] = px;
        positions[at + 1] = py;
        positions[at + 2] = pz;
        normals[at] = scale * nx;
        normals[at + 1] = scale * ny;
        normals[at + 2] = scale * nz;
        at += 3;
      }
    }
  }

  return { run, positions, normals };
}

/** One component and its derivatives. */
function evaluate(modes, u, { cos, sin }, sum) {
  let value = 0;
  let du = 0;
  let dv = 0;
  for (let m = 0; m < modes.length; m++) {
    const { n, sine, r, p, far, near, a0, a1, a2, a3 } = modes[m];
    if (n === 0) {
      value += a0 + u * (a1 + u * (a2 + u * a3));
      du += a1 + u * (2 * a2 + u * 3 * a3);
      continue;
    }
    const fast = Math.exp(-r * u);
    const slow = Math.exp(-p * u);
    const a = a0 * fast;
    const b = (a1 * far) / fast;
    const d = a2 * slow;
    const e = (a3 * near) / slow;
    const q = a + b + d + e;
    const slope = r * (b - a) + p * (e - d);
    if (sine) {
      value += q * sin[n];
      du += slope * sin[n];
      dv += n * q * cos[n];
    } else {
      value += q * cos[n];
      du += slope * cos[n];
      dv -= n * q * sin[n];
    }
  }
  sum.q = value;
  sum.du = du;
  sum.dv = dv;
}
