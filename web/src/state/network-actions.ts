/** What a person can do to the selected network. */

import type { Network } from "../document/network/network";
import { editShape } from "./shape-actions";
import type { Change, State } from "./store";

/** Changes it as a whole. What a hand goes on changing is one step with `key`. */
export function changeNetwork(state: State, edit: (network: Network) => Network, key?: string): Change {
  const change = editShape(state, (shape) => (shape.kind === "vertex-frame" ? edit(shape) : shape));
  return key === undefined || change.undo === "none" ? change : { ...change, undo: "merge", key: `network:${key}` };
}
