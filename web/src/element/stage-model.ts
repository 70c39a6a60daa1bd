/** What the solver made of a design, as the stage takes it. */

import { lookOf } from "../document/look";
import type { Design } from "../document/types";
import type { StageModel } from "../render/mesh";
import type { SolvedParts } from "../solver/solved";
import type { PartId } from "../state/part-ids";

export function stageModel(design: Design, { parts, bounds }: SolvedParts, hidden: readonly PartId[] = []): StageModel {
  return {
    parts: parts.map((part, place) => ({
      ...part,
      look: lookOf(design.parts[place]),
      hidden: hidden.includes(part.id),
    })),
    bounds,
  };
}
