/** A button that shows an icon alone. */

import { html, nothing } from "lit";
import { type IconName, icon } from "./icons";

/** What a press does may leave it nothing more to do: the focus stays on it, which `disabled` would take away. The title says what its name does not, as why it cannot be pressed. */
export function iconButton(name: IconName, label: string, title: string, disabled: boolean, press: () => void) {
  return html`<button
    class="button bare"
    type="button"
    aria-label=${label}
    title=${title}
    aria-disabled=${disabled ? "true" : nothing}
    @click=${() => disabled || press()}
  >
    ${icon(name)}
  </button>`;
}
