/** Where a part stands: its size, how it is turned, and how far it is moved. */

import { phrases } from "../../language";

export const placing = phrases("placing", {
  heading: "Placement",
  about: "Scaled, then turned, then moved.",
  edges: ["Width", "Depth", "Height"],
  edgeHelp: "How far it reaches along this axis of its own. Below 0 it is the mirror image.",
  factors: ["Scale along x", "Scale along y", "Scale along z"],
  factorHelp: "1 leaves it as it is. Below 0 it is the mirror image.",
  shifts: ["Moved along x", "Moved along y", "Moved along z"],
  shiftHelp: "After it is turned.",
  turn: "Turned",
  turnHelp: "Anti-clockwise, seen from where the axis points to.",
  degree: "°",
  axis: ["Axis x", "Axis y", "Axis z"],
  reset: "Put it back",
  locked: "It is locked where it stands.",
  resetNote: "Where it was before it was scaled, turned or moved.",
});
