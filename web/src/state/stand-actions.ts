/** One part put onto the rim of another: its height and its place follow, and if wanted its width. */

import { roundTo } from "../document/boxes";
import { difference, moved, ownAxis, resized } from "../document/moving";
import type { WholePlacement } from "../document/placement";
import type { Triple } from "../document/types";
import type { Boxes } from "./arrange-actions";
import type { PartId } from "./part-ids";
import { placeParts, standingOf } from "./place-actions";
import { objectOf } from "./scene-actions";
import { selectedIds } from "./seen-actions";
import { looseIds } from "./several-actions";
import type { Change, State } from "./store";

/** An end of a part: over which point it is, how high it reaches, and how wide it is. */
export interface Rim {
  readonly middle: readonly [x: number, y: number];
  readonly high: number;
  readonly width: number;
}

export interface Rims {
  readonly upper: Rim;
  readonly lower: Rim;
}

/** Separate objects share no point: so far above the rim, as a share of its width, nobody sees it. */
const HAIR = 1e-3;
/** The digits of a mesh, as a share of what it is of. */
const TOLD = 1e-6;

/**
 * The selected parts stand on the rim of the one that was selected last: the middle of their own lower end over the middle of the rim, and their lowest point as high as that reaches, or a hair higher
 * where both are separate objects. With `fitted` that end becomes as wide as the rim: an upright part keeps its height, another grows as a whole.
 */
export function standOn(state: State, boxes: Boxes, rims: ReadonlyMap<PartId, Rims>, fitted: boolean): Change {
  const lead = selectedIds(state).at(-1) ?? -1;
  const rim = rims.get(lead)?.upper;
  const base = state.design.parts[state.ids.indexOf(lead)];
  if (!rim || !base) return { undo: "none" };
  const digit =
    10 ** Math.floor(Math.log10(TOLD * Math.max(rim.width, Math.abs(rim.high), ...rim.middle.map(Math.abs))));
  const places = looseIds(state).flatMap((id) => {
    const box = boxes.get(id);
    const lower = rims.get(id)?.lower;
    const part = state.design.parts[state.ids.indexOf(id)];
    if (id === lead || !box || !lower || !part) return [];
    const foot: Triple = [...lower.middle, box.min[2]];
    const standing = standingOf(state, id);
    const sized =
      fitted && lower.width > 0 ? widened(standing, Number((rim.width / lower.width).toPrecision(7)), foot) : standing;
    const gap = objectOf(part) === objectOf(base) ? 0 : HAIR * rim.width;
    const by = difference([...rim.middle, rim.high + gap], foot).map((far) => roundTo(far, digit)) as unknown as Triple;
    return [[id, moved(sized, by)] as const];
  });
  return placeParts(state, new Map(places));
}

function widened(place: WholePlacement, factor: number, about: Triple): WholePlacement {
  const upright = Math.abs(ownAxis(place, 2)[2]) > 1 - 1e-9;
  return upright ? resized(resized(place, 0, factor, about), 1, factor, about) : resized(place, null, factor, about);
}
