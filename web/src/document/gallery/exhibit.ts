/** A finished design to start from. */

import type { Design, Look, Shape } from "../types";

export interface Exhibit {
  /** Stable and unique: what tests and thumbnails call it. */
  readonly id: string;
  readonly title: string;
  /** What to look at, or where it was printed. */
  readonly note: string;
  readonly shape: Shape;
  readonly look?: Look;
}

/** The exhibit as a document of its own. */
export function designOf(exhibit: Exhibit): Design {
  return {
    pasu: 1,
    title: exhibit.title,
    parts: [{ shape: exhibit.shape, ...(exhibit.look && { look: exhibit.look }) }],
  };
}
