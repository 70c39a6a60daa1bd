import type { Bounds } from "./mesh";
import { along, at, distance, dot, type Triple } from "./triple";

/**
 * Where the camera is: on a sphere round what it looks at. Angles in radians, lengths in model units. The eye is at
 * `target + distance (sin polar cos azimuth, sin polar sin azimuth, cos polar)`: polar 0 looks straight down, pi straight up,
 * azimuth -pi/2 is the front.
 */
export interface CameraPose {
  azimuth: number;
  polar: number;
  distance: number;
  target: Triple;
}

/** Where the camera looks from. */
export type Direction = Pick<CameraPose, "azimuth" | "polar">;

/** The standard views. */
export type ViewName = "three-quarter" | "front" | "side" | "top" | "below";

/** Vertical field of view in radians: a long lens, as products are photographed, so that a rim keeps its true curve. */
export const FIELD_OF_VIEW = (27 * Math.PI) / 180;

/** What a fitted pot leaves free beside itself, as a factor of its size. */
const FIT_MARGIN = 1.16;

/** The same above and below, where the page lays its description and its buttons over the stage. */
export const FIT_MARGIN_UPRIGHT = 1.3;

const FRONT = -Math.PI / 2;

/** The direction of every standard view. */
export const VIEWS: Readonly<Record<ViewName, Direction>> = {
  "three-quarter": { azimuth: FRONT + 0.55, polar: 1.13 },
  front: { azimuth: FRONT, polar: Math.PI / 2 },
  side: { azimuth: 0, polar: Math.PI / 2 },
  top: { azimuth: FRONT, polar: 0 },
  below: { azimuth: FRONT, polar: Math.PI },
};

/** The orthonormal axes of the camera: `right`, `up`, and `back` from the target to the eye. */
export interface CameraAxes {
  right: Triple;
  up: Triple;
  back: Triple;
}

/** The axes for a direction; well defined at the poles too, where a look-at matrix is not. */
export function axesOf(azimuth: number, polar: number): CameraAxes {
  const [ca, sa, cp, sp] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(polar), Math.sin(polar)];
  return { right: [-sa, ca, 0], up: [-cp * ca, -cp * sa, sp], back: [sp * ca, sp * sa, cp] };
}

/** The position of the eye. */
export function eyeOf(pose: CameraPose): Triple {
  const { back } = axesOf(pose.azimuth, pose.polar);
  return along(pose.target, back, pose.distance);
}

/** An angle moved by whole turns to be within half a turn of another: the short way round. */
export function nearestTurn(angle: number, to: number): number {
  return angle + 2 * Math.PI * Math.round((to - angle) / (2 * Math.PI));
}

/**
 * The least distance from which all points (xyz triples) are inside the picture, with a margin unless that is not asked for, looking at `target`.
 * `upright` is the margin above and below.
 * A point at `(x, y, z)` in camera axes is inside when `|y| <= (d - z) tan(fov / 2)` and `|x| <= (d - z) tan(fov / 2) aspect`.
 */
export function fitDistance(
  points: ArrayLike<number>,
  target: Triple,
  axes: CameraAxes,
  aspect: number,
  margin = true,
  upright = FIT_MARGIN_UPRIGHT,
): number {
  const tan = Math.tan(FIELD_OF_VIEW / 2);
  const tanY = tan / (margin ? upright : 1);
  const tanX = (tan / (margin ? FIT_MARGIN : 1)) * (aspect > 0 ? aspect : 1);
  let far = 0;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const p: Triple = [at(points, i) - target[0], at(points, i + 1) - target[1], at(points, i + 2) - target[2]];
    const depth = dot(p, axes.back);
    far = Math.max(far, depth + Math.abs(dot(p, axes.right)) / tanX, depth + Math.abs(dot(p, axes.up)) / tanY);
  }
  return far;
}

/** Near and far planes that enclose a sphere, the near one never so close that depth loses its precision. */
export function clipPlanes(eye: Triple, bounds: Pick<Bounds, "centre" | "radius">): { near: number; far: number } {
  const away = distance(eye, bounds.centre);
  const far = away + bounds.radius;
  return { near: Math.max(away - bounds.radius, far / 400), far };
}
