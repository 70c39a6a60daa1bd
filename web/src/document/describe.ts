/** The shape in words: what someone who cannot see the pot should know about it. */

import { formatNumber } from "../number";
import type { Body } from "./body";
import type { Extents } from "./extents";
import type { Triple, Unit } from "./types";

/** What the description is made of; lengths in model units. */
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

const NUMBER_WORDS = [
  "no",
  "one",
  "two",
  "three",
  "four",
  "five",
  "six",
  "seven",
  "eight",
  "nine",
  "ten",
  "eleven",
  "twelve",
];

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

/** "A vase 3.6 cm high and 2.2 cm wide, widest at the rim, with 7 petals." */
export function describe(shape: Facts, unit: Unit, { height, greatest }: Extents = shape.extents): string {
  const size = `${length(height)} ${unit} high and ${length(greatest.width)} ${unit} wide`;
  const clauses = [`${capital(noun(shape, greatest.width))} ${size}`, `widest ${place(shape.widestAt)}`];
  const marks: string[] = [];
  if (shape.petals === 2) marks.push(`an oval ${shape.petalsAt}`);
  if (shape.petals > 2) marks.push(`${shape.petals} petals${shape.petalsAt === "foot" ? " at the foot" : ""}`);
  if (shape.waves === 1) marks.push("a slanting rim");
  if (shape.waves === 2) marks.push("a saddle-shaped rim");
  if (shape.waves > 2) marks.push(`${shape.waves} waves in the rim`);
  if (marks.length > 0) clauses.push(`with ${marks.join(" and ")}`);
  const open = shape.closed ? "" : " The wall does not close.";
  const parts = shape.parts > 1 ? ` It is made of ${NUMBER_WORDS[shape.parts] ?? shape.parts} parts.` : "";
  return `${clauses.join(", ")}.${open}${parts}`;
}

/** How far the picture's triangles may be from the surface, in words; rounded up, because it is a promise. */
export function describeAccuracy(bound: number, unit: Unit): string {
  const place = 10 ** (Math.floor(Math.log10(bound)) - 1);
  const promised = bound > 0 ? Math.ceil(bound / place) * place : 0;
  return `Drawn to within ${formatNumber(promised, 2)} ${unit} of the true surface.`;
}

function noun(shape: Facts, across: number): string {
  const slenderness = across > 0 ? shape.height / across : 1;
  if (slenderness < 0.3) return "a plate";
  if (slenderness < 0.85 && shape.mouth > 0.7) return "a bowl";
  if (shape.mouth < 0.45 && slenderness > 1.2) return "a bottle";
  if (slenderness < 1.35 && shape.mouth < 0.85) return "a jar";
  return "a vase";
}

function place(at: number): string {
  if (at > 0.93) return "at the rim";
  if (at > 0.62) return "at the shoulder";
  if (at > 0.38) return "in the middle";
  if (at > 0.07) return "low down";
  return "at the foot";
}

function length(value: number): string {
  return formatNumber(value, 3);
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
