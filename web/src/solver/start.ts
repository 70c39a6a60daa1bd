/** Starts the real worker. */

import { boot } from "../worker/boot";
import type { SolverPort } from "./messages";

const begun = boot(new URL("../../../crates/pasu-wasm/pkg/pasu_drawing_bg.wasm", import.meta.url));

/** A worker in a file of its own that the bundler finds by this very expression. */
export function startWorker(): SolverPort {
  return begun(new Worker(new URL("./worker.ts", import.meta.url), { type: "module" }));
}
