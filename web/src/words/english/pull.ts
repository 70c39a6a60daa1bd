/** A hand on the pot: the tool that pulls, and the rings that it takes hold of. */

import type { Spread, Way } from "../../document/brush";
import type { Lock } from "../../document/locks";
import { phrases } from "../../language";

export const pull = phrases("pull", {
  tool: "Pull",
  way: "Which way",
  ways: { out: "Out", up: "Up", round: "Round", free: "Free" } satisfies Readonly<Record<Way, string>>,
  wayHelp: {
    out: "Away from the axis and towards it",
    up: "Up and down (Shift)",
    round: "Round the axis (Alt)",
    free: "As the hand goes",
  } satisfies Readonly<Record<Way, string>>,
  spread: "Where",
  spreads: { all: "All round", side: "One side", petals: "Petals" } satisfies Readonly<Record<Spread, string>>,
  width: "Width",
  widthHelp: "Width (wheel with Shift)",
  degrees: (width: string) => `${width}°`,
  petals: "Number of petals",
  fewer: "Fewer petals",
  more: "More petals",
  rings: "Rings",
  handle: "handle",
  foot: "Foot",
  rim: "Rim",
  ring: (number: number) => `Ring ${number}`,
  end: (number: number) => `End ${number}`,
  middle: "Middle",
  places: "Places to pull at",
  keysOfFamily: "Arrow keys pull the pot here, with shift further, with alt round the axis.",
  keep: "Keep",
  locks: {
    rim: "Rim",
    foot: "Foot",
    height: "Height",
    slopes: "Slope of both ends",
    capacity: "What it holds",
  } satisfies Readonly<Record<Lock, string>>,
  keepHelp: "What is ticked stays as it is while you pull.",
  keepCapacity:
    "While you pull, the pot becomes lower or higher so that it holds what it held, and exactly that when you let go; with the rim or the height kept as well, its other rings become narrower or wider.",
  spilt: "Nothing else that is free can make up for this: the pot holds something else now. Undo takes the pull back.",
  keys: "Arrow keys move the ring, plus and minus set the width of the pull, Delete removes the ring.",
  at: (name: string, radius: string, height: string) => `${name}: radius ${radius}, height ${height}`,
  removed: (name: string) => `${name} is gone.`,
  behind: "This form cannot follow any further with the numbers that it has.",
  free: "Make it rings",
});
