import { readFile, writeFile } from "node:fs/promises";
import { expect, test } from "vitest";
import { realMaker } from "../../../testing/real-maker";
import { edgesOf, faultOf, isFree } from "../network/network";
import { designOf } from "./exhibit";
import { NETWORKED } from "./networks";

/** Those that bound a solid. */
const SOLIDS = ["own-mug", "own-basket", "own-spouted", "own-hat", "own-dress"];

test.each(NETWORKED.map(({ id, shape }) => [id, shape] as const))("%s is a network", (id, shape) => {
  if (shape.kind !== "vertex-frame") throw new Error(shape.kind);
  expect(faultOf(shape)).toBe(null);
  const open = [...edgesOf(shape).values()].filter(isFree).length;
  expect([id, open > 0]).toEqual([id, !SOLIDS.includes(id)]);
});

test.each(NETWORKED.filter(({ id }) => SOLIDS.includes(id)).map((exhibit) => [exhibit.id, exhibit] as const))(
  "%s is a solid that can be made",
  async (_, exhibit) => {
    const { maker } = realMaker({ free: true });
    const report = await maker.ask({ kind: "check", design: designOf(exhibit), making: { craft: "print" } });
    if (report.state !== "done") throw new Error(JSON.stringify(report));
    expect(report.value.findings.filter(({ severity }) => severity === "error")).toEqual([]);
    expect(report.value.ok).toBe(true);
  },
  120_000,
);

test("what the benchmark of storage compares are these", async () => {
  const file = new URL("../../../../tests/bench/networks.json", import.meta.url);
  const lines = NETWORKED.map(({ id, shape }) => JSON.stringify({ id, shape }));
  const text = `[\n${lines.join(",\n")}\n]\n`;
  if (process.env.PASU_BLESS) await writeFile(file, text);
  expect(await readFile(file, "utf8")).toBe(text);
});
