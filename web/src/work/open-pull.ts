/** Fetched with the tool that pulls: a maker of its own for it, which starts before the hand takes hold. */

import { MakerClient } from "../maker/client";
import { startMaker } from "../maker/start";
import type { Store } from "../state/store";
import { Pull } from "./pull";

export function openPull(store: Store): Pull {
  const maker = new MakerClient(startMaker);
  maker.warm();
  return new Pull(store, maker);
}
