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

/** Half of how far it is from where the first of tangents stands to where the one over against it does, at the other end half way round: they are as many at one end as at the other. */
export function reachOf(tangents: readonly { at: Float32Array }[]): number {
  const [from, to] = [tangents[0]?.at, tangents[0.75 * tangents.length]?.at];
  return from && to ? Math.hypot(...from.map((x, i) => x - at(to, i))) / 2 : 0;
}
