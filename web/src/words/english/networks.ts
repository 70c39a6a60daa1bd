/** A network of patches: picking and moving its points, building with its patches, and what pushes them. */

import type { Doing, Touch, Way } from "../../document/network/grasping";
import type { Axis } from "../../document/network/moving";
import type { Objection } from "../../document/network/topology";
import { phrases, plural } from "../../language";
import { formatNumber } from "../../number";

const points = (count: number) => plural(count, { one: "1 point", other: `${formatNumber(count)} points` });
const patches = (count: number) => plural(count, { one: "1 patch", other: `${formatNumber(count)} patches` });

export const networks = phrases("networks", {
  lead: "A network.",
  about: (patchCount: number, pointCount: number) =>
    `${patches(patchCount)} through ${points(pointCount)}. Each goes through the corners and the middles of its edges.`,
  onStage: "Points on the stage",
  beside: "Other patches",
  besideAbout: "The same four edges as a patch of the equation, a Coons patch and a NURBS patch.",
  besideOpen: "Patches compared…",
  pick: "Pick",
  picked: (pointCount: number, patchCount: number) => `${points(pointCount)} and ${patches(patchCount)} picked.`,
  pickedNone:
    "Nothing is picked: click a point or the square in the middle of a patch. Several with shift, with Pick several, or by a finger that rests on them.",
  several: "Pick several",
  severalHelp:
    "A click, a tap or Enter picks beside what is picked, or leaves it out, as with shift. A finger that rests on a point does so too.",
  all: "All",
  none: "None",
  ring: "Ring",
  ringHelp: "The whole rim, or all edges across a strip, from one edge whose middle is picked.",
  patchOf: "Patches",
  patchOfHelp: "The patches of which a point is picked.",
  numberOfPoint: "Point",
  numberOfPatch: "Patch",
  noSuchPoint: (most: string) => `Points have the numbers 1 to ${most}.`,
  noSuchPatch: (most: string) => `Patches have the numbers 1 to ${most}.`,
  move: "Move",
  motions: { move: "Move", turn: "Turn", scale: "Scale" } satisfies Readonly<Record<Doing, string>>,
  motion: "What a hand does",
  way: "Along",
  ways: { view: "View", x: "x", y: "y", z: "z", normal: "Normal" } satisfies Readonly<Record<Way, string>>,
  touch: "Beside points, a hand",
  touches: { view: "turns the view", box: "picks in a box", region: "draws a region" } satisfies Readonly<
    Record<Touch, string>
  >,
  grid: "To a grid of",
  gridStep: "Grid",
  meet: "To other points",
  mirror: "Mirror",
  mirrors: { x: "left and right (x)", y: "front and back (y)", z: "above and below (z)" } satisfies Readonly<
    Record<Axis, string>
  >,
  noMirror: "None",
  inMirror: "What stands in the mirror stays there.",
  place: ["x", "y", "z"] as const,
  placeHelp: "Where the point is, or the middle of those that are picked.",
  build: "Build",
  builds: {
    extrude: { name: "Extrude", help: "A patch on every free edge whose middle is picked." },
    split: { name: "Split", help: "Divides every strip across an edge whose middle is picked." },
    bridge: { name: "Bridge", help: "Joins two picked rims of as many edges." },
    fill: { name: "Fill", help: "Closes a hole of four picked edges." },
    remove: { name: "Delete", help: "Takes the picked patches away." },
  },
  built: { extrude: "Extruded.", split: "Split.", bridge: "Bridged.", fill: "Filled.", remove: "Deleted." },
  objections: {
    empty: "A network has at least one patch.",
    crowded: "Along an edge there can be no more than two patches.",
    repeated: "A patch would have one point twice.",
    collapsed: "Two corners of a patch would be in one place.",
    infinite: "A point would be nowhere.",
    "no-edge": "Pick the middle of an edge first.",
    "no-free-edge": "The picked edges have a patch on both sides. Pick one at the rim.",
    "no-patch": "Pick a patch first.",
    "no-point": "Pick a point first.",
    "last-patch": "One patch has to stay.",
    crossing: "The strip runs through a patch both ways, and cannot be split.",
    spanned: "A sculpted region lies over several patches of the strip. Take it away first.",
    torn: "A sculpted region goes on from what would be taken away to patches that stay. Take it away first.",
    bent: "A sculpted region would go round a corner at which not four patches meet. Take it away first.",
    "no-rings": "Pick two whole rims first: the middle of an edge of each, and then Ring.",
    "unequal-rings": "Both rims have to have as many edges.",
    "no-hole": "Pick the four edges of a hole first.",
    branching: "More than two of the picked edges meet in a point.",
  } satisfies Readonly<Record<Objection, string>>,
  surface: "Patch",
  surfaceHelp: "how stiff it is along u and along v",
  ofSeveral: (first: string, count: number) =>
    `The numbers are those of patch ${first}. What is changed here is changed on all ${patches(count)} that are picked.`,
  noSurface: "Pick a patch to change its numbers.",
  parameters: { a1: "Along u", a2: "Along v" },
  parameterHelp: "Only how it compares with the other one matters, between the edges.",
  component: (axis: string) => `in ${axis}`,
  same: "the same in x, y, z",
  sameOf: (name: string) => `${name}: the same in x, y, z`,
  tooLittle: "It has to be more than 0.",
  magnification: "Sliders reach to",
  forces: "Forces",
  forcesHelp: "what pushes it, on all of it or on a rectangle",
  addForce: "Add a force",
  removeForce: (number: string) => `Remove force ${number}`,
  force: (number: string) => `Force ${number}`,
  strength: "Strength",
  height: "Height",
  heightHelp: "How far it moves the surface at its middle, along the normal.",
  from: (axis: string) => `${axis} from`,
  to: (axis: string) => `${axis} to`,
  /** Of the beginning of a region, and of its end. */
  passes: [
    (axis: string, to: string) => `The region ends at ${to} along ${axis}: it has to begin before that.`,
    (axis: string, from: string) => `The region begins at ${from} along ${axis}: it has to end after that.`,
  ] as const,
  ofForce: (what: string, number: string) => `${what}, force ${number}`,
  falloff: "Falls off",
  falloffs: { smooth: "smoothly", sine: "with a crease at its rim" },
  region: "Draw a region on the stage",
  noRegion: "A region is drawn from one of its corners to the other, both on the surface and few patches apart.",
  bentRegion: "Where three patches meet in a corner, or five, no region can lie round it. Draw it beside that corner.",
  noMoreForces: (most: string) => `This patch has ${most} forces, and can have no more.`,
  whole: "All patches",
  wholeHelp: "which edges look smooth, and what decides how strips bend",
  crease: "Smooth up to",
  creaseHelp:
    "Where two patches meet at less than this angle, the surface is drawn as if it were smooth there. 0° shows every edge.",
  noCrease: "An angle from 0° to 180°.",
  rule: "How a strip bends is decided by",
  rules: { global: "all its patches", seed: "its first patch" },
  seed: "Counted from patch",
  ruleHelp:
    "A strip runs from patch to patch through opposite edges. Its first patch is the one that comes first on the way out from the patch that is counted from, as in the paper.",
  file: "Files",
  fileAbout:
    "As OBJ: faces of four corners, whose edges get middles, or of eight points, in the unit of the design on the page. Forces, and where the network was moved and turned to, stay with the design.",
  saveObj: "Save as OBJ",
  openObj: "Open OBJ quads…",
  objTrouble: {
    empty: "This file has no faces.",
    crowded: "In this file more than two faces meet along an edge.",
    large: "This file is larger than 32 MiB.",
    many: (found: string, most: string) => `This file has ${found} faces. A network has ${most} patches at most.`,
    point: (line: string) => `Line ${line} of this file has not the three numbers of a point.`,
    corners: (line: string, corners: number) =>
      `The face in line ${line} of this file has ${plural(corners, { one: "1 corner", other: `${formatNumber(corners)} corners` })}. A network is of faces of four corners, or of eight points.`,
    "no-point": (line: string, named: string, count: number) =>
      `The face in line ${line} of this file names the point ${named}, and there ${plural(count, { one: "is 1", other: `are ${formatNumber(count)}` })}.`,
    repeated: (line: string) => `The face in line ${line} of this file names one point twice.`,
    collapsed: (line: string) => `Two corners of the face in line ${line} of this file are in one place.`,
  },

  handles: "Points of the network",
  handleKeys:
    "Arrow keys move what is picked, with shift further. Enter picks a point, with shift or Pick several beside the others.",
  point: (number: string, at: string) => `Point ${number}: ${at}`,
  pivot: (count: number) => `Middle of ${points(count)}`,
  patch: (number: string) => `Patch ${number}`,
  crest: (number: string) => `Crest of force ${number}`,
  crestOf: (crest: string, patch: string) => `${crest}, ${patch}`,
  become: "Make it patches",
  becomeAbout:
    "A network through points of this form, to pull a spout out of it or to dent it. It goes without its wall.",
  columns: "Patches round",
  rows: "Patches from end to end",
  noSuchCount: (least: string, most: string) => `It has to be a whole number from ${least} to ${most}.`,
  apart: (distance: string) => `No further than ${distance} from the form, at the same parameters.`,
  use: "Use it",
  leave: "Leave it",
  changed: "The form has changed meanwhile.",
  cannot: "This form cannot become patches: its points cannot be told apart, or it ends in a point.",
  comparing: "Comparing…",
});
