/** What the numbers of the families are called, and what each does. */

import type { FamilyKind, FieldKey, Group } from "../../document/field";
import type { Kind } from "../../document/types";
import { phrases } from "../../language";

interface FieldWords {
  readonly name: string;
  readonly help: string;
}

type Fields<K extends FamilyKind> = Readonly<Record<FieldKey<K>, FieldWords>>;

/** Second order, ZY01 equations 1 to 8. The mixed order has the same and differs in `z` alone. */
const PLANAR: Fields<"second-order"> = {
  "r-0": {
    name: "Rim radius",
    help: "How wide the rim is, from the axis to the middle of its petals.",
  },
  "r-1": {
    name: "Rim petal depth",
    help: "How far the petals of the rim swing out and in. 0 gives a round rim.",
  },
  "r-2": {
    name: "Foot radius",
    help: "How wide the foot is.",
  },
  "r-3": {
    name: "Foot petal depth",
    help: "How far the petals of the foot swing out and in.",
  },
  height: {
    name: "Height",
    help: "From the foot up to the rim.",
  },
  "n-1": {
    name: "Petals",
    help: "How many petals the eye counts while the wall goes round. In the paper the wave has one more for each turn of the wall. A fraction leaves the pot open.",
  },
  "n-0": {
    name: "Turns of the wall",
    help: "How often the wall goes round the axis before it closes. 1 is a pot; a fraction leaves it open.",
  },
  "t-0": {
    name: "Waist pull",
    help: "Draws the wall in towards the axis between rim and foot. 0 leaves it straight.",
  },
  "t-1": {
    name: "Waist pull",
    help: "Draws the wall in towards the axis between rim and foot, across.",
  },
  "s-0": {
    name: "Wall stiffness",
    help: "Keeps the wall straight against the waist pull. It may not be 0.",
  },
  "s-1": {
    name: "Wall stiffness",
    help: "Keeps the wall straight against the waist pull, across. It may not be 0.",
  },
  "force-0": {
    name: "Even push",
    help: "Pushes the whole wall: below 0 outwards, above 0 inwards.",
  },
  "force-1": {
    name: "Push growing to the foot",
    help: "Pushes harder the nearer the foot: below 0 outwards, above 0 inwards.",
  },
};

/** ZY01 equations 9 to 12. */
const MIXED_ORDER: Fields<"mixed-order"> = {
  ...PLANAR,
  rise: {
    name: "Rise at the rim",
    help: "How steeply the wall leaves the rim: far below 0 it drops at once, near 0 the rim lies flat, above 0 it first climbs.",
  },
};

/** ZY01 equations 13 to 17. The foot is at `u = 0`. */
const FOURTH_ORDER: Fields<"fourth-order"> = {
  r1: {
    name: "Rim radius",
    help: "How wide the rim is.",
  },
  "eta-1": {
    name: "Rim flare",
    help: "How strongly the wall leans where it meets the rim, as a share of the belly’s swell.",
  },
  "dz-1": {
    name: "Rise at the rim",
    help: "How steeply the wall climbs where it meets the rim.",
  },
  r0: {
    name: "Foot radius",
    help: "How wide the foot is.",
  },
  "eta-0": {
    name: "Foot flare",
    help: "How strongly the wall leans where it leaves the foot, as a share of the belly’s swell.",
  },
  "dz-0": {
    name: "Rise at the foot",
    help: "How steeply the wall climbs where it leaves the foot.",
  },
  h1: {
    name: "Height",
    help: "From the foot up to the rim.",
  },
  rm: {
    name: "Belly radius",
    help: "The width that the two flares aim at half way up.",
  },
  "t-0": {
    name: "Waist pull",
    help: "Tightens the wall like a skin, towards the shortest way between its ends.",
  },
  "t-1": {
    name: "Waist pull",
    help: "Tightens the wall like a skin, towards the shortest way between its ends.",
  },
  "w-0": {
    name: "Axis pull",
    help: "Draws the middle of the wall in towards the axis.",
  },
  "w-1": {
    name: "Axis pull",
    help: "Draws the middle of the wall in towards the axis.",
  },
  "s-0": {
    name: "Wall stiffness",
    help: "Bends the wall in wide, even curves. It may not be 0.",
  },
  "s-1": {
    name: "Wall stiffness",
    help: "Bends the wall in wide, even curves. It may not be 0.",
  },
};

