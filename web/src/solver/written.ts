/** A mesh that is written over in place: of thousands of patches a hand moves few, and the others stay where they are, also on the GPU. */

/** Who is further behind than this has all of it anew. */
const MOST = 16;

/** What was written over in the arrays of a mesh, by the revisions that this made. */
export class Written {
  #log: { readonly from: number; readonly to: number; readonly ranges: Uint32Array }[] = [];

  /** All since a revision, each as pairs of the first vertex and how many there are from it on; null where that is not known any more. */
  since(revision: number): readonly Uint32Array[] | null {
    const first = this.#log.findIndex(({ from }) => from === revision);
    return first < 0 ? null : this.#log.slice(first).map(({ ranges }) => ranges);
  }

  /** Notes what led from one revision to the next. */
  note(from: number, to: number, ranges: Uint32Array): void {
    this.#log = [...this.#log, { from, to, ranges }].slice(-MOST);
  }
}

/** Puts triples, one range after the other, where they belong among all. */
export function rewrite(all: Float32Array, triples: Float32Array, ranges: Uint32Array): void {
  let next = 0;
  for (let pair = 0; pair < ranges.length; pair += 2) {
    const [from, count] = [3 * (ranges[pair] ?? 0), 3 * (ranges[pair + 1] ?? 0)];
    all.set(triples.subarray(next, next + count), from);
    next += count;
  }
}
