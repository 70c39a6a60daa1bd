/** One maker for all elements of a page. */

import { MakerClient } from "../../maker/client";
import { startMaker } from "../../maker/start-anywhere";
import { Shared } from "./shared";

export const makers = new Shared(() => new MakerClient(startMaker));
