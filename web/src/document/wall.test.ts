import { expect, test } from "vitest";
import type { Part, Wall } from "./types";
import { firstFoot, firstWall, sameSurface, wallFields, wallNumber, wallRange, withWallNumber } from "./wall";

test.each([
  [3.6, 0.15],
  [20, 0.8],
  [250, 10],
  [0.02, 0.0008],
])("a pot of size %d begins with a wall of %d", (size, thickness) => {
  expect(firstWall(size, "rings")).toEqual({ thickness, base: thickness });
});

test("a size that is not known takes a usual wall", () => {
  for (const size of [0, Number.NaN, Number.POSITIVE_INFINITY]) expect(firstWall(size, "rings").thickness).toBe(0.3);
});

test("only numbers that mean something are asked for", () => {
  const names = (wall: Parameters<typeof wallFields>[0]) => wallFields(wall, "rings").map(({ key }) => key);
  const wall = firstWall(20, "rings");
  expect(names(wall)).toEqual(["thickness", "base", "drain"]);
  expect(names({ ...wall, base: 0 })).toEqual(["thickness", "base"]);
  expect(names({ ...wall, foot: firstFoot(wall) })).toEqual(["thickness", "base", "foot-0", "foot-1", "drain"]);
});

test("numbers are read and changed by their fields, and a hole of no width is none", () => {
  const wall = { ...firstWall(20, "rings"), foot: [1, 2] as const };
  for (const field of wallFields(wall, "rings")) {
    const changed = withWallNumber(wall, field, 0.7);
    expect(wallNumber(changed, field)).toBe(0.7);
    expect(withWallNumber(changed, field, 0.7)).toBe(changed);
  }
  const drain = wallFields(wall, "rings").find(({ key }) => key === "drain");
  if (!drain) throw new Error("drain");
  expect(withWallNumber({ ...wall, drain: 2 }, drain, 0)).toEqual(wall);
});

test("sliders end at short numbers and step by a hundredth or so", () => {
  for (const field of wallFields({ ...firstWall(7.3, "rings"), foot: [1, 1] }, "rings")) {
    const { max, step } = wallRange(field, 7.3);
    expect(max / step).toBeGreaterThanOrEqual(100);
    expect(max / step).toBeLessThanOrEqual(1000);
  }
});

test("another wall is the same surface, another shape is not", () => {
  const part = { shape: { kind: "fourth-order" } } as unknown as Part;
  const walled = { ...part, wall: firstWall(3, "rings") };
  expect(sameSurface([part], [walled])).toBe(true);
  expect(sameSurface([part], [part, part])).toBe(false);
  expect(sameSurface([part], [{ ...part, shape: { ...part.shape } }])).toBe(false);
});

test("patches have a thickness alone, and what else is given can be taken away", () => {
  const wall = firstWall(20, "vertex-frame");
  expect(wall).toEqual({ thickness: 0.8, base: 0 });
  const names = (of: Wall) => wallFields(of, "vertex-frame").map(({ key }) => key);
  expect(names(wall)).toEqual(["thickness"]);
  expect(names({ ...wall, base: 1, drain: 2 })).toEqual(["thickness", "base", "drain"]);
});
