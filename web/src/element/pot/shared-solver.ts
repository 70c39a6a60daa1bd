/** One solver for all elements of a page. */

import { SolverClient } from "../../solver/client";
import { startWorker } from "../../solver/start-anywhere";
import { Shared } from "./shared";

export const solvers = new Shared(() => new SolverClient(startWorker));
