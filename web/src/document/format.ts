/** The files that a pot can be saved as, in the order in which they are offered. */

import type { Format } from "./types";

export const FORMAT_NAMES: readonly Format[] = [
  "3mf",
  "stl",
  "step",
  "svg",
  "a4.svg",
  "letter.svg",
  "glb",
  "obj",
  "obj.zip",
  "ply",
];
