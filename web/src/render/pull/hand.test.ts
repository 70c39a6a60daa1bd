import { expect, test } from "vitest";
import { Camera } from "../camera";
import { newPlacing } from "../placing";
import type { Bench } from "../stage";
import { newStudio } from "../studio";
import { Hand } from "./hand";

const ROWS = [0, 0.2, 0.2, 1];
const COLUMNS = 5;

/** A tube whose radius is 1 + u, with a double row at a corner; 800 by 600 pixels from the front. */
function bench(): Bench {
  const points = ROWS.flatMap((u, row) =>
    Array.from({ length: COLUMNS }, (_, column) => {
      const v = column / (COLUMNS - 1);
      const angle = 2 * Math.PI * v;
      return { uv: [u, v], at: [(1 + u) * Math.cos(angle), (1 + u) * Math.sin(angle), row] };
    }),
  );
  const camera = new Camera();
  camera.radius = 3;
  camera.travel({ azimuth: 0, polar: Math.PI / 2, distance: 12, target: [0, 0, 1.5] }, true);
  const studio = newStudio("light");
  studio.frame.value = [0, 0, 1.5, 1 / 3];
  camera.aim([0, 0, 1.5], 3, 800 / 600, { centre: [0, 0, 0], radius: 1 });
  const part = {
    id: "tube",
    vertices: points.length,
    lattice: { columns: COLUMNS, uv: { array: new Float32Array(points.flatMap(({ uv }) => uv)) } },
    positions: { array: new Float32Array(points.flatMap(({ at }) => at)) },
    placing: newPlacing(),
  };
  const pot = { parts: [part], bounds: { radius: 3 } };
  const overlay = { pen: { ratio: { value: 1 } } };
  return { studio, camera, pot, overlay, cut: () => [0, 0, 0, 1], changed: () => {} } as unknown as Bench;
}

test("a point is found in the mesh between its rows and columns", () => {
  const hand = new Hand(bench());
  expect(hand.pointOf({ place: 0, u: 0.1, v: 0 })).toEqual([
    expect.closeTo(1.1, 6),
    expect.closeTo(0, 6),
    expect.closeTo(0.5, 6),
  ]);
  expect(hand.pointOf({ place: 0, u: 0.6, v: 0.5 })?.[2]).toBeCloseTo(2.5, 6);
  expect(hand.pointOf({ place: 0, u: 1, v: 1 })?.[2]).toBeCloseTo(3, 6);
  // Half way between two columns the chord is followed.
  const [x = 0, y = 0] = hand.pointOf({ place: 0, u: 0, v: 0.125 }) ?? [];
  expect([x, y]).toEqual([expect.closeTo(0.5, 6), expect.closeTo(0.5, 6)]);
  expect(hand.pointOf({ place: 1, u: 0, v: 0 })).toBeNull();
});

test("points are seen as from where the camera was, whatever becomes of it", () => {
  const there = bench();
  const hand = new Hand(there);
  expect(hand.sight(0)).toBeNull();
  hand.prepare(there.camera, 800, 600);
  const see = hand.sight(0);
  const middle = see?.([0, 0, 1.5]);
  expect(middle).toEqual({ x: expect.closeTo(400, 3), y: expect.closeTo(300, 3), depth: expect.any(Number) });
  const [above, right] = [see?.([0, 0, 2.5]), see?.([0, 1, 1.5])];
  expect(middle?.depth).toBeGreaterThan(0);
  expect(above?.y).toBeLessThan(300);
  expect(right?.x).toBeGreaterThan(400);
  expect(see?.([100, 0, 1.5])).toBeNull();
  there.camera.travel({ azimuth: 1, polar: 1, distance: 30, target: [5, 5, 5] }, true);
  there.camera.aim([0, 0, 0], 9, 1, { centre: [0, 0, 0], radius: 1 });
  expect(see?.([0, 0, 2.5])).toEqual(above);
});

test("what is to be seen is drawn anew only where it is something else", () => {
  const there = bench();
  let frames = 0;
  const hand = new Hand({ ...there, changed: () => (frames += 1) } as unknown as Bench);
  const touch = { place: 0, u: 0.5, v: 0.25, degree: 4, petals: 1, held: false };
  hand.show(null);
  expect(frames).toBe(0);
  hand.show(touch);
  hand.show({ ...touch });
  expect(frames).toBe(1);
  hand.show({ ...touch, held: true });
  hand.show(null);
  hand.show(null);
  expect(frames).toBe(3);
});
