// Whether a design that is handed over is the one of before, told without reading it strictly: of hundreds of parts that takes twenty times as long as an answer.
//
// Two values are the same here only where whatever reads them finds the same: the same keys in the same order, the same lengths, the same numbers to the sign of a zero. A copy is taken of what was read,
// because the caller may change what is theirs between two calls. Nobody can change a text: that it is the same is told at once.

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

  /** Whether a source is what was read before. */
  function isKnown(source) {
    if (source === known.fixed) return true;
    if (!found(() => isStill(source, known.items))) return false;
    if (found(() => isFixed(source))) known.fixed = source;
    return true;
  }

  return (name, source, about) => {
    // A getter that calls what looks at it has no end.
    if (source === null || !["string", "object"].includes(typeof source) || looking) return call(name, source, about);
    if (known && isKnown(source)) {
      const answer = call(`${name}Again`, known.mark, about);
      if (answer !== undefined) return answer;
    }
    known = undefined;
    const copy = found(() => copied(source));
    if (copy === undefined) return call(name, source, about);
    const answer = call(name, copy.plain, about);
    const mark = freshMark();
    call("markLast", mark);
    const fixed = found(() => isFixed(source)) ? source : undefined;
    known = { items: copy.known, fixed, mark };
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
 * `plain` is the copy, `known` the same as lists of keys and of values, which are gone through faster than objects.
 */
export function copied(value) {
  let left = MOST_VALUES;
  function copy(value, depth) {
    left -= 1;
    if (left < 0 || depth > DEEPEST) return undefined;
    if (typeof value !== "object" || value === null) return { plain: value, known: value };
    if (ArrayBuffer.isView(value)) return undefined;
    const keys = Array.isArray(value) ? null : Object.keys(value);
    const { length } = keys ?? value;
    if (length > left) return undefined;
    const plain = keys ? {} : [];
    const items = [];
    for (let i = 0; i < length; i += 1) {
      const key = keys ? keys[i] : i;
      if (key === "__proto__") return undefined;
      const item = copy(value[key], depth + 1);
      if (item === undefined) return undefined;
      items.push(item.known);
      plain[key] = item.plain;
    }
    return { plain, known: { keys, items } };
  }
  return copy(value, 0);
}

/** Whether nothing of a value can ever be another: all of it is frozen, and none of it is computed. */
function isFixed(value) {
  if (typeof value !== "object" || value === null) return true;
  if (!Object.isFrozen(value)) return false;
  const own = Object.values(Object.getOwnPropertyDescriptors(value));
  return own.every((descriptor) => "value" in descriptor && isFixed(descriptor.value));
}

/** Whether a value is what `known` was taken of. Whatever getters and proxies throw is thrown. */
export function isStill(value, known) {
  if (typeof known !== "object" || known === null) return Object.is(value, known);
  if (typeof value !== "object" || value === null) return false;
  const { keys, items } = known;
  const { length } = items;
  if (keys === null) {
    if (!Array.isArray(value) || value.length !== length) return false;
    for (let i = 0; i < length; i += 1) if (!isSame(value[i], items[i])) return false;
    return true;
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return false;
  let i = 0;
  // Keys that are inherited are found as well, and make it another: it is read then. `Object.keys` would make a list of each.
  for (const key in value) {
    if (i >= length || key !== keys[i] || !isSame(value[key], items[i])) return false;
    i += 1;
  }
  return i === length;
}

/** Most values are numbers, for which no call is worth while. */
function isSame(value, known) {
  return typeof known === "number" ? Object.is(value, known) : isStill(value, known);
}
