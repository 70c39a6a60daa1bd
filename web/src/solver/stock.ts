/** What the page keeps of meshes between two of them: arrays to be written over, and what depends on the grid alone. */

import type { Lattice, PartMesh, SentMesh, Spare, Used } from "./messages";
import { Written } from "./written";

/** One set is on the stage and one under way; while a third is sent back, the next may be asked for. */
const SPARES = 3;

/** The grid under the hand, that at rest, and one of a comparison, each with parts that are wound one way and the other. */
const LATTICES = 6;

export type Lattices = ReadonlyMap<string, Lattice>;

export class Stock {
  #spares: Spare[] = [];
  readonly #lattices = new Map<string, Lattice>();

  /** The lattices at this moment, by topology. Whoever asks for a mesh holds on to them until it comes: others may put them out. */
  get lattices(): Lattices {
    return new Map(this.#lattices);
  }

  /** Keeps the arrays of a mesh that is of no more use. Two stages may give back the same one. */
  add({ positions, normals, ware }: Used): void {
    if (this.#spares.some((spare) => spare.positions === positions)) return;
    this.#spares = [...this.#spares, { positions, normals, texels: ware.texels }].slice(-SPARES);
  }

  /** Arrays for so many vertices, if there are any. */
  take(vertices: number): Spare | null {
    const index = this.#spares.findIndex(({ positions }) => positions.length === 3 * vertices);
    return this.#spares.splice(index, index < 0 ? 0 : 1)[0] ?? null;
  }

  /** The mesh with its lattice, the very arrays that the last one of this topology had, or that were there when it was asked for. */
  whole({ lattice, serial, ...surface }: SentMesh, then: Lattices): PartMesh {
    const { topology } = surface;
    const found = this.#lattices.get(topology) ?? lattice ?? then.get(topology);
    if (!found) throw new Error(`the solver sent no lattice for ${topology}`);
    // Put in anew, so that the one that was not used for longest comes first and goes first.
    this.#lattices.delete(topology);
    this.#lattices.set(topology, found);
    for (const old of [...this.#lattices.keys()].slice(0, -LATTICES)) this.#lattices.delete(old);
    return { ...surface, ...found, ...(serial !== undefined && { writes: new Written() }) };
  }
}
