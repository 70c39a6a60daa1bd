/** Measures as the panel lists them, and what can be said of a pot that holds water. */

import { formatNumber, ouncesWords } from "../number";
import {
  angleWords,
  areaShown,
  areaWords,
  errorWords,
  lengthWords,
  massShown,
  millilitres,
  type Shown,
  volumeShown,
  volumeWords,
  words,
} from "./quantities";
import { asSentence } from "./report-words";
import type { Capacity, Curvature, Measures, PartMeasures, Quantity, Triple, Unit } from "./types";

/** Areas whose difference nobody can measure are the same. */
const SAME = 1e-4;

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

/** Everything that was measured; `part` is the one whose wall and curvature are told. Sizes have the digits that the stage shows, unless they are told as exactly as they are known. */
export function measureGroups(measures: Measures, part: number, unit: Unit, exact = false): readonly Group[] {
  const own = measures.parts[part];
  return [
    sizes(measures, unit, exact),
    ...held(measures, unit),
    ...clay(measures, unit),
    ...standing(measures, unit),
  ].concat(own ? wall(own, unit) : []);
}

function sizes({ height, width, area }: Measures, unit: Unit, exact: boolean): Group {
  const length: Shown = { factor: 1, unit };
  const size = (name: string, measure: Quantity, note?: string) =>
    quantity(name, measure, length, note, exact ? EXACT_DIGITS : SIZE_DIGITS);
  return {
    title: "Size",
    lines: [
      size("Height", height),
      ...(isRound(width)
        ? [size("Width", width.greatest, "the same all round")]
        : [
            size("Greatest width", width.greatest, `across, at ${angleWords(width.greatestDirection)}`),
            size("Least width", width.least, `across, at ${angleWords(width.leastDirection)}`),
          ]),
      quantity("Area of the surface", area, areaShown(unit)),
    ],
  };
}

/** Widths that differ by less than anyone can measure have no direction worth telling. */
function isRound({ greatest, least }: Measures["width"]): boolean {
  return greatest.value - least.value <= 1e-6 * greatest.value;
}

function held(measures: Measures, unit: Unit): readonly Group[] {
  const { capacity } = measures;
  if (!capacity) return [{ title: "Capacity", lines: [], reason: emptyReason(measures) }];
  const { brim, spill, stopped } = capacity;
  return [
    {
      title: "Capacity",
      lines: [
        quantity(
          "To the brim",
          brim,
          volumeShown(brim.value, unit),
          [
            stopped ? "with the drain hole stopped" : "",
            unit === "in" ? ouncesWords(millilitres(brim.value, unit)) : "",
          ]
            .filter(Boolean)
            .join(", ") || undefined,
        ),
        quantity("Spills at a height of", aboveFoot(spill.level, measures.bottom), { factor: 1, unit }),
      ],
    },
  ];
}

/** Why a design holds nothing. */
export function emptyReason({ parts }: Measures): string {
  const reasons = parts.map((part) => part.capacityReason ?? part.reason);
  return asSentence(reasons.find((reason) => reason !== null) ?? "it holds nothing");
}

function clay({ clay: body }: Measures, unit: Unit): readonly Group[] {
  if (!body) return [];
  return [
    {
      title: "Clay",
      lines: [
        quantity("Volume", body.volume, volumeShown(body.volume.value, unit)),
        quantity("Mass, fired", body.mass, massShown(body.mass.value)),
        quantity("Area to glaze, all sides", body.area, areaShown(unit)),
      ],
    },
  ];
}

