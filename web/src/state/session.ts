/** What the page remembers that is not part of the design. */

import type { OrderKind } from "../document/convert";

export type Tab = "shape" | "profile" | "order" | "look";
export const TABS: readonly Tab[] = ["shape", "profile", "order", "look"];

export type ThemeChoice = "auto" | "light" | "dark";
export const THEMES: readonly ThemeChoice[] = ["auto", "light", "dark"];

export interface Overlays {
  readonly isoU: boolean;
  readonly isoV: boolean;
  readonly wireframe: boolean;
  readonly boundary: boolean;
  readonly axes: boolean;
}

export interface Session {
  /** The part whose parameters are shown. */
  readonly part: number;
  readonly tab: Tab;
  readonly theme: ThemeChoice;
  readonly overlays: Overlays;
  /** The vector-valued parameters whose `x` and `y` are set apart, by name. */
  readonly unlocked: readonly string[];
  /** Whether every parameter's help text is on the page instead of in its tooltip. */
  readonly explain: boolean;
  /** The order shown beside the design. */
  readonly compare: OrderKind | null;
}

export const NEW_SESSION: Session = {
  part: 0,
  tab: "shape",
  theme: "auto",
  overlays: { isoU: false, isoV: false, wireframe: false, boundary: false, axes: false },
  unlocked: [],
  explain: false,
  compare: null,
};
