/** What a person can do to the rings of the selected part. */

import { withoutCurve } from "../document/curves";
import type { Hoop } from "../document/ring-numbers";
import type { BoundaryValue, Rings } from "../document/types";
import { editShape } from "./shape-actions";
import type { Change, State } from "./store";

/** Takes one away, by its number from the first end on; ends stay. */
export function removeRing(state: State, index: number): Change {
  return editShape(state, (shape) => withoutCurve(shape, index));
}

/** Changes one ring of a pot of rings. What a hand goes on changing is one step with `key`. */
export function changeRing(state: State, index: number, edit: (ring: Hoop) => Hoop, key?: string): Change {
  return changeRings(
    state,
    (pot) => {
      const ring = pot.rings[index];
      const next = ring && edit(ring);
      return !next || next === ring
        ? pot
        : { ...pot, rings: pot.rings.map((each, at) => (at === index ? next : each)) };
    },
    key === undefined ? undefined : `ring:${index}:${key}`,
  );
}

/** Changes a pot of rings as a whole. */
export function changeRings(state: State, edit: (pot: Rings) => Rings, key?: string): Change {
  const change = editShape(state, (shape) => (shape.kind === "rings" ? edit(shape) : shape));
  return key === undefined || change.undo === "none" ? change : { ...change, undo: "merge", key };
}

/** Changes boundary data that are written out. What a hand goes on changing is one step with `key`. */
export function changeWritten(state: State, edit: (shape: BoundaryValue) => BoundaryValue, key?: string): Change {
  const change = editShape(state, (shape) => (shape.kind === "boundary-value" ? edit(shape) : shape));
  return key === undefined || change.undo === "none" ? change : { ...change, undo: "merge", key: `written:${key}` };
}
