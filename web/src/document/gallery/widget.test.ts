import { expect, test } from "vitest";
import { realMaker } from "../../../testing/real-maker";
import { type Box, boxOf } from "../box";
import { faultOf } from "../network/network";
import { matrixOf, placedAll } from "../placement";
import type { Part } from "../types";
import { designOf } from "./exhibit";
import { handle } from "./networks";
import { GLUED } from "./scenes";
import { widget } from "./widget";

const exponents = ({ shape }: Part) => (shape.kind === "octant" ? shape.exponents : []);
const CORNERS = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].flatMap((z) => [x, y, z])));
const boxes = (parts: readonly Part[]) =>
  parts.map(({ place }) => boxOf(placedAll(matrixOf(place) ?? [], CORNERS)) as Box);

test("the widget is counted as the paper counts it", () => {
  const parts = widget();
  expect(parts).toHaveLength(23);
  // Each of the holes is lined by four that are hollow, and eight go round the annulus.
  expect(parts.filter((part) => exponents(part).filter((each) => each < 1).length === 2)).toHaveLength(8);
  expect(parts.filter((part) => exponents(part).join() === "2,1,50")).toHaveLength(8);
  expect(new Set(parts.map(({ object }) => object ?? 0)).size).toBe(1);
});

test("the annulus is as round as it is said to be", () => {
  const ring = boxes(widget().slice(0, 12));
  const [low, high] = [0, 2].map((axis) => [
    Math.min(...ring.map(({ min }) => min[axis] as number)),
    Math.max(...ring.map(({ max }) => max[axis] as number)),
  ]) as [[number, number], [number, number]];
  expect(low[1] - low[0]).toBeCloseTo(3.2 * Math.SQRT2, 6);
  expect(high[1] - high[0]).toBeCloseTo(3.2 * Math.SQRT2, 6);
  // And upright: all of it is as thick as it was, along y.
  for (const { min, max } of ring)
    expect([min[1], max[1]].map((each) => Math.round(1e6 * each) / 1e6)).toEqual([-1, 1]);
});

test("from each octant one comes to every other, from box to touching box", () => {
  const all = boxes(widget());
  const touch = (a: Box, b: Box) =>
    [0, 1, 2].every(
      (i) => (a.min[i] as number) <= (b.max[i] as number) + 1e-9 && (b.min[i] as number) <= (a.max[i] as number) + 1e-9,
    );
  const reached = new Set([0]);
  for (let grown = -1; grown < reached.size; ) {
    grown = reached.size;
    for (const [at, box] of all.entries())
      if ([...reached].some((other) => touch(all[other] as Box, box))) reached.add(at);
    if (grown === reached.size) break;
  }
  expect(reached.size).toBe(23);
});

test("no octant is wholly inside the box of another", () => {
  const all = boxes(widget());
  const inside = (a: Box, b: Box) =>
    [0, 1, 2].every(
      (i) => (a.min[i] as number) >= (b.min[i] as number) && (a.max[i] as number) <= (b.max[i] as number),
    );
  for (const [i, a] of all.entries())
    for (const [j, b] of all.entries()) if (i !== j) expect([i, j, inside(a, b)]).toEqual([i, j, false]);
});

test("a handle by itself is closed, and the mug that it is glued to has clay in both", async () => {
  const shape = handle(4, 5, [3, 2], [0.7, 0.5]);
  if (shape.kind !== "vertex-frame") throw new Error(shape.kind);
  expect(faultOf(shape)).toBe(null);
  const exhibit = GLUED.find(({ id }) => id === "own-glued-mug");
  if (!exhibit) throw new Error("no mug");
  const { maker } = realMaker({ free: true });
  const design = designOf(exhibit);
  const measured = await maker.ask({ kind: "measure", design, product: "pot", fill: null });
  if (measured.state !== "done") throw new Error(JSON.stringify(measured));
  const volumes = measured.value.parts.map(({ clay }) => clay?.volume.value ?? 0);
  expect(volumes).toHaveLength(2);
  // An ellipse of 1.5 by 0.9, some eight centimetres long.
  expect(volumes[1]).toBeGreaterThan(6);
  expect(volumes[1]).toBeLessThan(12);
  const report = await maker.ask({ kind: "check", design, making: { craft: "print" } });
  if (report.state !== "done") throw new Error(JSON.stringify(report));
  expect(report.value.findings.filter(({ severity }) => severity === "error")).toEqual([]);
}, 120_000);

test("all of the widget's octants are solids of the volume that they should have", async () => {
  const { maker } = realMaker({ free: true });
  const exhibit = GLUED.find(({ id }) => id === "own-widget");
  if (!exhibit) throw new Error("no widget");
  const measured = await maker.ask({ kind: "measure", design: designOf(exhibit), product: "pot", fill: null });
  if (measured.state !== "done") throw new Error(JSON.stringify(measured));
  const volumes = measured.value.parts.map(({ clay }) => clay?.volume.value ?? 0);
  expect(volumes).toHaveLength(23);
  // A round hole leaves of the square about it 1 - pi / 4 in its corners; the concave octants have a little more or less.
  const lining = volumes.slice(0, 4).reduce((sum, each) => sum + each, 0);
  const square = 4 * 1.6 ** 2 * 2;
  expect(lining / square).toBeGreaterThan(0.19);
  expect(lining / square).toBeLessThan(0.24);
  // The segments of the circle round the square: pi / 2 - 1 times it.
  const rim = volumes.slice(4, 12).reduce((sum, each) => sum + each, 0);
  expect(rim / square).toBeGreaterThan(0.52);
  expect(rim / square).toBeLessThan(0.6);
}, 120_000);
