/** The pot on the stage mixed with another: both are read where either has a ring, once; every share of them follows from that at once. */

import { inUnitOf, mixable, mixedDesign, places, through, wanted } from "../document/mixing";
import type { Design, Refusal, Rings } from "../document/types";
import type { SolverClient } from "../solver/client";

/** What there is of the other, from 0 to 1, as a design; or why there is none. */
export type Mix =
  | { readonly state: "done"; readonly at: (share: number) => Design }
  | { readonly state: "refused"; readonly refusal: Refusal }
  /** One of them is no single pot of rings, or together they have too many. */
  | { readonly state: "other" | "many" };

export async function mixOf(solver: SolverClient, mine: Design, given: Design): Promise<Mix> {
  const theirs = inUnitOf(mine, given);
  const [one, other] = [mixable(mine), mixable(theirs)];
  if (!one || !other) return { state: "other" };
  const us = places(one, other);
  if (!us) return { state: "many" };
  const foot = one.foot !== undefined || other.foot !== undefined;
  const rim = one.rim !== undefined || other.rim !== undefined;
  const readings = await Promise.all(
    [one, other].map(async (shape, which) => {
      const at = wanted(shape, us);
      const outcome = await solver.read(`mix ${which}`, shape, at.at);
      return outcome.state === "done" ? through(shape, at, outcome.value, { foot, rim }) : outcome;
    }),
  );
  const whole = readings.filter((reading): reading is Rings => "rings" in reading);
  const [first, second] = whole;
  if (first && second)
    return { state: "done", at: (share) => mixedDesign(mine, theirs, { mine: first, theirs: second }, share) };
  const refused = readings.find((reading) => "state" in reading && reading.state === "refused");
  return refused && "refusal" in refused ? { state: "refused", refusal: refused.refusal } : { state: "other" };
}
