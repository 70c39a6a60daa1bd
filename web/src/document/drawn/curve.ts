/** The line through knots: smooth between corners, as a centripetal spline of Catmull and Rom (Yuksel et al. 2011), which has no loops and cusps of its own. */

import { between, type Knot, type Spot } from "./knot";

/** Pieces are no longer than this. */
const STEP = 1.5;
const MOST_PIECES = 200;

export function curveThrough(knots: readonly Knot[]): readonly Spot[] {
  const line: Spot[] = [];
  const apart = knots.filter((knot, i) => i === 0 || between(knot, knots[i - 1] as Knot) > 0);
  for (let i = 0; i + 1 < apart.length; i += 1) {
    const [a, b] = [apart[i] as Knot, apart[i + 1] as Knot];
    // At an end and at a corner the line goes on as it comes: the neighbour is mirrored.
    const before = a.sharp || i === 0 ? beyond(a, b) : (apart[i - 1] as Knot);
    const after = b.sharp || i + 2 === apart.length ? beyond(b, a) : (apart[i + 2] as Knot);
    const straight = (a.sharp || i === 0) && (b.sharp || i + 2 === apart.length);
    const pieces = straight ? 1 : Math.min(MOST_PIECES, Math.max(1, Math.ceil(between(a, b) / STEP)));
    for (let piece = 0; piece < pieces; piece += 1) line.push(at(before, a, b, after, piece / pieces));
  }
  const last = apart.at(-1);
  if (last) line.push({ x: last.x, y: last.y });
  return line;
}

function beyond(here: Spot, from: Spot): Spot {
  return { x: 2 * here.x - from.x, y: 2 * here.y - from.y };
}

/** By the pyramid of Barry and Goldman, from b at 0 to c at 1. */
function at(a: Spot, b: Spot, c: Spot, d: Spot, share: number): Spot {
  const t1 = Math.sqrt(between(a, b));
  const t2 = t1 + Math.sqrt(between(b, c));
  const t3 = t2 + Math.sqrt(between(c, d));
  const t = t1 + share * (t2 - t1);
  const mix = (p: Spot, q: Spot, from: number, to: number): Spot => {
    const part = (t - from) / (to - from);
    return { x: p.x + part * (q.x - p.x), y: p.y + part * (q.y - p.y) };
  };
  const [ab, bc, cd] = [mix(a, b, 0, t1), mix(b, c, t1, t2), mix(c, d, t2, t3)];
  return mix(mix(ab, bc, 0, t2), mix(bc, cd, t1, t3), t1, t2);
}
