/** From a shape to the problem that it stands for. */

import { filled } from "../document/kinds";
import type { TwoSided } from "../document/types";
import { bloorWilson, fourthOrder, planar } from "./families";
import { free } from "./free";
import { hoops } from "./hoops";
import type { Problem } from "./problem";

export function problemOf(given: TwoSided): Problem {
  const shape = filled(given);
  switch (shape.kind) {
    case "second-order":
    case "mixed-order":
      return planar(shape);
    case "fourth-order":
      return fourthOrder(shape);
    case "bloor-wilson":
      return bloorWilson(shape);
    case "boundary-value":
      return free(shape);
    case "rings":
      return hoops(shape);
  }
}
