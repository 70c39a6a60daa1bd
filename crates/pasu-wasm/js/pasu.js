// Pasu for browsers, workers and Node.
//
// The WebAssembly instance lives behind this file: errors become PasuError, and an instance that a bug has stopped is
// replaced by a fresh one, which costs nothing else because every function is stateless.

import load, * as bindings from "./bindings.js";

/** A refusal: `code` says what, `path` where, `message` tells a person. */
export class PasuError extends Error {
  constructor(code, path, message, options) {
    super(message, options);
    this.name = "PasuError";
    this.code = code;
    this.path = path;
  }
}

let loading;
let ready = false;
let broken = false;

/** Loads the module, once; `source` says where it is, if not beside this file, or is a function that does. */
export default function init(source) {
  loading ??= instantiate(typeof source === "function" ? source() : source).then(
    () => {
      ready = true;
    },
    (error) => {
      loading = undefined; // so that it can be tried again
      throw error;
    },
  );
  return loading;
}

/** Whether the engine has 128-bit SIMD: a module of two of its instructions. */
const HAS_SIMD = WebAssembly.validate(
  Uint8Array.of(
    0,
    97,
    115,
    109,
    1,
    0,
    0,
    0,
    1,
    5,
    1,
    96,
    0,
    1,
    123,
    3,
    2,
    1,
    0,
    10,
    10,
    1,
    8,
    0,
    65,
    0,
    253,
    15,
    253,
    98,
    11,
  ),
);

async function instantiate(source) {
  const found = source ?? (await onDisk()) ?? (HAS_SIMD ? undefined : scalarModule());
  await load(found === undefined ? undefined : { module_or_path: found });
}

/** The module that gives the same bits without SIMD, for engines of before 2023. */
function scalarModule() {
  return new URL("./pasu_scalar_bg.wasm", import.meta.url);
}

/** The module's bytes where this very file is imported by its path in Node, whose fetch() does not read files. */
async function onDisk() {
  if (!import.meta.url.startsWith("file:")) return undefined;
  const files = "node:fs/promises"; // a name that bundlers for browsers leave alone
  const { readFile } = await import(/* @vite-ignore */ files);
  return readFile(HAS_SIMD ? new URL("./pasu_bg.wasm", import.meta.url) : scalarModule());
}

export function parse(source) {
  return call(bindings.parse, source);
}

export function link(source) {
  return call(bindings.link, source);
}

export function mesh(source, options) {
  if (typeof options !== "object" || options === null) return call(bindings.mesh, source, options);
  const { into, ...others } = options;
  return call(bindings.mesh, source, others, into);
}

export function bound(source, options) {
  return call(bindings.bound, source, options);
}

export function evaluate(source, part, at) {
  return call(bindings.evaluate, source, part, at);
}

export function derivatives(source, part, at) {
  return call(bindings.derivatives, source, part, at);
}

export function fingerprint(source) {
  return call(bindings.fingerprint, source);
}

function call(binding, ...args) {
  if (!ready) throw new PasuError("not-ready", "", "Pasu is not loaded yet: call init() and wait for it first.");
  try {
    if (broken) {
      bindings.__wbg_reset_state();
      broken = false;
    }
    return binding(...args);
  } catch (error) {
    if (error instanceof Error && error.name === "PasuError" && error.code !== "bug") {
      throw new PasuError(error.code, error.path, error.message);
    }
    // Whatever else comes out of the module is a bug of ours, and the instance can no longer be trusted. It is replaced
    // at the next call, not now: the stack may be what has run out.
    broken = true;
    throw new PasuError("bug", "", error instanceof Error ? error.message : String(error), { cause: error });
  }
}
