// What the blank page of kernel.bench.ts runs.

import * as bench from "../../crates/bench-wasm/pkg/bench.js";
import * as pasu from "../../crates/pasu-wasm/pkg/pasu.js";
import { groups } from "./groups.mjs";

const json = async (path) => (await fetch(new URL(path, import.meta.url))).json();

const ready = Promise.all([bench.default(), pasu.default(), json("vase.json"), json("turned.json")]);

globalThis.measure = async (options) => {
  if (!globalThis.crossOriginIsolated) throw new Error("the clock is coarse: the page is not isolated");
  const [, , vase, turned] = await ready;
  for await (const group of groups({ bench, pasu, vase, turned }, options)) await globalThis.handOver(group);
};
