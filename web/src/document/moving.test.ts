import { expect, test } from "vitest";
import { AXES, mirrored, moved, ownAxis, resized, turned } from "./moving";
import { matrixOf, placedAll, UNMOVED, type WholePlacement } from "./placement";
import type { Triple } from "./types";

/** Places of all kinds, mirrored ones and half turns among them. */
const PLACES: readonly WholePlacement[] = [
  UNMOVED,
  { ...UNMOVED, shift: [3, -2, 0.5] },
  { scale: [2, 0.5, 1], axis: [0, 0.6, 0.8], angle: 1.1, shift: [1, 2, 3] },
  { scale: [1, -1, 1], axis: [1, 0, 0], angle: -Math.PI, shift: [0, 0, 4] },
  { scale: [0.3, -2, 1.5], axis: [0.48, 0.64, -0.6], angle: -2.9, shift: [-7, 0, 0] },
];
const POINTS = [0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 1, -2, 0.5];
const ABOUT: Triple = [1.5, -0.5, 2];

const at = (place: WholePlacement) => [...placedAll(matrixOf(place) ?? [], POINTS)];
const eachPoint = (points: readonly number[], of: (point: Triple) => Triple) =>
  Array.from({ length: points.length / 3 }, (_, i) => of(points.slice(3 * i, 3 * i + 3) as unknown as Triple)).flat();
function same(found: readonly number[], wanted: readonly number[]): void {
  for (const [i, x] of found.entries()) expect(x).toBeCloseTo(wanted[i] as number, 9);
}

/** As the solver has placements: the axis in the upper half, less than half a turn forwards. */
function standsAsDocumentsDo({ axis: [h, k, l], angle, scale }: WholePlacement): void {
  expect(Math.hypot(h, k, l)).toBeCloseTo(1, 10);
  expect(k > 0 || (k === 0 && (h > 0 || (h === 0 && l === 1)))).toBe(true);
  expect(angle).toBeGreaterThanOrEqual(-Math.PI);
  expect(angle).toBeLessThan(Math.PI);
  expect(scale[0]).toBeGreaterThan(0);
  expect(scale[2]).toBeGreaterThan(0);
}

test("what is moved is moved, and has no digits of rounding", () => {
  for (const place of PLACES)
    same(
      at(moved(place, [0.1, 0.2, 0.3])),
      eachPoint(at(place), ([x, y, z]) => [x + 0.1, y + 0.2, z + 0.3]),
    );
  expect(moved({ ...UNMOVED, shift: [0.1, 0, 0] }, [0.2, 0, 0]).shift).toEqual([0.3, 0, 0]);
});

test("what is turned goes round the axis through the point", () => {
  for (const place of PLACES)
    for (const axis of AXES) {
      const angle = 0.7 + axis;
      const unit = [0, 1, 2].map((i) => (i === axis ? 1 : 0)) as unknown as Triple;
      const turn = matrixOf({ axis: unit, angle }) ?? [];
      const wanted = eachPoint(at(place), (point) => {
        const arm = point.map((x, i) => x - (ABOUT[i] as number));
        return [...placedAll(turn, arm)].map((x, i) => x + (ABOUT[i] as number)) as unknown as Triple;
      });
      const found = turned(place, unit, angle, ABOUT);
      same(at(found), wanted);
      standsAsDocumentsDo(found);
    }
});

test("four quarter turns are none, and two half turns neither", () => {
  for (const place of PLACES) {
    let found = place;
    for (let quarter = 0; quarter < 4; quarter += 1) found = turned(found, [0, 1, 0], Math.PI / 2, ABOUT);
    same(at(found), at(place));
  }
  expect(turned(turned(UNMOVED, [1, 0, 0], Math.PI, [0, 0, 1]), [1, 0, 0], Math.PI, [0, 0, 1])).toEqual(UNMOVED);
  expect(turned(UNMOVED, [0, 0, 1], Math.PI, [0, 0, 0])).toEqual({ ...UNMOVED, angle: -Math.PI });
});

test("what is scaled keeps the point, and its other own axes as they are", () => {
  for (const place of PLACES) {
    same(
      at(resized(place, null, 2, ABOUT)),
      eachPoint(at(place), (point) => point.map((x, i) => 2 * x - (ABOUT[i] as number)) as unknown as Triple),
    );
    for (const axis of AXES) {
      const along = ownAxis(place, axis);
      const wanted = eachPoint(at(place), (point) => {
        const far = point.reduce((all, x, i) => all + (x - (ABOUT[i] as number)) * (along[i] as number), 0);
        return point.map((x, i) => x + 0.5 * far * (along[i] as number)) as unknown as Triple;
      });
      const found = resized(place, axis, 1.5, ABOUT);
      same(at(found), wanted);
      expect([found.axis, found.angle]).toEqual([place.axis, place.angle]);
    }
  }
});

test("a mirror image is one, with its handedness along y alone, and that of the image is the part", () => {
  for (const place of PLACES)
    for (const axis of AXES) {
      const found = mirrored(place, axis, 2);
      same(
        at(found),
        eachPoint(at(place), (point) => point.map((x, i) => (i === axis ? 4 - x : x)) as unknown as Triple),
      );
      standsAsDocumentsDo(found);
      expect(Math.sign(found.scale[1])).toBe(-Math.sign(place.scale[1]));
      same(at(mirrored(found, axis, 2)), at(place));
    }
  expect(mirrored(UNMOVED, 1, 0)).toEqual({ ...UNMOVED, scale: [1, -1, 1] });
});
