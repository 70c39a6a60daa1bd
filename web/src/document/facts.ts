/** What there is to say of a shape to someone who cannot see it. */

import type { Body } from "./body";
import type { Extents } from "./extents";
import type { Triple } from "./types";

/** What a description is made of; lengths in model units. */
export interface Facts {
  readonly parts: number;
  readonly height: number;
  /** Along x and y. */
  readonly width: number;
  readonly depth: number;
  /** In every direction. */
  readonly extents: Extents;
  /** Height of the widest place, 0 at the bottom, 1 at the top. */
  readonly widestAt: number;
  /** Width of the mouth as a share of the widest width. */
  readonly mouth: number;
  /** How many times the outline swings out, and where. */
  readonly petals: number;
  readonly petalsAt: "rim" | "foot";
  /** How many times the rim rises. */
  readonly waves: number;
  readonly closed: boolean;
  /** Height and mean radius of the rings of the first part, from the foot to the rim. */
  readonly outline: readonly (readonly [number, number])[];
}

/** The box that a placed mesh fills. */
export interface Box {
  readonly min: Triple;
  readonly max: Triple;
}

/** A part as it is told of, scaled and turned; `lift` is how far it is moved upwards. */
export interface ToldPart {
  readonly body: Body | null;
  readonly closed: boolean;
  readonly lift: number;
}

/** What there is to say of parts that fill a box together; the outline is that of the first. */
export function factsOf(parts: readonly ToldPart[], { min: low, max: high }: Box, extents: Extents): Facts | null {
  const [first] = parts;
  if (!first?.body) return null;
  const { lift, body } = first;
  const { rim, widest, petals, petalsAt, waves, outline } = body;
  const height = high[2] - low[2];
  return {
    parts: parts.length,
    height,
    width: high[0] - low[0],
    depth: high[1] - low[1],
    extents,
    widestAt: height > 0 ? (widest.height + lift - low[2]) / height : 0,
    mouth: widest.radius > 0 ? rim.radius / widest.radius : 0,
    petals,
    petalsAt,
    waves,
    closed: parts.every(({ closed }) => closed),
    outline: lift === 0 ? outline : outline.map(([at, radius]) => [at + lift, radius] as const),
  };
}
