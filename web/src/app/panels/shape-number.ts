/** A number of the selected part's shape as a field in a table, bound to its place in the document. */

import { html } from "lit";
import { type Path, pathText } from "../../document/path";
import { setNumber } from "../../state/shape-actions";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import type { Designer } from "../../work/designer";

/** `problem` is what the solver has against it. */
export function shapeNumber(designer: Designer, label: string, path: Path, value: number, problem: string) {
  return html`<pasu-number
    compact
    data-at=${pathText(path)}
    .label=${label}
    .value=${value}
    .step=${0.1}
    .problem=${problem}
    @number-change=${(event: NumberChangeEvent) => designer.apply(setNumber(designer.state, path, event.value, event.gesture))}
    @number-done=${() => designer.store.endGesture()}
    @number-cancel=${() => designer.store.cancelGesture()}
  ></pasu-number>`;
}
