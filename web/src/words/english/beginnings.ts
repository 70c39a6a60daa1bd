/** What a new design may begin as: forms, and the families of the equations. */

import type { BEGINNINGS } from "../../document/beginnings";
import type { FORMS } from "../../document/forms";
import { phrases } from "../../language";

interface Told {
  readonly title: string;
  readonly note: string;
}

export const beginnings = phrases("beginnings", {
  heading: "New pot",
  lead: "Choose a form to begin with. Your present pot stays within reach: undo brings it back.",
  beside: "Beside the present pot",
  besideNote: "What you choose becomes a part of its own, to the right of what stands there.",
  surprise: "Surprise me",
  draw: "Draw or trace…",
  scan: "From a scan…",
  surpriseNote: "A pot that nobody has thought of, and that can be made.",
  forms: {
    "form-cylinder": { title: "Cylinder", note: "A tall vase with an upright wall." },
    "form-bowl": { title: "Bowl", note: "On a foot ring, wide open." },
    "form-jar": { title: "Jar", note: "High shoulders and a rolled lip." },
    "form-bottle": { title: "Bottle", note: "A low belly and a long neck." },
    "form-vase": { title: "Vase", note: "Slender below, full at the shoulder." },
    "form-teapot": { title: "Teapot body", note: "Round and low, for one litre." },
    "form-planter": { title: "Planter", note: "A rim to lift it by, a hole to drain." },
    "form-cup": { title: "Cup", note: "A third of a litre, without a handle." },
    "form-plate": { title: "Plate", note: "Flat, with a wall that rises." },
    "form-jug": { title: "Jug with a spout", note: "The lip is pulled on one side." },
    "form-moon-jar": { title: "Moon jar", note: "Nearly a ball, and not quite even." },
    "form-gourd": { title: "Gourd", note: "Two bellies and a waist." },
  } satisfies Readonly<Record<(typeof FORMS)[number]["id"], Told>>,
  blends: "From one section into another",
  blendsLead:
    "Choose the section at the foot and the one at the rim: the wall flows from one into the other. Or begin with a pot that is made so.",
  networks: "From patches",
  networksLead: "A few points with smooth patches between them: drag points, sculpt, add patches where you need them.",
  octants: "From octants",
  octantsLead: "Balls, boxes and stars: three numbers say how round, how square or how hollow a solid is.",
  equations: "By its equation",
  equationsLead: "Families of pots as the papers have them, each with numbers of its own.",
  families: {
    "new-vase": {
      title: "Vase",
      note: "Fourth order: the slopes at rim and foot are yours.",
    },
    "new-jar": {
      title: "Jar",
      note: "Fourth order: a shoulder under a wide mouth.",
    },
    "new-bowl": {
      title: "Bowl",
      note: "Fourth order: from a narrow foot to an open rim.",
    },
    "new-bottle": {
      title: "Bottle",
      note: "Fourth order: a low belly and a long neck.",
    },
    "new-cup": {
      title: "Cup",
      note: "Second order: two edges, and a straight wall between them.",
    },
    "new-petals": {
      title: "Petalled vase",
      note: "Second order: petals, and a waist that the equation draws in.",
    },
    "new-lip": {
      title: "Vase with a lip",
      note: "Mixed order: petals, and how steeply the wall leaves the rim.",
    },
    "new-dints": {
      title: "Dint vase",
      note: "Bloor–Wilson: waves in the rim that fade in the wall.",
    },
    "new-free": {
      title: "Free boundary data",
      note: "Any edges, wave by wave. For those who like tables.",
    },
  } satisfies Readonly<Record<(typeof BEGINNINGS)[number]["id"], Told>>,
});
