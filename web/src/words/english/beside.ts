/** Patches of the equation beside Coons and NURBS patches. */

import { phrases } from "../../language";

export const beside = phrases("beside", {
  heading: "Patches compared",
  lead: "Three surfaces over the same four edges. Turn one and all turn. What the sliders do inside, only the patch of the equation can; its edges, which they bend too, the others follow.",
  stage: "Three surfaces side by side",
  keys: "Arrow keys turn, plus and minus come closer and go away, F shows all.",
  names: { equation: "PDE patch", coons: "Bicubic Coons patch", nurbs: "NURBS patch" },
  notes: {
    equation: "8 points. Its parameters bend edges and inside together; a force sculpts any part of it.",
    coons: "4 edges and nothing else: there is nothing to change inside.",
    nurbs: "16 control points with weights. A dent as narrow as that of a force takes more of them.",
  },
  shaping: "The PDE patch",
  a1: "a₁, across",
  a2: "a₂, along",
  height: "Height of the force",
  width: "Width of its region",
  refused: (why: string) => `This cannot be shown: ${why}`,
  tooWide: "The edges are those of all three: expected a region of the patch, up to 1.",
  noStage: "Live pictures need WebGL2, which this browser does not have.",
});
