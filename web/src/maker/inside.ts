/** Surfaces within a blend, with what its equation leaves or how much room there is at each of their points. */

import { evaluate, inside, insideValues } from "pasu";
import { type Beyond, beyondOf, type InsideMap, type SeenInside, sheetsOf } from "../document/blend/looking";
import type { Blend, Sent, Triple } from "../document/types";
import type { InsideAsk } from "./messages";
import { paintedOf } from "./painted";

/** A residual that is less than this part of the size is none: derivatives of the fourth order are no more exact. */
const ROUNDING = 1e-9;

export function insideOf({ design, part, look }: InsideAsk): SeenInside {
  const blend = design.parts[part]?.shape;
  if (blend?.kind !== "blend") throw new Error("what is looked into is a blend");
  const { at, indices } = sheetsOf(blend, look);
  const beyond = look.shown === "joined" ? beyondOf(blend) : null;
  const within = evaluate(design as Sent, part, at);
  const positions = new Float32Array(within.length + (beyond?.at.length ?? 0));
  positions.set(within);
  if (beyond) positions.set(joined(design as Sent, part, blend, beyond), within.length);
  const half = [blend.start, blend.end].some(({ form }) => form === "disc-in-square");
  const values = new Float32Array(positions.length / 3).fill(Number.NaN);
  values.set(valuesOf(design as Sent, part, look.map, at, half));
  let [least, greatest] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  const told = inside(design as Sent, part);
  const [worst, place] = look.map === "residual" ? [told.residual, told.residualAt] : [told.jacobian, told.jacobianAt];
  const worstAt: Triple = [place[0] ?? 0, place[1] ?? 0, place[2] ?? 0];
  const painted = paintedOf({ values, least, greatest });
  const size = positions.reduce((most, each) => Math.max(most, Math.abs(each)), 0);
  const holds = look.map === "residual" && Math.max(worst, greatest) <= ROUNDING * size;
  const all = beyond
    ? Uint32Array.from([...indices, ...beyond.indices.map((each) => each + within.length / 3)])
    : indices;
  return { ...painted, values, positions, indices: all, worst, worstAt, folded: told.isFolded, holds };
}

/** Points of the solids that a blend joins: of its sections, moved along its tangents there. So both have the tangents in common. */
export function joined(
  design: Sent,
  part: number,
  { start, end }: Blend,
  { at, along }: Omit<Beyond, "indices">,
): Float64Array<ArrayBuffer> {
  const points = Float64Array.from(evaluate(design, part, at));
  for (const [point, far] of along.entries()) {
    const { taper, dz } = at[3 * point + 2] === 0 ? start : end;
    for (const axis of [0, 1]) points[3 * point + axis] = (points[3 * point + axis] ?? 0) * (1 + far * taper);
    points[3 * point + 2] = (points[3 * point + 2] ?? 0) + far * dz;
  }
  return points;
}

/** Where a disc over a square has infinite derivatives there is no number. */
function valuesOf(
  design: Sent,
  part: number,
  map: InsideMap,
  at: Float64Array<ArrayBuffer>,
  half: boolean,
): Float32Array<ArrayBuffer> {
  if (!half) return Float32Array.from(insideValues(design, part, map, at));
  const known: number[] = [];
  for (let point = 0; 3 * point < at.length; point += 1) {
    const u = at[3 * point] ?? 0;
    if (u > 0 && u < 1) known.push(point);
  }
  const asked = Float64Array.from(known.flatMap((point) => [...at.subarray(3 * point, 3 * point + 3)]));
  const values = new Float32Array(at.length / 3).fill(Number.NaN);
  insideValues(design, part, map, asked).forEach((value, place) => {
    values[known[place] ?? 0] = value;
  });
  return values;
}
