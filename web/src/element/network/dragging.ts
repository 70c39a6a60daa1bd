/** What a movement of the pointer means for points that are seen from somewhere: moved in the plane across the view or along a way, turned, or scaled. */

import { type Motion, onGrid, scaleBy, shiftBy, shiftOnto, turnBy } from "../../document/network/moving";
import { cross, dot, unit } from "../../document/network/surface";
import { minus, plus } from "../../document/network/topology";
import type { Triple } from "../../document/types";
import type { See, Spot } from "../../render/pull/reach";
import { followed } from "../blend/grip-pull";

/** How a point moves on the screen along x, y and z, in pixels for a unit. */
interface Slope {
  readonly right: Triple;
  readonly down: Triple;
}

/** Nearer to its pivot a hand turns and scales by how far it goes, in pixels. */
const NEAR = 16;
/** So many pixels double the size, or turn by a radian. */
const REACH = 100;

function slopeAt(see: See, at: Triple, size: number): Slope {
  const here = see(at);
  const step = 1e-4 * size;
  const along = [0, 1, 2].map((axis) => {
    const there = see(at.map((value, each) => (each === axis ? value + step : value)) as unknown as Triple);
    return here && there ? [(there.x - here.x) / step, (there.y - here.y) / step] : [0, 0];
  });
  const of = (which: 0 | 1) => along.map((each) => each[which] ?? 0) as unknown as Triple;
  return { right: of(0), down: of(1) };
}

/** The least movement that is seen as this one: it lies across the view. */
export function acrossView(see: See, at: Triple, size: number, by: Spot): Triple {
  const { right, down } = slopeAt(see, at, size);
  const [rr, rd, dd] = [dot(right, right), dot(right, down), dot(down, down)];
  const determinant = rr * dd - rd * rd;
  if (!(determinant > 0)) return [0, 0, 0];
  const [p, q] = [(by.x * dd - by.y * rd) / determinant, (by.y * rr - by.x * rd) / determinant];
  return plus([p * right[0], p * right[1], p * right[2]], down, q);
}

/** Towards the eye. */
export function towardsEye(see: See, at: Triple, size: number): Triple {
  const { right, down } = slopeAt(see, at, size);
  return unit(cross(down, right)) ?? [0, 0, 1];
}

export interface Grasp {
  readonly see: See;
  /** The point that the hand has. */
  readonly at: Triple;
  /** The middle of what is picked. */
  readonly pivot: Triple;
  /** The way that it goes along, or is turned about; null for the view's own. */
  readonly way: Triple | null;
  readonly size: number;
  /** The step of the grid; null where there is none. */
  readonly grid: number | null;
  readonly from: Spot;
}

export function moving(grasp: Grasp, by: Spot, meets: Triple | null): Motion {
  const { see, at, way, size, grid } = grasp;
  if (meets) return shiftOnto(at, meets);
  if (!way) return shifting(grasp, acrossView(see, at, size, by));
  const [far = 0] = followed(see, at, [way], by);
  const steps = grid === null ? far : Math.round(far / grid) * grid;
  return shifting(grasp, [way[0] * steps, way[1] * steps, way[2] * steps]);
}

/** By so far; where there is a grid, to the point of it that is nearest to there. Along a normal it goes by whole steps. */
export function shifting({ at, way, grid }: Grasp, by: Triple): Motion {
  const straight = !way || way.filter((value) => value !== 0).length === 1;
  return shiftBy(grid !== null && straight ? minus(onGrid(plus(at, by, 1), grid, way ?? undefined), at) : by);
}

export function turning({ see, pivot, way, size, from }: Grasp, by: Spot): Motion {
  const eye = towardsEye(see, pivot, size);
  const axis = way ?? eye;
  const sign = dot(axis, eye) < 0 ? -1 : 1;
  const middle = see(pivot) ?? from;
  const [x, y] = [from.x - middle.x, from.y - middle.y];
  if (Math.hypot(x, y) < NEAR) return turnBy(pivot, axis, (sign * by.x) / REACH);
  const angle = Math.atan2(y + by.y, x + by.x) - Math.atan2(y, x);
  // The screen counts downwards: what goes round clockwise there turns back about the way to the eye.
  return turnBy(pivot, axis, -sign * angle);
}

export function scaling({ see, pivot, way, from }: Grasp, by: Spot): Motion {
  const middle = see(pivot) ?? from;
  const [x, y] = [from.x - middle.x, from.y - middle.y];
  const before = Math.hypot(x, y);
  const factor = before < NEAR ? 2 ** (by.x / REACH) : Math.hypot(x + by.x, y + by.y) / before;
  return scaleBy(pivot, Math.max(factor, 0.01), way);
}
