import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import { surprise } from "../document/surprise";
import type { Design } from "../document/types";
import { judgedBy, Surprises } from "./surprises";

const makeable = async () => ({ state: "done", value: { ok: true } }) as const;

/** Seeds in this order, the last for ever. */
const seeds = (...all: readonly number[]) => {
  const left = [...all];
  return () => (left.length > 1 ? left.shift() : left[0]) ?? 0;
};

test("no pot comes twice in a row, though chance would have it so", async () => {
  const surprises = new Surprises(makeable, seeds(7, 7, 7));
  expect(await surprises.next()).toEqual(surprise(7));
  expect(await surprises.next()).toEqual(surprise(8));
  expect(await surprises.next()).toEqual(surprise(7));
});

test("what cannot be made gives way to the next seed, the first behind the last", async () => {
  const judged: Design[] = [];
  const surprises = new Surprises(
    async (design) => {
      judged.push(design);
      const refusal = { code: "no-wall", path: "", message: "" };
      if (judged.length === 1) return { state: "refused", refusal };
      return { state: "done", value: { ok: judged.length > 2 } };
    },
    seeds(2 ** 32 - 1),
  );
  expect(await surprises.next()).toEqual(surprise(1));
  expect(judged).toEqual([surprise(2 ** 32 - 1), surprise(0), surprise(1)]);
});

test("where nothing can be made there is none, and the search ends", async () => {
  let asked = 0;
  const surprises = new Surprises(async () => {
    asked += 1;
    return { state: "done", value: { ok: false } };
  });
  expect(await surprises.next()).toBeNull();
  expect(asked).toBe(20);
});

test("of two that are asked for at once the newer comes", async () => {
  const surprises = new Surprises(makeable, seeds(1, 2));
  const [first, second] = await Promise.all([surprises.next(), surprises.next()]);
  expect(first).toBeNull();
  expect(second).toEqual(surprise(2));
});

test("the real maker judges, and without one a pot comes all the same", async () => {
  const { maker, worker } = realMaker({ free: true });
  expect(
    await new Surprises(
      judgedBy(async () => maker),
      seeds(3),
    ).next(),
  ).toEqual(surprise(3));
  expect(worker.last.ask.kind).toBe("check");
  expect(
    await new Surprises(
      judgedBy(async () => null),
      seeds(4),
    ).next(),
  ).toEqual(surprise(4));
});
