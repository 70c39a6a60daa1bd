/** What makes an open surface a pot: its numbers as a person changes them, and the wall that a pot begins with. */

import { WALL } from "./families.gen";
import type { Path } from "./path";
import { numberAt, setPath } from "./path";
import type { Part, Shape, Wall } from "./types";

/** What the numbers of a wall are told apart by. */
export type WallKey = (typeof WALL)[number]["key"];

/** One number of a wall; all are lengths. */
export interface WallField {
  readonly key: WallKey;
  readonly path: Path;
  /** The end of the slider, as a share of the size of the pot. */
  readonly most: number;
}

const FIELDS: readonly WallField[] = WALL;

/** The numbers of a wall that mean something as it is. */
export function wallFields(wall: Wall, kind: Shape["kind"]): readonly WallField[] {
  const means = (field: WallField) => {
    // What is given all the same can be taken away.
    if (isThickness(kind)) return field.key === "thickness" || wallNumber(wall, field) !== 0;
    if (field.path[0] === "foot") return wall.foot !== undefined;
    return field.key !== "drain" || wall.base > 0;
  };
  return FIELDS.filter(means);
}

export function wallNumber(wall: Wall, field: WallField): number {
  return numberAt(wall, field.path, 0);
}

/** The wall with one number changed; a hole of no width is left out. */
export function withWallNumber(wall: Wall, field: WallField, value: number): Wall {
  return setPath(wall, field.path, field.key === "drain" && value === 0 ? undefined : value);
}

/** How the thickness of a first wall relates to the height or width of its pot. */
const FIRST_THICKNESS = 1 / 25;
/** And a foot ring to that wall. */
const RING_IN_WALLS = 1.5;

/** What a pot of this size begins with; a network has a thickness alone. */
export function firstWall(size: number, kind: Shape["kind"]): Wall {
  const thickness = neat(size * FIRST_THICKNESS);
  return { thickness, base: isThickness(kind) ? 0 : thickness };
}

/** Whether a wall on this is a thickness and a side and no more: patches have no foot and no rim. */
export function isThickness(kind: Shape["kind"]): boolean {
  return kind === "vertex-frame";
}

/** The foot ring that a wall begins with. */
export function firstFoot(wall: Wall): readonly [number, number] {
  return [neat(RING_IN_WALLS * wall.thickness), neat(wall.thickness)];
}

const NEAT = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** The nearest short number. */
function neat(value: number): number {
  if (!(value > 0 && Number.isFinite(value))) return 0.3;
  const power = 10 ** Math.floor(Math.log10(value));
  const best = NEAT.reduce((a, b) => (Math.abs(b * power - value) < Math.abs(a * power - value) ? b : a));
  return Number((best * power).toPrecision(2));
}

/** How long a slider is and how fine its steps are, for a pot of this size: both short numbers. */
export function wallRange(field: WallField, size: number): { readonly max: number; readonly step: number } {
  const max = neat(field.most * size);
  return { max, step: Number((10 ** (Math.floor(Math.log10(max)) - 2)).toPrecision(1)) };
}

/** Whether anything but walls differs between two designs that share what is the same. */
export function sameSurface(a: readonly Part[], b: readonly Part[]): boolean {
  return (
    a.length === b.length && a.every((part, index) => part.shape === b[index]?.shape && part.place === b[index]?.place)
  );
}
