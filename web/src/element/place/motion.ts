/** What becomes of placed parts when a hand drags one of their handles: from pixels to a motion, and from a motion to placements. */

import { roundTo } from "../../document/boxes";
import { type Axis, moved, resized, scaledBy, sum, turned, unit } from "../../document/moving";
import type { WholePlacement } from "../../document/placement";
import type { Triple } from "../../document/types";
import { across, alongLine, inPlane } from "../../render/place/onto";
import type { See, Spot } from "../../render/pull/reach";
import type { PartId } from "../../state/part-ids";
import type { Held } from "../../work/held";

/** What a hand holds. */
export type Grip =
  | { readonly kind: "free" }
  | { readonly kind: "move"; readonly axis: Axis }
  | { readonly kind: "turn"; readonly axis: Axis }
  /** Along an axis of the part's own, or all of it. */
  | { readonly kind: "scale"; readonly axis: Axis | null };

/** What becomes of all parts that are held. Angles are in radians. */
export type Motion =
  | { readonly kind: "move"; readonly by: Triple; readonly onTable: boolean }
  | { readonly kind: "turn"; readonly axis: Axis; readonly angle: number }
  | { readonly kind: "scale"; readonly axis: Axis | null; readonly factor: number };

/** Parts as they stood when a hand took hold of them. */
export interface Hold extends Held {
  readonly grip: Grip;
  readonly see: See;
  /** Where the handle was seen, on the stage. */
  readonly spot: Spot;
  /** How far from the middle handles stand. */
  readonly reach: number;
  /** Whether this one stands on the other side, away from where it makes things grow. */
  readonly isBehind: boolean;
  /** The own axis along which it is scaled. */
  readonly along: Triple | null;
}

/** In which steps a hand moves. */
export interface Steps {
  readonly length: number;
  /** In degrees. */
  readonly angle: number;
  readonly factor: number;
}

export const DEGREE = Math.PI / 180;
/** Where nothing else is asked for: what a hand can just do. */
const FINE = { angle: 0.5, factor: 0.01 };
/** What is so near to the table, in steps, comes to stand on it. */
const NEAR_TABLE = 0.6;
const ROUND = 48;

/** The motion by which what is held follows a hand; null where that cannot be seen from here. */
export function motionOf(hold: Hold, by: Spot, steps: Steps | null): Motion | null {
  switch (hold.grip.kind) {
    case "free":
      return overTable(hold, by, steps);
    case "move": {
      const { axis } = hold.grip;
      const far = alongLine(hold.see, hold.pivot, unit(axis), hold.reach, seenAt(hold, by));
      return far === null ? null : alongAxis(hold, axis, far, steps);
    }
    case "turn": {
      const { axis } = hold.grip;
      const angle = angleOf(hold, axis, by);
      const step = (steps ?? FINE).angle;
      return angle === null ? null : { kind: "turn", axis, angle: roundTo(angle / DEGREE, step) * DEGREE };
    }
    case "scale":
      return scaling(hold, hold.grip.axis, by, steps);
  }
}

/** Where the parts stand after a motion. */
export function placesAfter({ places, pivot, low }: Held, motion: Motion): ReadonlyMap<PartId, WholePlacement> {
  const foot: Triple = [pivot[0], pivot[1], low];
  const each = (place: WholePlacement): WholePlacement => {
    switch (motion.kind) {
      case "move":
        return moved(place, motion.by);
      case "turn":
        return turned(place, unit(motion.axis), motion.angle, pivot);
      case "scale":
        return resized(place, motion.axis, motion.factor, foot);
    }
  };
  return new Map([...places].map(([id, place]) => [id, each(place)]));
}

/** How far something goes up or down to stand on a table: the digits of a mesh, not those of its noise. */
export function toTable(low: number, table: number, size: number): number {
  return roundTo(table - low, 10 ** (Math.floor(Math.log10(size || 1)) - 6));
}

/** Where the middle would be seen if it had gone with the hand. */
function seenAt({ see, pivot, spot }: Hold, by: Spot): Spot {
  const { x, y } = see(pivot) ?? spot;
  return { x: x + by.x, y: y + by.y };
}

/** The least length that a hand can tell: not more than a pixel. */
function finest({ see, pivot, reach }: Hold): number {
  return 10 ** Math.floor(Math.log10(reach / across(see, pivot, reach)));
}

