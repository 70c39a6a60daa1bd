/** The orders of the equation in a potter's words: what each can do, and what a vase that is switched has to leave behind. */

import type { Loss, OrderKind } from "../../document/types";
import { phrases } from "../../language";

interface OrderNote {
  readonly can: readonly string[];
  readonly cannot: readonly string[];
}

export const orders = phrases("orders", {
  notes: {
    "second-order": {
      can: [
        "Set where the rim and the foot are",
        "Petals on the rim and the foot",
        "A waist, and a push along the wall",
      ],
      cannot: ["Choose how the wall leaves the rim or the foot", "Swell into a belly without a push"],
    },
    "mixed-order": {
      can: ["All of second order", "Choose how steeply the wall leaves the rim: a flat lip, or a drop"],
      cannot: ["Choose the slope at the foot", "Choose how far the wall leans out at either end"],
    },
    "fourth-order": {
      can: [
        "Set where the rim and the foot are",
        "Choose the slope of the wall at both ends",
        "Bellies, necks and feet",
      ],
      cannot: ["Petals (use free boundary data for those)", "A push along the wall"],
    },
  } satisfies Readonly<Record<OrderKind, OrderNote>>,
  losses: {
    dints: "The dints of the rim are left out.",
    skew: "The skew of the rim is left out.",
    petals: "The petals are left out.",
    push: "The push along the wall is left out.",
    turns: "The wall now goes round once.",
    rise: "The rise of the wall becomes even.",
    slopes: "The slopes at rim and foot are left to the equation.",
  } satisfies Readonly<Record<Loss, string>>,
  allFree:
    "This pot is made of free boundary data: the order of each direction is set with its modes, under Shape. Only the named families can be switched as a whole.",
  rings:
    "A pot of rings is of fourth order: its wall passes through every ring. No other order has them, so it stays as it is.",
  network: "A network of patches has no rim and no foot, so it cannot be converted to another order.",
  octant: "An octant has no rim and no foot, so it cannot be converted to another order.",
  blend: "A blend is a solid of fourth order between its sections, so it stays as it is.",
  lead: "The order of the equation decides how much of a wall can be chosen. Switching keeps the rim, the foot and the height, and undo brings the old wall back.",
  thisPot: "This pot",
  /** Before what an order cannot do, for whoever hears it. */
  not: "Not: ",
  ifYouSwitch: (losses: readonly string[]) => `If you switch: ${losses.join(" ")}`,
  notSwitched: (why: string) => `Not switched. ${why}`,
  compare: "Show side by side",
  stop: "Stop comparing",
  compareWith: (order: string) => `Show side by side with ${order}`,
  stopWith: (order: string) => `Stop comparing with ${order}`,
  switch: "Switch",
  switchTo: (order: string) => `Switch to ${order}`,
});
