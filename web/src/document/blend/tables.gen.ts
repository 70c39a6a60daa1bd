// Generated from the tables of the Rust crate `pasu` by `PASU_BLESS=1 cargo test -p pasu --features typescript`. Do not edit.

/** The numbers of a section. */
export const SECTION = [
  { key: "radius-0", path: ["radius", 0], symbol: "r_x", dimension: "length", min: 0, max: 3, step: 0.01 },
  { key: "radius-1", path: ["radius", 1], symbol: "r_y", dimension: "length", min: 0, max: 3, step: 0.01 },
  { key: "z", path: ["z"], symbol: "z", dimension: "length", min: 0, max: 6, step: 0.05 },
  { key: "taper", path: ["taper"], symbol: "κ", dimension: "one", min: -2, max: 2, step: 0.01 },
  { key: "dz", path: ["dz"], symbol: "z'", dimension: "length", min: -10, max: 10, step: 0.1 },
] as const;

/** The weights of the equation, 1 where none are given. */
export const WEIGHTS = [
  { key: "weights-0", path: ["weights", 0], symbol: "a", dimension: "one", min: 0.001, max: 1, step: 0.001 },
  { key: "weights-1", path: ["weights", 1], symbol: "b", dimension: "one", min: 0.001, max: 1, step: 0.001 },
  { key: "weights-2", path: ["weights", 2], symbol: "c", dimension: "one", min: 0.001, max: 1, step: 0.001 },
] as const;

/** Terms along u, v and w: those that hold where none are given, and the most. */
export const TERMS = {
  usual: [4, 4, 3],
  most: [256, 256, 64],
} as const;

/** How the equation can be solved. */
export const METHODS = ["exact", "modal", "collocation"] as const;
