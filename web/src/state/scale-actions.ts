/** What makes a design larger or smaller, or its numbers. */

import { inUnit, scaled, type Walls } from "../document/scaled";
import type { Design, Unit } from "../document/types";
import type { Change, State } from "./store";

const NOTHING: Change = { undo: "none" };

/** Says the pot in another unit: it stays as large as it is, and its numbers change. */
export function setUnit(state: State, unit: Unit): Change {
  const design = inUnit(state.design, unit);
  return design === state.design ? NOTHING : { design, undo: "step", convert: (origin) => inUnit(origin, unit) };
}

/** Makes the pot so many times as large. */
export function resize(state: State, factor: number, walls: Walls): Change {
  if (!(factor > 0 && Number.isFinite(factor)) || factor === 1) return NOTHING;
  const convert = (design: Design) => scaled(design, factor, walls);
  return { design: convert(state.design), undo: "step", convert };
}
