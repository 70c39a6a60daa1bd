/** The standard views and the step of the zoom, which buttons and keys share. */

type ViewName = "three-quarter" | "front" | "side" | "top" | "below";

export const VIEWS: readonly { readonly name: ViewName; readonly label: string }[] = [
  { name: "three-quarter", label: "Three-quarter" },
  { name: "front", label: "Front" },
  { name: "side", label: "Side" },
  { name: "top", label: "Top" },
  { name: "below", label: "Below" },
];

/** How much closer one step comes. */
export const ZOOM = 1.2;
