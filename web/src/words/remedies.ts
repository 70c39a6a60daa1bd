/** What is different of a wall that would make a pot, in words for a button; and of one that was fitted, as a sentence. */

import { DEFAULTS } from "../document/tables.gen";
import type { Finding, Unit, Wall } from "../document/types";
import { report } from "./english/report";
import { lengthWords } from "./quantities";

/** Digits of the lengths that the solver proposes. */
const DIGITS = 2;

/** The code of a finding of the checks: the ring is not the one that was asked for. */
const FITTED_FOOT = "fitted-foot";

/** The same of the drain. */
const FITTED_DRAIN = "fitted-drain";

/** "There is no room for the foot ring that was asked for: it is made 1.1 cm wide and 0.4 cm high."; null for any other finding. */
export function fittedWords({ code, remedy }: Finding, unit: Unit): string | null {
  if (!remedy) return null;
  const { foot, drain } = remedy.wall;
  const length = (value: number) => lengthWords(value, unit, DIGITS);
  if (code === FITTED_FOOT && foot) {
    const [width, height] = foot;
    return report.fittedFoot(length(width), length(height));
  }
  if (code === FITTED_DRAIN && drain) {
    return report.fittedDrain(length(drain));
  }
  return null;
}

/** "Make it with a ring 3 mm wide and 2 mm high" */
export function remedyWords(asked: Wall, wall: Wall, unit: Unit): string {
  const length = (value: number) => lengthWords(value, unit, DIGITS);
  const said = report.remedies;
  const changes: string[] = [];
  if ((wall.side ?? DEFAULTS.side) !== (asked.side ?? DEFAULTS.side)) {
    changes.push(wall.side === "outside" ? said.outwards : said.inwards);
  }
  if (wall.thickness !== asked.thickness) changes.push(said.wall(length(wall.thickness)));
  if (wall.base !== asked.base) changes.push(said.base(length(wall.base)));
  if ((wall.rim ?? DEFAULTS.rim) !== (asked.rim ?? DEFAULTS.rim)) changes.push(said.flatRim);
  if (wall.foot) {
    const [width, height] = wall.foot;
    if (width !== asked.foot?.[0] || height !== asked.foot[1]) {
      changes.push(said.ring(length(width), length(height)));
    }
  } else if (asked.foot) changes.push(said.noRing);
  if ((wall.drain ?? 0) !== (asked.drain ?? 0))
    changes.push(wall.drain ? said.drain(length(wall.drain)) : said.noDrain);
  if (asked.lining && !wall.lining) changes.push(said.follows);
  return said.make(changes);
}