/** Along an axis, so that the number of the part that was selected last becomes round. */
function alongAxis(hold: Hold, axis: Axis, far: number, steps: Steps | null): Motion {
  const by = (amount: number, onTable = false): Motion => ({ kind: "move", by: scaledBy(amount, unit(axis)), onTable });
  if (axis === 2 && steps && Math.abs(hold.low + far - hold.table) < NEAR_TABLE * steps.length) {
    return by(toTable(hold.low, hold.table, hold.reach), true);
  }
  return by(rounded(hold, axis, far, steps));
}

function rounded(hold: Hold, axis: Axis, far: number, steps: Steps | null): number {
  const lead = [...hold.places.values()].at(-1)?.shift[axis] ?? 0;
  return steps ? roundTo(roundTo(lead + far, steps.length) - lead, steps.length * 1e-6) : roundTo(far, finest(hold));
}

function overTable(hold: Hold, by: Spot, steps: Steps | null): Motion | null {
  const spot = seenAt(hold, by);
  const found = inPlane(hold.see, hold.pivot, [unit(0), unit(1)], hold.reach, spot);
  if (found) {
    const [x, y] = found.map((far, axis) => rounded(hold, axis as Axis, far, steps)) as [number, number];
    return { kind: "move", by: [x, y, 0], onTable: false };
  }
  // The table is seen edge on: along it there is one way left and right.
  const here = hold.see(hold.pivot);
  const ways = ([0, 1] as const).map((axis) => {
    const there = hold.see(sum(hold.pivot, scaledBy(hold.reach, unit(axis))));
    return { axis, seen: here && there ? Math.abs(there.x - here.x) : 0 };
  });
  const axis: Axis = (ways[0]?.seen ?? 0) >= (ways[1]?.seen ?? 0) ? 0 : 1;
  const far = alongLine(hold.see, hold.pivot, unit(axis), hold.reach, spot);
  return far === null ? null : alongAxis(hold, axis, far, steps);
}

/** Two directions square to an axis, so that from one to the other is anti-clockwise. */
function squareTo(axis: Axis): readonly [Triple, Triple] {
  return [unit(((axis + 1) % 3) as Axis), unit(((axis + 2) % 3) as Axis)];
}

/** A point of the ring round an axis through the middle. */
export function onRing(pivot: Triple, radius: number, axis: Axis, angle: number): Triple {
  const [a, b] = squareTo(axis);
  return sum(pivot, sum(scaledBy(radius * Math.cos(angle), a), scaledBy(radius * Math.sin(angle), b)));
}

/** By what angle what is held follows a hand that holds the ring of an axis. */
function angleOf(hold: Hold, axis: Axis, by: Spot): number | null {
  const { see, pivot, reach, spot } = hold;
  const angleAt = (at: Spot) => {
    const found = inPlane(see, pivot, squareTo(axis), reach, at);
    return found && Math.atan2(found[1], found[0]);
  };
  const [from, to] = [angleAt(spot), angleAt({ x: spot.x + by.x, y: spot.y + by.y })];
  if (from !== null && to !== null) return Math.atan2(Math.sin(to - from), Math.cos(to - from));
  // The ring is seen edge on: a hand rolls it where it is nearest.
  const angles = Array.from({ length: ROUND }, (_, i) => (2 * Math.PI * i) / ROUND);
  const depth = (angle: number) => see(onRing(pivot, reach, axis, angle))?.depth ?? Number.POSITIVE_INFINITY;
  const front = angles.reduce((best, angle) => (depth(angle) < depth(best) ? angle : best), 0);
  const step = 0.01;
  const [a, b] = [see(onRing(pivot, reach, axis, front)), see(onRing(pivot, reach, axis, front + step))];
  if (!a || !b) return null;
  const [dx, dy] = [(b.x - a.x) / step, (b.y - a.y) / step];
  const length = Math.hypot(dx, dy);
  return length > 0 ? (by.x * dx + by.y * dy) / length ** 2 : null;
}

/** Twice as large where the handle is twice as far away, half where a hand went so far the other way: never nothing, and never turned inside out. */
function scaling(hold: Hold, axis: Axis | null, by: Spot, steps: Steps | null): Motion | null {
  const { see, pivot, reach, along, isBehind } = hold;
  const ahead =
    axis === null
      ? ((by.x - by.y) * Math.SQRT1_2 * reach) / across(see, pivot, reach)
      : along && alongLine(see, pivot, along, reach, seenAt(hold, by));
  if (ahead === null) return null;
  const far = isBehind ? -ahead : ahead;
  const raw = far >= 0 ? 1 + far / reach : 1 / (1 - far / reach);
  const step = (steps ?? FINE).factor;
  return { kind: "scale", axis, factor: Math.max(step, roundTo(raw, step)) };
}
