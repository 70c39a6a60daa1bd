import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import type { Levels } from "../document/types";
import { scaled, scannedOf } from "./scanned";

type Radius = (height: number, angle: number) => number;

/** A scan of a pot 30 high that stands at (4, -7, 2), with a floor and an inner wall, as loose triangles. */
function scan(radius: Radius, { columns = 120, rows = 90, more = [] as readonly number[] } = {}): Float32Array {
  const at = (row: number, column: number, inset = 0) => {
    const [height, angle] = [(30 * row) / rows, (2 * Math.PI * column) / columns];
    const r = radius(height, angle) - inset;
    return [4 + r * Math.cos(angle), -7 + r * Math.sin(angle), 2 + height];
  };
  const numbers: number[] = [...more];
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      for (const inset of [0, 0.5]) {
        const [a, b, c, d] = [
          at(row, column, inset),
          at(row, column + 1, inset),
          at(row + 1, column, inset),
          at(row + 1, column + 1, inset),
        ];
        numbers.push(...a, ...b, ...d, ...a, ...d, ...c);
      }
      const foot = [4, -7, 2];
      if (row === 0) numbers.push(...foot, ...at(0, column), ...at(0, column + 1));
    }
  }
  return Float32Array.from(numbers);
}

const belly = (height: number) => 6 + 3 * Math.sin(height / 6);

/** Null where there is no pot. */
async function levelsOf(positions: Float32Array): Promise<Levels | null> {
  const outcome = await realMaker({ free: true }).maker.ask({ kind: "levels", positions });
  return outcome.state === "done" ? outcome.value : null;
}

async function rings(positions: Float32Array, tolerance: number, height = 30) {
  const levels = await levelsOf(positions);
  if (!levels) throw new Error("there is no pot");
  const outcome = await scannedOf(realMaker({ free: true }).maker, scaled(levels, height), tolerance);
  if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
  return outcome.value;
}

test("a round pot is found again, wherever it stands, as large as it is to be", async () => {
  const positions = scan(belly);
  const levels = await levelsOf(positions);
  expect(levels?.axis[0]).toBeCloseTo(4, 3);
  expect(levels?.axis[1]).toBeCloseTo(-7, 3);
  expect(levels?.bottom).toBeCloseTo(2, 5);
  const found = await rings(positions, 0.1, 15);
  expect(found.distance).toBeLessThanOrEqual(0.1);
  expect(found.rms).toBeLessThan(found.distance);
  expect(found.withoutHandle).toBeNull();
  expect(Math.max(...found.away.map(Math.abs))).toBeCloseTo(found.distance, 6);
  expect(found.shape.rings.length).toBeLessThan(12);
  // At half of the size.
  expect(found.shape.rings[0]?.r.mean).toBeCloseTo(3, 1);
  expect(found.shape.rings.at(-1)?.z.mean).toBeCloseTo(15, 0);
  expect(found.shape.rings.every(({ r }) => r.waves === undefined)).toBe(true);
});

test("petals that turn as they climb are waves of the rings", async () => {
  const found = await rings(
    scan((height, angle) => belly(height) + 0.6 * Math.cos(5 * angle - height / 12)),
    0.2,
  );
  expect(found.distance).toBeLessThanOrEqual(0.2);
  for (const { r } of found.shape.rings) expect(r.waves?.some(({ n }) => n === 5)).toBe(true);
});

test("a handle is told, and rings go on without it", async () => {
  // A block that sticks out from 8 to 20, over 12 degrees.
  const out = (height: number, angle: number) => height > 8 && height < 20 && Math.abs(angle - 3) < 0.1;
  const found = await rings(
    scan((height, angle) => (out(height, angle) ? 14 : belly(height))),
    0.2,
  );
  expect(found.distance).toBeGreaterThan(3);
  // It is outside of them.
  expect(Math.max(...found.away)).toBeCloseTo(found.distance, 5);
  expect(Math.min(...found.away)).toBeGreaterThan(-0.2);
  // The rest of the pot is as round as it was.
  expect(found.withoutHandle?.distance).toBeLessThanOrEqual(0.2);
  expect(found.shape.rings.every(({ r }) => r.waves === undefined)).toBe(true);
});

test("what is no pot has no levels", async () => {
  expect(await levelsOf(new Float32Array(0))).toBeNull();
  expect(await levelsOf(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0))).toBeNull();
  expect(await levelsOf(Float32Array.of(0, 0, Number.NaN, 1, 0, 5, 0, 1, 9))).toBeNull();
  // Half a pot, open at one side.
  const half = scan(belly);
  const kept: number[] = [];
  for (let t = 0; t < half.length; t += 9) if ((half[t + 1] ?? 0) > -7) kept.push(...half.subarray(t, t + 9));
  expect(await levelsOf(Float32Array.from(kept))).toBeNull();
  const levels = await levelsOf(scan(belly));
  expect(levels?.radii.every((section) => section.length === 180)).toBe(true);
});
