import { expect, test } from "vitest";
import { JAR, WALL } from "../../testing/jar";
import { areCarried, motionsBetween } from "./carried";
import { IDENTITY, matrixOf, placedAll } from "./placement";
import type { Part, Placement } from "./types";

const [JAR_PART] = JAR.parts;
if (!JAR_PART) throw new Error("the jar has a part");
const { shape } = JAR_PART;
const at = (place?: Placement): Part => ({ shape, ...(place && { place }) });
const motion = (before: Part, now: Part) => motionsBetween([before], [now])[0] ?? null;

/** Whether the motion takes every point of the part from where it was to where it is. */
function carries(before: Placement, now: Placement): void {
  const points = [0, 0, 0, 1, 2, 3, -4, 5, 0.5];
  const [from, to] = [matrixOf(before), matrixOf(now)];
  const by = motion(at(before), at(now));
  if (!from || !to || !by) throw new Error("not carried");
  const expected = placedAll(to, points);
  for (const [i, value] of placedAll(by, placedAll(from, points)).entries())
    expect(value).toBeCloseTo(expected[i] ?? 0, 11);
}

test("what is moved, or turned about the vertical, is carried along", () => {
  expect(motion(at(), at())).toBe(IDENTITY);
  carries({}, { shift: [1, 2, 3] });
  carries({ shift: [5, 6, 7], scale: [1, 2, -3] }, { shift: [1, 2, 3], scale: [1, 2, -3] });
  carries({ angle: 0.3, shift: [5, 6, 7] }, { angle: -2, shift: [1, 2, 3] });
  carries({ angle: 0.3 }, { axis: [0, 0, -1], angle: 0.4 });
  carries({ axis: [1, 2, 2], angle: 0.7, shift: [1, 0, 0] }, { axis: [1, 2, 2], angle: 0.7, shift: [0, 9, 0] });
});

test("a shift alone is exact", () => {
  const leaning = { axis: [1, 2, 2], angle: 0.7 } as const;
  expect(motion(at({ ...leaning, shift: [1, 0, 0] }), at({ ...leaning, shift: [1, 0, 0.5] }))).toEqual([
    ...IDENTITY.slice(0, 12),
    0,
    0,
    0.5,
    1,
  ]);
});

test("what is scaled, tilted, stood on its head or of another shape is not", () => {
  expect(motion(at(), at({ scale: [1, 1, 2] }))).toBeNull();
  expect(motion(at(), at({ axis: [1, 0, 0], angle: 0.1 }))).toBeNull();
  expect(motion(at(), at({ axis: [1, 0, 0], angle: -Math.PI }))).toBeNull();
  expect(motion(at(), { shape: { ...shape } })).toBeNull();
  expect(motion(at(), at({ axis: [0, 0, 0], angle: 1 }))).toBeNull();
  expect(motionsBetween([at()], [at(), at()])).toEqual([null, null]);
});

test("a design is carried where all of its parts are, with the walls that they had", () => {
  const moved = at({ shift: [1, 0, 0] });
  expect(areCarried([at(), at()], [at(), moved])).toBe(true);
  expect(areCarried([at()], [{ ...moved, wall: WALL }])).toBe(false);
  expect(areCarried([at(), at()], [at(), at({ scale: [2, 2, 2] })])).toBe(false);
  expect(areCarried([at()], [])).toBe(false);
});
