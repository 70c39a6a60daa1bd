/** Measures as the panel lists them, and what can be said of a pot that holds water. */

import type { Curvature, Measures, PartMeasures, Quantity, Triple, Unit } from "../document/types";
import { isolated } from "../language";
import { formatNumber } from "../number";
import { localVolumeWords, poundsShown } from "./customary";
import { measures as said } from "./english/measures";
import { quantities } from "./english/quantities";
import { dryWords } from "./making";
import {
  angleWords,
  areaShown,
  areaWords,
  directionWords,
  errorWords,
  lengthShown,
  lengthWords,
  massShown,
  type Shown,
  volumeShown,
  words,
} from "./quantities";

/** Areas whose difference nobody can measure are the same. */
const SAME = 1e-4;

/** What it stands on is no area if it is less than this part of the square of its width. */
const EDGE = 1e-6;

/** Degrees: of a direction, and of a width, which is the same from behind. */
const TURN = 360;
const HALF_TURN = 180;

/** Digits of heights and widths, as in the caption and on the dimension lines; and where they are told exactly. */
const SIZE_DIGITS = 3;
const EXACT_DIGITS = 7;

/** One line of the panel. */
export interface Line {
  readonly name: string;
  readonly value: string;
  /** How far it may be off, in words; empty where it is read off to the digits shown. */
  readonly error: string;
  /** What the number means, or where it is. */
  readonly note?: string;
}

export interface Group {
  readonly title: string;
  readonly lines: readonly Line[];
  /** Why there are no numbers, in words. */
  readonly reason?: string;
}

/**
 * Everything that was measured; `part` is the one whose wall and curvature are told, `name` what it is called where there are others. Sizes have the digits that the stage shows,
 * unless they are told as exactly as they are known.
 */
export function measureGroups(
  measures: Measures,
  part: number,
  unit: Unit,
  exact = false,
  name: string | null = null,
): readonly Group[] {
  const own = measures.parts[part];
  return [
    sizes(measures, unit, exact),
    ...held(measures, unit),
    ...clay(measures, unit),
    ...standing(measures, unit),
  ].concat(own ? wall(own, unit, name) : []);
}

function sizes({ height, width, area }: Measures, unit: Unit, exact: boolean): Group {
  const length = lengthShown(unit);
  const digits = exact ? EXACT_DIGITS : SIZE_DIGITS;
  const size = (name: string, measure: Quantity, note?: string) => quantity(name, measure, length, note, digits);
  return {
    title: said.size,
    lines: [
      size(said.height, height),
      ...(isRound(width, digits)
        ? [size(said.width, width.greatest, said.sameAllRound)]
        : [
            size(said.greatestWidth, width.greatest, said.across(directionWords(width.greatestDirection, HALF_TURN))),
            size(said.leastWidth, width.least, said.across(directionWords(width.leastDirection, HALF_TURN))),
          ]),
      quantity(said.surface, area, areaShown(unit)),
    ],
  };
}

/** Widths that differ by less than anyone can measure, or than is told, have no direction worth telling. */
function isRound({ greatest, least }: Measures["width"], digits: number): boolean {
  const [wide, narrow] = [greatest, least].map(({ value }) => formatNumber(value, digits));
  return wide === narrow || greatest.value - least.value <= 1e-6 * greatest.value;
}

function held(measures: Measures, unit: Unit): readonly Group[] {
  const { capacity } = measures;
  if (!capacity) return [{ title: said.capacity, lines: [], reason: emptyReason(measures, unit) }];
  const { brim, spill, stopped } = capacity;
  const notes = [...(stopped ? [said.stopped] : []), ...(unit === "in" ? [localVolumeWords(brim.value, unit, 3)] : [])];
  return [
    {
      title: said.capacity,
      lines: [
        quantity(said.brim, brim, volumeShown(brim.value, unit), notes.length > 0 ? said.notes(notes) : undefined),
        quantity(said.spills, aboveFoot(spill.level, measures.bottom), lengthShown(unit)),
      ],
    },
  ];
}

/** Why a design holds nothing. */
export function emptyReason({ parts }: Measures, unit: Unit): string {
  for (const { capacityCause, capacityReason, cause, reason } of parts) {
    const why = capacityCause ?? cause;
    if (why) return dryWords(why, capacityReason ?? reason ?? "", unit);
  }
  return said.holdsNothing;
}

function clay({ clay: body }: Measures, unit: Unit): readonly Group[] {
  if (!body) return [];
  const pints = unit === "in" ? localVolumeWords(body.volume.value, unit, 3) : undefined;
  const pounds = unit === "in" ? words(body.mass.value, poundsShown(), 3) : undefined;
  return [
    {
      title: said.clay,
      lines: [
        quantity(said.volume, body.volume, volumeShown(body.volume.value, unit), pints),
        quantity(said.mass, body.mass, massShown(body.mass.value), pounds),
        quantity(said.glazed, body.area, areaShown(unit)),
      ],
    },
  ];
}

