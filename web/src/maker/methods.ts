/** The same blend by each method that solves it: how long that takes, what it leaves of the equation, and how far its inside is from the others. */

import { evaluate, inside } from "pasu";
import { loftShares } from "../document/blend/loft";
import { type Method, methodsFor, termsOf, termsUsed, withMethod } from "../document/blend/solving";
import type { Blend, Design, Sent, Triple } from "../document/types";
import type { MethodsAsk, Solved } from "./messages";

/** How often each is solved: the shortest time is told, as whatever else a machine does only adds to it. */
const ROUNDS = 5;

/** Points along each parameter at which insides are compared, none of them on the border. */
const COMPARED = 9;

export function methodsOf({ design, part }: MethodsAsk): readonly Solved[] {
  const blend = design.parts[part]?.shape;
  if (blend?.kind !== "blend") throw new Error("what is solved by several methods is a blend");
  const ways = methodsFor(blend).map((method) => ({ method, design: alone(withMethod(blend, method)) }));
  const times = new Map<Method, number>();
  // In turns: what was solved last is kept, and would cost nothing.
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const way of ways) {
      const begun = performance.now();
      evaluate(way.design, 0, [0.5, 0.5, 0.5]);
      times.set(way.method, Math.min(times.get(way.method) ?? Number.POSITIVE_INFINITY, performance.now() - begun));
    }
  }
  const at = places();
  const own = evaluate(alone(blend), 0, at);
  const loft = loftOf(blend, at);
  return ways.map((way) => {
    const found = evaluate(way.design, 0, at);
    const { residual, residualRms } = inside(way.design, 0);
    return {
      method: way.method,
      terms: termsOf(blend).slice(0, termsUsed(way.method)),
      milliseconds: times.get(way.method) ?? 0,
      residual,
      mean: residualRms,
      apart: farthest(found, own),
      fromLoft: farthest(found, loft),
    };
  });
}

/** The blend by itself: no other part takes time. */
function alone(shape: Blend): Sent {
  return { pasu: 1, parts: [{ shape }] } satisfies Design as Sent;
}

function places(): Float64Array<ArrayBuffer> {
  const share = (index: number) => (index + 0.5) / COMPARED;
  const each = Array.from({ length: COMPARED }, (_, index) => share(index));
  return Float64Array.from(each.flatMap((w) => each.flatMap((u) => each.flatMap((v): Triple => [u, v, w]))));
}

/** `x`, `y` and `z` of a plain loft; its `z` is that of every method. */
function loftOf(blend: Blend, at: Float64Array<ArrayBuffer>): Float64Array {
  const { start, end } = blend;
  const ends = [0, 1].map((w) => {
    const there = at.slice();
    for (let place = 2; place < there.length; place += 3) there[place] = w;
    return evaluate(alone(blend), 0, there);
  });
  const found = evaluate(alone(blend), 0, at);
  for (let place = 0; place < found.length; place += 3) {
    const shares = loftShares(at[place + 2] ?? 0, [start.taper, end.taper]);
    for (const axis of [0, 1]) {
      const [one, other] = ends.map((points) => points[place + axis] ?? 0);
      found[place + axis] = shares[0] * (one ?? 0) + shares[1] * (other ?? 0);
    }
  }
  return found;
}

function farthest(one: Float64Array, other: Float64Array): number {
  let most = 0;
  for (let place = 0; place < one.length; place += 3) {
    const gap = [0, 1, 2].map((axis) => (one[place + axis] ?? 0) - (other[place + axis] ?? 0));
    most = Math.max(most, Math.hypot(...gap));
  }
  return most;
}