function standing({ centre, tipping, footprint, bottom }: Measures, unit: Unit): readonly Group[] {
  const lines: Line[] = [];
  const heavy = (name: string, at: { readonly at: Triple; readonly error: number } | null) => {
    if (!at) return;
    const [x, y, z] = at.at;
    const off = Math.hypot(x, y);
    lines.push({
      name,
      value: lengthWords(z - bottom, unit),
      error: errorWords(at.error),
      note:
        off > 1e-6 * Math.abs(z - bottom)
          ? `above the foot, ${lengthWords(off, unit, 3)} from the axis`
          : "above the foot",
    });
  };
  heavy("Centre of mass", centre.empty);
  heavy("Centre of mass, full", centre.full);
  if (footprint) {
    const { area, hullArea } = footprint;
    const touching =
      hullArea.value - area.value <= SAME * hullArea.value
        ? "all of it touches the table"
        : `of which ${areaWords(area.value, unit)} touch the table`;
    lines.push(quantity("Footprint", hullArea, areaShown(unit), touching));
  }
  const tips = (name: string, tip: Measures["tipping"]["empty"], heavyAt: { readonly at: Triple } | null) => {
    if (!tip) return;
    // What it stands on contains the disc that reaches to the nearest edge, and is that disc if it is no larger.
    const nearest = heavyAt ? (heavyAt.at[2] - bottom) * Math.tan((tip.degrees * Math.PI) / 180) : 0;
    const disc = Math.PI * nearest * nearest;
    const round = footprint !== null && Math.abs(footprint.hullArea.value - disc) <= SAME * disc;
    const note = round ? "in every direction" : `towards ${angleWords(tip.toward)}`;
    lines.push({ name, value: angleWords(tip.degrees), error: errorWords(tip.error), note });
  };
  tips("Tips when tilted by", tipping.empty, centre.empty);
  tips("Tips when full, by", tipping.full, centre.full);
  return lines.length > 0 ? [{ title: "Standing", lines }] : [];
}

function wall(part: PartMeasures, unit: Unit): readonly Group[] {
  const { thickness, overhang, overhangInside, curvature } = part;
  const length = (value: number) => lengthWords(value, unit);
  const lines: Line[] = [];
  if (thickness) {
    const { least, greatest } = thickness;
    const same = formatNumber(least.value, 4) === formatNumber(greatest.value, 4);
    lines.push({
      name: "Thickness",
      value: same ? length(least.value) : `${formatNumber(least.value, 4)} to ${length(greatest.value)}`,
      error: errorWords(Math.max(least.error, greatest.error)),
      ...(same ? {} : { note: `${length(thickness.asked)} was asked for` }),
    });
  }
  for (const [name, hangs] of [
    [overhangInside ? "Largest overhang, outside" : "Largest overhang", overhang],
    ["Largest overhang, inside", overhangInside],
  ] as const) {
    if (!hangs) continue;
    const { degrees } = hangs;
    const error = errorWords(hangs.error);
    lines.push(
      degrees > 0
        ? { name, value: angleWords(degrees), error, note: "from upright, where it faces down" }
        : { name, value: "none", error, note: "nothing faces down" },
    );
  }
  lines.push(...curved("Mean curvature", curvature.mean, `/${unit}`));
  lines.push(...curved("Gaussian curvature", curvature.gaussian, `/${unit}²`));
  return [{ title: "Wall", lines }];
}

function curved(name: string, { least, greatest }: Curvature, unit: string): readonly Line[] {
  const end = (extreme: { readonly value: number } | null, otherwise: string) =>
    extreme ? formatNumber(extreme.value, 4) : otherwise;
  const error = errorWords(Math.max(least?.error ?? 0, greatest?.error ?? 0));
  return [{ name, value: `${end(least, "no least")} to ${end(greatest, "no greatest")}\u00a0${unit}`, error }];
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
  if (!capacity) return emptyReason(measures);
  const stopped = capacity.stopped ? " with its drain hole stopped" : "";
  return `Holds ${volumeWords(capacity.brim.value, unit, 3)} to the brim${stopped}.`;
}

/** The heights between which water can stand; null where none can. */
export function waterRange({ capacity }: Measures): { readonly low: number; readonly high: number } | null {
  if (!capacity) return null;
  const [low, high] = [capacity.floor, levelOf(capacity)];
  return high > low ? { low, high } : null;
}

/** As high as water can stand, without a doubt: its error is taken off. */
function levelOf({ spill, floor }: Capacity): number {
  const { value, error } = spill.level;
  return Math.max(floor, value - error);
}
