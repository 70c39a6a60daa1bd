/** What a hand on whole parts needs to know of them: where they are and how large, as far as the solver has told. */

import { computed, effect, type ReadonlySignal } from "@preact/signals-core";
import type { Box } from "../document/box";
import { boxAround, handy, longestOf, roundStep, tableUnder } from "../document/boxes";
import { matrixOf, placedAll, type WholePlacement } from "../document/placement";
import type { Triple } from "../document/types";
import type { Bounds } from "../solver/bounds";
import type { PartId } from "../state/part-ids";
import { standingOf } from "../state/place-actions";
import { looseIds } from "../state/several-actions";
import type { State } from "../state/store";
import type { Designer } from "./designer";

/** How many steps it is across the scene at least. */
const STEPS_ACROSS = 40;

/** The parts that a hand would move. */
export interface Manner {
  /** About which they turn: where they come to stand by that does not move it. */
  readonly pivot: Triple;
  readonly box: Box;
  readonly table: number;
  /** A round length that is short beside the scene, and not longer than what is moved. */
  readonly step: number;
}

/** The same with where each of them stands. */
export interface Held extends Omit<Manner, "box"> {
  readonly low: number;
  readonly places: ReadonlyMap<PartId, WholePlacement>;
}

const manners = new WeakMap<Pick<Designer, "state" | "surface">, ReadonlySignal<Manner | null>>();

/** Null where nothing is selected that may be moved, and where it is not known yet. All who ask are answered from one look at the scene. */
export function mannerOf(designer: Pick<Designer, "state" | "surface">): Manner | null {
  const known = manners.get(designer) ?? computed(() => lookedAt(designer));
  manners.set(designer, known);
  return known.value;
}

function lookedAt({ state, surface }: Pick<Designer, "state" | "surface">): Manner | null {
  const parts = surface.shown?.solved.parts ?? [];
  const loose = new Set(looseIds(state));
  const held = parts.filter(({ id }) => loose.has(id));
  const boxes = held.flatMap(({ box }) => box ?? []);
  const box = boxAround(boxes);
  const all = boxAround(parts.flatMap((part) => part.box ?? []));
  if (!box || !all) return null;
  const cores = [...middlesOf({ state, surface }, loose).values()];
  const size = longestOf(all);
  const middle = [0, 1, 2].map((i) => cores.reduce((sum, core) => sum + (core[i] as number), 0) / cores.length);
  const others = parts.filter(({ id }) => !loose.has(id)).flatMap((part) => part.box ?? []);
  return {
    // The digits of rounding of sums are none of the pot's.
    pivot: handy(middle as unknown as Triple, size * 1e-6),
    box,
    table: tableUnder(others),
    step: roundStep(Math.min((size || 1) / STEPS_ACROSS, longestOf(box) || Number.POSITIVE_INFINITY)),
  };
}

export function heldBy(state: State, { pivot, box, table, step }: Manner, ids: readonly PartId[]): Held {
  return { pivot, table, step, low: box.min[2], places: new Map(ids.map((id) => [id, standingOf(state, id)])) };
}

/** Shapes that go round their axis: it is their middle, whatever their petals fill. */
const ROUND: readonly (string | undefined)[] = ["second-order", "mixed-order", "fourth-order", "bloor-wilson", "rings"];

function coreOf(kind: string | undefined, bounds: Bounds | null): Triple {
  const [x, y, z] = bounds ? handy(bounds.centre, bounds.radius) : [0, 0, 0];
  return ROUND.includes(kind) ? [0, 0, z] : [x, y, z];
}

/** The middle of every part where it stands, or of some: of what goes round an axis a point of that. */
export function middlesOf(
  { state, surface }: Pick<Designer, "state" | "surface">,
  some: ReadonlySet<PartId> | null = null,
): ReadonlyMap<PartId, Triple> {
  const { shown } = surface;
  return new Map(
    (shown?.solved.parts ?? []).flatMap(({ id, own }, place) => {
      if (some && !some.has(id)) return [];
      const core = coreOf(shown?.design.parts[place]?.shape.kind, own);
      const matrix = matrixOf(standingOf(state, id));
      return matrix ? [[id, [...placedAll(matrix, core)] as unknown as Triple] as const] : [];
    }),
  );
}

/** What every part fills of the scene, as far as it is known. */
export function boxesOf({ surface }: Pick<Designer, "surface">): ReadonlyMap<PartId, Box> {
  const parts = surface.shown?.solved.parts ?? [];
  return new Map(parts.flatMap(({ id, box }) => (box ? [[id, box] as const] : [])));
}

/** Does something once all of this is known of the document as it is, or cannot be: of two presses in quick succession the second goes by where the first has put the parts. */
export async function onceKnown<T>({ surface }: Pick<Designer, "surface">, run: () => T | Promise<T>): Promise<T> {
  const isKnown = () => surface.settled !== null || surface.status === "error";
  while (!isKnown()) {
    let leave = () => {};
    await new Promise<void>((resolve) => {
      leave = effect(() => {
        if (isKnown()) resolve();
      });
    });
    leave();
  }
  return await run();
}
