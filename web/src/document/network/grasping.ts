/** What a hand does with points of a network. */

import type { Axis } from "./moving";

export type Doing = "move" | "turn" | "scale";
export const DOINGS = ["move", "turn", "scale"] as const satisfies readonly Doing[];
/** In the plane across the view, along an axis, or along the normal. */
export type Way = "view" | Axis | "normal";
export const WAYS = ["view", "x", "y", "z", "normal"] as const satisfies readonly Way[];
/** What a pointer does where it touches no point: turns the view, picks what is in a box, or draws a region to sculpt. */
export type Touch = "view" | "box" | "region";
export const TOUCHES = ["view", "box", "region"] as const satisfies readonly Touch[];
