/** Reading and replacing one value deep inside plain data, sharing all that stays the same. */

export type Path = readonly (string | number)[];

/** The value at `path`, or `undefined` where the path leaves the data. */
export function getPath(root: unknown, path: Path): unknown {
  let here = root;
  for (const key of path) {
    if (typeof here !== "object" || here === null) return undefined;
    here = (here as Readonly<Record<string | number, unknown>>)[key];
  }
  return here;
}

/** The number at `path`, or `fallback` where there is none. */
export function numberAt(root: unknown, path: Path, fallback: number): number {
  const value = getPath(root, path);
  return typeof value === "number" ? value : fallback;
}

/** A copy of `root` with `value` at `path`; `root` itself when nothing changes. `undefined` removes a key. */
export function setPath<T>(root: T, path: Path, value: unknown): T {
  return replace(root, path, 0, value) as T;
}

function replace(node: unknown, path: Path, depth: number, value: unknown): unknown {
  const key = path[depth];
  if (key === undefined) return value;
  if (typeof key === "number") {
    const list: readonly unknown[] = Array.isArray(node) ? node : [];
    const next = replace(list[key], path, depth + 1, value);
    if (key < list.length && Object.is(next, list[key])) return node;
    const copy = [...list];
    copy[key] = next;
    return copy;
  }
  const record = (typeof node === "object" && node !== null ? node : {}) as Readonly<Record<string, unknown>>;
  const next = replace(record[key], path, depth + 1, value);
  if (Object.is(next, record[key])) return node;
  if (next !== undefined) return { ...record, [key]: next };
  const { [key]: _removed, ...rest } = record;
  return rest;
}

/** `["parts", 0, "shape", "s", 1]` as `parts[0].shape.s[1]`, the way the solver names a place. */
export function pathText(path: Path): string {
  let text = "";
  for (const key of path) {
    if (typeof key === "number") text += `[${key}]`;
    else text += text === "" ? key : `.${key}`;
  }
  return text;
}

/** The same the other way: the place that the solver names. */
export function pathOf(text: string): Path {
  const keys = text.split(/[.[\]]/).filter((key) => key !== "");
  return keys.map((key) => (/^\d+$/.test(key) ? Number(key) : key));
}

/** Freezes plain data all the way down, so that no part of the page can change a document behind the history's back. */
export function frozen<T>(value: T): T {
  if (typeof value === "object" && value !== null && !Object.isFrozen(value)) {
    Object.freeze(value);
    for (const child of Object.values(value)) frozen(child);
  }
  return value;
}
