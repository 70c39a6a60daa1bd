// Plain loops over tables: the sum of outer products as one writes it down, with flat typed arrays and nothing generated.

import { solve } from "./solve.mjs";

/** Position and unit normal of every vertex of a grid. */
export function plainLoops(design, rows, columns) {
  const positions = new Float32Array(3 * rows * columns);
  const normals = new Float32Array(3 * rows * columns);

  function run() {
    const [x, y, z] = solve(design).map((modes) => tables(modes, rows, columns));
    for (let i = 0; i < rows; i++) sumRow(i, columns, x, y, z, positions, normals);
  }

  return { run, positions, normals };
}

/** One row of vertices. A function of its own: engines compile what is called often better than what loops for long. */
function sumRow(i, columns, x, y, z, positions, normals) {
  const { n_modes: n_x, along: along_x, around: around_x } = x;
  const { n_modes: n_y, along: along_y, around: around_y } = y;
  const { n_modes: n_z, along: along_z, around: around_z } = z;
  let at = 3 * i * columns;
  for (let j = 0; j < columns; j++) {
    let xs = 0;
    let xu = 0;
    let xv = 0;
    for (let m = 0, a = 2 * i * n_x, b = 2 * j * n_x; m < n_x; m++, a += 2, b += 2) {
      xs += along_x[a] * around_x[b];
      xu += along_x[a + 1] * around_x[b];
      xv += along_x[a] * around_x[b + 1];
    }
    let ys = 0;
    let yu = 0;
    let yv = 0;
    for (let m = 0, a = 2 * i * n_y, b = 2 * j * n_y; m < n_y; m++, a += 2, b += 2) {
      ys += along_y[a] * around_y[b];
      yu += along_y[a + 1] * around_y[b];
      yv += along_y[a] * around_y[b + 1];
    }
    let zs = 0;
    let zu = 0;
    let zv = 0;
    for (let m = 0, a = 2 * i * n_z, b = 2 * j * n_z; m < n_z; m++, a += 2, b += 2) {
      zs += along_z[a] * around_z[b];
      zu += along_z[a + 1] * around_z[b];
      zv += along_z[a] * around_z[b + 1];
    }
    const nx = yu * zv - zu * yv;
    const ny = zu * xv - xu * zv;
    const nz = xu * yv - yu * xv;
    const scale = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
    positions[at] = xs;
    positions[at + 1] = ys;
    positions[at + 2] = zs;
    normals[at] = scale * nx;
    normals[at + 1] = scale * ny;
    normals[at + 2] = scale * nz;
    at += 3;
  }
}

/** Of one component, mode by mode: `q` and `q'` at every row; cosine or sine and its derivative at every column. */
function tables(modes, rows, columns) {
  const n_modes = modes.length;
  const along = new Float64Array(2 * rows * n_modes);
  const around = new Float64Array(2 * columns * n_modes);
  for (const [m, { n, sine, r, p, far, near, a0, a1, a2, a3 }] of modes.entries()) {
    for (let i = 0, at = 2 * m; i < rows; i++, at += 2 * n_modes) {
      const u = i / (rows - 1);
      if (n === 0) {
        along[at] = a0 + u * (a1 + u * (a2 + u * a3));
        along[at + 1] = a1 + u * (2 * a2 + u * 3 * a3);
      } else {
        const fast = Math.exp(-r * u);
        const slow = Math.exp(-p * u);
        const a = a0 * fast;
        const b = (a1 * far) / fast;
        const d = a2 * slow;
        const e = (a3 * near) / slow;
        along[at] = a + b + d + e;
        along[at + 1] = r * (b - a) + p * (e - d);
      }
    }
    for (let j = 0, at = 2 * m; j < columns; j++, at += 2 * n_modes) {
      const angle = (2 * Math.PI * n * j) / (columns - 1);
      around[at] = sine ? Math.sin(angle) : Math.cos(angle);
      around[at + 1] = n * (sine ? Math.cos(angle) : -Math.sin(angle));
    }
  }
  return { n_modes, along, around };
}
