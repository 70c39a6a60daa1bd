// Pasu for browsers, workers and Node: all of it.

import * as bindings from "./bindings.js";
import { entry, PasuError } from "./wrapper.js";

const { init, parse, link, mesh, bound, evaluate, derivatives, fingerprint } = entry(
  { module: () => new URL("./pasu_bg.wasm", import.meta.url), bindings: () => bindings },
  { module: () => new URL("./pasu_scalar_bg.wasm", import.meta.url), bindings: () => bindings },
);

export { bound, derivatives, evaluate, fingerprint, init as default, link, mesh, PasuError, parse };
