/** What is made of some parts of a design, and what is said of these, by their places in the whole. */

import { PasuError } from "pasu";
import type { Sent } from "../document/types";
import type { SolidArrays } from "./solid";

/** The part that a path begins at. */
const PART = /^parts\[(\d+)\]/;

export function ofSome<T extends SolidArrays>(design: Sent, places: readonly number[], make: (some: Sent) => T): T {
  const placeOf = (part: number) => places[part] ?? part;
  const parts = places.flatMap((place) => design.parts[place] ?? []);
  try {
    const made = make({ ...design, parts });
    return { ...made, faces: made.faces.map((face) => ({ ...face, part: placeOf(face.part) })) };
  } catch (error) {
    if (!(error instanceof PasuError)) throw error;
    const path = error.path.replace(PART, (_, part: string) => `parts[${placeOf(Number(part))}]`);
    throw Object.assign(error, { path });
  }
}
