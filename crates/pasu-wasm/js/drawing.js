// What it takes to draw a design, at a fraction of the weight of the whole: `import { mesh } from "pasu/drawing"`.

// One by one, so that a bundler leaves out what is not among them.
import load, {
  __wbg_reset_state,
  bound as boundOf,
  convert as convertOf,
  derivatives as derivativesOf,
  evaluate as evaluateOf,
  fingerprint as fingerprintOf,
  handles as handlesOf,
  link as linkOf,
  mesh as meshOf,
  parse as parseOf,
} from "./drawing_bindings.js";
import { entry, PasuError } from "./wrapper.js";

const bindings = {
  default: load,
  __wbg_reset_state,
  parse: parseOf,
  link: linkOf,
  mesh: meshOf,
  bound: boundOf,
  evaluate: evaluateOf,
  derivatives: derivativesOf,
  fingerprint: fingerprintOf,
  convert: convertOf,
  handles: handlesOf,
};

const { init, widen, parse, link, mesh, bound, evaluate, derivatives, fingerprint, convert, handles, follow } = entry(
  { module: () => new URL("./pasu_drawing_bg.wasm", import.meta.url), bindings: () => bindings },
  // Old engines are too few for a small module of their own.
  { module: () => new URL("./pasu_scalar_bg.wasm", import.meta.url), bindings: () => import("./bindings.js") },
  { module: () => new URL("./pasu_bg.wasm", import.meta.url), bindings: () => import("./bindings.js") },
);

export {
  bound,
  convert,
  derivatives,
  evaluate,
  fingerprint,
  follow,
  handles,
  init as default,
  link,
  mesh,
  PasuError,
  parse,
  widen,
};
