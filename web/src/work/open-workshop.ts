/** Fetched when something is first to be made: the workshop with its maker. */

import { MakerClient } from "../maker/client";
import { startMaker } from "../maker/start";
import type { Designer } from "./designer";
import { Workshop } from "./workshop";

export function openWorkshop(designer: Designer): Workshop {
  return new Workshop(designer, new MakerClient(startMaker));
}
