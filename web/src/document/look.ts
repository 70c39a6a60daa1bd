/** Glazes, clays and units: their names in the document and for people. */

import { DEFAULTS } from "./tables.gen";
import type { ClayName, Design, GlazeName, Look, Part, Unit } from "./types";

export const GLAZES: Readonly<Record<GlazeName, string>> = {
  celadon: "Celadon",
  tenmoku: "Tenmoku",
  cobalt: "Cobalt",
  "tin-white": "Tin white",
  shino: "Shino",
  "copper-red": "Copper red",
  clear: "Clear",
  bare: "No glaze",
};

export const CLAYS: Readonly<Record<ClayName, string>> = {
  stoneware: "Stoneware",
  porcelain: "Porcelain",
  terracotta: "Terracotta",
  black: "Black clay",
};

export const UNITS: Readonly<Record<Unit, string>> = {
  mm: "millimetre",
  cm: "centimetre",
  in: "inch",
};

/** Both names of a part's look, defaults included. */
export function lookOf(part: Part | undefined): Required<Look> {
  return {
    glaze: part?.look?.glaze ?? DEFAULTS.glaze,
    clay: part?.look?.clay ?? DEFAULTS.clay,
  };
}

export function looksOf(design: Design): readonly Required<Look>[] {
  return design.parts.map(lookOf);
}

export function unitOf(design: Design): Unit {
  return design.unit ?? DEFAULTS.unit;
}
