// Generated from the tables of the Rust crate `pasu` by `PASU_BLESS=1 cargo test -p pasu --features typescript`. Do not edit.

/** What of a pot a number is about, in the order in which they are shown. */
export const GROUPS = ["rim", "foot", "height", "wall", "equation", "force"] as const;

/** The numbers of the named families, and what each starts from. */
export const FAMILIES = {
  "second-order": {
    fields: [
      { key: "r-0", path: ["r", 0], symbol: "r_1", group: "rim", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "r-1", path: ["r", 1], symbol: "r_2", group: "rim", dimension: "length", min: -0.5, max: 0.5, step: 0.005 },
      { key: "r-2", path: ["r", 2], symbol: "r_3", group: "foot", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "r-3", path: ["r", 3], symbol: "r_4", group: "foot", dimension: "length", min: -0.5, max: 0.5, step: 0.005 },
      { key: "height", path: ["height"], symbol: "h_0", group: "height", dimension: "length", min: 0.2, max: 10, step: 0.05 },
      { key: "n-1", path: ["n", 1], symbol: "n_2", group: "wall", dimension: "waves", min: 0, max: 24, step: 1 },
      { key: "n-0", path: ["n", 0], symbol: "n_1", group: "wall", dimension: "waves", min: 1, max: 4, step: 1 },
      { key: "t-0", path: ["t", 0], symbol: "t_x", group: "equation", dimension: "one", min: 0, max: 2, step: 0.01, pair: "t" },
      { key: "t-1", path: ["t", 1], symbol: "t_y", group: "equation", dimension: "one", min: 0, max: 2, step: 0.01, pair: "t" },
      { key: "s-0", path: ["s", 0], symbol: "s_x", group: "equation", dimension: "one", min: 0.1, max: 10, step: 0.05, pair: "s" },
      { key: "s-1", path: ["s", 1], symbol: "s_y", group: "equation", dimension: "one", min: 0.1, max: 10, step: 0.05, pair: "s" },
      { key: "force-0", path: ["force", 0], symbol: "p_0", group: "force", dimension: "one", min: -5, max: 5, step: 0.05 },
      { key: "force-1", path: ["force", 1], symbol: "p_1", group: "force", dimension: "one", min: -5, max: 5, step: 0.05 },
    ],
    reset: { kind: "second-order", r: [1, 0.1, 0.6, 0.06] },
  },
  "mixed-order": {
    fields: [
      { key: "r-0", path: ["r", 0], symbol: "r_1", group: "rim", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "r-1", path: ["r", 1], symbol: "r_2", group: "rim", dimension: "length", min: -0.5, max: 0.5, step: 0.005 },
      { key: "r-2", path: ["r", 2], symbol: "r_3", group: "foot", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "r-3", path: ["r", 3], symbol: "r_4", group: "foot", dimension: "length", min: -0.5, max: 0.5, step: 0.005 },
      { key: "height", path: ["height"], symbol: "h_0", group: "height", dimension: "length", min: 0.2, max: 10, step: 0.05 },
      { key: "n-1", path: ["n", 1], symbol: "n_2", group: "wall", dimension: "waves", min: 0, max: 24, step: 1 },
      { key: "n-0", path: ["n", 0], symbol: "n_1", group: "wall", dimension: "waves", min: 1, max: 4, step: 1 },
      { key: "t-0", path: ["t", 0], symbol: "t_x", group: "equation", dimension: "one", min: 0, max: 2, step: 0.01, pair: "t" },
      { key: "t-1", path: ["t", 1], symbol: "t_y", group: "equation", dimension: "one", min: 0, max: 2, step: 0.01, pair: "t" },
      { key: "s-0", path: ["s", 0], symbol: "s_x", group: "equation", dimension: "one", min: 0.1, max: 10, step: 0.05, pair: "s" },
      { key: "s-1", path: ["s", 1], symbol: "s_y", group: "equation", dimension: "one", min: 0.1, max: 10, step: 0.05, pair: "s" },
      { key: "force-0", path: ["force", 0], symbol: "p_0", group: "force", dimension: "one", min: -5, max: 5, step: 0.05 },
      { key: "force-1", path: ["force", 1], symbol: "p_1", group: "force", dimension: "one", min: -5, max: 5, step: 0.05 },
      { key: "rise", path: ["rise"], symbol: "h_0'", group: "rim", dimension: "length", min: -20, max: 20, step: 0.1 },
    ],
    reset: { kind: "mixed-order", r: [1, 0.1, 0.6, 0.06], rise: -10 },
  },
  "fourth-order": {
    fields: [
      { key: "r1", path: ["r1"], symbol: "r_1", group: "rim", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "eta-1", path: ["eta", 1], symbol: "η_2", group: "rim", dimension: "one", min: -5, max: 5, step: 0.05 },
      { key: "dz-1", path: ["dz", 1], symbol: "h_1'", group: "rim", dimension: "length", min: -15, max: 15, step: 0.1 },
      { key: "r0", path: ["r0"], symbol: "r_0", group: "foot", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "eta-0", path: ["eta", 0], symbol: "η_1", group: "foot", dimension: "one", min: -5, max: 5, step: 0.05 },
      { key: "dz-0", path: ["dz", 0], symbol: "h_0'", group: "foot", dimension: "length", min: -15, max: 15, step: 0.1 },
      { key: "h1", path: ["h1"], symbol: "h_1", group: "height", dimension: "length", min: 0.2, max: 10, step: 0.05 },
      { key: "rm", path: ["rm"], symbol: "r_m", group: "wall", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "t-0", path: ["t", 0], symbol: "t_x", group: "equation", dimension: "one", min: 0, max: 60, step: 0.5, pair: "t" },
      { key: "t-1", path: ["t", 1], symbol: "t_y", group: "equation", dimension: "one", min: 0, max: 60, step: 0.5, pair: "t" },
      { key: "w-0", path: ["w", 0], symbol: "w_x", group: "equation", dimension: "one", min: 0, max: 200, step: 1, pair: "w" },
      { key: "w-1", path: ["w", 1], symbol: "w_y", group: "equation", dimension: "one", min: 0, max: 200, step: 1, pair: "w" },
      { key: "s-0", path: ["s", 0], symbol: "s_x", group: "equation", dimension: "one", min: 0.1, max: 10, step: 0.05, pair: "s" },
      { key: "s-1", path: ["s", 1], symbol: "s_y", group: "equation", dimension: "one", min: 0.1, max: 10, step: 0.05, pair: "s" },
    ],
    reset: { kind: "fourth-order", r0: 0.4, r1: 0.3, rm: 0.8, h1: 2, eta: [0.5, 0.5], dz: [6, 6], s: [1, 1], t: [3, 3], w: [1, 1] },
  },
  "bloor-wilson": {
    fields: [
      { key: "r-0", path: ["r", 0], symbol: "r_1", group: "rim", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "R-0", path: ["R", 0], symbol: "R_1", group: "rim", dimension: "length", min: -10, max: 10, step: 0.05 },
      { key: "H-0", path: ["H", 0], symbol: "H_0", group: "rim", dimension: "length", min: -10, max: 10, step: 0.05 },
      { key: "n1", path: ["n1"], symbol: "n_1", group: "rim", dimension: "waves", min: 0, max: 20, step: 1 },
      { key: "h-1", path: ["h", 1], symbol: "h_1", group: "rim", dimension: "length", min: -2, max: 2, step: 0.01 },
      { key: "H-1", path: ["H", 1], symbol: "H_1", group: "rim", dimension: "length", min: -5, max: 5, step: 0.05 },
      { key: "r-1", path: ["r", 1], symbol: "r_2", group: "rim", dimension: "length", min: -1, max: 1, step: 0.01 },
      { key: "r-2", path: ["r", 2], symbol: "r_3", group: "rim", dimension: "length", min: -1, max: 1, step: 0.01 },
      { key: "r-3", path: ["r", 3], symbol: "r_4", group: "foot", dimension: "length", min: 0, max: 3, step: 0.01 },
      { key: "R-3", path: ["R", 3], symbol: "R_4", group: "foot", dimension: "length", min: -10, max: 10, step: 0.05 },
      { key: "h-0", path: ["h", 0], symbol: "h_0", group: "height", dimension: "length", min: 0.2, max: 10, step: 0.05 },
      { key: "R-1", path: ["R", 1], symbol: "R_2", group: "wall", dimension: "length", min: -5, max: 5, step: 0.05 },
      { key: "R-2", path: ["R", 2], symbol: "R_3", group: "wall", dimension: "length", min: -5, max: 5, step: 0.05 },
      { key: "a", path: ["a"], symbol: "a", group: "equation", dimension: "one", min: 0, max: 15, step: 0.01 },
    ],
    reset: { kind: "bloor-wilson", a: 0.01, r: [1, 0.1, 0.1, 0.8], R: [-3, -0.5, -0.5, 2], h: [3, 0.3], H: [-0.5, -0.7], n1: 1 },
  },
} as const;

/** What can be prescribed of a harmonic, by the order of its component. */
export const DATA = {
  2: ["start", "end"],
  4: ["start", "end", "start_u", "end_u"],
} as const;

/** The numbers of a wall. All are lengths, from 0 to so much of the size of the pot. */
export const WALL = [
  { key: "thickness", path: ["thickness"], most: 0.2 },
  { key: "base", path: ["base"], most: 0.2 },
  { key: "foot-0", path: ["foot", 0], most: 0.2 },
  { key: "foot-1", path: ["foot", 1], most: 0.2 },
  { key: "drain", path: ["drain"], most: 0.4 },
] as const;
