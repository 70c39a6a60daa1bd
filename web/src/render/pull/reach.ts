import type { Triple } from "../triple";

/** A point of the screen, in CSS pixels from the upper left of the stage. */
export interface Spot {
  readonly x: number;
  readonly y: number;
  /** How far from the eye, where that is known: more is further. */
  readonly depth?: number;
}

/** From a point of a part, before placement, to the screen as it was when the hand took hold; null behind the eye. */
export type See = (point: Triple) => Spot | null;

/** Away from the axis, up, and round it in radians, from a point of a part. */
export interface Reached {
  readonly out: number;
  readonly up: number;
  readonly round: number;
}

export type Direction = "out" | "up" | "round" | "free";

/** A direction that is seen shorter than this share of what one across the view is, moves as if it were so long: towards the eye a hand cannot point. */
const SHORTEST = 0.35;

/** Newton steps: the perspective bends little. */
const STEPS = 4;

/** The step by which it is seen where a direction leads to, as a share of the pot. */
const NEAR = 1e-4;

/**
 * How far a point has to move in a direction so that it is seen where the hand is: along the way of that direction on the screen, as near as can be. `free` moves it in the plane of the axis.
 * `size` is that of the pot.
 */
export function reached(see: See, point: Triple, size: number, by: Spot, way: Direction): Reached {
  const from = see(point);
  if (!from) return { out: 0, up: 0, round: 0 };
  const to = { x: from.x + by.x, y: from.y + by.y };
  const across = acrossOf(see, point, size);
  if (way === "free") return freely(see, point, size, to, across);
  let far = 0;
  for (let step = 0; step < STEPS; step += 1) {
    const here = see(moved(point, along(way, far)));
    const beside = see(moved(point, along(way, far + NEAR * unitOf(way, point, size))));
    if (!here || !beside) break;
    const unit = NEAR * unitOf(way, point, size);
    let [dx, dy] = [(beside.x - here.x) / unit, (beside.y - here.y) / unit];
    const length = Math.hypot(dx, dy);
    const least = SHORTEST * across * (way === "round" ? radiusOf(point) || size : 1);
    // Straight at the eye: downwards on the screen is towards whoever looks from above.
    if (length < 1e-6 * least) [dx, dy] = [0, 1];
    else [dx, dy] = [dx / length, dy / length];
    const left = (to.x - here.x) * dx + (to.y - here.y) * dy;
    far += left / Math.max(length, least);
    // Where it is seen too short, one step is all: the next would make up for what was held back.
    if (length < least) break;
  }
  return along(way, far);
}

/** Both at once, each held back where it is seen short. */
function freely(see: See, point: Triple, size: number, to: Spot, across: number): Reached {
  let [out, up] = [0, 0];
  for (let step = 0; step < STEPS; step += 1) {
    const unit = NEAR * size;
    const at = (a: number, b: number) => see(moved(point, { out: a, up: b, round: 0 }));
    const [here, outward, upward] = [at(out, up), at(out + unit, up), at(out, up + unit)];
    if (!here || !outward || !upward) break;
    const a = [(outward.x - here.x) / unit, (outward.y - here.y) / unit] as const;
    const b = [(upward.x - here.x) / unit, (upward.y - here.y) / unit] as const;
    const left = [to.x - here.x, to.y - here.y] as const;
    const [aa, ab, bb] = [a[0] * a[0] + a[1] * a[1], a[0] * b[0] + a[1] * b[1], b[0] * b[0] + b[1] * b[1]];
    const [al, bl] = [a[0] * left[0] + a[1] * left[1], b[0] * left[0] + b[1] * left[1]];
    // The square of how short the shortest way is seen that the two have between them.
    const shortest = (aa + bb - Math.hypot(aa - bb, 2 * ab)) / 2;
    const held = Math.max(0, (SHORTEST * across) ** 2 - shortest);
    const determinant = (aa + held) * (bb + held) - ab * ab;
    out += (al * (bb + held) - bl * ab) / determinant;
    up += (bl * (aa + held) - al * ab) / determinant;
    if (held > 0) break;
  }
  return { out, up, round: 0 };
}

function along(way: Direction, far: number): Reached {
  return { out: way === "out" ? far : 0, up: way === "up" ? far : 0, round: way === "round" ? far : 0 };
}

/** Where a point is after a movement. */
export function moved([x, y, z]: Triple, { out, up, round }: Reached): Triple {
  const angle = Math.atan2(y, x) + round;
  const radius = Math.hypot(x, y) + out;
  return [radius * Math.cos(angle), radius * Math.sin(angle), z + up];
}

function radiusOf([x, y]: Triple): number {
  return Math.hypot(x, y);
}

function unitOf(way: Direction, point: Triple, size: number): number {
  return way === "round" && radiusOf(point) > 0 ? size / radiusOf(point) : size;
}

/** How many pixels a unit of length is, across the view at that point: the longest of three. */
function acrossOf(see: See, point: Triple, size: number): number {
  const here = see(point);
  const unit = NEAR * size;
  const lengths = [0, 1, 2].map((axis) => {
    const beside = see(point.map((x, i) => (i === axis ? x + unit : x)) as unknown as Triple);
    return here && beside ? ((beside.x - here.x) / unit) ** 2 + ((beside.y - here.y) / unit) ** 2 : 0;
  });
  // Of three directions at right angles the squares add up to two of one that is seen across.
  return Math.sqrt(lengths.reduce((sum, each) => sum + each, 0) / 2);
}
