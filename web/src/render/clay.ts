import type { Triple } from "./triple";

/** The clay bodies of the format. */
export type ClayName = "stoneware" | "porcelain" | "terracotta" | "black";

/** A fired clay body as light sees it. Colours are linear reflectances. */
export interface Clay {
  /** Colour of the bare, fired body. */
  colour: Triple;
  /** Colour of the coarse grains in it. */
  grain: Triple;
  /** How much of the grain shows, 0 to 1. */
  grog: number;
  /** Roughness of the bare surface, 0 (mirror) to 1. */
  roughness: number;
}

export const CLAYS: Readonly<Record<ClayName, Clay>> = {
  stoneware: { colour: [0.4, 0.29, 0.195], grain: [0.13, 0.085, 0.055], grog: 0.75, roughness: 0.78 },
  porcelain: { colour: [0.79, 0.765, 0.715], grain: [0.7, 0.66, 0.6], grog: 0.12, roughness: 0.6 },
  terracotta: { colour: [0.47, 0.165, 0.075], grain: [0.3, 0.09, 0.045], grog: 0.4, roughness: 0.85 },
  black: { colour: [0.035, 0.031, 0.029], grain: [0.1, 0.085, 0.075], grog: 0.35, roughness: 0.7 },
};

export const CLAY_NAMES: readonly ClayName[] = ["stoneware", "porcelain", "terracotta", "black"];
