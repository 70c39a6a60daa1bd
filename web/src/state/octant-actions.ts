/** What a person can do to the selected octant. */

import type { Octant } from "../document/types";
import { editShape } from "./shape-actions";
import type { Change, State } from "./store";

/** Changes its exponents. What a hand goes on changing is one step with `key`. */
export function changeOctant(state: State, edit: (octant: Octant) => Octant, key?: string): Change {
  const change = editShape(state, (shape) => (shape.kind === "octant" ? edit(shape) : shape));
  return key === undefined || change.undo === "none" ? change : { ...change, undo: "merge", key: `octant:${key}` };
}
