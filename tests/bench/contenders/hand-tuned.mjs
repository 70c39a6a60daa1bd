// The same algorithm as Pasu's, in the best JavaScript that we know how to write: code generated for the very modes of the design,
// unrolled, with every coefficient of a row in a local variable, tables by recurrence in typed arrays, and no allocation after the first run.

import { solve } from "./solve.mjs";

/** Recurrences start anew every so many steps, so that their rounding stays below that of single precision. */
const RESEED = 64;

/**
 * Position and unit normal of every vertex of a grid. With `mirrored`, the columns `v` and `-v` share their sums: those of cosines are the
 * same, those of sines change their sign. Where only `y` has sines and has nothing else, they share their normal as well.
 */
export function handTuned(design, rows, columns, { mirrored }) {
  const positions = new Float32Array(3 * rows * columns);
  const normals = new Float32Array(3 * rows * columns);
  const components = solve(design);
  const harmonics = [...new Set(components.flat().map(({ n }) => n))].filter((n) => n > 0).sort((a, b) => a - b);
  const n_terms = components.flat().length;
  const row_table = new Float64Array(2 * n_terms * rows);
  const column_table = new Float64Array(2 * harmonics.length * columns);
  const fading = [new Float64Array(rows), new Float64Array(rows)];
  const kernel = compile(components, harmonics, mirrored);

  function run() {
    const modes = solve(design).flat();
    for (let term = 0; term < n_terms; term++) fillRows(row_table, modes[term], term, n_terms, rows, fading);
    for (let h = 0; h < harmonics.length; h++) fillColumns(column_table, harmonics[h], h, harmonics.length, columns);
    for (let i = 0; i < rows; i++) kernel(i, row_table, column_table, positions, normals, columns);
  }

  return { run, positions, normals };
}

/** `q` and `q'` of one mode at every row. */
function fillRows(table, { n, r, p, a0, a1, a2, a3 }, term, n_terms, rows, [fast, slow]) {
  const stride = 2 * n_terms;
  let at = 2 * term;
  if (n === 0) {
    for (let i = 0; i < rows; i++, at += stride) {
      const u = i / (rows - 1);
      table[at] = a0 + u * (a1 + u * (a2 + u * a3));
      table[at + 1] = a1 + u * (2 * a2 + u * 3 * a3);
    }
    return;
  }
  fillFading(fast, r, rows);
  fillFading(slow, p, rows);
  const last = rows - 1;
  for (let i = 0; i < rows; i++, at += stride) {
    const a = a0 * fast[i];
    const b = a1 * fast[last - i];
    const d = a2 * slow[i];
    const e = a3 * slow[last - i];
    table[at] = a + b + d + e;
    table[at + 1] = r * (b - a) + p * (e - d);
  }
}

/** `exp(-rate u)` at every row. */
function fillFading(table, rate, rows) {
  const step = Math.exp(-rate / (rows - 1));
  let value = 1;
  for (let i = 0; i < rows; i++) {
    if (i % RESEED === 0) value = Math.exp((-rate * i) / (rows - 1));
    table[i] = value;
    value *= step;
  }
}

/** `cos(n v)` and `sin(n v)` at every column. */
function fillColumns(table, n, harmonic, n_harmonics, columns) {
  const angle = (2 * Math.PI * n) / (columns - 1);
  const turn_cos = Math.cos(angle);
  const turn_sin = Math.sin(angle);
  let cos = 1;
  let sin = 0;
  for (let j = 0, at = 2 * harmonic; j < columns; j++, at += 2 * n_harmonics) {
    if (j % RESEED === 0) {
      cos = Math.cos(angle * j);
      sin = Math.sin(angle * j);
    }
    table[at] = cos;
    table[at + 1] = sin;
    const turned = cos * turn_cos - sin * turn_sin;
    sin = sin * turn_cos + cos * turn_sin;
    cos = turned;
  }
}

