/** Moving, turning and scaling what is picked of a network: with its mirror image, and to a grid. */

import type { Triple } from "../types";
import { at, CORNERS, type Network, patchesRound, sizeOf } from "./network";
import { meanOf, minus, plus } from "./topology";

export type Axis = "x" | "y" | "z";
export const AXES = ["x", "y", "z"] as const satisfies readonly Axis[];

/** Digits of what a hand does. */
const DIGITS = 5;
/** Of the size: vertices no further from where the mirror has them are each other's images. */
const NEAR = 1e-5;

export interface Motion {
  (point: Triple): Triple;
  /** Whether points go to where others are, which have more digits than a hand has use for. */
  readonly isExact?: boolean;
}

/** Digits that documents keep. */
const KEPT = 12;

export function middleOf(network: Network, picked: Iterable<number>): Triple {
  return meanOf([...picked].map((vertex) => at(network, vertex)));
}

export function shiftBy(by: Triple): Motion {
  return (point) => plus(point, by, 1);
}

/** As far as a number that was typed says, to its last digit. */
export function shiftExactly(by: Triple): Motion {
  return Object.assign(shiftBy(by), { isExact: true });
}

/** With what is at one point to another one, and not to beside it. */
export function shiftOnto(from: Triple, to: Triple): Motion {
  const by = minus(to, from);
  const motion: Motion = (point) => (point.every((value, axis) => value === from[axis]) ? to : plus(point, by, 1));
  return Object.assign(motion, { isExact: true });
}

/** About an axis through a point; anticlockwise seen against it. */
export function turnBy(pivot: Triple, axis: Triple, angle: number): Motion {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y, z] = axis;
  return (point) => {
    const [px, py, pz] = minus(point, pivot);
    const along = (x * px + y * py + z * pz) * (1 - c);
    return [
      pivot[0] + c * px + s * (y * pz - z * py) + along * x,
      pivot[1] + c * py + s * (z * px - x * pz) + along * y,
      pivot[2] + c * pz + s * (x * py - y * px) + along * z,
    ];
  };
}

/** From a point, the same in all directions, or along one alone. */
export function scaleBy(pivot: Triple, factor: number, way: Triple | null): Motion {
  return (point) => {
    const from = minus(point, pivot);
    if (!way) return plus(pivot, from, factor);
    const along = from[0] * way[0] + from[1] * way[1] + from[2] * way[2];
    return plus(point, way, (factor - 1) * along);
  };
}

/** The nearest point of a grid; on axes that `moves` leaves out it stays. */
export function onGrid(point: Triple, step: number, moves: Triple = [1, 1, 1]): Triple {
  const snap = (axis: 0 | 1 | 2) => (moves[axis] === 0 ? point[axis] : Math.round(point[axis] / step) * step);
  return [snap(0), snap(1), snap(2)];
}

const mirrored = new WeakMap<Network["vertices"], Map<Axis, ReadonlyMap<number, number>>>();

/** For each vertex its image in the plane where the coordinate is 0, where there is one. */
export function imagesOf(network: Network, mirror: Axis): ReadonlyMap<number, number> {
  const before = mirrored.get(network.vertices) ?? new Map<Axis, ReadonlyMap<number, number>>();
  const images = before.get(mirror) ?? imagesIn(network, mirror);
  mirrored.set(network.vertices, before.set(mirror, images));
  return images;
}

function imagesIn(network: Network, mirror: Axis): ReadonlyMap<number, number> {
  const axis = AXES.indexOf(mirror);
  const cell = NEAR * sizeOf(network);
  const keyOf = (point: Triple) => point.map((value) => Math.round(value / cell)).join();
  const places = new Map<string, number>();
  for (const [index, point] of network.vertices.entries()) places.set(keyOf(point), index);
  const images = new Map<number, number>();
  for (const [index, point] of network.vertices.entries()) {
    const key = keyOf(point.map((value, each) => (each === axis ? -value + 0 : value)) as unknown as Triple);
    const image = places.get(key);
    if (image !== undefined) images.set(index, image);
  }
  return images;
}

/** The network after a motion of what is picked, or as it was where that would be none. What stands in the mirror stays there. */
export function moved(
  network: Network,
  picked: ReadonlySet<number>,
  motion: Motion,
  mirror: Axis | null = null,
): Network {
  const digits = DIGITS - Math.floor(Math.log10(sizeOf(network)));
  const step = 10 ** Math.min(Math.max(digits, 0), 12);
  const rounded = (value: number) =>
    motion.isExact ? Number(value.toPrecision(KEPT)) : Math.round(value * step) / step;
  // A coordinate in which nothing moves is as it was, however many digits it has.
  const neat = (point: Triple, from: Triple) =>
    point.map((value, each) => (value === from[each] ? from[each] : rounded(value) + 0)) as unknown as Triple;
  const vertices = [...network.vertices];
  const images = mirror ? imagesOf(network, mirror) : null;
  const axis = mirror ? AXES.indexOf(mirror) : -1;
  for (const vertex of picked) {
    const point = network.vertices[vertex];
    if (!point) continue;
    const image = images?.get(vertex);
    const to = neat(motion(point), point);
    vertices[vertex] =
      image === vertex ? (to.map((value, each) => (each === axis ? 0 : value)) as unknown as Triple) : to;
    if (image === undefined || image === vertex || picked.has(image)) continue;
    vertices[image] = to.map((value, each) => (each === axis ? -value + 0 : value)) as unknown as Triple;
  }
  // What is frozen here has not to be looked through by whoever keeps the design.
  for (const vertex of picked) freeze(vertices, vertex);
  if (images) for (const vertex of picked) freeze(vertices, images.get(vertex));
  const next = Object.isFrozen(network.vertices)
    ? { ...network, vertices: Object.freeze(vertices) }
    : { ...network, vertices };
  return standsApart(next, new Set([...picked, ...[...picked].flatMap((vertex) => images?.get(vertex) ?? [])]))
    ? next
    : network;
}

/** What comes of a motion, or the network before it where every point stays in its place: that is no step to undo. */
export function unlessStill(next: Network, before: Network): Network {
  const isStill =
    next.patches === before.patches &&
    next.vertices.every((point, index) => {
      const old = before.vertices[index];
      return point === old || point.every((value, axis) => value === old?.[axis]);
    });
  return isStill ? before : next;
}

function freeze(vertices: readonly Triple[], vertex: number | undefined): void {
  const point = vertex === undefined ? undefined : vertices[vertex];
  if (point) Object.freeze(point);
}

/** Whether no corners meet of the patches round these vertices: nothing else comes of moving them. */
function standsApart(network: Network, vertices: ReadonlySet<number>): boolean {
  const round = patchesRound(network, vertices);
  for (const vertex of vertices) if (!at(network, vertex).every(Number.isFinite)) return false;
  return round.every((patch) => {
    const frame = network.patches[patch]?.frame;
    const corners = CORNERS.map((place) => at(network, frame?.[place] ?? 0));
    return corners.every(([x, y, z], one) =>
      corners.every((other, place) => place <= one || other[0] !== x || other[1] !== y || other[2] !== z),
    );
  });
}