/** The dint vase, IA equations 15 to 18. The rim is at `u = 0`. */
const BLOOR_WILSON: Fields<"bloor-wilson"> = {
  "r-0": {
    name: "Rim radius",
    help: "How wide the rim is.",
  },
  "R-0": {
    name: "Rim flare",
    help: "Which way the wall leaves the rim: below 0 inwards, above 0 outwards.",
  },
  "H-0": {
    name: "Rise at the rim",
    help: "How steeply the wall leaves the rim: below 0 downwards, above 0 it first climbs.",
  },
  n1: {
    name: "Number of dints",
    help: "How many waves the rim has. A fraction leaves the pot open.",
  },
  "h-1": {
    name: "Dint height",
    help: "How far the rim waves up and down. 0 gives a level rim.",
  },
  "H-1": {
    name: "Dint slope",
    help: "How the waves run on into the wall: against the dint height they fade quickly, with it they carry on.",
  },
  "r-1": {
    name: "Rim skew, first",
    help: "Stretches the rim into an oval along the diagonal. It adds to the second.",
  },
  "r-2": {
    name: "Rim skew, second",
    help: "Stretches the rim into an oval along the diagonal. It adds to the first.",
  },
  "r-3": {
    name: "Foot radius",
    help: "How wide the foot is.",
  },
  "R-3": {
    name: "Foot flare",
    help: "Which way the wall runs on through the foot: above 0 outwards, below 0 inwards.",
  },
  "h-0": {
    name: "Height",
    help: "From the foot up to the middle of the rim.",
  },
  "R-1": {
    name: "Skew slope, first",
    help: "How the oval of the rim runs on into the wall. It adds to the second.",
  },
  "R-2": {
    name: "Skew slope, second",
    help: "How the oval of the rim runs on into the wall. It adds to the first.",
  },
  a: {
    name: "Smoothing",
    help: "How far the edges reach into the wall: near 0 far, large values keep their waves close to the rim.",
  },
};

export const parameters = phrases("parameters", {
  kinds: {
    "second-order": "Second order",
    "mixed-order": "Mixed order",
    "fourth-order": "Fourth order",
    "bloor-wilson": "Bloor–Wilson",
    "boundary-value": "Free boundary data",
    rings: "Rings",
    "vertex-frame": "Network of patches",
    blend: "Blend",
    octant: "Octant",
  } satisfies Readonly<Record<Kind, string>>,
  sources: {
    "second-order": "Zhang and You 2001, eqs 1 to 8",
    "mixed-order": "Zhang and You 2001, eqs 9 to 12",
    "fourth-order": "Zhang and You 2001, eqs 13 to 17",
    "bloor-wilson": "Ishak and Ali, eqs 15 to 18",
  } satisfies Readonly<Record<FamilyKind, string>>,
  groups: {
    rim: { name: "Rim", help: "The upper edge" },
    foot: { name: "Foot", help: "The lower edge" },
    wall: { name: "Wall", help: "What the clay does in between" },
    height: { name: "Height", help: "From the foot to the rim" },
    equation: { name: "Equation", help: "The weights of its terms" },
    force: { name: "Force", help: "A push along the whole wall" },
  } satisfies Readonly<Record<Group, FieldWords>>,
  fields: {
    "second-order": PLANAR,
    "mixed-order": MIXED_ORDER,
    "fourth-order": FOURTH_ORDER,
    "bloor-wilson": BLOOR_WILSON,
  } satisfies { readonly [K in FamilyKind]: Fields<K> },
  explain: "Explain",
  inX: "in x",
  inY: "in y",
  same: "Same in x and y",
  sameOf: (name: string) => `${name}: same in x and y`,
  free: "Make it rings…",
  patches: "Make it patches…",
  freeAbout: "To pull it where you like, with petals, tilts and corners of your own:",
  opensByDints: "The wall does not close. It closes when the number of dints is a whole number.",
  opensByPetals: "The wall does not close. It closes when the petals and the turns are whole numbers.",
});
