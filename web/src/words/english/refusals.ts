/** What is said when something is refused: of which thing, and why. Codes that are not here speak in the library's own words. */

import { phrases } from "../../language";

const range = (least: string | null, greatest: string | null) =>
  least !== null && greatest !== null
    ? `a number from ${least} to ${greatest}`
    : least !== null
      ? `a number of at least ${least}`
      : `at most ${greatest}`;

export const refusals = phrases("refusals", {
  /** What it is about, and the sentence. */
  of: (subject: string, sentence: string) => `${subject.charAt(0).toUpperCase()}${subject.slice(1)}: ${sentence}`,
  /** From the large to the small: a part, a number of it. */
  within: (subjects: readonly string[]) => subjects.join(", "),
  fields: {
    title: "Title",
    unit: "Unit",
    name: "Name",
    place: "Place",
    joints: "Slider",
    parts: "Parts",
    object: "Glued to",
    wall: "Wall",
    look: "Glaze and clay",
  },
  /** The limits of a slider. */
  limits: ["From", "To"],
  /** A field that has no name but its own in the document. */
  field: (name: string) => `“${name}”`,
  /** Of free boundary data. */
  component: (axis: string) => `equation of ${axis}`,
  mode: (n: string) => `wave ${n}`,
  axes: ["x", "y", "z"],
  exponent: (axis: string) => `exponent of ${axis}`,
  /** Where a part stands; of what has three numbers, along which axis. */
  placed: {
    scale: (axis: string) => `scale along ${axis}`,
    shift: (axis: string) => `moved along ${axis}`,
    axis: () => "axis",
    angle: () => "turn",
  },
  /** Of a network of patches, all counted from 1. */
  network: {
    patches: "patches",
    vertices: "points",
    patch: (n: string) => `patch ${n}`,
    point: (n: string) => `point ${n}`,
    force: (n: string) => `force ${n}`,
    corner: (n: string) => `number of its point ${n}`,
    frame: "its points",
    a1: "along u",
    a2: "along v",
    f0: "strength",
    falloff: "falls off",
    component: (axis: string) => `in ${axis}`,
    ends: [(axis: string) => `${axis} from`, (axis: string) => `${axis} to`],
  },
  /** In the library's words, for which there are none here. */
  library: (sentence: string) => sentence,
  /** By code, what a language says in general where the library's English sentence says more. */
  general: {} as Readonly<Record<string, string>>,
  range,
  open: (above: string | null, below: string | null) =>
    above !== null && below !== null
      ? `a number greater than ${above} and less than ${below}`
      : above !== null
        ? `a number greater than ${above}`
        : `a number less than ${below}`,
  not: (number: string) => `a number other than ${number}`,
  hasToBe: (expected: string) => `It has to be ${expected}.`,
  hasToBeNot: (expected: string, found: string) => `It has to be ${expected}, and is ${found}.`,
  quoted: (text: string) => `“${text}”`,
  unknownField: (found: string, words: string) => `“${found}” is nothing that is known here. What is known: ${words}.`,
  missing: "It is missing.",
  notFinite: "It has to be a number that can be computed with.",
  tooMany: (found: string, greatest: string) => `There are ${found}; at most ${greatest} are possible.`,
  tooManyPoints: "It has so many waves that drawing it would take more points than can be drawn.",
  noWall: "This part has no wall. With one it is a pot.",
  overflow: "Its numbers grow so large that they cannot be computed. Smaller ones can.",
  resonant:
    "The equation swings between foot and rim by itself, so that the edges do not decide the surface. Change a weight of the equation or the number of waves a little.",
  fileTooLarge: (name: string) => `“${name}” is too large to be a design of Pasu.`,
  noDesign: (name: string) =>
    `“${name}” cannot be opened: it holds no design, because Pasu did not save it or another program has changed it.`,
  noDesignInStl: (name: string) =>
    `“${name}” cannot be opened: an STL holds triangles, and a design only if its link is very short. Open the link, or another file that Pasu saved.`,
  solverStopped: "The solver stopped on this design and was started again. Undo the last change, or go on.",
  makerStopped:
    "The part of Pasu that makes pots stopped on this design and was started again. Change something, or try again.",
  solverUnusable: (why: string) => `The solver could not be used: ${why}`,
  makerUnusable: (why: string) => `This could not be made: ${why}`,
});
