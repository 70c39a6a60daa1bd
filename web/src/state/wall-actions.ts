/** What a person can do to the wall of the selected part, to the water in it and to the colours on it. */

import { setPath } from "../document/path";
import { DEFAULTS } from "../document/tables.gen";
import type { MapName, Wall } from "../document/types";
import { firstFoot, firstWall, type WallField, withWallNumber } from "../document/wall";
import type { Change, State } from "./store";

const NOTHING: Change = { undo: "none" };

/** Makes the part a pot of this size, or a surface again. */
export function setPot(state: State, pot: boolean, size: number): Change {
  const kind = state.design.parts[state.part]?.shape.kind;
  return rewall(state, () => (pot && kind ? firstWall(size, kind) : undefined), { undo: "step" });
}

/** Puts another wall in the place of that of a part. */
export function setWall(state: State, part: number, wall: Wall): Change {
  if (!state.design.parts[part]) return NOTHING;
  return { design: setPath(state.design, ["parts", part, "wall"], wall), undo: "step" };
}

/** Sets one number. `gesture` joins the steps of one drag. */
export function setWallNumber(state: State, field: WallField, value: number, gesture: boolean): Change {
  const key = `wall:${field.path.join(".")}`;
  return rewall(
    state,
    (wall) => wall && withWallNumber(wall, field, value),
    gesture ? { undo: "merge", key } : { undo: "step" },
  );
}

export function setSide(state: State, side: "inside" | "outside"): Change {
  // What is laid outwards has the surface itself as its inside.
  const laid = (wall: Wall) => (side === DEFAULTS.side ? wall : setPath(wall, ["lining"], undefined));
  return rewall(state, (wall) => wall && setPath(laid(wall), ["side"], side === DEFAULTS.side ? undefined : side), {
    undo: "step",
  });
}

/** Gives the pot an inside that keeps so many of the waves round it; null has it follow the outside. */
export function setLining(state: State, waves: number | null, gesture = false): Change {
  const { part } = state;
  const lining = waves === null ? undefined : waves === 0 ? {} : { waves };
  const before = state.design.parts[part]?.wall?.lining;
  if (before === lining || (before && lining && (before.waves ?? 0) === waves)) return NOTHING;
  return rewall(
    state,
    (wall) => wall && setPath(wall, ["lining"], lining),
    gesture ? { undo: "merge", key: "wall:lining" } : { undo: "step" },
  );
}

export function setRim(state: State, rim: "flat" | "rounded"): Change {
  return rewall(state, (wall) => wall && setPath(wall, ["rim"], rim === DEFAULTS.rim ? undefined : rim), {
    undo: "step",
  });
}

/** Puts a ring under the base, or takes it away. */
export function setFootRing(state: State, ring: boolean): Change {
  return rewall(state, (wall) => wall && setPath(wall, ["foot"], ring ? firstFoot(wall) : undefined), {
    undo: "step",
  });
}

/** How full a pot is at first. */
const FIRST_FILL = 0.7;

/** Pours water in, and cuts the pot open to show it; or out again, and closes the pot. */
export function setWater(state: State, water: boolean): Change {
  const overlays = { ...state.session.overlays, cut: water };
  return { undo: "none", session: { fill: water ? FIRST_FILL : null, overlays } };
}

/** Moves the water to a share of the depth. */
export function setFill(state: State, fill: number): Change {
  const share = Math.min(1, Math.max(0, fill));
  return share === state.session.fill ? NOTHING : { undo: "none", session: { fill: share } };
}

export function setMap(map: MapName | null): Change {
  return { undo: "none", session: { map } };
}

function rewall(
  state: State,
  edit: (wall: Wall | undefined) => Wall | undefined,
  policy: { readonly undo: "step" | "merge"; readonly key?: string },
): Change {
  const { part } = state;
  const before = state.design.parts[part];
  if (!before) return NOTHING;
  const wall = edit(before.wall);
  if (wall === before.wall) return NOTHING;
  return { design: setPath(state.design, ["parts", part, "wall"], wall), ...policy };
}
