/** Whether a pot can be made: the findings of the checks, and what would help. */

import type { PlaceName } from "../../document/places";
import { phrases } from "../../language";

export const report = phrases("report", {
  /** Inside a sentence. */
  places: {
    foot: "at the foot",
    belly: "at the belly",
    shoulder: "at the shoulder",
    neck: "at the neck",
    rim: "at the rim",
    middle: "half way up",
  } satisfies Readonly<Record<PlaceName, string>>,
  inside: { rim: "inside the rim", neck: "inside the neck", shoulder: "inside the shoulder" },
  inPlaces: "in places",
  closed: "The mesh is closed, every edge is shared by two triangles, and it does not cross itself.",
  /** A sentence that ends without its full stop, and where that is. */
  placed: (sentence: string, place: string) => `${sentence} (${place}).`,
  ofPart: (name: string, sentence: string) => `${name}: ${sentence}`,
  thinnedTo: (thinnest: string, place: string, share: string) =>
    `The wall is thinned to ${thinnest} ${place}, where the pot bends more tightly or comes closer to itself than the wall is thick: ${share} of it is thinner than asked for.`,
  /** The same where there is little room. */
  thinnedBrief: (thinnest: string, place: string) => `The wall is thinned to ${thinnest} ${place}.`,
  thinned: (thinnest: string, place: string, asked: string) =>
    `The wall is thinned to ${thinnest} ${place}, where the pot bends too tightly for ${asked}.`,
  tooThin: (thin: string, place: string) =>
    `The wall is only ${thin} thick ${place}: too thin for most clay and most printers at this size.`,
  overhang: (angle: string, place: string) => `Overhang of ${angle} ${place}: a printer needs support there.`,
  /** `place` is null where it has no name. */
  steepest: (angle: string, place: string | null) =>
    place === null
      ? `The steepest overhang is ${angle}: it prints without support.`
      : `The steepest overhang is ${angle}, ${place}: it prints without support.`,
  /** Of a pot that has a ceiling beneath it, of which another sentence speaks. */
  steepestOfWall: (angle: string, place: string | null) =>
    place === null
      ? `The steepest overhang of the wall is ${angle}: it prints without support.`
      : `The steepest overhang of the wall is ${angle}, ${place}: it prints without support.`,
  noOverhangOfWall: "The wall hangs over nowhere: it prints without support.",
  noOverhang: "Nothing hangs over: it prints without support.",
  falls: "It falls over: its weight is not above its foot.",
  fallsFull: "It stands empty, but falls over when it is full.",
  stands: (empty: string) => `It stands: empty it tips when tilted by ${empty}.`,
  standsFull: (empty: string, full: string) =>
    `It stands: empty it tips when tilted by ${empty}, and when full by ${full}.`,
  tips: (empty: string) => `It tips easily: empty when tilted by ${empty}.`,
  tipsFull: (empty: string, full: string) => `It tips easily: empty when tilted by ${empty}, and when full by ${full}.`,
  fittedFoot: (width: string, height: string) =>
    `There is no room for the foot ring that was asked for: it is made ${width} wide and ${height} high.`,
  fittedDrain: (width: string) => `There is no room for the drain that was asked for: it is made ${width} wide.`,
  /** Three layers are usual, and a part of one is nothing. */
  thinBase: {
    "not-printed": (thickness: string, least: string) =>
      `The base is only ${thickness} thick: a layer is usually ${least}, and what is thinner is not printed.`,
    "breaks-printed": (thickness: string, least: string) =>
      `The base is only ${thickness} thick: three layers are usually ${least}, and fewer leak and break.`,
    "no-clay": (thickness: string, least: string) =>
      `The base is only ${thickness} thick: clay of less than ${least} does not hold.`,
    "breaks-fired": (thickness: string, least: string) =>
      `The base is only ${thickness} thick: clay of less than ${least} warps and breaks.`,
  },
  ceiling: (width: string, height: string) =>
    `The base within the foot ring is a ceiling, ${width} wide and ${height} above the ground: printers bridge it or need support.`,
  underside: (height: string) => `The underside is up to ${height} above the ground: printers need support beneath it.`,
  /** One part and another. */
  together: {
    "same-body": (other: string) => `It is the same body in the same place as ${other}.`,
    touches: (other: string) => `It touches or runs through ${other}.`,
    within: (other: string) => `It lies within the clay of ${other}.`,
    round: (other: string) => `It has clay round all of ${other}.`,
    "not-joined": (other: string) =>
      `It cannot be joined with ${other} into one solid: their surfaces meet too closely to be told apart. Move one of them a little, or leave them apart.`,
    "pinched-joint": (other: string) =>
      `It cannot be joined with ${other} into one solid: where they touch along an edge or at a point alone it would be pinched. Let them meet in a face or run into each other, or leave them apart.`,
  },
  unkept: (bound: string, asked: string) =>
    `The triangles come within ${bound} of the wall, not within ${asked} as asked for: its other side bends too sharply for that.`,
  joined: (bound: string, asked: string) =>
    `Joined with others, the triangles come within ${bound} of this part, not within ${asked} as asked for: where surfaces all but coincide, joining moves them a little.`,
  leftOut: "This part has no wall and is left out of the pots: with thickness and base it is one.",
  remedies: {
    outwards: "the clay laid outwards",
    inwards: "the clay laid inwards",
    wall: (thickness: string) => `a wall of ${thickness}`,
    base: (thickness: string) => `a base of ${thickness}`,
    flatRim: "a flat rim",
    ring: (width: string, height: string) => `a ring ${width} wide and ${height} high`,
    noRing: "no ring",
    drain: (width: string) => `a drain of ${width}`,
    noDrain: "no drain",
    follows: "an inside that follows the outside",
    roundInside: "Make the inside round, so that the wall keeps its thickness",
    make: (changes: readonly string[]) => `Make it with ${changes.join(" and ")}`,
  },
});
