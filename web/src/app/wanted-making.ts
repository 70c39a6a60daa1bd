/** Fetches what makes things of a design as soon as anything is looked at that it makes. */

import { effect, untracked } from "@preact/signals-core";
import type { Design } from "../document/types";
import type { Session } from "../state/session";
import type { Designer } from "../work/designer";

/** Once the first surface stands, which does not wait for it; until what comes back is called. */
export function fetchMadeWhenWanted(designer: Designer): () => void {
  return effect(() => {
    const { made, store, surface } = designer;
    if (made || !surface.settled || !wantsMaking(store.design, store.session)) return;
    untracked(() => void designer.openMade());
  });
}

/** Whether anything is looked at that the maker makes. */
function wantsMaking({ parts }: Design, { tab, fill, map, overlays }: Session): boolean {
  const looked = tab === "wall" || tab === "measures" || overlays.cut;
  return looked || fill !== null || map !== null || parts.length > 1 || parts.some(({ wall }) => wall);
}
