import { vec4 } from "gl-matrix";
import type { Bench } from "../stage";
import { at, type Triple } from "../triple";
import type { See } from "./reach";

type Quad = readonly [number, number, number, number];

/**
 * How points are seen on a screen of so many CSS pixels from where the camera is now, and stay seen so, whatever becomes of the camera. `model` takes them to
 * where they stand.
 */
export function sightOf(
  bench: Bench,
  [width, height]: readonly [number, number],
  model: readonly number[],
): See | null {
  if (width === 0) return null;
  const { view } = bench.camera;
  const [cx = 0, cy = 0, cz = 0, scale = 1] = bench.studio.frame.value;
  const [look, lens] = [view.uniforms.viewMatrix.value, view.uniforms.projectionMatrix.value].map((each) => [...each]);
  const by = (matrix: readonly number[] | undefined, [x, y, z, w]: Quad): Quad =>
    vec4.transformMat4([0, 0, 0, 0], [x, y, z, w], (matrix ?? []) as number[]) as number[] as unknown as Quad;
  const clip = (point: Triple) => {
    const [px, py, pz] = by(model, [...point, 1]);
    return by(lens, by(look, [scale * (px - cx), scale * (py - cy), scale * (pz - cz), 1]));
  };
  // All of it is linear before the division: found once for the corner and for each axis, so that thousands of points cost little.
  const corner = clip([0, 0, 0]);
  const [ax, ay, az] = (
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const
  ).map((axis) => clip(axis).map((value, place) => value - at(corner, place))) as unknown as readonly [
    Quad,
    Quad,
    Quad,
  ];
  return ([px, py, pz]) => {
    const w = px * ax[3] + py * ay[3] + pz * az[3] + corner[3];
    if (!(w > 0)) return null;
    const x = px * ax[0] + py * ay[0] + pz * az[0] + corner[0];
    const y = px * ax[1] + py * ay[1] + pz * az[1] + corner[1];
    return { x: width * (0.5 + (0.5 * x) / w), y: height * (0.5 - (0.5 * y) / w), depth: w };
  };
}
