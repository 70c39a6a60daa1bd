import { type ClayName, clayOf } from "./clay";
import { LAYERS, OWN } from "./materials.gen";
import { type Colour, isColour, linearOf } from "./own-colour";
import type { Triple } from "./triple";

/** The glazes of the format. */
export type GlazeName = keyof typeof LAYERS;

/** How one part of the mesh looks. */
export interface StageLook {
  readonly glaze: GlazeName | Colour;
  readonly inside: GlazeName | Colour;
  /** Where the glaze of the outside ends, as a share of its height; below it the clay is bare. */
  readonly line: number;
  readonly clay: ClayName | Colour;
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

/** What only the stage shows of a glaze. */
const ON_STAGE: Readonly<Record<GlazeName, Omit<Glaze, "tint" | "body" | "opacity" | "roughness" | "coat">>> = {
  celadon: { edge: [0.62, 0.62, 0.5], breaking: 0.55, mottle: 0.3, streak: 0.15, speckle: 0.14 },
  tenmoku: { edge: [0.3, 0.085, 0.022], breaking: 0.95, mottle: 0.35, streak: 0.75, speckle: 0.1 },
  cobalt: { edge: [0.16, 0.24, 0.42], breaking: 0.6, mottle: 0.35, streak: 0.4, speckle: 0.12 },
  "tin-white": { edge: [0.55, 0.45, 0.33], breaking: 0.55, mottle: 0.2, streak: 0.1, speckle: 0.4 },
  shino: { edge: [0.5, 0.17, 0.055], breaking: 0.9, mottle: 0.75, streak: 0.15, speckle: 0.6 },
  "copper-red": { edge: [0.66, 0.56, 0.47], breaking: 0.9, mottle: 0.45, streak: 0.6, speckle: 0.1 },
  clear: { edge: [0.6, 0.5, 0.4], breaking: 0, mottle: 0.15, streak: 0.1, speckle: 0.15 },
  bare: { edge: [1, 1, 1], breaking: 0, mottle: 0, streak: 0, speckle: 0 },
};

/** No layer at all. */
const BARE = { tint: [1, 1, 1], body: [1, 1, 1], opacity: 0, roughness: 1 } as const;

function glaze(name: GlazeName): Glaze {
  const layer = LAYERS[name];
  return { ...(layer ?? BARE), ...ON_STAGE[name], coat: layer ? 1 : 0 };
}

export const GLAZE_NAMES = Object.keys(LAYERS) as readonly GlazeName[];

export const GLAZES = Object.fromEntries(GLAZE_NAMES.map((name) => [name, glaze(name)])) as Readonly<
  Record<GlazeName, Glaze>
>;

/** What only the stage shows of a glaze of one's own colour. */
const OWN_ON_STAGE = { breaking: 0.35, mottle: 0.25, streak: 0.15, speckle: 0.12 } as const;

/** The glaze of a name, or of a colour: an opaque one. */
export function glazeOf(choice: GlazeName | Colour): Glaze {
  if (!isColour(choice)) return GLAZES[choice];
  const colour = linearOf(choice);
  // Where it is thin it is a little paler.
  const edge = colour.map((channel) => 0.12 + 0.8 * channel) as unknown as Triple;
  return { tint: colour, body: colour, edge, opacity: OWN.opacity, roughness: OWN.glaze, coat: 1, ...OWN_ON_STAGE };
}

/** What tells materials apart. */
export function lookKey({ glaze, inside, line, clay }: StageLook): string {
  return [glaze, inside, line, clay].join(" ");
}

/** A plain wall, as files have it: its linear reflectances. */
export function plainColour(glaze: GlazeName | Colour, clay: ClayName | Colour): Triple {
  const { tint, body, opacity } = glazeOf(glaze);
  const { colour } = clayOf(clay);
  const channel = (i: 0 | 1 | 2) => colour[i] * tint[i] * (1 - opacity) + body[i] * opacity;
  return [channel(0), channel(1), channel(2)];
}

/** Reflectances below this are dark: those of copper red are, those of celadon on stoneware are not. */
const DARK = 0.07;

/** Whether a look is so dark that what is drawn over it has to be light. */
export function isDark({ glaze, clay }: Pick<StageLook, "glaze" | "clay">): boolean {
  const [red, green, blue] = plainColour(glaze, clay);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue < DARK;
}
