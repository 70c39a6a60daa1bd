/** What a new design may begin as: one plain pot of each kind. */

import { familyOf } from "./schema";
import type { Design, Kind, Shape } from "./types";

export interface Beginning {
  readonly kind: Kind;
  readonly title: string;
  readonly note: string;
}

export const BEGINNINGS: readonly Beginning[] = [
  { kind: "fourth-order", title: "Fourth order", note: "Bellies and necks: the slopes at rim and foot are yours." },
  { kind: "second-order", title: "Second order", note: "Petals and a waist between two edges." },
  { kind: "mixed-order", title: "Mixed order", note: "Petals, and how steeply the wall leaves the rim." },
  { kind: "bloor-wilson", title: "Bloor–Wilson", note: "The dint vase: waves in the rim that fade in the wall." },
  { kind: "boundary-value", title: "Free boundary data", note: "Any edges, wave by wave. For those who like tables." },
];

/** A round pot of free boundary data, to add waves to. */
const FREE: Shape = {
  kind: "boundary-value",
  span: "2pi",
  x: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, cos: { start: 1, end: 0.6, start_u: -1.6, end_u: -1.2 } }] },
  y: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, sin: { start: 1, end: 0.6, start_u: -1.6, end_u: -1.2 } }] },
  z: { order: 2, s: 1, t: 1, modes: [{ n: 0, cos: { start: 2.4, end: 0 } }] },
};

export function beginningOf(kind: Kind): Design {
  return { pasu: 1, parts: [{ shape: familyOf(kind)?.reset ?? FREE }] };
}
