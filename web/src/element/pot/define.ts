/** Defines `<pasu-pot>`, unless a page has done so already with another copy. */

import { PasuPotElement } from "./pasu-pot";

if (!customElements.get("pasu-pot")) customElements.define("pasu-pot", PasuPotElement);

export { PasuPotElement };
