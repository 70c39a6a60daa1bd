/** Scenes: several pots that stand together, each an object of its own. In centimetres. */

import { FORMS } from "../forms";
import { ringed } from "../ringed";
import type { Look, Part, Placement, Triple } from "../types";
import { type Exhibit, exhibits } from "./exhibit";
import { handle } from "./networks";
import { PAPERS } from "./papers";
import { widget } from "./widget";

/** How far a lid hovers above the rim that it covers: nobody sees it, and separate objects share no point. */
const GAP = 0.02;

/** How high a lid is. */
const LID = 3.3;

/** How far it can be lifted. */
const RISE = 8;

type Standing = Pick<Placement, "scale" | "shift">;

function found<Id extends string>(all: readonly Exhibit<Id>[], id: Id): Exhibit<Id> {
  const exhibit = all.find((each) => each.id === id);
  if (!exhibit) throw new Error(`no exhibit is called ${id}`);
  return exhibit;
}

/** One of the forms, standing there, perhaps in other colours. */
function form(id: (typeof FORMS)[number]["id"], place: Standing, own: Look = {}): Part {
  const { shape, wall, look } = found(FORMS, id);
  return { shape, ...(wall && { wall }), look: { ...look, ...own }, place };
}

/** A lid for a mouth of so large a radius, the knob uppermost: it is thrown as a bowl, and turned over. */
function lid(label: string, radius: number, thickness: number, look: Look, [x, y, z]: Triple): Part {
  const radii = [1.35, 0.95, 1.7, 0.65 * radius, radius - 0.1, radius];
  return {
    shape: ringed(radii, [0, 0.9, 1.5, 2.1, 2.7, LID], { a: 0.5 }),
    wall: { thickness, base: 0.5, rim: "flat" },
    look,
    place: { axis: [1, 0, 0], angle: -Math.PI, shift: [x, y, z + LID + GAP] },
    joints: { z: { label, limits: [z + LID + GAP, z + LID + GAP + RISE] } },
  };
}

/** A figure of a paper in other clay, five times as large. */
function figure(id: (typeof PAPERS)[number]["id"], x: number, look: Look): Part {
  return { shape: found(PAPERS, id).shape, look, place: { scale: [5, 5, 5], shift: [x, 0, 0] } };
}

/** Each of them an object of its own. */
function separate(parts: readonly Part[]): Pick<Exhibit, "parts"> & { readonly shape: Part["shape"] } {
  const [first] = parts;
  if (!first) throw new Error("a scene has a part at least");
  return { shape: first.shape, parts: parts.map((part, object) => (object === 0 ? part : { ...part, object })) };
}

/** Glued into one object. */
function glued(parts: readonly Part[]): Pick<Exhibit, "parts"> & { readonly shape: Part["shape"] } {
  const [first] = parts;
  if (!first) throw new Error("an object has a part at least");
  return { shape: first.shape, parts };
}

/** A cup and its handle, whose ends are within the wall of the cup: they share points and neither is inside the other. */
function mug(): readonly Part[] {
  const cup = form("form-cup", {});
  return [cup, { shape: handle(3.86, 5, [3, 1.7], [0.75, 0.45]), ...(cup.look && { look: cup.look }) }];
}

const TERRACOTTA: Look = { glaze: "bare", clay: "terracotta" };
const SHINO: Look = { glaze: "shino", clay: "stoneware" };

const cup = (x: number, y: number): Part =>
  form("form-cup", { scale: [0.75, 0.75, 0.75], shift: [x, y, 0] }, { glaze: "celadon" });

export const SCENES = exhibits([
  { id: "own-lidded-jar", ...separate([form("form-jar", {}), lid("Lift the lid", 5.2, 0.4, SHINO, [0, 0, 18.4])]) },
  {
    id: "own-tea-set",
    ...separate([
      form("form-teapot", {}),
      lid("Lift the lid", 3.7, 0.3, TERRACOTTA, [0, 0, 10.9]),
      cup(-11.5, -7),
      cup(-4, -12.5),
      cup(4.5, -12.5),
      cup(12, -7),
      form("form-jug", { scale: [0.6, 0.6, 0.6], shift: [-14, 3, 0] }),
      form("form-plate", { scale: [0.6, 0.6, 0.6], shift: [17, 4, 0] }),
    ]),
  },
  {
    id: "own-shelf",
    ...separate([
      figure("zhang-you-1a", -26, { glaze: "celadon", clay: "porcelain" }),
      figure("zhang-you-3b", -13, { glaze: "cobalt", clay: "porcelain" }),
      figure("zhang-you-5b", 0, { glaze: "copper-red", clay: "porcelain" }),
      figure("zhang-you-5d", 13, { glaze: "tenmoku", clay: "stoneware" }),
      figure("ishak-ali-4-n5", 26, { glaze: "shino", clay: "stoneware" }),
    ]),
  },
]);

/** Of several parts that are one object. */
export const GLUED = exhibits([
  { id: "own-glued-mug", ...glued(mug()) },
  { id: "own-widget", ...glued(widget()) },
]);
