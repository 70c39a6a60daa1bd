/** Networks woven of rings: walls between them, discs within them, tubes from one opening to another. What stands in one place is one vertex. */

import type { Triple } from "../types";
import type { Frame, Network, Patch } from "./network";

/** Points that go round: corners at even places, the middles of edges between them. */
export type Ring = readonly Triple[];

/** Decimals of what is written. */
const DECIMALS = 6;

export class Weaving {
  readonly #places = new Map<string, number>();
  readonly #vertices: Triple[] = [];
  readonly #patches: Patch[] = [];

  constructor(private readonly decimals = DECIMALS) {}

  /** A patch through eight points, from a corner on, with middles between them. */
  patch(points: readonly Triple[], more: Omit<Patch, "frame"> = {}): void {
    this.#patches.push({ frame: points.map((point) => this.#vertex(point)) as unknown as Frame, ...more });
  }

  /** A wall from one ring to another, whose middles are given by a third: all as long, and closed. `without` are columns that stay open. */
  wall(from: Ring, middle: Ring, to: Ring, without: readonly number[] = []): void {
    const { length } = from;
    const of = (ring: Ring, place: number) => ring[place % length] as Triple;
    for (let column = 0; 2 * column < length; column += 1) {
      if (without.includes(column)) continue;
      const [a, b, c] = [2 * column, 2 * column + 1, 2 * column + 2];
      this.patch([
        of(from, a),
        of(from, b),
        of(from, c),
        of(middle, c),
        of(to, c),
        of(to, b),
        of(to, a),
        of(middle, a),
      ]);
    }
  }

  /** Closes a ring of a multiple of four patches by half as many, which meet in its middle. */
  disc(ring: Ring, centre: Triple, bulge: (share: number, point: Triple) => Triple): void {
    const { length } = ring;
    const of = (place: number) => ring[place % length] as Triple;
    for (let place = 0; place < length; place += 4) {
      const [a, b, c, d, e] = [0, 1, 2, 3, 4].map((by) => of(place + by)) as [Triple, Triple, Triple, Triple, Triple];
      this.patch([a, b, c, d, e, bulge(0.5, e), centre, bulge(0.5, a)]);
    }
  }

  network(more: Omit<Network, "kind" | "vertices" | "patches"> = {}): Network {
    return { kind: "vertex-frame", vertices: this.#vertices, patches: this.#patches, ...more };
  }

  #vertex(point: Triple): number {
    const neat = point.map((value) => Number(value.toFixed(this.decimals)) + 0) as unknown as Triple;
    const key = neat.join();
    const known = this.#places.get(key);
    if (known !== undefined) return known;
    this.#places.set(key, this.#vertices.length);
    this.#vertices.push(neat);
    return this.#vertices.length - 1;
  }
}

/** A ring of so many patches round the axis, half a patch turned so that a patch and no edge is on either axis. */
export function ringOf(patches: number, of: (angle: number) => Triple): Ring {
  return Array.from({ length: 2 * patches }, (_, place) => of((Math.PI * (place - 1)) / patches));
}

/** The four sides of an opening between two rings, as a ring: from its corner at the first ring on. */
export function opening(from: Ring, middle: Ring, to: Ring, column: number): Ring {
  const { length } = from;
  const of = (ring: Ring, place: number) => ring[place % length] as Triple;
  const [a, b, c] = [2 * column, 2 * column + 1, 2 * column + 2];
  return [of(from, a), of(from, b), of(from, c), of(middle, c), of(to, c), of(to, b), of(to, a), of(middle, a)];
}

/** The same ring from another place on, and the other way round where that is wanted. */
export function turned(ring: Ring, first: number, reversed = false): Ring {
  const { length } = ring;
  return ring.map((_, place) => ring[(((first + (reversed ? -place : place)) % length) + length) % length] as Triple);
}
