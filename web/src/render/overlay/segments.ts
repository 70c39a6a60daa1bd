import { at } from "../triple";

/** The pieces of polylines (xyz triples), six numbers a piece. */
export function ofPolylines(lines: readonly Float32Array[]): Float32Array {
  let count = 0;
  for (const line of lines) count += Math.max(0, Math.floor(line.length / 3) - 1);
  const out = new Float32Array(6 * count);
  let k = 0;
  for (const line of lines) {
    for (let i = 3; i + 2 < line.length; i += 3, k += 6) {
      out.set(line.subarray(i - 3, i), k);
      out.set(line.subarray(i, i + 3), k + 3);
    }
  }
  return out;
}

/** Beyond this many indices the search for the boundary costs more memory than a few edges at the rim are worth. */
const LARGE = 6_000_000;

/** The edges of all triangles, each once, as pairs of vertices. Of very large meshes some edges on the boundary are left out. */
export function edgesOf(indices: Uint32Array): Uint32Array {
  const pairs: number[] = [];
  const large = indices.length > LARGE;
  const upward = new Set<number>();
  // An edge inside a surface is met in both directions and taken in the one that goes up. One that goes down is taken when
  // its twin never comes: it is on the boundary.
  for (const up of [true, false]) {
    for (let t = 0; t < indices.length; t += 3) {
      for (let side = 0; side < 3; side++) {
        const a = at(indices, t + side);
        const b = at(indices, t + ((side + 1) % 3));
        if (a === b || up !== a < b) continue;
        if (!large) {
          if (up) upward.add(a * KEY + b);
          else if (upward.has(b * KEY + a)) continue;
        } else if (!up) continue;
        pairs.push(a, b);
      }
    }
  }
  return new Uint32Array(pairs);
}

/** Larger than any number of vertices (the format allows 16 million), and its square is still a whole number in a double. */
const KEY = 2 ** 26;

/**
 * Arrows: a shaft of a length along each direction, and two barbs at its tip, in the plane of the shaft and the vertical. A direction
 * without length gives none.
 */
export function ofArrows(tangents: readonly { at: Float32Array; along: Float32Array }[], length: number): Float32Array {
  const out: number[] = [];
  for (const { at: from, along: way } of tangents) {
    const size = Math.hypot(at(way, 0), at(way, 1), at(way, 2));
    if (!(size > 0 && Number.isFinite(size))) continue;
    const d = [at(way, 0) / size, at(way, 1) / size, at(way, 2) / size] as const;
    const tip = [0, 1, 2].map((k) => at(from, k) + length * at(d, k));
    out.push(at(from, 0), at(from, 1), at(from, 2), at(tip, 0), at(tip, 1), at(tip, 2));
    // A vector across the shaft: horizontal for steep shafts, vertical for level ones.
    const steep = Math.abs(d[2]) > 0.7;
    const up = steep ? ([1, 0, 0] as const) : ([0, 0, 1] as const);
    const lean = d[0] * up[0] + d[1] * up[1] + d[2] * up[2];
    const across = [0, 1, 2].map((k) => at(up, k) - lean * at(d, k));
    const unit = Math.hypot(at(across, 0), at(across, 1), at(across, 2));
    for (const sign of [-1, 1]) {
      out.push(at(tip, 0), at(tip, 1), at(tip, 2));
      for (let k = 0; k < 3; k++)
        out.push(at(tip, k) - length * (0.24 * at(d, k) + (sign * 0.13 * at(across, k)) / unit));
    }
  }
  return new Float32Array(out);
}
