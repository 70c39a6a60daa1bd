/** The standard views and the step of the zoom, which buttons and keys share. */

export const VIEWS = ["three-quarter", "front", "side", "top", "below"] as const;

/** How much closer one step comes. */
export const ZOOM = 1.2;
