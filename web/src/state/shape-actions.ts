/** What a person can do to the shape of the selected part: pure functions from a state to the change that they ask for. */

import type { Path } from "../document/path";
import { getPath, setPath } from "../document/path";
import { moveHandle } from "../document/profile";
import type { Field } from "../document/schema";
import { fieldValue, withField } from "../document/schema";
import type { Handle, Shape } from "../document/types";
import type { Change, State } from "./store";

/** Sets one number, or the `x` and `y` of a locked parameter, in one go. `gesture` joins the steps of one drag. */
export function setFields(state: State, fields: readonly Field[], value: number, gesture: boolean): Change {
  const key = `field:${fields.map((field) => field.path.join(".")).join("+")}`;
  const next = (shape: Shape) => fields.reduce((made, field) => withField(made, field, value), shape);
  return reshape(state, next, gesture ? { undo: "merge", key } : { undo: "step" });
}

/** Puts numbers back to those of another shape of the same kind, which is what was opened or what the paper printed. */
export function resetFields(state: State, fields: readonly Field[], to: Shape): Change {
  return reshape(
    state,
    (shape) =>
      to.kind === shape.kind
        ? fields.reduce((made, field) => withField(made, field, fieldValue(to, field)), shape)
        : shape,
    { undo: "step" },
  );
}

/** Sets `x` and `y` apart, or together again at the value of `x`. */
export function setLock(state: State, fields: readonly [Field, Field], locked: boolean): Change {
  const [first, second] = fields;
  const name = first.pair ?? "";
  const others = state.session.unlocked.filter((other) => other !== name);
  const session = { unlocked: locked ? others : [...others, name] };
  if (!locked) return { undo: "none", session };
  const change = reshape(state, (shape) => withField(shape, second, fieldValue(shape, first)), { undo: "step" });
  return { ...change, session };
}

/** Sets one number of free boundary data by its path inside the shape. */
export function setNumber(state: State, path: Path, value: number, gesture: boolean): Change {
  const key = `number:${path.join(".")}`;
  return reshape(
    state,
    (shape) => (Object.is(getPath(shape, path) ?? 0, value) ? shape : setPath(shape, path, value)),
    gesture ? { undo: "merge", key } : { undo: "step" },
  );
}

/** Any other change of the selected part's shape, as one step. */
export function editShape(state: State, edit: (shape: Shape) => Shape): Change {
  return reshape(state, edit, { undo: "step" });
}

/** Drags a handle of the profile. */
export function dragHandle(
  state: State,
  handle: Pick<Handle, "radial" | "axial"> & { readonly id: string },
  radial: number,
  axial: number,
): Change {
  return reshape(state, (shape) => moveHandle(shape, handle, radial, axial), {
    undo: "merge",
    key: `handle:${handle.id}`,
  });
}

/** Puts the selected part as it is in another order into its place. */
export function switchOrder(state: State, converted: Shape): Change {
  const change = reshape(state, () => converted, { undo: "step" });
  return { ...change, session: { compare: null } };
}

function reshape(
  state: State,
  edit: (shape: Shape) => Shape,
  policy: { readonly undo: "step" | "merge"; readonly key?: string },
): Change {
  const part = state.design.parts[state.part];
  if (!part) return { undo: "none" };
  const shape = edit(part.shape);
  if (shape === part.shape) return { undo: "none" };
  return { design: setPath(state.design, ["parts", state.part, "shape"], shape), ...policy };
}
