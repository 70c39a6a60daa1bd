/** The shape in words: what someone who cannot see the pot should know about it. */

import type { Extents } from "../document/extents";
import type { Facts } from "../document/facts";
import type { Unit } from "../document/types";
import { listed } from "../language";
import { boundWords } from "./bound";
import { description } from "./english/description";
import { spokenLength } from "./quantities";

const DIGITS = 3;

/** "A vase 3.6 cm high and 2.2 cm wide, widest at the rim, with 7 petals." What is made of several parts has none of these as a whole: "Three parts, 4.2 cm high and 14.4 cm wide together." */
export function describe(shape: Facts, unit: Unit, { height, greatest }: Extents = shape.extents): string {
  const length = (value: number) => spokenLength(value, unit, DIGITS);
  if (shape.parts > 1) return describeBodies(shape.parts, unit, { height, greatest });
  const marks: string[] = [];
  if (shape.petals === 2) marks.push(description.oval[shape.petalsAt]);
  if (shape.petals > 2) marks.push(description.petals[shape.petalsAt](shape.petals));
  if (shape.waves === 1) marks.push(description.slanting);
  if (shape.waves === 2) marks.push(description.saddle);
  if (shape.waves > 2) marks.push(description.waves(shape.waves));
  const said = [
    description.pot(
      description.forms[formOf(shape, greatest.width)],
      length(height),
      length(greatest.width),
      description.widest[placeOf(shape.widestAt)],
      marks.length > 0 ? listed(marks) : null,
    ),
  ];
  if (!shape.closed) said.push(description.open);
  return description.sentences(said);
}

/** How large several parts are together, or one that is no pot. */
export function describeBodies(parts: number, unit: Unit, { height, greatest }: Pick<Extents, "height" | "greatest">) {
  const [high, wide] = [height, greatest.width].map((value) => spokenLength(value, unit, DIGITS)) as [string, string];
  return parts > 1 ? description.parts(parts, high, wide) : description.body(high, wide);
}

/** How far the picture's triangles may be from the surface, in words. */
export function describeAccuracy(bound: number, unit: Unit): string {
  return description.accuracy(boundWords(bound, unit));
}

function formOf(shape: Facts, across: number): keyof typeof description.forms {
  const slenderness = across > 0 ? shape.height / across : 1;
  if (slenderness < 0.3) return "plate";
  if (slenderness < 0.85 && shape.mouth > 0.7) return "bowl";
  if (shape.mouth < 0.45 && slenderness > 1.2) return "bottle";
  if (slenderness < 1.35 && shape.mouth < 0.85) return "jar";
  return "vase";
}

function placeOf(at: number): keyof typeof description.widest {
  if (at > 0.93) return "rim";
  if (at > 0.62) return "shoulder";
  if (at > 0.38) return "middle";
  if (at > 0.07) return "low";
  return "foot";
}
