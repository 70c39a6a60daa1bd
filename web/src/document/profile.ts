/**
 * The four boundary data of a pot as handles on its section: the rim and foot points, and the slopes of the wall there. The solver says which
 * numbers of the shape each of them moves; here they are moved.
 */

import { AXES } from "./boundary-value";
import { filled } from "./kinds";
import { numberAt, pathOf, setPath } from "./path";
import type { Component, Handle, Rings, Shape } from "./types";

export function isFree(handle: Handle): boolean {
  return handle.radial.length > 0 || handle.axial.length > 0;
}

/** The shape after a handle moved by (`radial`, `axial`), in model units; the same shape when it cannot be moved so. */
export function moveHandle(
  shape: Shape,
  handle: Pick<Handle, "radial" | "axial">,
  radial: number,
  axial: number,
): Shape {
  let next = shape;
  const ways = [
    [handle.radial, radial],
    [handle.axial, axial],
  ] as const;
  for (const [steps, distance] of ways) {
    if (distance === 0) continue;
    for (const { path: text, by } of steps) {
      const path = pathOf(text);
      const whole = filled(next);
      next = setPath(whole, path, add(numberAt(whole, path, 0), by * distance));
    }
  }
  return next;
}

/** Whether the handles of one shape move another too: they are told by places in the document. */
export function sharesHandles(one: Shape, other: Shape): boolean {
  if (one.kind === "rings" && other.kind === "rings") {
    const ends = ({ foot, rim }: Rings) => `${foot !== undefined} ${rim !== undefined}`;
    return one.rings.length === other.rings.length && ends(one) === ends(other);
  }
  if (one.kind !== "boundary-value" || other.kind !== "boundary-value") return one.kind === other.kind;
  return AXES.every((axis) => isBeginning(one[axis], other[axis]));
}

/** What is added behind the last mode moves none of those before it. */
function isBeginning(one: Component, other: Component): boolean {
  return one.order === other.order && one.modes.every(({ n }, index) => other.modes[index]?.n === n);
}

/** A sum rounded to nine digits: finer than any hand, and the field beside the picture stays readable. */
function add(value: number, by: number): number {
  return by === 0 ? value : Number((value + by).toPrecision(9));
}
