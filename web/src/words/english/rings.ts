/** A pot of rings: what each is like in a potter's words, the whole pot, and its numbers. `u` is that of the equation. */

import type { SwingName } from "../../document/ring-numbers";
import type { PetalsAt } from "../../document/whole-pot";
import { listed, phrases, plural } from "../../language";

export const rings = phrases("rings", {
  lead: "A pot of rings.",
  about: "The wall passes through every ring, and bends as little as its equation lets it in between.",
  pull: "Pull it on the stage",
  rim: "Rim",
  foot: "Foot",
  ring: (number: number) => `Ring ${number}`,
  radius: "Radius",
  height: "Height",
  of: (what: string, ring: string) => `${what}, ${ring}`,
  sharp: "Sharp",
  swingsOf: "Oval, petals, tilt and waves",
  /** What a ring is like, behind its name. */
  like: (all: readonly string[]) => listed(all),
  swings: {
    oval: "Oval",
    petals: "Petals",
    tilt: "Tilt",
    waves: "Waves",
  } satisfies Readonly<Record<SwingName, string>>,
  tags: {
    oval: () => "oval",
    petals: (count: number) => plural(count, { one: "1 petal", other: `${count} petals` }),
    tilt: () => "tilted",
    waves: (count: number) => plural(count, { one: "1 wave", other: `${count} waves` }),
  } satisfies Readonly<Record<SwingName, (count: number) => string>>,
  sizes: {
    oval: "Longer by",
    petals: "Depth",
    tilt: "Higher by",
    waves: "Height",
  } satisfies Readonly<Record<SwingName, string>>,
  count: "Number",
  turn: "Turn",
  degree: "°",
  pulled: (count: number) =>
    plural(count, { one: "and 1 wave that was pulled", other: `and ${count} waves that were pulled` }),
  pulledTag: "pulled",
  does: (ring: string) => `Change ${ring}`,
  above: "Add a ring above",
  below: "Add a ring below",
  makeRound: "Make it round",
  freeEnd: "Free the slope here",
  remove: "Delete",
  noRoom: "There is no room for one more ring here.",

  whole: "The whole pot",
  wholeAbout: "every ring at once",
  across: "Width",
  twist: "Twist",
  lean: "Lean",
  taper: "Taper",
  petals: "Petals",
  depth: "Depth of the petals",
  petalsAt: "Where the petals are",
  flutes: "Flutes",
  fluteDepth: "Depth of the flutes",
  places: { all: "All over", rim: "Rim", belly: "Belly", foot: "Foot" } satisfies Readonly<Record<PetalsAt, string>>,
  help: {
    height: "From the foot to the rim.",
    across: "Across the widest ring.",
    twist: "How far the rim is turned against the foot. It shows where a ring is not round.",
    lean: "How far the rim stands beside the foot.",
    oval: "How much longer one way than round.",
    taper: "Wider at the rim and narrower at the foot, or the other way.",
    petals: "How many petals the depth adds.",
    depth: "How far petals swing out.",
    flutes: "How many flutes the depth adds.",
    fluteDepth: "From the ridges to the bottom of the grooves.",
  },

  numbers: "As numbers",
  numbersAbout: "what the equation is given",
  smoothing: "Smoothing",
  place: "Place u",
  waves: (count: number) => plural(count, { one: "with 1 wave round it", other: `with ${count} waves round it` }),
});
