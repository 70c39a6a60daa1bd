// The pot that tests of the page begin with, as a surface and with a wall.

import { designOf } from "../src/document/gallery/exhibit";
import { FIRST } from "../src/document/gallery/first";
import { setPath } from "../src/document/path";
import type { Design, Wall } from "../src/document/types";
import { page } from "../src/words/english/page";

export const JAR: Design = designOf(FIRST, page.firstPot);

/** So thin that it fits in every form of the jar. */
export const WALL: Wall = { thickness: 0.3, base: 0.3 };

export const POT: Design = setPath(JAR, ["parts", 0, "wall"], WALL);

/** The same with another height. */
export function tall(design: Design, height: number): Design {
  return setPath(design, ["parts", 0, "shape", "h1"], height);
}
