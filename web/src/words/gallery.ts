/** What a design of the gallery is called. */

import type { ExhibitId } from "../document/gallery";
import { FIRST } from "../document/gallery/first";
import { gallery } from "./english/gallery";
import { page } from "./english/page";

export interface ExhibitWords {
  readonly title: string;
  readonly note: string;
  /** What its parts are called, where it has several. */
  readonly parts?: readonly string[];
}

export function exhibitWords(id: ExhibitId): ExhibitWords {
  return id === FIRST.id ? { title: page.firstPot, note: gallery.firstNote } : gallery.exhibits[id];
}
