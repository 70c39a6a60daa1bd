/** Clay, glaze, unit and theme. */

import type { ClayName, GlazeName, Unit } from "../../document/types";
import { phrases } from "../../language";

export const look = phrases("look", {
  glazes: {
    celadon: "Celadon",
    tenmoku: "Tenmoku",
    cobalt: "Cobalt",
    "tin-white": "Tin white",
    shino: "Shino",
    "copper-red": "Copper red",
    clear: "Clear",
    bare: "No glaze",
  } satisfies Readonly<Record<GlazeName, string>>,
  clays: {
    stoneware: "Stoneware",
    porcelain: "Porcelain",
    terracotta: "Terracotta",
    black: "Black clay",
  } satisfies Readonly<Record<ClayName, string>>,
  units: {
    mm: "millimetre",
    cm: "centimetre",
    in: "inch",
  } satisfies Readonly<Record<Unit, string>>,
  glaze: "Glaze",
  own: "Own colour",
  ownGlaze: "Own colour of the glaze",
  ownInside: "Own colour of the glaze inside",
  ownClay: "Own colour of the clay",
  inside: "Glaze inside",
  asOutside: "As outside",
  line: "Bare foot, up to",
  lineHelp: "Below this share of the height the outside is bare clay: as dipped upside down, or wiped.",
  lineProblem: "A percentage from 0 to 100.",
  clay: "Clay",
  unit: "Unit",
  unitOfLength: "Unit of length",
  /** A unit by its name and its sign. */
  unitChoice: (name: string, sign: string) => `${name} (${sign})`,
  staysAsLarge: "The pot stays as large as it is; its numbers are converted.",
});
