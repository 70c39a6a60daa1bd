import type { ClayName } from "./clay";
import type { Triple } from "./triple";

/** The glazes of the format. */
export type GlazeName = "celadon" | "tenmoku" | "cobalt" | "tin-white" | "shino" | "copper-red" | "clear" | "bare";

/** How one part of the mesh looks. */
export interface StageLook {
  glaze: GlazeName;
  clay: ClayName;
}

/**
 * A glaze as light sees it: a layer of coloured glass over the clay whose thickness varies (thin on edges and the rim, pooled in
 * hollows). Colours are linear.
 */
export interface Glaze {
  /** What a layer of thickness 1 lets through, there and back: the colour of the glass. */
  tint: Triple;
  /** What is scattered inside the layer: the colour of an opaque glaze. */
  body: Triple;
  /** How opaque a layer of thickness 1 is, 0 (glass) to 1. */
  opacity: number;
  /** Colour where the glaze breaks, that is where it is thin over an edge. */
  edge: Triple;
  /** How strongly it breaks to that colour, 0 to 1. */
  breaking: number;
  /** How much the thickness varies over a plain wall, 0 to 1. */
  mottle: number;
  /** How much the variation is drawn out downwards, as runny glazes are, 0 to 1. */
  streak: number;
  /** Iron spots and pinholes, 0 to 1. */
  speckle: number;
  /** Roughness of the surface, 0 (mirror) to 1. */
  roughness: number;
  /** Whether there is any glaze: 1, or 0 for bare clay. */
  coat: number;
}

export const GLAZES: Readonly<Record<GlazeName, Glaze>> = {
  celadon: {
    tint: [0.4, 0.66, 0.5],
    body: [0.34, 0.49, 0.39],
    opacity: 0.62,
    edge: [0.62, 0.62, 0.5],
    breaking: 0.55,
    mottle: 0.3,
    streak: 0.15,
    speckle: 0.14,
    roughness: 0.1,
    coat: 1,
  },
  tenmoku: {
    tint: [0.1, 0.04, 0.02],
    body: [0.016, 0.01, 0.008],
    opacity: 0.95,
    edge: [0.3, 0.085, 0.022],
    breaking: 0.95,
    mottle: 0.35,
    streak: 0.75,
    speckle: 0.1,
    roughness: 0.09,
    coat: 1,
  },
  cobalt: {
    tint: [0.05, 0.12, 0.5],
    body: [0.012, 0.035, 0.2],
    opacity: 0.8,
    edge: [0.16, 0.24, 0.42],
    breaking: 0.6,
    mottle: 0.35,
    streak: 0.4,
    speckle: 0.12,
    roughness: 0.08,
    coat: 1,
  },
  "tin-white": {
    tint: [0.85, 0.84, 0.8],
    body: [0.78, 0.765, 0.72],
    opacity: 0.96,
    edge: [0.55, 0.45, 0.33],
    breaking: 0.55,
    mottle: 0.2,
    streak: 0.1,
    speckle: 0.4,
    roughness: 0.2,
    coat: 1,
  },
  shino: {
    tint: [0.8, 0.6, 0.42],
    body: [0.72, 0.64, 0.54],
    opacity: 0.88,
    edge: [0.5, 0.17, 0.055],
    breaking: 0.9,
    mottle: 0.75,
    streak: 0.15,
    speckle: 0.6,
    roughness: 0.36,
    coat: 1,
  },
  "copper-red": {
    tint: [0.5, 0.035, 0.025],
    body: [0.2, 0.012, 0.013],
    opacity: 0.8,
    edge: [0.66, 0.56, 0.47],
    breaking: 0.9,
    mottle: 0.45,
    streak: 0.6,
    speckle: 0.1,
    roughness: 0.06,
    coat: 1,
  },
  clear: {
    tint: [0.9, 0.88, 0.8],
    body: [0.6, 0.6, 0.55],
    opacity: 0.06,
    edge: [0.6, 0.5, 0.4],
    breaking: 0,
    mottle: 0.15,
    streak: 0.1,
    speckle: 0.15,
    roughness: 0.07,
    coat: 1,
  },
  bare: {
    tint: [1, 1, 1],
    body: [1, 1, 1],
    opacity: 0,
    edge: [1, 1, 1],
    breaking: 0,
    mottle: 0,
    streak: 0,
    speckle: 0,
    roughness: 1,
    coat: 0,
  },
};

export const GLAZE_NAMES: readonly GlazeName[] = [
  "celadon",
  "tenmoku",
  "cobalt",
  "tin-white",
  "shino",
  "copper-red",
  "clear",
  "bare",
];

/** Whether a look is so dark that what is drawn over it has to be light. */
export function isDark(look: StageLook): boolean {
  const dark: readonly GlazeName[] = ["tenmoku", "cobalt", "copper-red"];
  return dark.includes(look.glaze) || (look.clay === "black" && (look.glaze === "bare" || look.glaze === "clear"));
}
