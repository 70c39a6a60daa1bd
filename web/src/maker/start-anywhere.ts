/** Starts the maker's worker for a page that may be of another origin than the worker's file. */

import { startAnywhere } from "../worker/anywhere";
import { boot } from "../worker/boot";
import type { MakerPort } from "./messages";
import address from "./worker.ts?worker&url";

// Each by an expression that bundlers know.
const begun = boot(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url), {
  scalar: new URL("../../../crates/pasu-wasm/pkg/pasu_scalar_bg.wasm", import.meta.url),
});

export function startMaker(): MakerPort {
  return begun(startAnywhere(new URL(address, import.meta.url)));
}
