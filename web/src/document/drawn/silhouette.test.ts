import { expect, test } from "vitest";
import { alike, type Picture, silhouetteOf } from "./silhouette";

type Colour = readonly [number, number, number];

/** How wide the pot is to either side of its axis, in this row; null beside it. */
type Half = (y: number) => number | null;

const WIDTH = 240;
const HEIGHT = 300;

/** A vase from row 40 to row 260. */
const vase: Half = (y) => (y < 40 || y > 260 ? null : 38 + 24 * Math.sin(((y - 40) / 220) * Math.PI * 1.4));

/** A photograph of a pot before a wall; `grain` is noise of so many levels. */
function photograph(
  half: Half,
  back: (x: number, y: number) => Colour,
  clay: Colour,
  { grain = 0, axis = 118 } = {},
): Picture {
  const data = new Uint8ClampedArray(4 * WIDTH * HEIGHT);
  let seed = 7;
  const noise = () => {
    seed = (seed * 1_103_515_245 + 12_345) % 2_147_483_648;
    return grain * (seed / 1_073_741_824 - 1);
  };
  for (let y = 0; y < HEIGHT; y += 1) {
    for (let x = 0; x < WIDTH; x += 1) {
      const wide = half(y + 0.5);
      // What is half covered by the pot has half its colour.
      const cover = wide === null ? 0 : Math.min(1, Math.max(0, wide + 0.5 - Math.abs(x + 0.5 - axis)));
      const behind = back(x, y);
      // Round things are lit from one side.
      const light = 0.75 + 0.35 * Math.min(1, Math.max(-1, (axis - x) / 70));
      for (let c = 0; c < 3; c += 1)
        data[4 * (y * WIDTH + x) + c] = cover * light * (clay[c] ?? 0) + (1 - cover) * (behind[c] ?? 0) + noise();
      data[4 * (y * WIDTH + x) + 3] = 255;
    }
  }
  return { width: WIDTH, height: HEIGHT, data };
}

const PALE: Colour = [214, 210, 200];
const TERRACOTTA: Colour = [150, 74, 48];

/** How far the outline that is found is from the pot at most, in pixels; a few rows at either end are not looked at. */
function worst(picture: Picture, half: Half, axis = 118): number {
  const seen = silhouetteOf(picture);
  if (!seen) throw new Error("nothing was seen");
  const off = seen.right.map(({ x, y }, i) => {
    const wide = half(y) ?? 0;
    return Math.max(Math.abs(x - axis - wide), Math.abs(axis - (seen.left[i]?.x ?? 0) - wide));
  });
  expect(seen.right[0]?.y).toBeGreaterThan(256);
  expect(seen.right.at(-1)?.y).toBeLessThan(44);
  expect(Math.abs(seen.axis - axis)).toBeLessThan(1);
  return Math.max(...off.slice(4, -4));
}

test("a dark pot before a pale wall, to less than a pixel", () => {
  expect(
    worst(
      photograph(vase, () => PALE, TERRACOTTA),
      vase,
    ),
  ).toBeLessThan(1);
});

test("before a wall that darkens to a side and downwards, with a table and grain", () => {
  const wall = (x: number, y: number): Colour => {
    const light = (1 - 0.3 * (x / WIDTH)) * (y > 220 ? 0.72 : 1 - 0.15 * (y / HEIGHT));
    return [PALE[0] * light, PALE[1] * light, PALE[2] * light];
  };
  expect(worst(photograph(vase, wall, [70, 40, 30], { grain: 9 }), vase)).toBeLessThan(2);
});

test("a white pot before a dark cloth", () => {
  expect(
    worst(
      photograph(vase, () => [38, 40, 46], [230, 228, 220], { grain: 6 }),
      vase,
    ),
  ).toBeLessThan(2);
});

test("dust, and a smaller pot beside it, are none of it", () => {
  const picture = photograph(vase, () => PALE, TERRACOTTA);
  for (let y = 230; y < 260; y += 1)
    for (let x = 205; x < 222; x += 1) picture.data.fill(30, 4 * (y * WIDTH + x), 4 * (y * WIDTH + x) + 3);
  for (const [x, y] of [
    [30, 30],
    [60, 280],
    [190, 20],
  ] as const)
    picture.data.fill(0, 4 * (y * WIDTH + x), 4 * (y * WIDTH + x) + 3);
  expect(worst(picture, vase)).toBeLessThan(1);
});

test("a bare wall, and a picture too small to show anything, have no pot", () => {
  expect(
    silhouetteOf(
      photograph(
        () => null,
        () => PALE,
        TERRACOTTA,
        { grain: 3 },
      ),
    ),
  ).toBeNull();
  expect(silhouetteOf({ width: 4, height: 4, data: new Uint8ClampedArray(64) })).toBeNull();
});

test("sides that are alike are one; with a spout they are two", () => {
  const seen = silhouetteOf(photograph(vase, () => PALE, TERRACOTTA));
  const both = seen && alike(seen);
  expect(both?.[100]?.x).toBeCloseTo(118 + (vase(both?.[100]?.y ?? 0) ?? 0), 0);
  const picture = photograph(vase, () => PALE, TERRACOTTA);
  // Something that stands out at the right.
  for (let y = 60; y < 130; y += 1)
    for (let x = 150; x < 215; x += 1) picture.data.set(TERRACOTTA, 4 * (y * WIDTH + x));
  const spouted = silhouetteOf(picture);
  expect(spouted).not.toBeNull();
  expect(spouted && alike(spouted)).toBeNull();
});
