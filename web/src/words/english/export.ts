/** Saving a file to be made. */

import type { Problem, SizeKind } from "../../document/saving";
import type { Format } from "../../document/types";
import { phrases, plural } from "../../language";

export const exporting = phrases("exporting", {
  formats: {
    "3mf": { label: "3MF", note: "For printing: true size, title and picture." },
    stl: { label: "STL", note: "For every slicer. In millimetres." },
    step: { label: "STEP", note: "For CAD: smooth surfaces, one solid." },
    svg: { label: "SVG", note: "A template for throwing or turning, at true size, on one large page." },
    "a4.svg": { label: "SVG A4", note: "The template on sheets of A4, to be put together: print them at 100 %." },
    "letter.svg": {
      label: "SVG Letter",
      note: "The template on sheets of letter paper, to be put together: print them at 100 %.",
    },
    glb: { label: "GLB", note: "For viewers, games and rooms: with its colours." },
    obj: { label: "OBJ", note: "For other 3D programs: the shape alone." },
    "obj.zip": { label: "OBJ+MTL", note: "For other 3D programs: the shape and its colours, two files in a package." },
    ply: { label: "PLY", note: "For science and scans: with its colours." },
  } satisfies Readonly<Record<Format, { readonly label: string; readonly note: string }>>,
  opensAgain: "Dropped on this page, the file opens the design again.",
  stlOpens:
    "Dropped on this page, an STL does not open the design again, unless its link is very short; every other format does.",
  problems: {
    shrinkage: (below: string) => `A percentage from 0 to less than ${below}.`,
    size: () => "A number greater than 0.",
    "holds-nothing": () => "This holds nothing: choose its height or width.",
    tolerance: () => "A number of millimetres greater than 0.",
  } satisfies Readonly<Record<Problem["code"], (below: string) => string>>,
  scaledBy: (factor: string) => `scaled by ${factor}`,
  larger: (percent: string) => `made ${percent} larger for the shrinkage`,
  applied: (all: readonly string[]) => all.join(", "),
  /** The size of a file. */
  size: (wide: string, high: string) => `${wide}\u00a0wide, ${high}\u00a0high`,
  heading: "Export",
  format: "Format",
  /** Two sentences on a format. */
  notes: (note: string, opens: string) => `${note} ${opens}`,
  made: "What is made",
  pot: { label: "Hollow pot", note: "With its wall, floor and foot." },
  solid: {
    label: "Closed solid",
    note: "For the vase mode of a slicer.",
    unwalled: "For vase mode. A hollow pot needs a wall.",
    closed: "It closes all round: what is inside is solid.",
  },
  sizeOf: "Size",
  sizes: { designed: "As designed", height: "Height", width: "Width", capacity: "Capacity" } satisfies Readonly<
    Record<SizeKind, string>
  >,
  finished: { height: "Finished height", width: "Finished width", capacity: "Holds to the brim" } satisfies Readonly<
    Record<Exclude<SizeKind, "designed">, string>
  >,
  shrinkage: "Shrinkage of the clay",
  percent: "%",
  tolerance: "Tolerance",
  /** In the field of a tolerance that is left to Pasu. */
  fine: "fine",
  join: "Join glued parts into one solid",
  writing: "Writing the file…",
  stop: "Stop",
  cancel: "Cancel",
  save: (format: string) => `Save ${format}`,
  measuring: "Measuring…",
  saved: "What is saved",
  inFile: "In the file",
  fired: "Once fired",
  appliedTo: "Applied",
  triangles: "Triangles",
  within: "True to within",
  moreOf: (count: number) => `And ${count} more of the kind.`,
  /** Beside the button that saves, which is then out of use. */
  unmakeable: "Not as it is",
  warnings: (count: number) => plural(count, { one: `${count} warning`, other: `${count} warnings` }),
});
