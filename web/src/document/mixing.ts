/**
 * Two pots of rings, mixed. Both are put through the rings of both: one that is put where the surface is changes nothing (docs/rings.md), and then radii, heights, and slopes at ends that have
 * them, are mixed number by number. Of what is no number (a glaze, which rings are sharp) the nearer pot has its way.
 */

import { inUnit } from "./scaled";
import { DEFAULTS, LIMITS } from "./tables.gen";
import type { Design, Hoop, Part, Rings, Series, Wall, Wave } from "./types";

/** Two rings of the two pots that are nearer than this along the profile are one. */
const NEAR = 1e-4;
/** Digits that a number of a document keeps: those of canonical form. */
const DIGITS = 12;
/** What a wave comes to that is only rounding, in the size of the pot. */
const ROUNDING = 1e-13;

/** Where a pot is looked at to know what its rings would be there: `u, v` pairs. */
export interface Places {
  readonly us: readonly number[];
  /** So many round the axis at each of them. */
  readonly columns: number;
  readonly at: Float64Array;
}

/** The point (xyz) of each of these places, and its derivative along `u`. */
export interface Points {
  readonly points: Float64Array;
  readonly du: Float64Array;
}

/** What two pots have, each read at the places of both. */
export interface Mixed {
  readonly mine: Rings;
  readonly theirs: Rings;
}

/** The one shape of a design that can be mixed: a single pot of rings. */
export function mixable({ parts }: Design): Rings | null {
  const [part] = parts;
  return parts.length === 1 && part?.shape.kind === "rings" ? part.shape : null;
}

/** Where the rings of both are, from the foot to the rim; null where they are more than a document may have. */
export function places(mine: Rings, theirs: Rings): readonly number[] | null {
  const us = [...mine.rings.map(({ u }) => u)];
  for (const { u } of theirs.rings) if (us.every((one) => Math.abs(one - u) >= NEAR)) us.push(u);
  return us.length > LIMITS.rings + 2 ? null : us.sort((a, b) => a - b);
}

/** Where a pot has to be looked at to be put through rings at these places. */
export function wanted(shape: Rings, us: readonly number[]): Places {
  const columns = 2 * Math.max(0, ...wavesOf(shape)) + 2;
  const at = new Float64Array(2 * us.length * columns);
  us.forEach((u, row) => {
    for (let i = 0; i < columns; i += 1) at.set([u, (2 * Math.PI * i) / columns], 2 * (row * columns + i));
  });
  return { us, columns, at };
}

/** The same pot through rings at these places, with slopes at those ends; what it has already stays to the bit. */
export function through(
  shape: Rings,
  { us, columns }: Places,
  read: Points,
  ends: { readonly foot: boolean; readonly rim: boolean },
): Rings {
  const known = wavesOf(shape);
  const size = Math.max(...shape.rings.map(({ r, z }) => Math.max(Math.abs(r.mean), Math.abs(z.mean))));
  const curve = (triples: Float64Array, row: number) => {
    const part = triples.subarray(3 * row * columns, 3 * (row + 1) * columns);
    const angle = (i: number) => (2 * Math.PI * i) / columns;
    const radial = (i: number) => (part[3 * i] ?? 0) * Math.cos(angle(i)) + (part[3 * i + 1] ?? 0) * Math.sin(angle(i));
    return {
      r: seriesOf(
        Array.from({ length: columns }, (_, i) => radial(i)),
        known,
        size,
      ),
      z: seriesOf(
        Array.from({ length: columns }, (_, i) => part[3 * i + 2] ?? 0),
        known,
        size,
      ),
    };
  };
  const rings = us.map((u, row): Hoop => shape.rings.find((hoop) => hoop.u === u) ?? { u, ...curve(read.points, row) });
  const { foot, rim, ...rest } = shape;
  const [below, above] = [
    foot ?? (ends.foot ? curve(read.du, 0) : null),
    rim ?? (ends.rim ? curve(read.du, us.length - 1) : null),
  ];
  return { ...rest, rings, ...(below && { foot: below }), ...(above && { rim: above }) };
}

