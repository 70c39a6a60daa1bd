// Generated from the tables of the Rust crate `pasu` by `PASU_BLESS=1 cargo test -p pasu --features typescript`. Do not edit.

/** Of the named families: what holds of a number that is left out, the numbers that count waves, and the interval round the axis. */
export const SHAPES = {
  "second-order": { defaults: { n: [1, 8], height: 3.6, s: [1, 1], t: [0.5, 0.5], force: [0, 0] }, waves: [["n", 0], ["n", 1]], span: 1 },
  "mixed-order": { defaults: { n: [1, 8], height: 3.6, s: [1, 1], t: [0.5, 0.5], force: [0, 0] }, waves: [["n", 0], ["n", 1]], span: 1 },
  "fourth-order": { defaults: {}, waves: [], span: "2pi" },
  "bloor-wilson": { defaults: {}, waves: [["n1"]], span: "2pi" },
} as const;

/** Millimetres in each unit. */
export const UNITS = {
  cm: 10,
  mm: 1,
  in: 25.4,
} as const;

/** The colours by which glazes are chosen. */
export const GLAZES = {
  celadon: "#9dbfa6",
  tenmoku: "#2f1a12",
  cobalt: "#1f3f8f",
  "tin-white": "#f1eee6",
  shino: "#e6c9ae",
  "copper-red": "#8f1f24",
  clear: "#d9cdb8",
  bare: "#b99a76",
} as const;

/** The colours by which clays are chosen. */
export const CLAYS = {
  stoneware: "#a98e6f",
  porcelain: "#efece6",
  terracotta: "#b9613d",
  black: "#38332f",
} as const;

/** What holds where a name is left out. */
export const DEFAULTS = {
  unit: "cm",
  glaze: "celadon",
  clay: "stoneware",
  side: "inside",
  rim: "flat",
} as const;

/** The most of a design: parts, modes of all parts, coefficients of a force, rings between the two ends, patches of a network, characters of a title or name. */
export const LIMITS = {
  parts: 500,
  modes: 4096,
  force: 512,
  rings: 64,
  patches: 100000,
  characters: 200,
} as const;
