/** From what a person chooses in the export dialogue to what is made, and how large that will be. */

import { formatNumber, parseAmount, parseLength, type Typed } from "../number";
import { UNITS as MILLIMETRES } from "./tables.gen";
import type { Design, Format, Making, Measures, Product, Report, Unit } from "./types";
import { millilitres } from "./volume";
import { capacityUnit, parseVolume } from "./volume-units";

export interface FileFormat {
  readonly format: Format;
  /** Whether it is made of triangles, as finely as the tolerance says. */
  readonly triangles: boolean;
  readonly type: string;
}

export const FORMATS: readonly FileFormat[] = [
  {
    format: "3mf",
    triangles: true,
    type: "model/3mf",
  },
  { format: "stl", triangles: true, type: "model/stl" },
  { format: "step", triangles: false, type: "model/step" },
  {
    format: "svg",
    triangles: false,
    type: "image/svg+xml",
  },
  {
    format: "a4.svg",
    triangles: false,
    type: "image/svg+xml",
  },
  {
    format: "letter.svg",
    triangles: false,
    type: "image/svg+xml",
  },
  {
    format: "glb",
    triangles: true,
    type: "model/gltf-binary",
  },
  { format: "obj", triangles: true, type: "model/obj" },
  {
    format: "obj.zip",
    triangles: true,
    type: "application/zip",
  },
  {
    format: "ply",
    triangles: true,
    type: "application/octet-stream",
  },
];

export function fileFormat(format: Format): FileFormat {
  return FORMATS.find((each) => each.format === format) ?? (FORMATS[0] as FileFormat);
}

export type SizeKind = "designed" | "height" | "width" | "capacity";

/** What stands in the dialogue's fields. */
export interface Choices {
  readonly product: Product;
  readonly size: SizeKind;
  /** The height or width in the unit of the design; or what it holds, in millilitres, or ounces beside inches. */
  readonly measure: string;
  /** In percent. */
  readonly shrinkage: string;
  /** In millimetres of the file; empty for what suits the size. */
  readonly tolerance: string;
  /** Whether the parts of one object become one solid. */
  readonly union?: boolean;
}

/** Why a choice cannot be made, and in which field. */
export interface Problem {
  readonly field: "measure" | "shrinkage" | "tolerance";
  readonly code: "shrinkage" | "size" | "holds-nothing" | "tolerance";
}

/** Whether there is anything to be joined: two parts of one object that a file has. */
export function hasGlued({ parts }: Design, product: Product): boolean {
  const isPot = product === "pot" && parts.some((part) => part.wall !== undefined);
  const made = parts.filter(({ wall, shape }) => !isPot || wall !== undefined || CLOSED.has(shape.kind));
  const objects = made.map(({ object = 0 }) => object);
  return new Set(objects).size < objects.length;
}

/** How many triangles a file has: those of parts that are joined as they are then. */
export function trianglesOf({ meshes, unions }: Pick<Report, "meshes" | "unions">): number {
  const joined = new Set(unions.flatMap(({ parts }) => parts));
  const apart = meshes.filter(({ part }) => !joined.has(part));
  return [...apart, ...unions].reduce((sum, { triangles }) => sum + triangles, 0);
}

/** Digits of a bound, and what rounding adds to one that has so many: a tolerance that is kept to the bit. */
const BOUND_DIGITS = 2;
const SLACK = 1e-9;

/** How far the triangles of a file are from the true faces at most, in millimetres: rounded up, so that it is no less than that. */
export function boundOf({ meshes, unions }: Pick<Report, "meshes" | "unions">, millimetres: number): number {
  const bound = millimetres * Math.max(0, ...[...meshes, ...unions].map((each) => each.bound));
  if (bound === 0) return 0;
  const step = 10 ** (Math.floor(Math.log10(bound)) + 1 - BOUND_DIGITS);
  return Math.ceil((bound / step) * (1 - SLACK)) * step;
}

/** Kinds that may be a solid without a wall. */
const CLOSED: ReadonlySet<string> = new Set(["vertex-frame", "blend", "octant"]);

/** Digits that leave a number what it was, but for what a change of units adds to it. */
const EXACT = 12;

/** Clay that shrinks by half is no clay. */
export const MOST_SHRINKAGE = 50;

/** What is made, or why that cannot be. */
export function makingOf(choices: Choices, measures: Measures, unit: Unit): Making | Problem {
  const shrinkage = choices.shrinkage.trim() === "" ? 0 : numberOf(parseAmount(choices.shrinkage.replace(/%\s*$/, "")));
  if (shrinkage === null || shrinkage < 0 || shrinkage >= MOST_SHRINKAGE) {
    return { field: "shrinkage", code: "shrinkage" };
  }
  const measure = choices.size === "designed" ? null : measureIn(choices, unit);
  if (choices.size !== "designed" && (measure === null || measure <= 0)) {
    return { field: "measure", code: "size" };
  }
  if (choices.size === "capacity" && !measures.capacity) {
    return { field: "measure", code: "holds-nothing" };
  }
  const size = measure === null ? {} : { size: sizeOf(choices.size, measure, unit) };
  const sized: Making = {
    product: choices.product,
    ...size,
    ...(shrinkage > 0 ? { shrinkage } : {}),
    ...(choices.union ? { union: true } : {}),
  };
  if (choices.tolerance.trim() === "") return sized;
  const tolerance = numberOf(parseLength(choices.tolerance, "mm"));
  if (tolerance === null || tolerance <= 0) return { field: "tolerance", code: "tolerance" };
  // The library takes it before scaling.
  return { ...sized, tolerance: tolerance / scaleOf(sized, measures, unit).millimetres };
}

/** What the fields say of how a file was made, but for its tolerance, which goes by the size; `walled` is whether there can be a hollow pot. */
export function choicesOf(
  { product, size, shrinkage = 0, union = false }: Making,
  unit: Unit,
  walled: boolean,
): Omit<Choices, "tolerance"> {
  const [kind, measure] = sizeIn(size, unit);
  return {
    product: walled ? (product ?? "pot") : "solid",
    size: kind,
    measure: measure === null ? "" : formatNumber(measure, EXACT),
    shrinkage: shrinkage === 0 ? "" : formatNumber(shrinkage, EXACT),
    ...(union ? { union } : {}),
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
  if (size?.capacity !== undefined) return ["capacity", capacityIn(size.capacity, unit)];
  return ["designed", null];
}

/** The number that stands in the field of a capacity in the cube of this unit. */
export function capacityIn(capacity: number, unit: Unit): number {
  return millilitres(capacity, unit) / capacityUnit(unit).millilitres;
}

/** What was typed, a capacity in millilitres: any unit of volume may stand behind it. */
function measureIn({ size, measure }: Choices, unit: Unit): number | null {
  if (size !== "capacity") return numberOf(parseLength(measure, unit));
  return numberOf(parseVolume(measure, capacityUnit(unit).name));
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

function numberOf(typed: Typed): number | null {
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
