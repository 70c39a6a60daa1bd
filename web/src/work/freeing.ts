/** A part as rings: asked of the maker, and put into the design as one step. */

import { setPath } from "../document/path";
import type { Rings, Shape } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { PartId } from "../state/part-ids";
import type { Store } from "../state/store";
import type { Outcome } from "../worker/port";

/** What a part would be as rings. */
export interface Freed {
  readonly part: PartId;
  /** What it was. */
  readonly from: Shape;
  readonly shape: Rings;
  /** How far both are apart at most, in the unit of the design. */
  readonly distance: number;
}

/** Nobody sees a difference of this part of a pot. */
const UNSEEN = 1e-3;

/** A round number about as small as what nobody sees of a pot as large as that. */
export function finenessOf(size: number): number {
  const wanted = UNSEEN * (size > 0 ? size : 1);
  const decade = 10 ** Math.floor(Math.log10(wanted));
  const digit = [5, 2, 1].find((each) => each * decade <= wanted * (1 + 1e-9)) ?? 1;
  return Number((digit * decade).toPrecision(1));
}

/** What a hand has drawn or made is not truer than so many times what nobody sees. */
const BY_HAND = 5;

/** How closely what a hand has drawn or made is to be followed, of a pot so high. */
export function followedByHand(height: number): number {
  return BY_HAND * finenessOf(height);
}

/** The selected part as rings, no further from what it is than `tolerance`. Of several questions the last is answered. */
export async function freed(maker: MakerClient, store: Store, tolerance: number): Promise<Outcome<Freed>> {
  const { design, part, ids } = store.state;
  const [id, from] = [ids[part], design.parts[part]?.shape];
  if (id === undefined || !from) return { state: "superseded" };
  const outcome = await maker.ask({ kind: "free", design, part, tolerance });
  if (outcome.state !== "done") return outcome;
  return { state: "done", value: { part: id, from, ...outcome.value } };
}

/** Puts the rings into the place of what they were found for, as one step; whether that still is what it was. */
export function takeFreed(store: Store, { part, from, shape }: Freed): boolean {
  const { design, ids } = store.state;
  const place = ids.indexOf(part);
  if (design.parts[place]?.shape !== from) return false;
  store.apply({ design: setPath(design, ["parts", place, "shape"], shape), undo: "step" });
  return true;
}
