/** What a design of the gallery is called. */

import type { ExhibitId } from "../document/gallery";
import { FIRST } from "../document/gallery/first";
import { gallery } from "./english/gallery";
import { page } from "./english/page";

export function exhibitWords(id: ExhibitId): { readonly title: string; readonly note: string } {
  return id === FIRST.id ? { title: page.firstPot, note: gallery.firstNote } : gallery.exhibits[id];
}
