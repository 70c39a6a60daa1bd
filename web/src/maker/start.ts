/** Starts the maker's worker. */

import { boot } from "../worker/boot";
import type { MakerPort } from "./messages";

const begun = boot(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url));

export function startMaker(): MakerPort {
  return begun(new Worker(new URL("./worker.ts", import.meta.url), { type: "module" }));
}
