/** What a person can do to a design as a whole and to the page: pure functions from a state to the change that they ask for. */

import { isAlike } from "../document/alike";
import { labelOf } from "../document/label";
import type { Path } from "../document/path";
import { getPath, setPath } from "../document/path";
import { LIMITS } from "../document/tables.gen";
import type { Design, Look, OrderKind } from "../document/types";
import { freshIds } from "./part-ids";
import type { Handling, Overlays, Session, Tab, ThemeChoice } from "./session";
import type { Change, State } from "./store";

export const MAX_TITLE = LIMITS.characters;
const NOTHING: Change = { undo: "none" };

/** Replaces the design, as one step: undo brings the old one back. Water, cut and colours were those of the other pot. */
export function openDesign(state: State, design: Design): Change {
  const overlays = state.session.overlays.cut ? { ...state.session.overlays, cut: false } : state.session.overlays;
  return {
    design,
    ids: freshIds(design.parts.length, state.fresh),
    session: { selection: [], compare: null, map: null, fill: null, overlays },
    undo: state.design === design ? "none" : "step",
  };
}

export function setTitle(state: State, title: string): Change {
  const short = labelOf(title);
  if (short === (state.design.title ?? "")) return NOTHING;
  return {
    design: setPath(state.design, ["title"], short === "" ? undefined : short),
    undo: "merge",
    key: "title",
  };
}

/** Glazes a part otherwise, or makes it of another clay; undefined takes away what was said. What a hand goes on choosing is one step with `key`. */
export function setLook(state: State, look: LookChange, key?: string): Change {
  const path: Path = ["parts", state.part, "look"];
  const before = getPath(state.design, path) as Look | undefined;
  const all = Object.entries({ ...before, ...look }).filter(([, value]) => value !== undefined);
  const next = Object.fromEntries(all) as Look;
  if (isAlike(before ?? {}, next)) return NOTHING;
  const design = setPath(state.design, path, next);
  return key === undefined ? { design, undo: "step" } : { design, undo: "merge", key };
}

/** What of a look is to be different. */
export type LookChange = { readonly [Field in keyof Look]?: Look[Field] | undefined };

export function selectTab(tab: Tab): Change {
  return { undo: "none", session: { tab } };
}

export function setTheme(theme: ThemeChoice): Change {
  return { undo: "none", session: { theme } };
}

export function toggleOverlay(state: State, name: keyof Overlays): Change {
  const overlays = state.session.overlays;
  return { undo: "none", session: { overlays: { ...overlays, [name]: !overlays[name] } } };
}

export function toggleExplain(state: State): Change {
  return { undo: "none", session: { explain: !state.session.explain } };
}

/** Takes up the tool that pulls, or puts it down. */
export function togglePulling(state: State): Change {
  return { undo: "none", session: { pulling: !state.session.pulling, placing: false } };
}

/** Takes up the tool that moves whole parts, or puts it down. */
export function togglePlacing(state: State): Change {
  return { undo: "none", session: { placing: !state.session.placing, pulling: false } };
}

/** What a hand does with whole parts. */
export function setHandling(handling: Handling): Change {
  return { undo: "none", session: { handling } };
}

export function toggleSnapping({ session }: State): Change {
  return { undo: "none", session: { snapping: !session.snapping } };
}

/** Remembers what was chosen for a file. */
export function setExport(state: State, change: Partial<Session["export"]>): Change {
  const before = state.session.export;
  const next = { ...before, ...change };
  return isAlike(before, next) ? NOTHING : { undo: "none", session: { export: next } };
}

/** How much clay is trimmed off and lost, in percent of the pot. */
export function setAllowance(allowance: number): Change {
  return { undo: "none", session: { allowance } };
}

export function compareWith(order: OrderKind | null): Change {
  return { undo: "none", session: { compare: order } };
}