function standing({ centre, tipping, footprint, bottom, width }: Measures, unit: Unit): readonly Group[] {
  const lines: Line[] = [];
  const heavy = (name: string, at: { readonly at: Triple; readonly error: number } | null) => {
    if (!at) return;
    const [x, y, z] = at.at;
    const off = Math.hypot(x, y);
    lines.push({
      name,
      value: lengthWords(z - bottom, unit),
      error: errorWords(at.error),
      note: off > 1e-6 * Math.abs(z - bottom) ? said.aboveFootOff(lengthWords(off, unit, 3)) : said.aboveFoot,
    });
  };
  heavy(said.centre, centre.empty);
  heavy(said.centreFull, centre.full);
  if (footprint) {
    const { area, hullArea } = footprint;
    const onEdge = hullArea.value <= EDGE * width.greatest.value ** 2;
    // What would be told as nothing is so, too: where a round foot only just touches.
    const touched = areaWords(area.value, unit);
    const isEdge = area.value <= EDGE * width.greatest.value ** 2 || touched === areaWords(0, unit);
    const part = isEdge ? said.edgeTouches : said.touches(touched);
    const touching = hullArea.value - area.value <= SAME * hullArea.value ? said.allTouches : part;
    const nothing = { value: 0, error: Math.max(hullArea.value, hullArea.error) };
    lines.push(
      onEdge
        ? quantity(said.footprint, nothing, areaShown(unit), said.standsOnEdge)
        : quantity(said.footprint, hullArea, areaShown(unit), touching),
    );
  }
  const tips = (name: string, tip: Measures["tipping"]["empty"], heavyAt: { readonly at: Triple } | null) => {
    if (!tip) return;
    // What it stands on contains the disc that reaches to the nearest edge, and is that disc if it is no larger.
    const nearest = heavyAt ? (heavyAt.at[2] - bottom) * Math.tan((tip.degrees * Math.PI) / 180) : 0;
    const disc = Math.PI * nearest * nearest;
    const round = footprint !== null && Math.abs(footprint.hullArea.value - disc) <= SAME * disc;
    const note = round ? said.everyWay : said.towards(directionWords(tip.toward, TURN));
    lines.push({ name, value: angleWords(tip.degrees), error: errorWords(tip.error), note });
  };
  tips(said.tips, tipping.empty, centre.empty);
  tips(said.tipsFull, tipping.full, centre.full);
  return lines.length > 0 ? [{ title: said.standing, lines }] : [];
}

function wall(part: PartMeasures, unit: Unit, called: string | null): readonly Group[] {
  const { thickness, overhang, overhangInside, curvature } = part;
  const length = (value: number) => lengthWords(value, unit);
  const lines: Line[] = [];
  if (thickness) {
    const { least, greatest } = thickness;
    const same = formatNumber(least.value, 4) === formatNumber(greatest.value, 4);
    lines.push({
      name: said.thickness,
      value: same ? length(least.value) : said.range(formatNumber(least.value, 4), length(greatest.value)),
      error: errorWords(Math.max(least.error, greatest.error)),
      ...(same ? {} : { note: said.askedFor(length(thickness.asked)) }),
    });
  }
  for (const [name, hangs] of [
    [overhangInside ? said.overhangOutside : said.overhang, overhang],
    [said.overhangInside, overhangInside],
  ] as const) {
    if (!hangs) continue;
    const { degrees } = hangs;
    const error = errorWords(hangs.error);
    lines.push(
      degrees > 0
        ? { name, value: angleWords(degrees), error, note: said.fromUpright }
        : { name, value: said.none, error, note: said.nothingFacesDown },
    );
  }
  const { mean, gaussian } = curvature;
  // Of what has edges everywhere there is nothing to tell.
  if (mean.least || mean.greatest || gaussian.least || gaussian.greatest) {
    lines.push(curved(said.mean, mean, quantities.bent[unit]));
    lines.push(curved(said.gaussian, gaussian, quantities.bentTwice[unit]));
  }
  return [{ title: called === null ? said.wall : said.wallOf(isolated(called)), lines }];
}

function curved(name: string, { least, greatest }: Curvature, unit: string): Line {
  if (!least && !greatest) return { name, value: said.noBound, error: "" };
  // What may as well be nothing is told as that.
  const told = ({ value, error }: Quantity) => formatNumber(Math.abs(value) <= error ? 0 : value, 4);
  const end = (extreme: Quantity | null, otherwise: string) => (extreme ? told(extreme) : otherwise);
  const error = errorWords(Math.max(least?.error ?? 0, greatest?.error ?? 0));
  const range = said.range(end(least, said.noLeast), end(greatest, said.noGreatest));
  return { name, value: quantities.measured(range, unit), error };
}

function aboveFoot({ value, error }: Quantity, bottom: number): Quantity {
  return { value: value - bottom, error };
}

function quantity(name: string, { value, error }: Quantity, shown: Shown, note?: string, digits?: number): Line {
  const line = { name, value: words(value, shown, digits), error: errorWords(error * shown.factor) };
  return note === undefined ? line : { ...line, note };
}

/** "Holds 820 ml to the brim."; or why it holds nothing. */
export function holdsText(measures: Measures, unit: Unit): string {
  const { capacity } = measures;
  if (!capacity) return emptyReason(measures, unit);
  const volume = localVolumeWords(capacity.brim.value, unit, 3);
  return capacity.stopped ? said.holdsStopped(volume) : said.holds(volume);
}
