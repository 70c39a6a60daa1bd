// Whether a design that is handed over is the one of before, told without reading it strictly: of hundreds of parts that takes twenty times as long as an answer.
//
// Two values are the same here only where whatever reads them finds the same: the same keys in the same order, the same lengths, the same numbers to the sign of a zero. A copy is taken of what was read,
// because the caller may change what is theirs between two calls.

import { freshMark } from "./wrapper.js";

/** Calls a binding about a design by its name, or that which answers of the design of before without reading it (`pickAgain` of `pick`). */
export function remembering(call) {
  let known;
  let looking = false;

  /** What is found of the caller's values; `undefined` where something is thrown, as it will be again where they are read. */
  function found(look) {
    looking = true;
    try {
      return look();
    } catch {
      return undefined;
    } finally {
      looking = false;
    }
  }

  return (name, source, about) => {
    // Texts are known to the module, and a getter that calls what looks at it has no end.
    if (typeof source !== "object" || source === null || looking) return call(name, source, about);
    if (known && found(() => isStill(source, known.copy))) {
      const answer = call(`${name}Again`, known.mark, about);
      if (answer !== undefined) return answer;
    }
    known = undefined;
    const copy = found(() => copied(source));
    if (copy === undefined) return call(name, source, about);
    const answer = call(name, copy.plain, about);
    const mark = freshMark();
    call("markLast", mark);
    known = { copy, mark };
    return answer;
  };
}

/** The most values of which a copy is kept: some thirty times as many as five hundred parts are. */
const MOST_VALUES = 2 ** 18;

/** No design is deeper. What goes in a circle is. */
const DEEPEST = 32;

/**
 * A copy of plain data; `undefined` of what is not plain, which has to be read as it is. Getters and proxies are asked once, and whatever they throw is thrown.
 *
 * Of objects the keys and values are kept in two lists, which are gone through faster than an object; `plain` is the object.
 */
export function copied(value) {
  let left = MOST_VALUES;
  function copy(value, depth) {
    left -= 1;
    if (left < 0 || depth > DEEPEST) return undefined;
    if (typeof value !== "object" || value === null) return { plain: value };
    if (ArrayBuffer.isView(value)) return undefined;
    if (Array.isArray(value)) {
      const { length } = value;
      if (length > left) return undefined;
      const items = [];
      const plain = [];
      for (let i = 0; i < length; i += 1) {
        const item = copy(value[i], depth + 1);
        if (item === undefined) return undefined;
        items.push(item);
        plain.push(item.plain);
      }
      return { items, plain };
    }
    const keys = Object.keys(value);
    if (keys.length > left) return undefined;
    const items = [];
    const plain = {};
    for (const key of keys) {
      if (key === "__proto__") return undefined;
      const item = copy(value[key], depth + 1);
      if (item === undefined) return undefined;
      items.push(item);
      plain[key] = item.plain;
    }
    return { keys, items, plain };
  }
  return copy(value, 0);
}

/** Whether a value is what a copy was taken of. Whatever getters and proxies throw is thrown. */
export function isStill(value, known) {
  const { items, keys } = known;
  if (items === undefined) return Object.is(value, known.plain);
  if (typeof value !== "object" || value === null) return false;
  const { length } = items;
  if (keys === undefined) {
    if (!Array.isArray(value) || value.length !== length) return false;
    for (let i = 0; i < length; i += 1) if (!isStill(value[i], items[i])) return false;
    return true;
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return false;
  const own = Object.keys(value);
  if (own.length !== length) return false;
  for (let i = 0; i < length; i += 1) {
    const key = keys[i];
    if (own[i] !== key || !isStill(value[key], items[i])) return false;
  }
  return true;
}
