/** From what a person chooses in the export dialogue to what is made, and how large that will be. */

import { formatNumber, parseNumber } from "../number";
import { millilitres } from "./quantities";
import { UNITS as MILLIMETRES } from "./tables.gen";
import type { Format, Making, Measures, Product, Unit } from "./types";

export interface FormatNote {
  readonly format: Format;
  readonly label: string;
  readonly note: string;
  /** Whether it is made of triangles, as finely as the tolerance says. */
  readonly triangles: boolean;
  readonly type: string;
}

export const FORMATS: readonly FormatNote[] = [
  {
    format: "3mf",
    label: "3MF",
    note: "For printing: true size, title and picture.",
    triangles: true,
    type: "model/3mf",
  },
  { format: "stl", label: "STL", note: "For every slicer. In millimetres.", triangles: true, type: "model/stl" },
  { format: "step", label: "STEP", note: "For CAD: smooth surfaces, one solid.", triangles: false, type: "model/step" },
  {
    format: "svg",
    label: "SVG",
    note: "A template for throwing or turning, at true size, on one large page.",
    triangles: false,
    type: "image/svg+xml",
  },
  {
    format: "a4.svg",
    label: "SVG A4",
    note: "The template on sheets of A4, to be put together: print them at 100 %.",
    triangles: false,
    type: "image/svg+xml",
  },
  {
    format: "letter.svg",
    label: "SVG Letter",
    note: "The template on sheets of letter paper, to be put together: print them at 100 %.",
    triangles: false,
    type: "image/svg+xml",
  },
  {
    format: "glb",
    label: "GLB",
    note: "For viewers, games and rooms: with its colours.",
    triangles: true,
    type: "model/gltf-binary",
  },
  { format: "obj", label: "OBJ", note: "For other 3D programs: the shape alone.", triangles: true, type: "model/obj" },
  {
    format: "obj.zip",
    label: "OBJ+MTL",
    note: "For other 3D programs: the shape and its colours, two files in a package.",
    triangles: true,
    type: "application/zip",
  },
  {
    format: "ply",
    label: "PLY",
    note: "For science and scans: with its colours.",
    triangles: true,
    type: "application/octet-stream",
  },
];

/** Whether a file that is dropped on the page opens the design again. */
export function opensAgain(format: Format): string {
  return format === "stl"
    ? "Dropped on this page, an STL does not open the design again, unless its link is very short; every other format does."
    : "Dropped on this page, the file opens the design again.";
}

export function formatNote(format: Format): FormatNote {
  return FORMATS.find((each) => each.format === format) ?? (FORMATS[0] as FormatNote);
}

export type SizeKind = "designed" | "height" | "width" | "capacity";

/** What stands in the dialogue's fields. */
export interface Choices {
  readonly product: Product;
  readonly size: SizeKind;
  /** The height or width in the unit of the design, or millilitres. */
  readonly measure: string;
  /** In percent. */
  readonly shrinkage: string;
  /** In millimetres of the file; empty for what suits the size. */
  readonly tolerance: string;
}

export interface Problem {
  readonly field: "measure" | "shrinkage" | "tolerance";
  readonly text: string;
}

/** Keeps a number, its unit and what it is of in one line. */
const GAP = "\u00a0";

/** Digits that leave a number what it was, but for what a change of units adds to it. */
const EXACT = 12;

/** Clay that shrinks by half is no clay. */
const MOST_SHRINKAGE = 50;

/** What is made, or why that cannot be. */
export function makingOf(choices: Choices, measures: Measures, unit: Unit): Making | Problem {
  const shrinkage = choices.shrinkage.trim() === "" ? 0 : numberIn(choices.shrinkage);
  if (shrinkage === null || shrinkage < 0 || shrinkage >= MOST_SHRINKAGE) {
    return { field: "shrinkage", text: `A percentage from 0 to less than ${MOST_SHRINKAGE}.` };
  }
  const measure = choices.size === "designed" ? null : numberIn(choices.measure);
  if (choices.size !== "designed" && (measure === null || measure <= 0)) {
    return { field: "measure", text: "A number greater than 0." };
  }
  if (choices.size === "capacity" && !measures.capacity) {
    return { field: "measure", text: "This holds nothing: choose its height or width." };
  }
  const size = measure === null ? {} : { size: sizeOf(choices.size, measure, unit) };
  const sized: Making = { product: choices.product, ...size, ...(shrinkage > 0 ? { shrinkage } : {}) };
  if (choices.tolerance.trim() === "") return sized;
  const tolerance = numberIn(choices.tolerance);
  if (tolerance === null || tolerance <= 0)
    return { field: "tolerance", text: "A number of millimetres greater than 0." };
  // The library takes it before scaling.
  return { ...sized, tolerance: tolerance / scaleOf(sized, measures, unit).millimetres };
}

