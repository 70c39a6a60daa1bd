/** What a person can do to the selected blend: its sections, and how its equation is solved. */

import type { End } from "../document/blend/section";
import { settled } from "../document/blend/solving";
import type { Blend, Section } from "../document/types";
import { editShape } from "./shape-actions";
import type { Change, State } from "./store";

/** Changes one section. What a hand goes on changing is one step with `key`. */
export function changeSection(state: State, end: End, edit: (section: Section) => Section, key?: string): Change {
  return changeBlend(
    state,
    (blend) => {
      const section = edit(blend[end]);
      return section === blend[end] ? blend : settled({ ...blend, [end]: section });
    },
    key === undefined ? undefined : `section:${end}:${key}`,
  );
}

/** Changes a blend as a whole. */
export function changeBlend(state: State, edit: (blend: Blend) => Blend, key?: string): Change {
  const change = editShape(state, (shape) => (shape.kind === "blend" ? edit(shape) : shape));
  return key === undefined || change.undo === "none" ? change : { ...change, undo: "merge", key };
}
