/** How much wet clay to wedge. */

import { phrases } from "../../language";

export const wedging = phrases("wedging", {
  heading: "Clay to wedge",
  shrinkage: "Shrinkage, wet to fired",
  allowance: "For trimming and waste",
  counted: (pot: string, spare: string) =>
    `${pot} for the pot itself, as large as it is before it shrinks, and ${spare} to trim off and lose.`,
  countedPot: (pot: string) => `${pot} for the pot itself, as large as it is before it shrinks.`,
  gains: (fired: string) =>
    `Fired, the pot weighs ${fired}, and no clay gains weight in the kiln: set by how much yours shrinks. From 8 to 13 % is common.`,
  density: (density: string) =>
    `Wet clay is taken to weigh ${density} g/cm³, a fifth of it water; glaze is not counted.`,
  percentage: (below: string) => `A percentage from 0 to less than ${below}.`,
});