/** What the fields say of how a file was made, but for its tolerance, which goes by the size; `walled` is whether there can be a hollow pot. */
export function choicesOf(
  { product, size, shrinkage = 0 }: Making,
  unit: Unit,
  walled: boolean,
): Omit<Choices, "tolerance"> {
  const [kind, measure] = sizeIn(size, unit);
  return {
    product: walled ? (product ?? "pot") : "solid",
    size: kind,
    measure: measure === null ? "" : formatNumber(measure, EXACT),
    shrinkage: shrinkage === 0 ? "" : formatNumber(shrinkage, EXACT),
  };
}

/** The tolerance of such a making in the millimetres of its file. */
export function toleranceIn(making: Making, measures: Measures, unit: Unit): string {
  const { tolerance } = making;
  return tolerance === undefined ? "" : formatNumber(tolerance * scaleOf(making, measures, unit).millimetres, EXACT);
}

function sizeIn(size: Making["size"], unit: Unit): readonly [SizeKind, number | null] {
  if (size?.height !== undefined) return ["height", size.height];
  if (size?.width !== undefined) return ["width", size.width];
  if (size?.capacity !== undefined) return ["capacity", millilitres(size.capacity, unit)];
  return ["designed", null];
}

function sizeOf(kind: SizeKind, measure: number, unit: Unit): NonNullable<Making["size"]> {
  switch (kind) {
    case "width":
      return { width: measure };
    case "capacity":
      return { capacity: measure / millilitres(1, unit) };
    default:
      return { height: measure };
  }
}

function numberIn(text: string): number | null {
  const typed = parseNumber(text);
  return "value" in typed ? typed.value : null;
}

/** The factors that are applied. */
export interface Scale {
  /** From the design to the finished pot. */
  readonly size: number;
  /** From the finished pot to the raw one in the file. */
  readonly shrinkage: number;
  /** From model units to the millimetres of the file. */
  readonly millimetres: number;
}

export function scaleOf({ size, shrinkage = 0 }: Making, { height, width, capacity }: Measures, unit: Unit): Scale {
  let factor = 1;
  if (size?.height !== undefined) factor = size.height / height.value;
  else if (size?.width !== undefined) factor = size.width / width.greatest.value;
  else if (size?.capacity !== undefined && capacity) factor = Math.cbrt(size.capacity / capacity.brim.value);
  const larger = 1 / (1 - shrinkage / 100);
  return { size: factor, shrinkage: larger, millimetres: factor * larger * MILLIMETRES[unit] };
}

/** What is said of the size before saving. */
export interface Sizes {
  /** The file, in millimetres: "120 × 84 mm". */
  readonly file: string;
  /** The finished pot, where that is another size. */
  readonly fired: string | null;
  /** What was applied, in words; empty when nothing was. */
  readonly applied: string;
}

export function sizesOf(making: Making, measures: Measures, unit: Unit): Sizes {
  const { size, shrinkage, millimetres } = scaleOf(making, measures, unit);
  const fired = millimetres / shrinkage;
  const factor = formatNumber(size, 4);
  const applied = [
    ...(factor === "1" ? [] : [`scaled by ${factor}`]),
    ...(shrinkage > 1 ? [`made ${formatNumber(100 * (shrinkage - 1), 3)}${GAP}% larger for the shrinkage`] : []),
  ];
  return {
    file: millimetresWords(measures, millimetres),
    fired: shrinkage > 1 ? millimetresWords(measures, fired) : null,
    applied: applied.join(", "),
  };
}

/** "84 mm wide, 120 mm high" */
function millimetresWords({ height, width }: Measures, scale: number): string {
  const words = (value: number) => `${formatNumber(value * scale, 4)}${GAP}mm`;
  return `${words(width.greatest.value)}${GAP}wide, ${words(height.value)}${GAP}high`;
}
