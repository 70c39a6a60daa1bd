// How long a person waits for what is asked of a pot, in the module of the library in Node: each call on pots that are drawn from numbers and on the gallery, every one of them new to it.

import { test } from "vitest";
import init, { check, measure, type PasuError, sketch, write } from "../../crates/pasu-wasm/pkg/pasu.js";
import { designOf } from "../../web/src/document/gallery/exhibit.ts";
import { SHELVES } from "../../web/src/document/gallery.ts";
import { surprise } from "../../web/src/document/surprise.ts";
import type { Design } from "../../web/src/document/types.ts";
import { QUICK, record } from "./rows.ts";

const SEEDS = QUICK ? 10 : 150;

/** What is asked of a design, by how a person calls it. */
const CALLS: readonly (readonly [string, (design: string) => unknown])[] = [
  ["drawn under the hand, with its wall", (design) => sketch(design)],
  ["measured", (design) => measure(design)],
  ["checked", (design) => check(design)],
  ["written as 3MF", (design) => write(design, "3mf")],
  ["written as STEP", (design) => write(design, "step")],
];

/** Milliseconds until there is an answer; a refusal is one. */
function waited(call: (design: string) => unknown, design: Design): number {
  const text = JSON.stringify(design);
  const begin = performance.now();
  try {
    call(text);
  } catch (error) {
    if ((error as PasuError).name !== "PasuError") throw error;
  }
  return performance.now() - begin;
}

/** The time that this share of all did not exceed. */
function share(samples: readonly number[], part: number): string {
  const sorted = [...samples].sort((a, b) => a - b);
  return (sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] ?? Number.NaN).toFixed(0);
}

function tell(group: string, designs: readonly Design[]): void {
  const rows = CALLS.map(([name, call]) => {
    const samples = designs.map((design) => waited(call, design));
    const note = `99 of 100 within ${share(samples, 0.99)} ms, all of ${samples.length} within ${share(samples, 1)} ms.`;
    return { name, samples, note };
  });
  record({ runner: "Node", group, unit: "ms", rows });
}

test("patience", async () => {
  await init();
  tell(
    "what a person waits for, pots drawn from numbers",
    Array.from({ length: SEEDS }, (_, seed) => surprise(seed)),
  );
  tell(
    "what a person waits for, the gallery",
    SHELVES.flatMap(({ exhibits }) => exhibits.map((exhibit) => designOf(exhibit))),
  );
});
