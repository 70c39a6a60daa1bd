// A network of patches side by side, so many that only what moves of it is sent.

import type { Design, Triple } from "../src/document/types";

export function stripOf(count: number): Design {
  const vertices: Triple[] = [];
  const patches = [];
  for (let column = 0; column <= 2 * count; column += 1)
    for (const row of column % 2 === 0 ? [0, 1, 2] : [0, 2]) vertices.push([column, row, 0]);
  for (let patch = 0; patch < count; patch += 1) {
    const at = 5 * patch;
    patches.push({ frame: [0, 3, 5, 6, 7, 4, 2, 1].map((place) => at + place) as unknown as Frame });
  }
  return { pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices, patches } }] };
}

type Frame = readonly [number, number, number, number, number, number, number, number];
