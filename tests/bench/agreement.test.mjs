// Every contender of the benchmarks computes what Pasu computes, and one that does not is found out.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { before, test } from "node:test";
import init, { mesh } from "../../crates/pasu-wasm/pkg/pasu.js";
import { agree } from "./agreement.mjs";
import { contenders } from "./contenders/index.mjs";
import { firstModes, withEveryWave } from "./designs.mjs";
import { takeTurns } from "./rounds.mjs";

// An even and an odd number of columns, which mirrored columns treat differently.
const GRIDS = [
  { rows: 33, columns: 64 },
  { rows: 20, columns: 51 },
];

let vase;

before(async () => {
  await init();
  vase = JSON.parse(await readFile(new URL("vase.json", import.meta.url), "utf8"));
});

const CASES = [
  ["1 mode", () => firstModes(vase, 1)],
  ["2 modes", () => firstModes(vase, 2)],
  ["8 modes", () => firstModes(vase, 8)],
  ["cosines and sines", () => withEveryWave(firstModes(vase, 3))],
];

for (const [what, designed] of CASES) {
  test(`contenders agree for ${what}`, () => {
    const design = designed();
    for (const grid of GRIDS) {
      const truth = mesh(design, grid);
      for (const contender of contenders(design, grid.rows, grid.columns)) {
        contender.run();
        contender.run();
        agree(contender, truth);
      }
    }
  });
}

test("a contender that computes something else is refused", () => {
  const truth = mesh(vase, GRIDS[0]);
  const moved = { name: "moved", positions: truth.positions.slice(), normals: truth.normals };
  moved.positions[7] += 1e-3;
  assert.throws(() => agree(moved, truth), /moved: positions differ/);
  assert.throws(() => agree({ ...truth, name: "short", normals: truth.normals.slice(3) }, truth), /short: normals/);
  agree({ name: "itself", ...truth }, truth);
});

test("contenders take turns", async () => {
  const counts = [0, 0];
  const run = (index) => (times) => {
    counts[index] += times;
    const end = performance.now() + 0.2 * times;
    while (performance.now() < end);
  };
  const samples = await takeTurns([{ run: run(0) }, { run: run(1) }], 3, 20);
  assert.deepEqual([samples[0].length, samples[1].length], [3, 3]);
  assert.ok(samples.flat().every((sample) => sample >= 0.2));
});
