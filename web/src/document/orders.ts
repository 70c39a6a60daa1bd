/** The orders of the equation in a potter's words: what each can do, and what a vase that is switched has to leave behind. */

import type { Kind, Loss, OrderKind } from "./types";

export const ORDER_KINDS: readonly OrderKind[] = ["second-order", "mixed-order", "fourth-order"];

/** What an order can and cannot do, in a potter's words. */
export interface OrderNote {
  readonly title: string;
  readonly can: readonly string[];
  readonly cannot: readonly string[];
}

export const ORDER_NOTES: Readonly<Record<OrderKind, OrderNote>> = {
  "second-order": {
    title: "Second order",
    can: ["Set where the rim and the foot are", "Petals on the rim and the foot", "A waist, and a push along the wall"],
    cannot: ["Choose how the wall leaves the rim or the foot", "Swell into a belly without a push"],
  },
  "mixed-order": {
    title: "Mixed order",
    can: ["All of second order", "Choose how steeply the wall leaves the rim: a flat lip, or a drop"],
    cannot: ["Choose the slope at the foot", "Choose how far the wall leans out at either end"],
  },
  "fourth-order": {
    title: "Fourth order",
    can: ["Set where the rim and the foot are", "Choose the slope of the wall at both ends", "Bellies, necks and feet"],
    cannot: ["Petals (use free boundary data for those)", "A push along the wall"],
  },
};

export const LOSS_WORDS: Readonly<Record<Loss, string>> = {
  dints: "The dints of the rim are left out.",
  skew: "The skew of the rim is left out.",
  petals: "The petals are left out.",
  push: "The push along the wall is left out.",
  turns: "The wall now goes round once.",
  rise: "The rise of the wall becomes even.",
  slopes: "The slopes at rim and foot are left to the equation.",
};

/** Whether a shape can be switched as a whole. */
export function convertible(kind: Kind): boolean {
  return kind !== "boundary-value";
}
