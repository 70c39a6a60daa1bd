/** A part is pulled: the shape that follows the hand. */

import { evaluate, type Hand, parse, pulled } from "pasu";
import { type Bump, bumpOf, spreadOf, takesRings } from "../document/brush";
import { curveUnder } from "../document/curves";
import { makingUp, SLOPES } from "../document/locks";
import { isRound, pulledRound, type RadialMove } from "../document/radial-pull";
import { type Hoop, turnedSeries } from "../document/ring-numbers";
import type { Rings, Sent, SentShape, Series, Shape, Triple } from "../document/types";
import { withSlopes } from "./end-slopes";
import { heldMeanwhile } from "./holding-meanwhile";
import type { PullAsk, PulledShape } from "./messages";

export function pulling(ask: PullAsk): PulledShape {
  const followed = following(ask);
  const { hold, shape, at } = ask;
  if (!hold || shape.kind !== "rings" || followed.shape.kind !== "rings") return followed;
  const up = makingUp(followed.shape, hold.locked, at[0]);
  return { ...followed, shape: heldMeanwhile(shape, followed.shape, hold.wall, up) };
}

/** How the shape follows the hand. */
function following(ask: Omit<PullAsk, "hold">): PulledShape {
  const { at, by, brush } = ask;
  const keep = ask.keep.filter((name) => name !== SLOPES);
  const shape = ask.keep.includes(SLOPES) ? withSlopes(ask.shape) : ask.shape;
  const design = alone(shape);
  const [x = 0, y = 0, z = 0] = evaluate(design, 0, at);
  const angle = (x === 0 && y === 0 ? at[1] : Math.atan2(y, x)) + by.round;
  const radius = Math.hypot(x, y) + by.out;
  const to: Triple = [radius * Math.cos(angle), radius * Math.sin(angle), z + by.up];
  // A ring as a whole is turned against its neighbours: there is no bump to be moved.
  if (shape.kind === "rings" && brush.spread === "all" && by.round !== 0 && !keep.includes("v"))
    return turning(shape, { at, by, brush, keep });
  // At several places, and all round, written data are to move away from the axis, not all the same way.
  if (shape.kind === "boundary-value" && brush.spread !== "side" && by.round === 0 && isRound(shape)) {
    const move = { out: keep.includes("x") ? 0 : by.out, up: keep.includes("z") ? 0 : by.up, lean: angle - at[1] };
    const behind = Math.hypot(by.out - move.out, by.up - move.up);
    return { shape: spread(design, at, move, bumpOf(brush)), at, behind };
  }
  const { design: made, ...followed } = pulled(design, 0, {
    at,
    to,
    ...(takesRings(shape) && spreadOf(brush)),
    keep,
  } satisfies Hand);
  const [u = at[0], v = at[1]] = followed.at;
  // Of a ring that is only put there every digit is kept: it changes nothing.
  const still = by.out === 0 && by.up === 0 && by.round === 0;
  return { shape: still ? shapeOf(made) : short(shapeOf(made), u, keep), at: [u, v], behind: followed.behind };
}

function turning(shape: Rings, { at, by, brush, keep }: Omit<PullAsk, "kind" | "shape" | "hold">): PulledShape {
  const followed = following({ kind: "pull", shape, at, by: { ...by, round: 0 }, brush, keep });
  const [u, v] = followed.at;
  const degrees = (by.round * 180) / Math.PI;
  const turned = (ring: Hoop): Hoop => ({
    ...ring,
    r: turnedSeries(ring.r, degrees),
    z: turnedSeries(ring.z, degrees),
  });
  const made = followed.shape as Rings;
  const rings = made.rings.map((ring) => (ring.u === u ? turned(ring) : ring));
  return { ...followed, shape: { ...made, rings }, at: [u, v + by.round] };
}

/** The curve under the hand, put there first where there is none, with a bump along the radius. */
function spread(design: Sent, at: PullAsk["at"], by: RadialMove, bump: Bump): Shape {
  const there = pulled(design, 0, { at, to: evaluate(design, 0, at) });
  const ringed = shapeOf(there.design);
  const curve = curveUnder(ringed, at[0]);
  if (ringed.kind !== "boundary-value" || !curve) return ringed;
  return shapeOf(parse(JSON.stringify(alone(pulledRound(ringed, curve.index, by, bump, at[1])))));
}

/** So many digits of its radius are kept of what a hand has pulled: no hand is finer, and links stay short. */
const DIGITS = 6;

/** A pot of rings with the numbers of one of them shortened, but for those that stay; what goes up and down by less than that is left out. */
function short(shape: Shape, u: number, keep: readonly string[]): Shape {
  if (shape.kind !== "rings") return shape;
  const round = (ring: Hoop): Hoop => {
    const places =
      DIGITS - Math.ceil(Math.log10(Math.max(Math.abs(ring.r.mean), Math.abs(ring.z.mean), Number.MIN_VALUE)));
    return {
      ...ring,
      ...(!keep.includes("r") && { r: rounded(ring.r, places) }),
      ...(!keep.includes("z") && { z: rounded(ring.z, places) }),
    };
  };
  return { ...shape, rings: shape.rings.map((ring) => (ring.u === u ? round(ring) : ring)) };
}

function rounded({ mean, waves = [] }: Series, places: number): Series {
  const to = (value: number) => Number(value.toFixed(Math.min(Math.max(places, 0), 100)));
  const left = waves.flatMap(({ n, cos = 0, sin = 0 }) => {
    const [c, s] = [to(cos), to(sin)];
    return c === 0 && s === 0 ? [] : [{ n, ...(c !== 0 && { cos: c }), ...(s !== 0 && { sin: s }) }];
  });
  return { mean: to(mean), ...(left.length > 0 && { waves: left }) };
}

/** The design of one shape. */
function alone(shape: Shape): Sent {
  return { pasu: 1, parts: [{ shape: shape as SentShape }] };
}

function shapeOf({ parts: [part] }: Sent): Shape {
  return (part as Sent["parts"][number]).shape as Shape;
}
