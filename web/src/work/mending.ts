/** Does what would mend a breach: the maker finds where parts have to go, and the document has them there. */

import type { Box } from "../document/box";
import { boxAround, longestOf, middleOf } from "../document/boxes";
import { type Axis, moved, scaledBy, unit } from "../document/moving";
import type { Breach, Part, Triple } from "../document/types";
import type { Move, Way } from "../maker/clearing";
import type { PartId } from "../state/part-ids";
import { placeParts, standingOf } from "../state/place-actions";
import { objectOf } from "../state/scene-actions";
import type { State } from "../state/store";
import type { Designer } from "./designer";
import { boxesOf } from "./held";

/** The maker does one thing of these at a time. */
const LANE = "mending";
/** Boxes are as exact as meshes: so much further, as a share of what goes, two parts are apart for certain. It is the least way too. */
const GAP = 2e-3;

/** What became of it. */
export type Mended =
  | { readonly state: "moved"; readonly ids: readonly PartId[]; readonly by: number }
  | { readonly state: "locked" | "nowhere" | "superseded" };

/** Puts two objects apart: the smaller of both goes up or aside with all that is glued to it, or else the larger. */
export async function moveApart(designer: Designer, breach: Breach): Promise<Mended> {
  const ways = waysApart(designer.state, boxesOf(designer), breach);
  if (ways.length === 0) return { state: "locked" };
  const { design } = designer.state;
  return follow(designer, async (judge) => judge.ask({ kind: "apart", design, ways }, LANE));
}

/** Brings what is loose of an object to another part of it, from the place that the breach names. */
export async function moveTogether(designer: Designer, { part, other, group, at }: Breach): Promise<Mended> {
  const { design, ids, session } = designer.state;
  const boxes = boxesOf(designer);
  const [own, there] = [part, other].map((place) => boxes.get(ids[place] as PartId));
  if (group.some((place) => session.locked.includes(ids[place] as PartId))) return { state: "locked" };
  if (!own || !there) return { state: "nowhere" };
  const from = at ?? middleOf(own);
  const ask = { kind: "together", design, group, other, from, to: middleOf(there), size: longestOf(own) } as const;
  return follow(designer, async (judge) => judge.ask(ask, LANE));
}

/** The directions in which the boxes of two objects come apart soonest, those of the smaller one first. */
export function waysApart(state: State, boxes: ReadonlyMap<PartId, Box>, { part, other }: Breach): readonly Way[] {
  const objects = [part, other].map((place) => placesWith(state, place));
  const [one, another] = objects as [readonly number[], readonly number[]];
  const found = [
    [one, another],
    [another, one],
  ].flatMap(([moving = [], from = []]) => {
    const locked = moving.some((place) => state.session.locked.includes(state.ids[place] as PartId));
    const [own, there] = [boxOfAll(state, boxes, moving), boxOfAll(state, boxes, from)];
    return locked || !own || !there ? [] : [{ moving, from, own, there }];
  });
  return found
    .toSorted((a, b) => volumeOf(a.own) - volumeOf(b.own))
    .flatMap(({ moving, from, own, there }) =>
      directions(own, there).map(({ towards, far }): Way => {
        const swept = boxAround([own, shifted(own, scaledBy(far, towards))]) ?? own;
        const others = state.design.parts.flatMap((_, place) => {
          const box = boxOfAll(state, boxes, [place]);
          const isNear = from.includes(place) || (box && meets(box, swept));
          return !moving.includes(place) && isNear ? [place] : [];
        });
        return { moving, towards, far, others };
      }),
    );
}

/** Never downwards, where the table is. */
function directions(own: Box, there: Box): readonly { readonly towards: Triple; readonly far: number }[] {
  const gap = GAP * longestOf(own);
  const along = (axis: Axis, sign: 1 | -1) => ({
    towards: scaledBy(sign, unit(axis)),
    far: gap + Math.max(0, sign === 1 ? there.max[axis] - own.min[axis] : own.max[axis] - there.min[axis]),
  });
  return [along(2, 1), along(0, 1), along(0, -1), along(1, 1), along(1, -1)].toSorted((a, b) => a.far - b.far);
}

/** What is found is done only where the document is still the one that was asked about. */
async function follow(
  designer: Designer,
  ask: (judge: NonNullable<Designer["made"]>["judge"]) => Promise<{ state: string; value?: Move | null }>,
): Promise<Mended> {
  const { design } = designer.state;
  const made = await designer.openMade();
  const found = made ? await ask(made.judge) : null;
  if (!found || found.state === "superseded" || designer.state.design !== design) return { state: "superseded" };
  const move = found.state === "done" ? found.value : null;
  if (!move) return { state: "nowhere" };
  const { state } = designer;
  const ids = move.moving.map((place) => state.ids[place] as PartId);
  designer.apply(placeParts(state, new Map(ids.map((id) => [id, moved(standingOf(state, id), move.by)]))));
  return { state: "moved", ids, by: Math.hypot(...move.by) };
}

/** The places of all parts of one object. */
function placesWith({ design }: State, place: number): readonly number[] {
  const part = design.parts[place];
  return design.parts.flatMap((each, at) => (part && objectOf(each) === objectOf(part) ? [at] : []));
}

/** What parts fill, walls included: those may be laid round the surface that a mesh is of. */
function boxOfAll({ design, ids }: State, boxes: ReadonlyMap<PartId, Box>, places: readonly number[]): Box | null {
  return boxAround(
    places.flatMap((place) => {
      const box = boxes.get(ids[place] as PartId);
      return box ? [wider(box, thicknessOf(design.parts[place]))] : [];
    }),
  );
}

/** How far a wall reaches from its surface at most. */
export function thicknessOf(part: Part | undefined): number {
  return (part?.wall?.thickness ?? 0) * Math.max(1, ...(part?.place?.scale ?? []).map(Math.abs));
}

function wider({ min, max }: Box, by: number): Box {
  const [low, high] = [shifted({ min, max: min }, [-by, -by, -by]).min, shifted({ min: max, max }, [by, by, by]).max];
  return { min: low, max: high };
}

function shifted({ min, max }: Box, by: Triple): Box {
  const at = (point: Triple): Triple => [point[0] + by[0], point[1] + by[1], point[2] + by[2]];
  return { min: at(min), max: at(max) };
}

function meets(a: Box, b: Box): boolean {
  return [0, 1, 2].every(
    (i) => (a.min[i] as number) <= (b.max[i] as number) && (b.min[i] as number) <= (a.max[i] as number),
  );
}

function volumeOf({ min, max }: Box): number {
  return (max[0] - min[0]) * (max[1] - min[1]) * (max[2] - min[2]);
}
