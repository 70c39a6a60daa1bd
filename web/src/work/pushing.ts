/** Pushes the selected parts into the wall of the one that was selected last, and glues them to it: from the meshes on the stage, by the exact surfaces of the maker. */

import { boxAround, longestOf, middleOf } from "../document/boxes";
import { leadingPoints } from "../document/leading";
import { moved } from "../document/moving";
import type { Triple } from "../document/types";
import type { PartId } from "../state/part-ids";
import { placeParts, standingOf } from "../state/place-actions";
import { glueTogether } from "../state/scene-actions";
import { selectedIds } from "../state/seen-actions";
import { looseIds } from "../state/several-actions";
import type { Designer } from "./designer";
import { thicknessOf } from "./mending";
import { columnsOf, hasEnds } from "./rims";

/** Which way: over the table towards the middle of the other, or up or down to it. */
export type Course = "sideways" | "upright";

/** What became of it: set into the wall, or not all of it; nothing on the way; nothing to be done. */
export type PushedTo = "set" | "partly" | "nowhere" | "superseded";

const LANE = "pushing";
/** So many points tell where the wall is. */
const MOST_POINTS = 400;

export async function pushOnto(designer: Designer, course: Course): Promise<PushedTo> {
  const { state, surface } = designer;
  const { design, ids } = state;
  const lead = selectedIds(state).at(-1);
  const shown = surface.settled;
  if (lead === undefined || !shown) return "superseded";
  const solved = new Map(shown.solved.parts.map((part, place) => [part.id, { part, place }]));
  const moving = looseIds(state).flatMap((id) => (id === lead ? [] : (solved.get(id) ?? [])));
  const other = solved.get(lead);
  const own = boxAround(moving.flatMap(({ part }) => part.box ?? []));
  if (!other?.part.box || !own) return "nowhere";
  const towards = wayTo(middleOf(own), middleOf(other.part.box), course);
  if (!towards) return "nowhere";
  const points = moving.flatMap(({ part, place }) => {
    const kind = design.parts[place]?.shape.kind;
    const ends = kind && hasEnds(kind) ? columnsOf(part.mesh.uvs) : 0;
    return leadingPoints(part, towards, ends, MOST_POINTS / moving.length);
  });
  const along = (point: Triple) => point.reduce((sum, x, axis) => sum + x * (towards[axis] as number), 0);
  const ends = (box: { readonly min: Triple; readonly max: Triple }) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map((corner) =>
      along([0, 1, 2].map((axis) => ((corner >> axis) & 1 ? box.max : box.min)[axis]) as unknown as Triple),
    );
  const thick = thicknessOf(design.parts[other.place]);
  const back = Math.max(0, Math.max(...ends(own)) - Math.min(...ends(other.part.box)) + thick);
  const places = moving.map(({ place }) => place);
  const made = await designer.openMade();
  if (!made) return "superseded";
  const ask = { design, moving: places, onto: other.place, towards, back, points, size: longestOf(own) };
  const outcome = await made.maker.ask({ kind: "push", ...ask }, LANE);
  if (outcome.state === "superseded" || designer.state.design !== design) return "superseded";
  const pushed = outcome.state === "done" ? outcome.value : null;
  if (!pushed) return "nowhere";
  const gone = places.map((place) => ids[place] as PartId);
  const standing = new Map(gone.map((id) => [id, moved(standingOf(state, id), pushed.by)]));
  const put = placeParts(state, standing).design ?? design;
  const glued = glueTogether({ ...state, design: put }, [...gone, lead]).design ?? put;
  if (glued !== design) designer.apply({ design: glued, undo: "step" });
  return pushed.isSet ? "set" : "partly";
}

/** A unit vector from one point to another, level or upright; null where they are not apart that way. */
function wayTo(from: Triple, to: Triple, course: Course): Triple | null {
  const [x, y, z] = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
  if (course === "upright") return z === 0 ? null : [0, 0, Math.sign(z)];
  const far = Math.hypot(x, y);
  return far > 0 ? [x / far, y / far, 0] : null;
}
