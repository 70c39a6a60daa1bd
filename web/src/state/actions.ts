/** What a person can do to a design as a whole and to the page: pure functions from a state to the change that they ask for. */

import type { Path } from "../document/path";
import { getPath, setPath } from "../document/path";
import { DEFAULTS, LIMITS } from "../document/tables.gen";
import type { Design, Look, OrderKind, Unit } from "../document/types";
import type { Overlays, Session, Tab, ThemeChoice } from "./session";
import type { Change, State } from "./store";

export const MAX_TITLE = LIMITS.characters;
const NOTHING: Change = { undo: "none" };

/** Replaces the design, as one step: undo brings the old one back. */
export function openDesign(state: State, design: Design): Change {
  return { design, session: { part: 0, compare: null }, undo: state.design === design ? "none" : "step" };
}

export function setTitle(state: State, title: string): Change {
  // Surrogate pairs count as one character, as they do for the solver.
  const short = [...title.replace(/\s+/g, " ").trimStart()].slice(0, MAX_TITLE).join("");
  if (short === (state.design.title ?? "")) return NOTHING;
  return {
    design: setPath(state.design, ["title"], short === "" ? undefined : short),
    undo: "merge",
    key: "title",
  };
}

export function setUnit(state: State, unit: Unit): Change {
  if ((state.design.unit ?? DEFAULTS.unit) === unit) return NOTHING;
  return { design: setPath(state.design, ["unit"], unit), undo: "step" };
}

export function setLook(state: State, look: Look): Change {
  const path: Path = ["parts", state.session.part, "look"];
  const before = getPath(state.design, path) as Look | undefined;
  const next: Look = { ...before, ...look };
  if (before?.glaze === next.glaze && before?.clay === next.clay) return NOTHING;
  return { design: setPath(state.design, path, next), undo: "step" };
}

export function selectPart(state: State, part: number): Change {
  const last = state.design.parts.length - 1;
  return { undo: "none", session: { part: Math.max(0, Math.min(last, part)) } };
}

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

/** Remembers what was chosen for a file. */
export function setExport(state: State, change: Partial<Session["export"]>): Change {
  const before = state.session.export;
  const same = Object.entries(change).every(([name, value]) => before[name as keyof typeof before] === value);
  return same ? NOTHING : { undo: "none", session: { export: { ...before, ...change } } };
}

export function compareWith(order: OrderKind | null): Change {
  return { undo: "none", session: { compare: order } };
}