/** So much of the other: 0 is one pot, 1 the other. Both go through the same rings and have slopes at the same ends. */
export function mixedRings({ mine, theirs }: Mixed, share: number): Rings {
  const nearer = share < 0.5 ? mine : theirs;
  const curve = <C extends { readonly r: Series; readonly z: Series }>(one: C, other: C): { r: Series; z: Series } => ({
    r: mixedSeries(one.r, other.r, share),
    z: mixedSeries(one.z, other.z, share),
  });
  const a = between(mine.a ?? 1, theirs.a ?? 1, share);
  const rings = mine.rings.map((hoop, at): Hoop => {
    const other = theirs.rings[at] ?? hoop;
    return { u: hoop.u, ...curve(hoop, other), ...(nearer.rings[at]?.sharp && { sharp: true }) };
  });
  return {
    kind: "rings",
    a,
    rings,
    ...(mine.foot && theirs.foot && { foot: curve(mine.foot, theirs.foot) }),
    ...(mine.rim && theirs.rim && { rim: curve(mine.rim, theirs.rim) }),
  };
}

/** The pot on the stage with so much of another: it stands where it stood and keeps its title and unit. */
export function mixedDesign(mine: Design, theirs: Design, mixed: Mixed, share: number): Design {
  const [one, other] = [mine.parts[0], theirs.parts[0]];
  if (!one || !other || share === 0) return mine;
  const { place: _place, wall: _wall, ...nearer } = share < 0.5 ? one : { ...one, look: other.look };
  const shape = share === 1 ? other.shape : mixedRings(mixed, share);
  const wall = share === 1 ? other.wall : mixedWall(one.wall, other.wall, share);
  const { look, ...rest } = nearer;
  const part: Part = {
    ...rest,
    shape,
    ...(one.place && { place: one.place }),
    ...(wall && { wall }),
    ...(look && { look }),
  };
  return { ...mine, parts: [part] };
}

/** The other in the unit of this one. */
export function inUnitOf(mine: Design, theirs: Design): Design {
  return inUnit(theirs, mine.unit ?? DEFAULTS.unit);
}

/** One that only one of them has goes on until the other is reached. */
function mixedWall(one: Wall | undefined, other: Wall | undefined, share: number): Wall | undefined {
  if (!one || !other) return one ?? other;
  const nearer = share < 0.5 ? one : other;
  return {
    ...nearer,
    thickness: between(one.thickness, other.thickness, share),
    base: between(one.base, other.base, share),
    ...(one.foot &&
      other.foot && {
        foot: [between(one.foot[0], other.foot[0], share), between(one.foot[1], other.foot[1], share)] as const,
      }),
    ...(one.drain && other.drain && { drain: between(one.drain, other.drain, share) }),
  };
}

function mixedSeries(one: Series, other: Series, share: number): Series {
  const of = ({ waves = [] }: Series, n: number) => waves.find((wave) => wave.n === n);
  const known = [...new Set([...(one.waves ?? []), ...(other.waves ?? [])].map(({ n }) => n))].sort((a, b) => a - b);
  const waves = known.map((n): Wave => {
    const [mine, theirs] = [of(one, n), of(other, n)];
    const [cos, sin] = [
      between(mine?.cos ?? 0, theirs?.cos ?? 0, share),
      between(mine?.sin ?? 0, theirs?.sin ?? 0, share),
    ];
    return { n, ...(cos !== 0 && { cos }), ...(sin !== 0 && { sin }) };
  });
  return { mean: between(one.mean, other.mean, share), ...(waves.length > 0 && { waves }) };
}

function between(one: number, other: number, share: number): number {
  return one === other ? one : Number(((1 - share) * one + share * other).toPrecision(DIGITS));
}

/** How often what this pot has goes round. No wave becomes another on its way from ring to ring. */
function wavesOf({ rings, foot, rim }: Rings): readonly number[] {
  const all = [...rings, ...(foot ? [foot] : []), ...(rim ? [rim] : [])].flatMap(({ r, z }) => [
    ...(r.waves ?? []),
    ...(z.waves ?? []),
  ]);
  return [...new Set(all.map(({ n }) => n))].sort((a, b) => a - b);
}

/** The mean and the waves of what was read round the axis. */
function seriesOf(values: readonly number[], known: readonly number[], size: number): Series {
  const sum = (weight: (v: number) => number) =>
    values.reduce((all, value, i) => all + value * weight((2 * Math.PI * i) / values.length), 0) / values.length;
  const short = (value: number) => (Math.abs(value) < ROUNDING * size ? 0 : value);
  const waves = known.flatMap((n): Wave[] => {
    const [cos, sin] = [short(2 * sum((v) => Math.cos(n * v))), short(2 * sum((v) => Math.sin(n * v)))];
    return cos === 0 && sin === 0 ? [] : [{ n, ...(cos !== 0 && { cos }), ...(sin !== 0 && { sin }) }];
  });
  return { mean: short(sum(() => 1)), ...(waves.length > 0 && { waves }) };
}
