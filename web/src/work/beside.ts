/** Putting a design beside what stands there. */

import { unitOf } from "../document/look";
import { inUnit } from "../document/scaled";
import { LIMITS } from "../document/tables.gen";
import type { Design } from "../document/types";
import { addParts } from "../state/scene-actions";
import { parts as words } from "../words/english/parts";
import type { Designer } from "./designer";
import { thumbnailGrid } from "./grid";

/** How much room is left between the two, as a share of the width of the one that comes. */
const APART = 0.12;

/** Adds the parts of a design to the right of all others, on the same table; whether it did. */
export async function addBeside(designer: Designer, design: Design): Promise<boolean> {
  const coming = inUnit(design, unitOf(designer.store.design));
  const { length } = designer.store.design.parts;
  if (length + coming.parts.length > LIMITS.parts) {
    designer.notices.say(words.tooMany(LIMITS.parts));
    return false;
  }
  const { rows, columns } = thumbnailGrid(coming.parts.length);
  const outcome = await designer.solver.mesh("beside", coming, rows, columns);
  const own = outcome.state === "done" ? outcome.value.bounds : null;
  const there = designer.surface.shown?.solved.bounds;
  if (!own || !there) {
    designer.notices.say(words.notAdded);
    return false;
  }
  const gap = APART * (own.max[0] - own.min[0]);
  const rounded = (value: number) => Number(value.toPrecision(6));
  const by = [rounded(there.max[0] + gap - own.min[0]), 0, rounded(there.min[2] - own.min[2])] as const;
  designer.apply(addParts(designer.state, coming.parts, by));
  return true;
}
