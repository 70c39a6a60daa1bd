// Pasu for browsers, workers and Node: all of it.

import * as bindings from "./bindings.js";
import { remembering } from "./known.js";
import { apart, entry, PasuError } from "./wrapper.js";

const entered = entry(
  { module: () => new URL("./pasu_bg.wasm", import.meta.url), bindings: () => bindings },
  { module: () => new URL("./pasu_scalar_bg.wasm", import.meta.url), bindings: () => bindings },
);
const { init, call, parse, link, bound, evaluate, derivatives, fingerprint, convert, handles, follow } = entered;

/**
 * Runs with the options but for `progress`, and with what calls a binding and tells that how far it is. What it throws is thrown as it is: here, because whatever comes out of the module is a
 * refusal or a bug.
 */
function watched(options, run) {
  let progress;
  try {
    progress = options?.progress;
  } catch {
    // A getter that throws is refused as that of every other option is.
  }
  if (progress === undefined || progress === null) return run(options, call);
  if (typeof progress !== "function") {
    throw new PasuError("wrong-type", "progress", `expected a function, found a ${typeof progress}`);
  }
  const { others } = apart(options, "progress");
  let failed;
  const told = (done) => {
    try {
      return progress(done);
    } catch (error) {
      failed = { error };
      return false;
    }
  };
  try {
    // biome-ignore lint/performance/noDynamicNamespaceImportAccess: all of them are called by their names
    return run(others, (name, ...args) => call("watched", told, () => bindings[name](...args)));
  } catch (error) {
    throw failed ? failed.error : error;
  }
}

const mesh = (source, options) => watched(options, (others, by) => entered.meshBy(by, source, others));
const measure = (source, options) => watched(options, (others, by) => by("measure", source, others));
const check = (source, making) => watched(making, (others, by) => by("check", source, others));
const write = (source, format, making) => watched(making, (others, by) => by("write", source, format, others));
const objMaterials = () => call("objMaterials");
const solid = (source, making) => watched(making, (others, by) => by("solid", source, others));
const sketch = (source, options) => {
  const { taken: into, others } = apart(options, "into");
  return call("sketch", source, others, into);
};
const paint = (source, map, options) => watched(options, (others, by) => by("paint", source, map, others));
const pull = (source, part, hand) => call("pull", source, part, hand);
const pulled = (source, part, hand) => call("pulled", source, part, hand);
const free = (source, part, options) => call("free", source, part, options);
const fit = (profile, options) => call("fit", profile, options);
const levels = (scan) => call("levels", scan);
const cells = (source, part, options) => call("cells", source, part, options);
const cellsFile = (source, part, format, options) => call("cellsFile", source, part, format, options);
const inside = (source, part) => call("inside", source, part);
const insideValues = (source, part, map, at) => call("insideValues", source, part, map, at);
const compare = (before, after) => call("compare", before, after);
const asked = remembering(call);
const pick = (source, ray) => asked("pick", source, ray);
const at = (source, point) => asked("at", source, point);
const tree = (source) => call("tree", source);
const flat = (tree) => call("flat", tree);
const connectivity = (source) => call("connectivity", source);
const constraints = (source, options) => watched(options, (others, by) => by("constraints", source, others));
const water = (source, level) => call("water", source, level);
const open = (bytes) => call("open", bytes) ?? null;
const provenance = (bytes) => call("provenance", bytes) ?? null;

export {
  at,
  bound,
  cells,
  cellsFile,
  check,
  compare,
  connectivity,
  constraints,
  convert,
  derivatives,
  evaluate,
  fingerprint,
  fit,
  flat,
  follow,
  free,
  handles,
  init as default,
  inside,
  insideValues,
  levels,
  link,
  measure,
  mesh,
  objMaterials,
  open,
  PasuError,
  paint,
  parse,
  pick,
  provenance,
  pull,
  pulled,
  sketch,
  solid,
  tree,
  water,
  write,
};
