// Everything that Pasu's sampling is held against.

import { closedForm } from "./closed-form.mjs";
import { handTuned } from "./hand-tuned.mjs";
import { parametricGeometry } from "./parametric-geometry.mjs";
import { plainLoops } from "./plain-loops.mjs";

/** The contenders for a design and a grid: `{ name, run(), positions, normals }`. */
export function contenders(design, rows, columns) {
  return [
    { name: HAND_TUNED, ...handTuned(design, rows, columns, { mirrored: false }) },
    { name: MIRRORED, ...handTuned(design, rows, columns, { mirrored: true }) },
    { name: PLAIN_LOOPS, ...plainLoops(design, rows, columns) },
    { name: CLOSED_FORM, ...closedForm(design, rows, columns) },
    three(parametricGeometry(design, rows, columns)),
  ];
}

export const HAND_TUNED = "hand-tuned JavaScript";
export const MIRRORED = "hand-tuned JavaScript, mirrored columns";
export const PLAIN_LOOPS = "plain JavaScript loops over tables";
export const CLOSED_FORM = "closed form at every vertex";
export const PARAMETRIC_GEOMETRY = "three's ParametricGeometry";

/** Its arrays are made anew in every run. */
function three(geometry) {
  return {
    name: PARAMETRIC_GEOMETRY,
    litters: true,
    coarse: true,
    run: geometry.run,
    get positions() {
      return geometry.positions;
    },
    get normals() {
      return geometry.normals;
    },
  };
}
