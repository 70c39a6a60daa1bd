/** What a person can do to the joints of parts, and by them. */

import { alongOf, briefJoints, carried, goneBy, type JointName, jointValue, UPRIGHT } from "../document/joints";
import { round } from "../document/moving";
import { setPath } from "../document/path";
import type { WholePlacement } from "../document/placement";
import type { Joint, Part, Triple } from "../document/types";
import type { PartId } from "./part-ids";
import { standingOf } from "./place-actions";
import { gluedTo } from "./scene-actions";
import type { Change, State } from "./store";

const NOTHING: Change = { undo: "none" };

/** A joint with whom it belongs to. */
export interface Jointed {
  readonly id: PartId;
  readonly place: number;
  readonly part: Part;
  readonly name: JointName;
  readonly joint: Joint;
}

/** Changes a joint, gives the part one, or with null takes it away. What a hand goes on changing is one step with `key`. */
export function changeJoint(state: State, id: PartId, name: JointName, joint: Joint | null, key?: string): Change {
  const at = state.ids.indexOf(id);
  const part = state.design.parts[at];
  if (!part) return NOTHING;
  const { [name]: before, ...others } = part.joints ?? {};
  if (joint === null && !before) return NOTHING;
  const joints = briefJoints(joint ? { ...others, [name]: brief(joint) } : others);
  const design = setPath(state.design, ["parts", at, "joints"], joints);
  return key === undefined ? { design, undo: "step" } : { design, undo: "merge", key: `joint:${id}:${name}:${key}` };
}

/** Moves a part, and with a glued joint all that is glued to it, to where its joint has this value. The joints of the others go along. */
export function moveJoint(state: State, { id, name, joint, part, place: at }: Jointed, value: number): Change {
  const along = alongOf(name);
  const by = value - jointValue(part, name, joint);
  if (by === 0) return NOTHING;
  const pivot = standingOf(state, id).shift;
  let { design } = state;
  for (const each of movedBy(state, id, joint)) {
    const place = state.ids.indexOf(each);
    const before = standingOf(state, each);
    const gone = goneBy(before, name, joint, by, pivot);
    const after: WholePlacement = place === at ? settled(gone, along, value, pivot) : gone;
    design = setPath(design, ["parts", place, "place"], after);
    const { joints } = design.parts[place] as Part;
    if (joints && place !== at) design = setPath(design, ["parts", place, "joints"], carried(joints, before, after));
  }
  return { design, undo: "merge", key: `joint:${id}:${name}` };
}

/** Who goes along with a joint. */
export function movedBy(state: Pick<State, "design" | "ids">, id: PartId, joint: Joint): readonly PartId[] {
  return joint.glued ? gluedTo(state, [id]) : [id];
}

/** The very number that was asked for, and no other changed. */
function settled(place: WholePlacement, along: 0 | 1 | 2 | null, value: number, pivot: Triple): WholePlacement {
  const shift = pivot.map((x, axis) => (axis === along ? round(value) : x)) as unknown as Triple;
  return { ...place, shift };
}

/** What need not be said is left out. */
function brief({ label, limits, axis, glued }: Joint): Joint {
  const isUpright = !axis || axis.every((x, at) => x === UPRIGHT[at]);
  return { ...(label && { label }), limits, ...(!isUpright && { axis }), ...(glued && { glued }) };
}
