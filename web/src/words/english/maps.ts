/** The colour maps. */

import type { MapName } from "../../document/types";
import { phrases } from "../../language";

export const maps = phrases("maps", {
  names: {
    "mean-curvature": "Mean curvature",
    "gaussian-curvature": "Gaussian curvature",
    thickness: "Wall thickness",
    overhang: "Overhang",
  } satisfies Readonly<Record<MapName, string>>,
  /** What the ends of the colours mean. */
  notes: {
    "mean-curvature": "Blue is hollow, orange bulges.",
    "gaussian-curvature": "Blue is a saddle, orange a dome.",
    thickness: "Violet is thin, yellow thick.",
    overhang:
      "From upright, where it faces down, outside and inside: above 45° a printer needs support. What it stands on is grey.",
  } satisfies Readonly<Record<MapName, string>>,
  /** Where all values are on one side of the middle. */
  rises: "Violet is least, yellow most.",
  show: "Colours show",
  glaze: "the glaze",
  /** The same as a choice that goes on from there. */
  options: {
    "mean-curvature": "mean curvature",
    "gaussian-curvature": "gaussian curvature",
    thickness: "wall thickness",
    overhang: "overhang",
  } satisfies Readonly<Record<MapName, string>>,
  needsWall: (map: string) => `${map} (needs a wall)`,
  colours: (map: string, low: string, high: string) => `${map}: colours from ${low} to ${high}`,
  onPot: (note: string, least: string, greatest: string) => `${note} On this pot: ${least} to ${greatest}.`,
  onOutside: (note: string, least: string, greatest: string) => `${note} On the outside: ${least} to ${greatest}.`,
  /** Of a wall that is as thick inside as outside, only that it is coloured there too. */
  inside: (least: string, greatest: string) => `Inside: ${least} to ${greatest}, as the wall moves the outside in.`,
  insideSame: "Inside the colours are the same: of the wall at that place.",
  insideSeen: "Seen through the mouth, or cut open. The rim, the floor and what the pot stands on are grey.",
  notInside: "The inside is grey: there is no wall of an even thickness before it.",
});
