/** Fetched when something is first to be made: what follows the document with the maker. */

import { MakerClient } from "../maker/client";
import { startMaker } from "../maker/start";
import type { Store } from "../state/store";
import { Made } from "./made";
import type { Surface } from "./surface";

export function openMade(store: Store, surface: Surface): Made {
  return new Made(store, surface, new MakerClient(startMaker), undefined, new MakerClient(startMaker));
}
