/** Several parts brought into order, and copies of parts in rows and rings. */

import { phrases } from "../../language";
import type { Side } from "../../state/arrange-actions";

export const arranging = phrases("arranging", {
  heading: "Arrange",
  about: "Align, mirror, rows, rings",
  align: "Align with the one selected last",
  sides: [
    { low: "Left", middle: "Centre", high: "Right" },
    { low: "Front", middle: "Middle", high: "Back" },
    { low: "Bottom", middle: "Half way up", high: "Top" },
  ] satisfies readonly Readonly<Record<Side, string>>[],
  onAxis: "On one axis",
  onTable: "On the table",
  onRim: "Stand on it",
  onRimFitted: "Stand on it, as wide as its rim",
  onRimNote: "Over the middle of the rim of the one selected last, and as high as that reaches.",
  onWall: "Set into its wall, sideways",
  onWallUpright: "Set into it, up or down",
  onWallNote:
    "Until all of what faces it lies in the clay of the one selected last, and glued to it. It does not come through the wall.",
  /** What became of that. */
  pushed: {
    partly: "What faces the wall is too uneven for it: some of it stays outside, so that nothing comes through.",
    nowhere: "Nothing is met that way.",
  },
  distribute: "Same gaps",
  distributeNote: "The outermost stay. It takes three parts.",
  mirror: "Mirror",
  ways: ["Left to right", "Front to back", "Top to bottom"],
  copies: "Copies",
  count: "How many",
  countHelp: "The parts themselves counted in.",
  row: "In a row",
  steps: ["Step along x", "Step along y", "Step along z"],
  makeRow: "Make the row",
  ring: "Round an axis",
  angle: "Over an angle of",
  angleHelp: "360 is all round.",
  centres: ["Axis at x", "Axis at y"],
  turning: "Each turns with its place",
  makeRing: "Make the ring",
  degree: "°",
});