/** One row of vertices, for exactly these modes. A function of its own: engines compile what is called often better than what loops for long. */
function compile(components, harmonics, mirrored) {
  const locals = [];
  const sums = [];
  let term = 0;
  for (const [axis, modes] of components.entries()) {
    const parts = { even: { X: [], U: [], V: [] }, odd: { X: [], U: [], V: [] } };
    for (const { n, sine } of modes) {
      const [q, slope, turned] = [`q${term}`, `p${term}`, `t${term}`];
      locals.push(`const ${q} = row_table[row + ${2 * term}], ${slope} = row_table[row + ${2 * term + 1}];`);
      if (n === 0) {
        parts.even.X.push(q);
        parts.even.U.push(slope);
      } else {
        const h = harmonics.indexOf(n);
        locals.push(`const ${turned} = ${sine ? n : -n} * ${q};`);
        const [trig, other] = sine ? [`s${h}`, `c${h}`] : [`c${h}`, `s${h}`];
        const part = sine ? parts.odd : parts.even;
        part.X.push(`${q} * ${trig}`);
        part.U.push(`${slope} * ${trig}`);
        part.V.push(`${turned} * ${other}`);
      }
      term++;
    }
    sums.push({ axis: "xyz"[axis], ...parts });
  }
  const circles = harmonics.flatMap((_, h) => [
    `const c${h} = column_table[column + ${2 * h}];`,
    `const s${h} = column_table[column + ${2 * h + 1}];`,
  ]);
  const text = `
    "use strict";
    const row = i * ${2 * term};
    ${locals.join("\n    ")}
    ${mirrored ? pairs(sums, circles, 2 * harmonics.length) : singles(sums, circles, 2 * harmonics.length)}`;
  return new Function("i", "row_table", "column_table", "positions", "normals", "columns", text);
}

const added = (terms) => (terms.length === 0 ? "0" : terms.join(" + "));

/** One vertex after the other. */
function singles(sums, circles, stride) {
  const lines = sums.flatMap(({ axis, even, odd }) =>
    ["X", "U", "V"].map((which) => `const ${axis}${which} = ${added([...even[which], ...odd[which]])};`),
  );
  return `
      for (let j = 0, column = 0, at = 3 * i * columns; j < columns; j++, column += ${stride}, at += 3) {
        ${circles.join("\n        ")}
        ${lines.join("\n        ")}
        ${vertex("at", "")}
      }`;
}

/** A vertex and its mirror image. */
function pairs(sums, circles, stride) {
  const [x, y, z] = sums;
  const symmetric = x.odd.X.length === 0 && y.even.X.length === 0 && z.odd.X.length === 0;
  const lines = sums.flatMap(({ axis, even, odd }) =>
    ["X", "U", "V"].flatMap((which) => {
      const name = `${axis}${which}`;
      // Sums of cosines are even in v and their derivatives odd; sums of sines the other way round.
      const flips = which === "V" ? even : odd;
      const keeps = which === "V" ? odd : even;
      if (flips[which].length === 0) return [`const ${name} = ${added(keeps[which])}, ${name}_ = ${name};`];
      if (keeps[which].length === 0) return [`const ${name} = ${added(flips[which])}, ${name}_ = -${name};`];
      return [
        `const ${name}k = ${added(keeps[which])}, ${name}f = ${added(flips[which])};`,
        `const ${name} = ${name}k + ${name}f, ${name}_ = ${name}k - ${name}f;`,
      ];
    }),
  );
  return `
      const half = (columns + 1) >> 1;
      for (let j = 0, column = 0, at = 3 * i * columns, mirror = at + 3 * (columns - 1); j < half; j++, column += ${stride}, at += 3, mirror -= 3) {
        ${circles.join("\n        ")}
        ${lines.join("\n        ")}
        ${vertex("at", "")}
        ${symmetric ? mirrorImage("mirror") : vertex("mirror", "_")}
      }`;
}

/** Writes the vertex whose `y` is that of the last one with the sign changed. */
function mirrorImage(at) {
  return `
        positions[${at}] = xX;
        positions[${at} + 1] = -yX;
        positions[${at} + 2] = zX;
        normals[${at}] = scale * nx;
        normals[${at} + 1] = -scale * ny;
        normals[${at} + 2] = scale * nz;`;
}

/** Writes a vertex and its normal. */
function vertex(at, mark) {
  const name = (of) => `${of}${mark}`;
  const [xU, yU, zU, xV, yV, zV] = ["xU", "yU", "zU", "xV", "yV", "zV"].map(name);
  const [nx, ny, nz, scale] = ["nx", "ny", "nz", "scale"].map(name);
  return `
        const ${nx} = ${yU} * ${zV} - ${zU} * ${yV};
        const ${ny} = ${zU} * ${xV} - ${xU} * ${zV};
        const ${nz} = ${xU} * ${yV} - ${yU} * ${xV};
        const ${scale} = 1 / Math.sqrt(${nx} * ${nx} + ${ny} * ${ny} + ${nz} * ${nz});
        positions[${at}] = ${name("xX")};
        positions[${at} + 1] = ${name("yX")};
        positions[${at} + 2] = ${name("zX")};
        normals[${at}] = ${scale} * ${nx};
        normals[${at} + 1] = ${scale} * ${ny};
        normals[${at} + 2] = ${scale} * ${nz};`;
}
