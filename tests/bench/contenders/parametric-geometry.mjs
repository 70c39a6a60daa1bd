// three's ParametricGeometry with a function that evaluates the closed form: what a page does that has three and a formula.

import { ParametricGeometry } from "../../../web/node_modules/three/examples/jsm/geometries/ParametricGeometry.js";
import { Circle } from "./circle.mjs";
import { solve } from "./solve.mjs";

/** The geometry of a grid. Its first parameter runs round the axis, its second along the profile: swapping them turns its normals outward. */
export function parametricGeometry(design, rows, columns) {
  let geometry;

  function run() {
    const components = solve(design);
    const [x, y, z] = components;
    const circle = new Circle(components);
    const point = (around, along, target) => {
      circle.at(2 * Math.PI * around);
      return target.set(evaluate(x, along, circle), evaluate(y, along, circle), evaluate(z, along, circle));
    };
    geometry = new ParametricGeometry(point, columns - 1, rows - 1);
  }

  return {
    run,
    get positions() {
      return geometry.attributes.position.array;
    },
    /** `X_v x X_u`, which points inward. */
    get normals() {
      return geometry.attributes.normal.array.map((x) => -x);
    },
  };
}

function evaluate(modes, u, { cos, sin }) {
  let value = 0;
  for (let m = 0; m < modes.length; m++) {
    const { n, sine, r, p, far, near, a0, a1, a2, a3 } = modes[m];
    if (n === 0) {
      value += a0 + u * (a1 + u * (a2 + u * a3));
      continue;
    }
    const fast = Math.exp(-r * u);
    const slow = Math.exp(-p * u);
    const q = a0 * fast + (a1 * far) / fast + a2 * slow + (a3 * near) / slow;
    value += q * (sine ? sin[n] : cos[n]);
  }
  return value;
}
