/** A blend: its sections and how its equation is solved. */

import type { Clash, Remedy } from "../../document/blend/agreement";
import type { CellShape, CellsFormat } from "../../document/blend/cells";
import type { GripName } from "../../document/blend/grips";
import type { InsideMap, Shown } from "../../document/blend/looking";
import type { Form, SectionKey } from "../../document/blend/section";
import type { Method } from "../../document/blend/solving";
import type { PlanName } from "../../document/gallery/section-choices";
import { phrases, plural } from "../../language";
import { formatNumber } from "../../number";

interface Told {
  readonly name: string;
  readonly help: string;
}

export const blends = phrases("blends", {
  lead: "A blend.",
  about: "It flows from one section into the other, and leaves each as steeply as you say.",
  upper: "Upper section",
  lower: "Lower section",
  /** Beside a number of one of them. */
  short: { upper: "upper", lower: "lower" },
  of: (what: string, section: string) => `${what}, ${section}`,
  form: "Form",
  forms: {
    disc: "Round or oval",
    outline: "Any outline",
    rectangle: "Rectangle",
    "rectangle-reversed": "Rectangle, reversed",
    "disc-in-square": "Disc over a square",
  } satisfies Readonly<Record<Form, string>>,
  fields: {
    "radius-0": { name: "Half width", help: "From the middle to the side, along x." },
    "radius-1": { name: "Half depth", help: "From the middle to the side, along y." },
    z: { name: "Height", help: "Where the section stands." },
    taper: {
      name: "Flare",
      help: "How fast the solid widens on its way up, in parts of its size. Below 0 it narrows.",
    },
    dz: { name: "Rise", help: "How fast it goes up there: the larger, the longer it keeps the section's direction." },
  } satisfies Readonly<Record<SectionKey, Told>>,
  turn: "Turn",
  turnHelp: "From above, anticlockwise. What is turned at one end alone is twisted in between.",
  degree: "°",
  ornament: "Corners and petals",
  count: "How many",
  petals: "Petals",
  corners: "Corners",
  place: "Turned by",
  rest: (count: number) => plural(count, { one: "1 wave of it was drawn.", other: `${count} waves of it were drawn.` }),
  drawing: (form: string, width: string, depth: string) => `${form} from above, ${width} by ${depth}`,
  asOutline: "Make it an outline",
  asOutlineAbout: "An outline can be turned, and between two outlines or discs the blend can have a wall.",

  solving: "How it is solved",
  solvingAbout: "method, terms and weights",
  method: "Method",
  methods: {
    exact: { name: "Exact", help: "Each wave in closed form" },
    modal: { name: "Modal", help: "Sines across, closed form from end to end" },
    collocation: { name: "Collocation", help: "As in the paper, to compare with" },
  } satisfies Readonly<Record<Method, Told>>,
  terms: "Terms",
  compareMethods: "Compare the methods",
  compareAgain: "Compare again",
  methodsOld: "This is of the blend as it was.",
  methodTime: "Time to solve",
  milliseconds: (time: string) => `${time} ms`,
  residualOf: (value: string, unit: string) => `${value} ${unit}`,
  noTerms: "none needed",
  methodResidual: "Largest residual",
  methodMean: "Residual, root mean square",
  methodApart: "Farthest from this blend",
  methodLoft: "Farthest from a plain loft",
  methodsAbout:
    "The shortest of five times on this device. Residuals are of 1728 samples within, distances of 729. A loft is the cubic between the sections, which no equation is asked of.",
  along: ["along u", "along v", "along w"] as const,
  weights: "Weights",
  weightsHelp: "How much each direction resists bending. A small second weight lets corners and petals reach far.",
  unseen: (waves: number, terms: number) =>
    `A section has ${waves} waves, and ${plural(terms, { one: "1 term", other: `${terms} terms` })} along v cannot see them: the inside may be carried far off. The skin is as it should be.`,
  enoughTerms: (least: number) => `Take ${least} terms along v`,
  solveExactly: "Solve it exactly",
  insideOnly: "Sines vanish on the skin: weights and terms change what is inside alone.",
  weight: ["Weight across", "Weight round", "Weight from end to end"] as const,

  rim: "At the rim",
  foot: "At the foot",
  plans: {
    round: "Round",
    oval: "Oval",
    square: "Square",
    triangle: "Triangle",
    hexagon: "Hexagon",
    star: "Star",
    flower: "Flower",
  } satisfies Readonly<Record<PlanName, string>>,
  begin: (foot: string, rim: string) => `Begin with ${foot.toLowerCase()} to ${rim.toLowerCase()}`,

  clashes: {
    kinds:
      "This solid folds through itself: one section goes round its middle, the other from side to side, and no method joins them well.",
    ways: "This solid is drawn together to nothing half way: its sections go from side to side in opposite directions.",
  } satisfies Readonly<Record<Clash, string>>,
  remedies: {
    kinds: { "disc-in-square": "Lay the disc over a square", outline: "Take both as outlines" },
    ways: { "disc-in-square": "Reverse the rectangle", outline: "Take both as outlines" },
  } satisfies Readonly<Record<Clash, Readonly<Record<Remedy, string>>>>,

  drawIt: "Draw it…",
  drawItOf: (section: string) => `Draw it…, ${section}`,
  draw: (section: string) => `Draw the section: ${section}`,
  drawLead:
    "Draw it as it is seen from above, in one stroke round the middle; its end meets its beginning. Or take it from an SVG file.",
  sheet: "Sheet to draw a section on",
  toleranceHelp: "How far the section may be from the line. Less takes more waves.",
  noArea: "This line goes round nothing. Draw it once round the middle.",
  found: (waves: number, distance: string) =>
    plural(waves, {
      one: `1 wave, ${distance} from the line at most.`,
      other: `${waves} waves, ${distance} from the line at most.`,
    }),

  handles: "Handles of the sections",
  handleKeys:
    "Arrow keys move a handle, with shift further. Of a tangent, left and right change its flare, up and down its rise.",
  grips: {
    height: "Height",
    width: "Half width",
    depth: "Half depth",
    turn: "Turn",
    tangent: "Tangent",
  } satisfies Readonly<Record<GripName, string>>,
  grip: (what: string, section: string, at: string) => `${what}, ${section}: ${at}`,
  degrees: (degrees: number) => `${formatNumber(degrees)} degrees`,
  leaves: (flare: number, rise: string) => `flare ${formatNumber(flare)}, rise ${rise}`,

  inside: "The inside",
  insideAbout: "cut open, or surface by surface",
  lookInside: "Look inside",
  insideLead:
    "The solid is solved all through, not only on its skin. Here is what it is like within: on the stage it stands in the place of the skin.",
  shown: "What is shown",
  showns: {
    cut: { name: "Cut away", help: "What three cuts along u, v and w leave" },
    surfaces: { name: "Three surfaces", help: "On each of them u, v or w stays the same" },
    joined: { name: "What it joins", help: "The solids that go on beyond both sections, in grey" },
  } satisfies Readonly<Record<Shown, Told>>,
  colours: "Colours show",
  insideMaps: {
    residual: { name: "Residual", help: "What the equation leaves: 0 where it holds" },
    jacobian: { name: "Jacobian", help: "How much room there is: 0 or less where it is folded" },
  } satisfies Readonly<Record<InsideMap, Told>>,
  /** What a slider is along, of a round solid and of one from side to side. */
  insideAt: {
    round: ["u, from the middle to the skin", "v, round the middle", "w, from section to section"],
    square: ["u, from side to side", "v, from front to back", "w, from section to section"],
  } as const,
  insideRange: "From 0 to 1.",
  insideColours: (map: string, low: string, high: string) => `${map}: colours from ${low} to ${high}`,
  insideHere: (least: string, greatest: string) => `On what is shown: ${least} to ${greatest}.`,
  insideWorst: {
    residual: (worst: string, at: string) => `The largest of 1728 samples is ${worst}, at ${at}.`,
    jacobian: (worst: string, at: string) => `The least of 1728 samples is ${worst}, at ${at}.`,
  } satisfies Readonly<Record<InsideMap, (worst: string, at: string) => string>>,
  insideHolds: (most: string) => `The equation holds everywhere: what is left of it is rounding, ${most} at most.`,
  insidePlace: (u: string, v: string, w: string) => `u ${u}, v ${v}, w ${w}`,
  insideSound: "The inside is not folded anywhere that was sampled.",
  insideFolded: "The inside is folded through itself there.",
  insideGrey: "Grey is where a disc over a square has no such number.",

  cells: "Cells for analysis",
  cellsAbout: "The inside of the solid, cut into cells that a finite element program reads. In millimetres.",
  cellCounts: "Cells",
  cellShape: "Shape of the cells",
  cellShapes: { hexahedron: "Hexahedra", tetrahedron: "Tetrahedra" } satisfies Readonly<Record<CellShape, string>>,
  cellFormats: { vtu: "Save VTK (.vtu)", msh: "Save Gmsh (.msh)", inp: "Save Abaqus (.inp)" } satisfies Readonly<
    Record<CellsFormat, string>
  >,
  cellsTold: (count: string, least: string) => `${count} cells, the least scaled Jacobian is ${least}.`,
  cellsUseless: (count: number) =>
    plural(count, {
      one: "1 of them is turned inside out and of no use.",
      other: `${count} of them are turned inside out and of no use.`,
    }),
});
