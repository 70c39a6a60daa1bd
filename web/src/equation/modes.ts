/** The functions of `u` that a surface is made of: one for each wave of each coordinate, and one for those that are the same. */

import { AXES } from "../document/boundary-value";
import { type Amount, decided } from "./amount";
import { type Component, frequency, type Harmonic, isSilent, type Problem } from "./problem";

/** `q(u)` of a wave. */
export interface Mode {
  /** From 1. */
  readonly index: number;
  readonly component: Component;
  readonly harmonic: Harmonic;
  /** Its angular frequency. */
  readonly k: number;
}

export interface Modes {
  readonly list: readonly Mode[];
  /** The number of the function that stands before a wave. */
  readonly indexOf: ReadonlyMap<Harmonic, number>;
}

export function modesOf({ components, span }: Problem): Modes {
  const found = new Map<string, Mode>();
  const indexOf = new Map<Harmonic, number>();
  for (const axis of AXES) {
    const component = components[axis];
    for (const harmonic of component.harmonics) {
      if (isSilent(harmonic)) continue;
      const k = frequency(harmonic, span);
      const key = keyOf(component, harmonic, k);
      const known = found.get(key);
      const mode = known
        ? { ...known, component: bothOf(known.component, component), harmonic: both(known.harmonic, harmonic) }
        : { index: found.size + 1, component, harmonic, k };
      found.set(key, mode);
      indexOf.set(harmonic, mode.index);
    }
  }
  return { list: [...found.values()], indexOf };
}

/** The functions are the same where all of this is. */
function keyOf({ order, s, t, w, free }: Component, harmonic: Harmonic, k: number): string {
  const { start, end, start_u, end_u, rings, force } = harmonic;
  const numbers = [s, t, w, start, end, start_u, end_u, ...rings, ...force].map(({ value }) => value);
  return [order, free.start, free.end, k, rings.length, ...numbers].join(" ");
}

/** The same number from two places of the shape. */
function either(one: Amount, other: Amount): Amount {
  return decided(one.value, [one, other], one.name);
}

function bothOf(one: Component, other: Component): Component {
  return { ...one, s: either(one.s, other.s), t: either(one.t, other.t), w: either(one.w, other.w) };
}

function both(one: Harmonic, other: Harmonic): Harmonic {
  const lists = (first: readonly Amount[], second: readonly Amount[]) =>
    first.map((amount, index) => either(amount, second[index] ?? amount));
  return {
    ...one,
    n: either(one.n, other.n),
    start: either(one.start, other.start),
    end: either(one.end, other.end),
    start_u: either(one.start_u, other.start_u),
    end_u: either(one.end_u, other.end_u),
    rings: lists(one.rings, other.rings),
    force: lists(one.force, other.force),
  };
}

/** Whether its values at the ends and its slopes there are all that decides it. */
export function isHeldAtEndsAlone({ rings, components }: Problem): boolean {
  return rings.length === 0 && Object.values(components).every(({ free }) => !free.start && !free.end);
}
