import { Buffer } from "./gl/buffer";
import type { PartMesh } from "./mesh";

/** What depends on the grid alone, on the GPU. */
export interface Lattice {
  readonly indices: Uint32Array;
  readonly uv: Buffer;
  readonly index: Buffer;
  /** Vertices of a row; they are numbered row by row. */
  readonly columns: number;
}

/** The lattices of a pot: parts on the same grid share one. */
export class Lattices {
  private readonly known = new Map<Uint32Array, Lattice>();

  of({ indices, uvs }: PartMesh): Lattice {
    let lattice = this.known.get(indices);
    if (!lattice) {
      lattice = {
        indices,
        uv: new Buffer(uvs, { size: 2 }),
        index: new Buffer(indices, { size: 1 }),
        columns: columnsOf(uvs),
      };
      this.known.set(indices, lattice);
    }
    return lattice;
  }

  /** Lets all others go. */
  keep(used: readonly Lattice[]): void {
    for (const lattice of this.known.values()) {
      if (used.includes(lattice)) continue;
      free(lattice);
      this.known.delete(lattice.indices);
    }
  }

  release(): void {
    for (const lattice of this.known.values()) free(lattice);
  }
}

/** How many vertices the first row has: those that have its u. */
function columnsOf(uvs: Float32Array): number {
  let columns = 1;
  while (2 * columns < uvs.length && uvs[2 * columns] === uvs[0]) columns += 1;
  return columns;
}

function free({ uv, index }: Lattice): void {
  uv.release();
  index.release();
}
