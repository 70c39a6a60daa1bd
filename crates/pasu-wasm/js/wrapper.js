// What both entries of the package, `pasu` and `pasu/drawing`, are made of.
//
// The WebAssembly instance lives behind this file: errors become PasuError, and an instance that a bug has stopped is
// replaced by a fresh one, which costs nothing else because every function is stateless.

/** A refusal: `code` says what, `path` and `place` where, `message` tells a person, `args` are what the message names. */
export class PasuError extends Error {
  constructor(code, path, message, { args = {}, place, ...options } = {}) {
    super(message, options);
    this.name = "PasuError";
    this.code = code;
    this.path = path;
    this.args = args;
    this.place = place ?? null;
  }
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

/** What depends on the topology of a mesh alone. */
const TABLES = ["uvs", "indices", "groups"];

/** Meshes of more vertices than this keep no tables: 34 MB. */
const MOST_KEPT = 2 ** 20;

/** The topology of the last mesh that had new arrays; with its tables, once two meshes in a row had it. */
let tables;

/**
 * A mesh with new arrays. Tables of the topology of the one before are copied when they are first read: they are more than half of a mesh, and new memory is what takes longest.
 *
 * A module that is given `tables` leaves them out of a mesh of their topology.
 */
function ofTables(mesh) {
  if (mesh.indices !== undefined) {
    const { topology, uvs, indices, groups } = mesh;
    const isAgain = topology === tables?.last && uvs.length <= 2 * MOST_KEPT;
    tables = isAgain ? { last: topology, topology, kept: { uvs, indices, groups } } : { last: topology };
    if (!isAgain) return mesh;
  }
  const { kept } = tables;
  for (const key of TABLES) {
    const hold = (value) =>
      Object.defineProperty(mesh, key, { value, writable: true, enumerable: true, configurable: true });
    const get = () => hold(new kept[key].constructor(kept[key]))[key];
    Object.defineProperty(mesh, key, { get, set: hold, enumerable: true, configurable: true });
  }
  return mesh;
}

/** Marks are never given twice, so that no instance of the module takes a design for one that another had. */
let mark = 0;

/** A mark that nobody has. */
export function freshMark() {
  mark += 1;
  return mark;
}

/** The options of a call without one of them, and that. */
export function apart(options, name) {
  if (typeof options !== "object" || options === null) return { others: options };
  try {
    if (Array.isArray(options)) return { others: options };
    const { [name]: taken, ...others } = options;
    return { taken, others };
  } catch (cause) {
    if (cause instanceof RangeError) throw cause; // as when the stack has run out
    throw new PasuError("wrong-type", "options", "expected options, found something that cannot be read", { cause });
  }
}

/**
 * An entry: `init`, `call`, which calls a binding by its name, and the functions that every entry has.
 *
 * `simd` and `scalar` stand for a module each, with 128-bit SIMD and for engines of before 2023 without: `module` is its
 * address, `bindings` a promise of what was generated for it. `whole` is one that takes the place of the first when `widen` is called.
 */
export function entry(simd, scalar, whole = simd) {
  const own = HAS_SIMD ? simd : scalar;
  const wide = HAS_SIMD ? whole : scalar;
  let loading;
  let widening;
  let loaded;
  let broken = false;
  let busy = false;

  /** Loads the module, once; `source` says where it is, if not beside this file, or is a function that does. */
  function init(source) {
    loading ??= instantiate(own, typeof source === "function" ? source() : source).catch((error) => {
      loading = undefined; // so that it can be tried again
      throw error;
    });
    return loading;
  }

  /**
   * Loads what this entry leaves out, once, in place of its own module; what is not left out does the same until then. `source` says where it is,
   * if not beside this file.
   */
  function widen(source) {
    if (wide === own) return init();
    widening ??= instantiate(wide, source).catch((error) => {
      widening = undefined;
      throw error;
    });
    return widening;
  }

  async function instantiate({ module, bindings }, source) {
    const generated = await bindings();
    await generated.default({ module_or_path: source ?? (await onDisk(module())) ?? module() });
    loaded = generated;
    broken = false;
  }

  function call(name, ...args) {
    if (!loaded) throw new PasuError("not-ready", "", "Pasu is not loaded yet: call init() and wait for it first.");
    // A getter that calls what reads it has no end, and an instance must not be replaced under a call that goes on.
    if (busy) throw new PasuError("busy", "", "Pasu is at another call, whose arguments cannot call it themselves.");
    busy = true;
    try {
      if (broken) {
        loaded.__wbg_reset_state();
        broken = false;
      }
      return loaded[name](...args);
    } catch (error) {
      if (error instanceof Error && error.name === "PasuError" && error.code !== "bug") {
        throw new PasuError(error.code, error.path, error.message, { args: error.args, place: error.place });
      }
      // Whatever else comes out of the module is a bug of ours, and the instance can no longer be trusted. It is replaced
      // at the next call, not now: the stack may be what has run out.
      broken = true;
      throw new PasuError("bug", "", error instanceof Error ? error.message : String(error), { cause: error });
    } finally {
      busy = false;
    }
  }

  /** A mesh, where `by` calls the binding. */
  function meshBy(by, source, options) {
    const { taken: into, others } = apart(options, "into");
    return into === undefined ? ofTables(by("mesh", source, others, tables)) : by("mesh", source, others, into);
  }

  /** A mesh of a network, with what gives of it what is another once points are elsewhere. */
  function follow(source, options) {
    const mesh = meshBy(call, source, options);
    const { rows, columns } = options ?? {};
    let known = freshMark();
    call("markLast", known);
    const moved = (moves) => {
      const next = freshMark();
      const answer = call("moved", known, next, moves, { rows, columns });
      if (answer) known = next;
      return answer;
    };
    return { mesh, moved };
  }

  return {
    init,
    widen,
    call,
    follow,
    parse: (source) => call("parse", source),
    link: (source) => call("link", source),
    mesh: (source, options) => meshBy(call, source, options),
    meshBy,
    bound: (source, options) => call("bound", source, options),
    evaluate: (source, part, at) => call("evaluate", source, part, at),
    derivatives: (source, part, at) => call("derivatives", source, part, at),
    fingerprint: (source) => call("fingerprint", source),
    convert: (shape, order) => call("convert", shape, order),
    handles: (shape) => call("handles", shape),
  };
}

/** A module's bytes where the package is imported by its path in Node, whose fetch() does not read files. */
async function onDisk(module) {
  if (module.protocol !== "file:") return undefined;
  const files = "node:fs/promises"; // a name that bundlers for browsers leave alone
  const { readFile } = await import(/* @vite-ignore */ files);
  return readFile(module);
}
