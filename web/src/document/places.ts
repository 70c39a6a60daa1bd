/** Where on a pot a point is, from its height and from which way the wall goes there. */

import type { Triple } from "./types";

export type PlaceName = "foot" | "belly" | "shoulder" | "neck" | "rim" | "middle";

/** Rings of the wall from the foot to the rim: height and mean radius. */
export type Outline = readonly (readonly [height: number, radius: number])[];

/** Shares of the height. */
const FOOT = 0.07;
const LOW = 0.2;
const RIM = 0.93;

/** A ring as wide as this share of the widest is belly still. */
const BELLY = 0.94;
/** Above the belly, a ring narrower than this is neck. */
const NECK = 0.7;
/** A wall that leans in by more than this (radius lost for each unit of height) is shoulder. */
const SHOULDER_SLOPE = 0.45;

export function placeOf([, , z]: Triple, outline: Outline): PlaceName {
  const low = outline[0]?.[0] ?? 0;
  const high = outline.at(-1)?.[0] ?? 0;
  if (!(high > low)) return "middle";
  const at = (z - low) / (high - low);
  if (at > RIM) return "rim";
  if (at < FOOT) return "foot";
  const widest = outline.reduce((best, ring) => (ring[1] > best[1] ? ring : best));
  const widestAt = (widest[0] - low) / (high - low);
  const { radius, slope } = ringAt(z, outline);
  if (radius > BELLY * widest[1] && widestAt < RIM) return "belly";
  if (at < widestAt) return at < LOW ? "foot" : widestAt < RIM ? "belly" : "middle";
  if (slope < -SHOULDER_SLOPE) return "shoulder";
  return radius < NECK * widest[1] ? "neck" : slope < 0 ? "shoulder" : "neck";
}

/**
 * Where on the inside a lining hangs over. A lining that faces down belongs to a wall that leans in above the belly, however thick it is and however far below the
 * outside's shoulder its own lies.
 */
export function hangingInside(at: Triple, outline: Outline): "rim" | "neck" | "shoulder" {
  const place = placeOf(at, outline);
  return place === "rim" || place === "neck" ? place : "shoulder";
}

/** The radius at a height and how it changes there. */
function ringAt(z: number, outline: Outline): { readonly radius: number; readonly slope: number } {
  for (let i = 1; i < outline.length; i += 1) {
    const [a, b] = [outline[i - 1], outline[i]];
    if (!a || !b || b[0] === a[0] || (z - a[0]) * (z - b[0]) > 0) continue;
    const slope = (b[1] - a[1]) / (b[0] - a[0]);
    return { radius: a[1] + slope * (z - a[0]), slope };
  }
  return { radius: outline.at(-1)?.[1] ?? 0, slope: 0 };
}
