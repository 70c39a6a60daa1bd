import { BODIES, OWN } from "./materials.gen";
import { type Colour, isColour, linearOf } from "./own-colour";
import type { Triple } from "./triple";

/** The clay bodies of the format. */
export type ClayName = keyof typeof BODIES;

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

/** What only the stage shows of a clay. */
const ON_STAGE: Readonly<Record<ClayName, Pick<Clay, "grain" | "grog">>> = {
  stoneware: { grain: [0.13, 0.085, 0.055], grog: 0.75 },
  porcelain: { grain: [0.7, 0.66, 0.6], grog: 0.12 },
  terracotta: { grain: [0.3, 0.09, 0.045], grog: 0.4 },
  black: { grain: [0.1, 0.085, 0.075], grog: 0.35 },
};

export const CLAY_NAMES = Object.keys(BODIES) as readonly ClayName[];

export const CLAYS = Object.fromEntries(
  CLAY_NAMES.map((name) => [name, { ...BODIES[name], ...ON_STAGE[name] }]),
) as Readonly<Record<ClayName, Clay>>;

/** How coarse the clay of one's own colour is. */
const OWN_GROG = 0.4;
/** How dark the grains in it are. */
const OWN_GRAIN = 0.45;

/** The clay of a name, or of a colour. */
export function clayOf(choice: ClayName | Colour): Clay {
  if (!isColour(choice)) return CLAYS[choice];
  const colour = linearOf(choice);
  const grain = colour.map((channel) => OWN_GRAIN * channel) as unknown as Triple;
  return { colour, grain, grog: OWN_GROG, roughness: OWN.clay };
}
