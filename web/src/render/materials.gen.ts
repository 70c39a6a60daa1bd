// Generated from the tables of the Rust crate `pasu` by `PASU_BLESS=1 cargo test -p pasu --features typescript`. Do not edit.

/** Layers of glaze, in linear colours; bare clay has none. */
export const LAYERS = {
  celadon: { tint: [0.4, 0.66, 0.5], body: [0.34, 0.49, 0.39], opacity: 0.62, roughness: 0.1 },
  tenmoku: { tint: [0.1, 0.04, 0.02], body: [0.016, 0.01, 0.008], opacity: 0.95, roughness: 0.09 },
  cobalt: { tint: [0.05, 0.12, 0.5], body: [0.012, 0.035, 0.2], opacity: 0.8, roughness: 0.08 },
  "tin-white": { tint: [0.85, 0.84, 0.8], body: [0.78, 0.765, 0.72], opacity: 0.96, roughness: 0.2 },
  shino: { tint: [0.8, 0.6, 0.42], body: [0.72, 0.64, 0.54], opacity: 0.88, roughness: 0.36 },
  "copper-red": { tint: [0.5, 0.035, 0.025], body: [0.2, 0.012, 0.013], opacity: 0.8, roughness: 0.06 },
  clear: { tint: [0.9, 0.88, 0.8], body: [0.6, 0.6, 0.55], opacity: 0.06, roughness: 0.07 },
  bare: null,
} as const;

/** Fired clay bodies, in linear colours. */
export const BODIES = {
  stoneware: { colour: [0.4, 0.29, 0.195], roughness: 0.78 },
  porcelain: { colour: [0.79, 0.765, 0.715], roughness: 0.6 },
  terracotta: { colour: [0.47, 0.165, 0.075], roughness: 0.85 },
  black: { colour: [0.035, 0.031, 0.029], roughness: 0.7 },
} as const;

/** What is of a colour of one's own: how opaque such a glaze is, and how rough glaze and clay are. */
export const OWN = {
  opacity: 0.9,
  glaze: 0.12,
  clay: 0.75,
} as const;
