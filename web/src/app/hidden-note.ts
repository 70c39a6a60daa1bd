/** What is said where somebody might take hidden parts for parts that are gone. */

import { html, nothing } from "lit";
import { hiddenParts } from "../state/seen-actions";
import { page } from "../words/english/page";
import type { Designer } from "../work/designer";

export function hiddenNote({ store }: Designer) {
  const count = hiddenParts(store.state);
  if (count === 0) return nothing;
  return html`<p class="hint">${page.hidden(count)}</p>`;
}
