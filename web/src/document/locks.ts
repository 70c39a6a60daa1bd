/** What of a named family stays while a hand pulls it: groups of its numbers, as a potter thinks of them. */

import { pathText } from "./path";
import { familyOf, type Group } from "./schema";
import type { Shape } from "./types";

export const LOCKS = ["rim", "foot", "height"] as const satisfies readonly Group[];

export type Lock = (typeof LOCKS)[number];

/** Those that a shape has numbers for. */
export function locksOf(shape: Shape): readonly Lock[] {
  const fields = familyOf(shape.kind)?.fields ?? [];
  return LOCKS.filter((lock) => fields.some(({ group }) => group === lock));
}

/** The numbers that stay, by the names of the solver; none of a shape that is no family. */
export function keptBy(shape: Shape, locked: readonly Lock[]): readonly string[] {
  const fields = familyOf(shape.kind)?.fields ?? [];
  return fields.filter(({ group }) => locked.some((lock) => lock === group)).map(({ path }) => pathText(path));
}

/** The same with one more locked, or no longer. */
export function withLock(locked: readonly Lock[], lock: Lock, on: boolean): readonly Lock[] {
  return LOCKS.filter((each) => (each === lock ? on : locked.includes(each)));
}
