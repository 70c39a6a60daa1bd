/** What is said where somebody might take hidden parts for parts that are gone. */

import { html, nothing } from "lit";
import { hiddenParts } from "../state/seen-actions";
import type { Designer } from "../work/designer";

export function hiddenNote({ store }: Designer) {
  const count = hiddenParts(store.state);
  if (count === 0) return nothing;
  const some = count === 1 ? "One part is hidden." : `${count} parts are hidden.`;
  return html`<p class="hint">${some} What is hidden is still part of the design, of its measures and of its files.</p>`;
}
