/** What makes a surface a pot. */

import type { WallKey } from "../../document/wall";
import { phrases } from "../../language";

export const wall = phrases("wall", {
  fields: {
    thickness: {
      name: "Thickness",
      help: "Through the clay, square to the wall. Where the pot bends more tightly than this, the wall is thinned.",
    },
    base: {
      name: "Base",
      help: "How thick the floor is. 0 leaves the pot open below, as a tube.",
    },
    "foot-0": {
      name: "Ring width",
      help: "How wide the ring is that the pot stands on.",
    },
    "foot-1": {
      name: "Ring height",
      help: "How far the underside is set back inside the ring.",
    },
    drain: {
      name: "Drain hole",
      help: "Across the hole in the middle of the base. 0 is none.",
    },
  } satisfies Readonly<Record<WallKey, { readonly name: string; readonly help: string }>>,
  isSurface:
    "This is a surface: it has a shape and no thickness. With a wall it becomes a pot, which holds water, stands, and can be printed or thrown.",
  makePot: "Make it a pot",
  isBlend: "It is a solid as it is, which can be printed. With a wall it becomes an open pot, which holds water.",
  isOpenBlend:
    "It is a solid as it is, which can be printed. A wall goes round between two closed sections: under Shape, make each that is none an outline or a disc.",
  isNetwork:
    "These patches have free edges: they are a surface without thickness. With one along their normals they become a body, which can be printed.",
  closed:
    "It goes round a body, so that it is a solid as it is, which can be printed. A wall takes a free edge to end at.",
  closedWall: "It has a wall all the same, with which it cannot be made.",
  thicken: "Give it a thickness",
  thickenedHelp:
    "Along the normals, at every point of the network. Where the patches bend more tightly than this it is refused.",
  thickened: "It has a thickness everywhere, and is a body that can be made.",
  remove: "Remove the wall",
  footRing: "Foot ring",
  rim: "Rim",
  rims: {
    flat: { label: "Flat", note: "Cut square across." },
    rounded: { label: "Rounded", note: "Half a circle." },
  },
  laid: "Clay is laid",
  sides: {
    inside: { label: "Inwards", note: "What you shaped is the outside." },
    outside: { label: "Outwards", note: "What you shaped is the lining." },
  },
  thinned: "Where the outside bends tightly the wall is thinner than asked for.",
  inside: "Inside",
  insides: {
    follows: {
      label: "Follows the outside",
      note: "As thick everywhere, but thinner where the outside bends tightly.",
    },
    round: { label: "Round", note: "Thrown round, the outside carved: nowhere thinner than asked for." },
    soft: { label: "Keeps broad waves", note: "Follows the broad waves of the outside and leaves out the fine ones." },
  },
  keptWaves: {
    name: "Waves inside",
    help: "How many of the waves round the outside the inside keeps, counted from the broadest.",
  },
  sidesOfNetwork: {
    inside: { label: "Inwards", note: "Towards what it goes round." },
    outside: { label: "Outwards", note: "Away from what it goes round." },
  },
  export: "Export it for making",
});
