/** Makes the selected part one of rings at once, where a hand asks more of it than its numbers can do. */

import { sizeOf } from "../document/extents";
import { unitOf } from "../document/look";
import { boundWords } from "../words/bound";
import { freeing } from "../words/english/freeing";
import { page } from "../words/english/page";
import { cannotWords } from "../words/freeing";
import type { Designer } from "./designer";
import { finenessOf, freed, takeFreed } from "./freeing";

/** What became of it, in words. */
export async function freeNow(designer: Designer): Promise<{ readonly done: string } | { readonly cannot: string }> {
  const { store, extents } = designer;
  const made = await designer.openMade();
  if (!made) return { cannot: page.unfetched };
  const found = await freed(made.maker, store, finenessOf(sizeOf(extents)));
  const unit = unitOf(store.design);
  if (found.state === "refused") return { cannot: cannotWords(found.refusal, unit) };
  if (found.state === "superseded" || !takeFreed(store, found.value)) return { cannot: freeing.changed };
  const { shape, distance } = found.value;
  return { done: freeing.done(shape.rings.length, boundWords(distance, unit)) };
}
