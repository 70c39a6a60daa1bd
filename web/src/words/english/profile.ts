/** The section of the pot and its handles. */

import type { HandleId, Restraint } from "../../document/types";
import { phrases } from "../../language";

export const profile = phrases("profile", {
  handles: {
    rim: "Rim",
    foot: "Foot",
    "rim-slope": "Slope at the rim",
    "foot-slope": "Slope at the foot",
  } satisfies Readonly<Record<HandleId, string>>,
  /** Why a handle does not move, or moves one way only. */
  restraints: {
    "foot-height": "The foot of this family always stands at height 0.",
    "second-order-slope": "Second order leaves the slope to the equation. Switch to mixed or fourth order to set it.",
    "mixed-order-lean": "Mixed order sets the rise at the rim, not the lean.",
    "mixed-order-foot": "In mixed order the wall always ends level at the foot.",
    "no-swell": "With this belly radius the flares have no effect. Change the belly radius to free them.",
    "level-foot": "The dint vase always ends level at the foot.",
    "no-radius": "There is no first harmonic in x and y, so there is no radius to drag.",
    "lean-order": "The lean needs x and y of order 4.",
    "free-end": "This end is free: the wall leaves it as it likes.",
    "rise-order": "The rise needs z of order 4.",
  } satisfies Readonly<Record<Restraint, string>>,
  draw: "Draw or trace it…",
  coming: "The section appears with the pot.",
  network: "A network of patches has no profile: it goes round no axis.",
  octant: "An octant has no profile: it goes round no axis.",
  blend: "A blend has no profile: it goes round no axis.",
  lead: "The pot cut through its axis. Drag a handle, or focus it and use the arrow keys, with shift for larger steps.",
  /** Of a pot of rings, behind the sentence above. */
  rings:
    "Double-click the wall to put a ring there, which changes nothing until it is moved. With keys, plus adds one above and Delete takes one away.",
  ring: (number: number) => `Ring ${number}`,
  section: "Section through the axis",
  handle: "handle",
  /** Which ways a handle moves. */
  ways: { move: "moves both ways", across: "moves left and right", along: "moves up and down" },
  named: (handle: string, ways: string) => `${handle}, ${ways}`,
  slope: (lean: string, rise: string) => `Lean ${lean}, rise ${rise}`,
  point: (radius: string, height: string) => `Radius ${radius}, height ${height}`,
  sentences: (all: readonly string[]) => all.join(" "),
});
