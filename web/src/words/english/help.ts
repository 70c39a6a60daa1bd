/** The keys, and what Pasu is. */

import { phrases } from "../../language";

type Keys = readonly (readonly [key: string, what: string])[];

const anywhere: Keys = [
  ["Ctrl Z", "Undo"],
  ["Ctrl Shift Z, Ctrl Y", "Redo"],
  ["Ctrl S", "Save as a file"],
  ["Ctrl O", "Open a file"],
  ["?", "This list"],
];
const pot: Keys = [
  ["Arrows", "Turn"],
  ["Shift arrows", "Move"],
  ["+ −", "Zoom"],
  ["F", "Fit to view"],
  ["P", "Pull at it, or turn it again"],
  ["M", "Move, turn and scale its parts, or turn it again"],
  ["U, Alt click, right click, a finger that stays", "List the parts that lie there, one behind the other"],
  ["1 to 5", "Three-quarter, front, side, top, below"],
];
const ring: Keys = [
  ["Arrows", "Out and in, up and down"],
  ["Shift arrows", "Ten times as far"],
  ["Alt ← →", "Round the axis"],
  ["+ −", "A wider or narrower pull"],
  ["Delete", "Take the ring away"],
  ["Escape", "Take back a pull under way"],
];
const hold: Keys = [
  ["Arrows", "Move, turn or scale"],
  ["Shift arrows", "Further"],
  ["Page Up, Page Down", "Up and down"],
  ["Ctrl while dragging", "In steps, or no longer"],
  ["Escape", "Take back what is under way"],
];
const water: Keys = [
  ["Arrows", "Up and down by a hundredth"],
  ["Shift arrows", "By a tenth"],
  ["Home, End", "Empty, full to the brim"],
];
const list: Keys = [
  ["Arrows", "Select"],
  ["Shift arrows, Ctrl A", "Select several, or all"],
  ["O", "Select all that is glued to it"],
  ["Alt arrows", "Move the part up or down the list"],
  ["H", "Hide the part, or show it"],
  ["L", "Lock the part where it stands, or unlock it"],
  ["D", "Make a copy beside it"],
  ["F2", "Name it"],
  ["Delete", "Take it away; undo brings it back"],
];
const formula: Keys = [
  ["Left, right", "From number to number"],
  ["Home, End", "First and last number"],
  ["Enter", "To its field"],
];
const number: Keys = [
  ["Arrows", "One step"],
  ["Shift arrows", "Ten steps"],
  ["Delete on a slider", "Reset; so does a double click"],
  ["Escape", "Forget what was typed"],
];

export const help = phrases("help", {
  heading: "Help",
  about: [
    "Pasu makes pots from partial differential equations: you choose the edges of a pot, and how the wall runs between them follows from an equation, exactly. The whole pot is in its link: whoever opens it sees the same pot.",
    "A wall makes a surface a pot, which has a capacity, a weight and a foot to stand on: under Measures they are told, and Export saves a file for a printer, a CAD program or a potter's wheel. Every such file holds its link and opens again when it is dropped on this page, but for an STL, which has room for a very short link alone.",
    "Every tab of the browser keeps a pot of its own, and its undo, through a reload. My designs is a shelf in this browser, on this device: what you save there stays as it is until you change it there. What was left unsaved in a closed tab comes back with the next one, or is found on the shelf. Under Overlays there is a link that shows a pot from where you see it now, cut open and coloured as it is.",
    "With a mouse: drag to turn, drag with the right button to move, roll the wheel to zoom. With fingers: one turns, two move and zoom. With Pull, the mouse or one finger pulls at the pot where it is: a ring follows, all round, at one side or as petals. Two fingers side by side squeeze it or draw it apart. Drag beside it, with the right button or with two fingers one above the other to turn it then; with Shift it goes up and down, with Alt round the axis, and the wheel with Shift makes the pull wider. With Move, whole parts go over the table under the hand, and by their handles along an axis, round one, or larger and smaller; a click with Shift selects another part besides. Files and links can be dropped on the page.",
  ],
  keys: [
    { title: "Anywhere", keys: anywhere },
    { title: "On the pot", keys: pot },
    { title: "On a ring, while pulling", keys: ring },
    { title: "On a handle, while moving parts", keys: hold },
    { title: "On the water", keys: water },
    { title: "In the list of parts", keys: list },
    { title: "On a number", keys: number },
    { title: "On a formula", keys: formula },
  ],
  /** `{0}` and `{1}` are the titles of the two papers. */
  sources: "After J. J. Zhang and L. You, {0} (2001), and S. N. Ishak and J. M. Ali, {1}.",
  papers: [
    "Surface representation using second, fourth and mixed order partial differential equations",
    "Parametric surface generation using partial differential equation based approach",
  ],
});
