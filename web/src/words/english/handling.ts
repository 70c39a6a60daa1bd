/** Whole parts under a hand: moved, turned and scaled on the stage. */

import { phrases } from "../../language";
import type { Handling } from "../../state/session";

export const handling = phrases("handling", {
  tool: "Move parts",
  way: "What a hand does with the parts",
  ways: { move: "Move", turn: "Turn", scale: "Scale" } satisfies Readonly<Record<Handling, string>>,
  steps: "Steps",
  stepsHelp: (length: string, angle: string) =>
    `Lengths in steps of ${length}, angles of ${angle}, and down to the table. With Ctrl held it is the other way round.`,
  toTable: "On the table",
  toTableHelp: "The lowest point of each selected part comes down to the table, or up to it.",
  locked: "What is selected is locked.",
  unseen: "What is selected is hidden.",
  handles: "Handles of the selected parts",
  handle: "handle",
  keys: "Arrow keys move, turn or scale, with Shift further. Over the table, Page Up and Page Down go up and down. Escape takes back what is under way.",
  names: {
    free: "Over the table",
    move: ["Along x", "Along y", "Up and down"],
    turn: ["About x", "About y", "About z"],
    scale: ["Along its own x", "Along its own y", "Along its own z"],
    all: "As a whole",
  },
  /** The letters in the handles. */
  letters: ["x", "y", "z"],
  at: (name: string, where: string) => `${name}: at ${where}`,
  both: (x: string, y: string) => `${x} along x, ${y} along y`,
  /** What was done, beside the hand. */
  along: (letter: string, by: string) => (letter === "" ? by : `${letter} ${by}`),
  joined: (parts: readonly string[]) => parts.join(", "),
  onTable: (by: string) => `${by}, on the table`,
  turnedBy: (degrees: string) => `${degrees}°`,
  times: (factor: string) => `× ${factor}`,
});
