/** The gallery: finished designs to start from, grouped by where they come from. */

import type { Exhibit } from "./gallery/exhibit";
import { OWN } from "./gallery/own";
import { PAPERS } from "./gallery/papers";

export interface Shelf {
  readonly title: string;
  readonly source: string;
  readonly exhibits: readonly Exhibit[];
  /** Whether they are as a paper printed them, whose units are nobody's. */
  readonly printed?: boolean;
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
    printed: true,
  },
  {
    title: "Ishak and Ali",
    source: "Parametric surface generation using partial differential equation based approach",
    exhibits: PAPERS.filter((exhibit) => exhibit.id.startsWith("ishak-ali")),
    printed: true,
  },
];
