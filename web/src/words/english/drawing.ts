/** Drawing a pot, or tracing a picture of one. */

import { phrases, plural } from "../../language";

export const drawing = phrases("drawing", {
  heading: "Draw or trace a pot",
  lead: "Draw the wall from the foot to the rim, with the mouse, a pen or a finger. Or trace it from a picture. Then drag the points until it is right.",
  board: "Sheet to draw on",
  axisName: "Axis, moves left and right",
  handle: "handle",
  sides: { right: "Right", left: "Left" },
  /** A point of the line, by its number from the foot on. */
  point: (number: number) => `Point ${number}`,
  pointOn: (number: number, side: string) => `Point ${number}, ${side}`,
  at: (name: string, radius: string, height: string) => `${name}: radius ${radius}, height ${height}`,
  /** What became of the line, and the point that has the focus. */
  added: (all: number, reading: string) => `Added, ${all} points. ${reading}`,
  removed: (all: number, reading: string) => `Taken away, ${all} points left. ${reading}`,
  fewest: "A line has two points at least.",
  sharpened: (reading: string) => `A corner. ${reading}`,
  smoothed: (reading: string) => `No corner any more. ${reading}`,
  keys: "Arrow keys move the point, with shift further. Plus adds one, Delete takes it away, S makes a corner of it.",

  svg: "SVG file…",
  photo: "Photograph…",
  points: "Begin with points",
  back: "Take back",
  clear: "Clear",
  /** Lines of a file. */
  line: "Line of the file",
  lineOf: (number: number, all: number) => `${number} of ${all}`,
  sensitivity: "Pot or background",
  sensitivityHelp: "To the right, more of the picture belongs to the pot; to the left, less.",
  withoutPhoto: "Without the photograph",
  traced: "Drag the points where the outline is not that of the pot: at a handle, a shadow, the foot.",

  height: "Height",
  heightHelp: "How high the pot is, from the foot to the rim. Where it gets a wall, rounding its rim adds a little.",
  alike: "Both sides alike",
  alikeAbout: "as the right one is",
  tolerance: "No further off than",
  toleranceHelp: "How far the pot may be from the line. Less takes more rings.",
  numbers: "Points as numbers",
  numbersAbout: "from the foot to the rim",
  radius: "Radius",
  up: "Height",
  of: (what: string, point: string) => `${what}, ${point}`,
  sharp: "Corner",
  sharpOf: (point: string) => `Corner at ${point}`,
  add: (point: string) => `Add a point above ${point}`,
  remove: (point: string) => `Take ${point} away`,

  nothing: "Nothing is drawn yet.",
  coming: "Finding rings…",
  found: (rings: number, distance: string) =>
    plural(rings, {
      one: `1 ring, ${distance} from the line at most.`,
      other: `${rings} rings, ${distance} from the line at most.`,
    }),
  use: "Use it",
  done: (rings: number, distance: string) =>
    plural(rings, {
      one: `The pot has 1 ring, ${distance} from the line at most.`,
      other: `The pot has ${rings} rings, ${distance} from the line at most.`,
    }),
  /** Why a file is of no use. */
  refused: {
    "too-large": "This file is too large to be the drawing of a pot.",
    "no-svg": "This is no SVG file that could be read.",
    entities: "This SVG file defines abbreviations of its own (entities), which are not read. Save it without them.",
    "no-line":
      "There is no line in this SVG file: no path, polygon or other shape. Text has to be turned into paths first.",
    flat: "This line is level: it has no height that a pot could have.",
    "no-photo": "This is no picture that this browser can show.",
    "no-pot": "No pot can be told from its background here. Draw it over the photograph by hand.",
  },
  stroke: "That was too short to be the wall of a pot. Draw it from the foot to the rim.",
});
