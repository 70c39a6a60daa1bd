/** What the page remembers that is not part of the design. */

import type { Format, MapName, OrderKind } from "../document/types";
import type { PartId } from "./part-ids";

export type Tab = "shape" | "profile" | "equation" | "look" | "wall" | "measures";
export const TABS: readonly Tab[] = ["shape", "profile", "equation", "look", "wall", "measures"];

export type ThemeChoice = "auto" | "light" | "dark";
export const THEMES: readonly ThemeChoice[] = ["auto", "light", "dark"];

export interface Overlays {
  readonly isoU: boolean;
  readonly isoV: boolean;
  readonly wireframe: boolean;
  readonly boundary: boolean;
  readonly axes: boolean;
  /** The half that is before the eye is taken away, so that the wall is seen. */
  readonly cut: boolean;
}

/** What a hand does with whole parts on the stage. */
export type Handling = "move" | "turn" | "scale";
export const HANDLINGS: readonly Handling[] = ["move", "turn", "scale"];

export interface Session {
  /** The selected parts, the one that panels are about last; those that undo may bring back among them. */
  readonly selection: readonly PartId[];
  /** Parts that are not drawn, though they are part of the design all the same. */
  readonly hidden: readonly PartId[];
  readonly tab: Tab;
  readonly theme: ThemeChoice;
  readonly overlays: Overlays;
  /** The vector-valued parameters whose `x` and `y` are set apart, by name. */
  readonly unlocked: readonly string[];
  /** Whether every parameter's help text is on the page instead of in its tooltip. */
  readonly explain: boolean;
  /** The order shown beside the design. */
  readonly compare: OrderKind | null;
  /** What the colours on the pot stand for; its own when there is none. */
  readonly map: MapName | null;
  /** How high the water stands, from 0 at the floor to 1 where it spills; null without water. */
  readonly fill: number | null;
  /** What was last chosen for files: the clay stays the same from pot to pot. */
  readonly export: { readonly format: Format; readonly shrinkage: number };
  /** Parts that no hand moves, turns, scales or deletes. */
  readonly locked: readonly PartId[];
  /** Whether a hand on the stage pulls the pot, and does not turn it. */
  readonly pulling: boolean;
  /** Whether a hand on the stage moves whole parts: never while it pulls. */
  readonly placing: boolean;
  readonly handling: Handling;
  /** Whether what a hand moves goes in steps, and comes to stand on the table. */
  readonly snapping: boolean;
  /** The blend whose inside is on the stage in the place of its skin. */
  readonly inside: PartId | null;
  /** How much more clay is wedged than the pot has, for trimming and waste, in percent. */
  readonly allowance: number;
}

export const NEW_SESSION: Session = {
  selection: [],
  hidden: [],
  tab: "shape",
  theme: "auto",
  overlays: { isoU: false, isoV: false, wireframe: false, boundary: false, axes: false, cut: false },
  unlocked: [],
  explain: false,
  compare: null,
  map: null,
  fill: null,
  export: { format: "3mf", shrinkage: 0 },
  locked: [],
  pulling: false,
  placing: false,
  handling: "move",
  snapping: false,
  inside: null,
  allowance: 20,
};
