/** What keys do to a handle of placed parts. */

import { scaledBy, unit } from "../../document/moving";
import type { Triple } from "../../document/types";
import { DEGREE, type Grip, type Motion } from "./motion";

/** To the right, away from whoever looks from the front, and up. */
type Way = readonly [right: number, forward: number, page: number];

const WAYS: Readonly<Record<string, Way>> = {
  ArrowRight: [1, 0, 0],
  ArrowLeft: [-1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

/** A press, and one with the shift key. */
const ANGLES = [1, 15] as const;
const FACTORS = [1.01, 1.1] as const;
/** The shift key goes by the steps in which a hand snaps; without it one goes by a tenth of them. */
const SMALL = 0.1;

export function gripKey(key: string): Way | null {
  return WAYS[key] ?? null;
}

/** The motion of one press; null where the key means nothing at this handle. */
export function keyMotion(grip: Grip, [right, forward, page]: Way, step: number, far: boolean): Motion | null {
  const length = (far ? 1 : SMALL) * step;
  const by = (way: Triple): Motion => ({ kind: "move", by: scaledBy(length, way), onTable: false });
  if (grip.kind === "free") return by([right, forward, page]);
  const way = right + forward + page;
  switch (grip.kind) {
    case "move":
      return by(scaledBy(way, unit(grip.axis)));
    case "turn":
      return { kind: "turn", axis: grip.axis, angle: way * ANGLES[far ? 1 : 0] * DEGREE };
    case "scale":
      return { kind: "scale", axis: grip.axis, factor: FACTORS[far ? 1 : 0] ** way };
  }
}
