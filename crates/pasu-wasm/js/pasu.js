// Pasu for browsers, workers and Node: all of it.

import * as bindings from "./bindings.js";
import { apart, entry, PasuError } from "./wrapper.js";

const { init, call, parse, link, mesh, bound, evaluate, derivatives, fingerprint } = entry(
  { module: () => new URL("./pasu_bg.wasm", import.meta.url), bindings: () => bindings },
  { module: () => new URL("./pasu_scalar_bg.wasm", import.meta.url), bindings: () => bindings },
);

const measure = (source, options) => call("measure", source, options);
const check = (source, making) => call("check", source, making);
const write = (source, format, making) => call("write", source, format, making);
const objMaterials = () => call("objMaterials");
const solid = (source, making) => call("solid", source, making);
const sketch = (source, options) => {
  const { into, others } = apart(options);
  return call("sketch", source, others, into);
};
const paint = (source, map, options) => call("paint", source, map, options);
const water = (source, level) => call("water", source, level);
const open = (bytes) => call("open", bytes) ?? null;
const provenance = (bytes) => call("provenance", bytes) ?? null;

export {
  bound,
  check,
  derivatives,
  evaluate,
  fingerprint,
  init as default,
  link,
  measure,
  mesh,
  objMaterials,
  open,
  PasuError,
  paint,
  parse,
  provenance,
  sketch,
  solid,
  water,
  write,
};
