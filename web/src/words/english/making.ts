/** What is said when a pot cannot be made, by which of several things is in the way; fetched with what makes it. */

import { phrases } from "../../language";

export const making = phrases("making", {
  tooManyWaves: (found: string, greatest: string) =>
    `A pot that is measured or made has at most ${greatest} waves round it, and this has ${found}: it can only be drawn.`,
  tooFast: (axis: string) =>
    `The equation of ${axis} changes too fast along the profile to be measured or made: it can only be drawn.`,
  tooSteep: "With these weights the solid leaves its sections too fast to be measured or made: it can only be drawn.",
  tooManyTriangles: (greatest: string) => `It takes more than ${greatest} triangles. A coarser tolerance takes fewer.`,
  tooManyPoints: "So fine a tolerance takes more points than a file can have. A coarser one takes fewer.",
  tooFine: (found: string) => `Triangles as fine as ${found} are more than can be made, or finer than their numbers.`,
  /** Sides and ends of a pot, inside a sentence. */
  faces: {
    outer: "outside",
    lining: "lining",
    rim: "rim",
    underside: "underside",
    "foot-ring": "foot ring",
    recess: "recess under the base",
    floor: "floor",
    drain: "drain hole",
    lid: "lid",
    foot: "foot",
  },
  openSurface: {
    noFoot: "The shape has no foot and no rim, so there is nothing for a wall to stand on.",
    notClosed: "The surface does not meet itself after one turn. It does with whole numbers of waves.",
    freeEdge:
      "A patch has a free edge, so that nothing is enclosed. With a thickness, under Wall, patches are a body; those that close are a solid as they are.",
    oneSided: "The surface has one side only, so that it has no inside.",
  },
  /** Of what has no foot and no rim. */
  noEnds:
    "A network of patches has no foot and no rim, so this cannot be done with it. What closes is a solid without a wall; what has free edges gets a thickness.",
  noTemplate: "A template is of a pot with a foot and a rim, and this has neither. Every other format takes it.",
  closes: "It closes, so that it is a solid as it is, and has no free edge for a wall to end at.",
  /** Of the thickness of patches. */
  thickness: {
    noFoot: "Patches have no foot and no rim: their wall has no base, no ring and no drain, and its edges are flat.",
    noNormal: "The surface has no normal there along which a wall could go.",
    sharp: (thickness: string) =>
      `Patches meet at so sharp an angle that a wall of ${thickness} has no room there. It takes a blunter one.`,
    turnedOver: (thickness: string) =>
      `The surface bends more sharply there than a wall of ${thickness} is thick. A thinner one may do.`,
    uneven: (found: string, thickness: string) =>
      `The wall would be ${found} thick there, where ${thickness} was asked for. It takes a thinner one, or more and smaller patches.`,
    touching: "Free edges touch in a single point. They need an edge in common, or nothing.",
  },
  /** Of a solid between sections that do not close round. */
  openSections:
    "A wall goes round between two closed sections: a disc or an outline at both ends. Without a wall this is a solid.",
  noInside: "Only of a blend is it known what is inside.",
  hollow: "A blend with a wall is hollow. Without one it is a solid.",
  leftOut: "This shape takes more of Pasu than is here.",
  collapsed: "Cells of two discs in squares have no volume at two edges. Discs and outlines have none of these.",
  folded:
    "The inside of the solid is folded over itself, though its skin is not: cells for analysis are of no use there.",
  fewTerms: (terms: string, waves: string, least: string) =>
    `A section has waves up to number ${waves}, which are not seen by terms along v up to number ${terms}: the inside is carried far off, though the skin is as it should be. It takes ${least} terms, or the method Exact.`,
  pinched: {
    noArea: (end: string) => `The ${end} encloses no area. A pot needs an outline with an inside there.`,
    waist: "The surface is pinched to a point. A pot has to be wide everywhere between foot and rim.",
    shrinks: (face: string) => `The ${face} shrinks to nothing, so that the numbers of a file cannot hold it.`,
    section: "A section encloses no area. A blend flows between two that do.",
    noHeight: "Both sections lie at the same height, and no tangent rises from it: the solid would be flat.",
    corners: "Two corners of a patch are the same point. A patch needs four.",
    thinEdge:
      "This octant thins out to less than the numbers of a file can hold. Exponents of at least 1 make it thicker there; neither turned nor moved it can be written as it is.",
  },
  crosses: {
    surface: "The surface runs through itself.",
    surfaceClose: "So much of the surface lies close to itself that nobody can tell whether it runs through itself.",
    outline: (face: string) => `The outline of the ${face} crosses itself.`,
    section: "The outline of a section crosses itself. It has to go round an area once.",
    sections: "Both sections lie at the same height, one in the other. One of them has to be higher.",
    doesNotClose: "The sides of the pot do not close.",
    edge: "Three patches have an edge in common. No more than two can meet along one.",
    region: "What is sculpted goes round a corner at which not four patches meet, so that it cannot lie flat there.",
    notJoined:
      "These parts cannot be joined into one solid: their surfaces meet too closely to be told apart. Parts that run into each other clearly can be.",
    pinchedJoint:
      "These parts cannot be joined into one solid: where they touch along an edge or at a point alone it would be pinched. Let them meet in a face or run into each other, or leave them apart.",
    /** The sentence, and how fine triangles may be that do not show it. */
    steppedOver: (sentence: string, bound: string) => `${sentence} Triangles within ${bound} step over it.`,
  },
  noLining: "An inside of its own takes a surface between a foot and a rim.",
  liningOutside: "Where the clay is laid outwards, what you shaped is itself the inside.",
  noOpening: "The surface closes to a point where the opening of a pot is. It can be made as a solid.",
  noRoom: {
    noDisc: (end: string) =>
      `The ${end} is neither level nor seen as a whole from its middle, so that no disc closes it. One that is level, or bends less, can be closed.`,
    noBase: "A pot without a base has nothing to carry this.",
    aboveRim: "The rim is lower than what is to lie within it.",
    roundBottom: "A round bottom has no edge under which a ring could stand.",
    tip: (base: string) =>
      `The bottom ends in a tip, too sharp for a wall above a base of ${base}. A thicker base may do.`,
    footNotLevel: "A ring needs a level foot to stand on.",
    ringTooWide: (width: string) => `A ring ${width} wide has no room within the foot.`,
    ringFillsFoot: (width: string) => `A ring ${width} wide fills the foot.`,
    middleOutside: "The middle of the base is outside of it, so that no drain can be there.",
    drainTooWide: (drain: string, room: string) =>
      `A drain of ${drain} has no room in the base, which is only ${room} wide there.`,
    bendsTooSharply: (thickness: string) =>
      `The surface bends so sharply, or comes so close to itself, that the wall would be only ${thickness} thick.`,
    sharpRing: (thickness: string) =>
      `A wall ${thickness} thick has no room round a sharp ring. A thinner wall may do, or a ring that turns less or is further from the next.`,
    endsInRing: "The base or the drain ends in a sharp ring. One that ends above or below it may do.",
    lining:
      "An inside of its own has no room: the pot is too narrow, or its outside goes too far in. A thinner wall may do, or an inside that follows the outside.",
    crossing: (face: string, other: string) => `The ${face} has no room: it runs through the ${other}.`,
    crossingItself: (face: string) => `The ${face} has no room: it runs through itself.`,
    close: (face: string) =>
      `So much of the ${face} lies close to itself that nobody can tell whether it has room. A thinner wall may do.`,
  },
  /** Why something holds no water. */
  dry: {
    solid: "A solid has no inside.",
    "open-surface": "The surface does not close round the axis, so it holds nothing.",
    "no-opening": "The surface closes to a point where the opening of a pot is, so nothing can be filled in.",
    "crosses-itself": "The surface runs through itself so far that it has no inside.",
    "no-foot": "The shape has no foot and no rim, between which it would be found how much it holds.",
    "no-bottom": "A tube has no bottom to hold anything. A base closes it.",
    dry: "In this position no water stays in it.",
    "too-long": "It takes too long to find out. Fewer or shallower waves or a thinner wall may do.",
  },
});
