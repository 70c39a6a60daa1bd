// The part of `cargo xtask bench` that runs in Node: prints one line of JSON for each group.

import { readFile } from "node:fs/promises";
import * as bench from "../../crates/bench-wasm/pkg/bench.js";
import * as pasu from "../../crates/pasu-wasm/pkg/pasu.js";
import { groups } from "./groups.mjs";

const file = (path) => readFile(new URL(path, import.meta.url));
const json = async (path) => JSON.parse(await file(path));

await bench.default({ module_or_path: await file("../../crates/bench-wasm/pkg/bench_bg.wasm") });
await pasu.default();
const designs = { vase: await json("vase.json"), turned: await json("turned.json") };
for await (const group of groups({ bench, pasu, ...designs }, { quick: process.argv.includes("--quick") })) {
  process.stdout.write(`${JSON.stringify({ runner: "Node", ...group, rows: group.rows.map(withoutTargets) })}\n`);
}

/** The targets are for browsers. */
function withoutTargets({ at_least, at_most, median_at_most, ...row }) {
  return row;
}
