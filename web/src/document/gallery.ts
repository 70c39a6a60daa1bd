/** The gallery: finished designs to start from, grouped by where they come from. */

import { OWN } from "./gallery/own";
import { PAPERS } from "./gallery/papers";
import type { Design, Look, Shape } from "./types";

export interface Exhibit {
  /** Stable and unique: what tests and thumbnails call it. */
  readonly id: string;
  readonly title: string;
  /** What to look at, or where it was printed. */
  readonly note: string;
  readonly shape: Shape;
  readonly look?: Look;
}

export interface Shelf {
  readonly title: string;
  readonly source: string;
  readonly exhibits: readonly Exhibit[];
}

export const SHELVES: readonly Shelf[] = [
  {
    title: "Our own",
    source: "Designs that show what the equations can do",
    exhibits: OWN,
  },
  {
    title: "Zhang and You",
    source: "Surface representation using second, fourth and mixed order partial differential equations, 2001",
    exhibits: PAPERS.filter((exhibit) => exhibit.id.startsWith("zhang-you")),
  },
  {
    title: "Ishak and Ali",
    source: "Parametric surface generation using partial differential equation based approach",
    exhibits: PAPERS.filter((exhibit) => exhibit.id.startsWith("ishak-ali")),
  },
];

/** The exhibit as a document of its own. */
export function designOf(exhibit: Exhibit): Design {
  return {
    pasu: 1,
    title: exhibit.title,
    parts: [{ shape: exhibit.shape, ...(exhibit.look && { look: exhibit.look }) }],
  };
}
