/** The gallery: finished designs to start from, grouped by where they come from. */

import { BLENDED, EXAMPLES } from "./gallery/blends";
import type { Exhibit } from "./gallery/exhibit";
import { NETWORKED } from "./gallery/networks";
import { OCTANTS } from "./gallery/octants";
import { OWN } from "./gallery/own";
import { PAPERS } from "./gallery/papers";
import { RINGED } from "./gallery/rings";
import { GLUED, SCENES } from "./gallery/scenes";

export type ExhibitId = (
  | typeof OWN
  | typeof PAPERS
  | typeof RINGED
  | typeof BLENDED
  | typeof NETWORKED
  | typeof OCTANTS
  | typeof SCENES
  | typeof GLUED
  | typeof EXAMPLES
)[number]["id"];

export interface Shelf {
  readonly id:
    | "own"
    | "rings"
    | "blends"
    | "networks"
    | "octants"
    | "scenes"
    | "zhang-you"
    | "zhang-you-2004"
    | "ishak-ali";
  readonly exhibits: readonly Exhibit<ExhibitId>[];
  /** Whether they are as a paper printed them, whose units are nobody's. */
  readonly printed?: boolean;
}

export const SHELVES: readonly Shelf[] = [
  {
    id: "own",
    exhibits: OWN,
  },
  {
    id: "rings",
    exhibits: RINGED,
  },
  {
    id: "scenes",
    exhibits: [...SCENES, ...GLUED],
  },
  {
    id: "blends",
    exhibits: BLENDED,
  },
  {
    id: "networks",
    exhibits: NETWORKED,
  },
  {
    id: "octants",
    exhibits: OCTANTS,
  },
  {
    id: "zhang-you",
    exhibits: PAPERS.filter((exhibit) => exhibit.id.startsWith("zhang-you")),
    printed: true,
  },
  {
    id: "zhang-you-2004",
    exhibits: EXAMPLES,
    printed: true,
  },
  {
    id: "ishak-ali",
    exhibits: PAPERS.filter((exhibit) => exhibit.id.startsWith("ishak-ali")),
    printed: true,
  },
];
