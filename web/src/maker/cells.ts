/** The inside of a solid as cells for analysis: how good they are, and the file that holds them. */

import { cells, cellsFile } from "pasu";
import type { CellShape, CellsFormat } from "../document/blend/cells";
import type { Design, Sent, Triple } from "../document/types";

export interface CellsAsk {
  readonly kind: "cells";
  readonly design: Design;
  readonly part: number;
  /** Along `u`, `v` and `w`. */
  readonly counts: Triple;
  readonly shape: CellShape;
  /** Null where only what they are like is asked. */
  readonly format: CellsFormat | null;
}

export interface MadeCells {
  readonly count: number;
  /** The least scaled Jacobian, and how many are not above 0. */
  readonly least: number;
  readonly useless: number;
  readonly bytes: Uint8Array<ArrayBuffer> | null;
}

export function cellsOf({ design, part, counts, shape, format }: CellsAsk): MadeCells {
  const options = { counts, shape };
  const { quality } = cells(design as Sent, part, options);
  let [least, useless] = [Number.POSITIVE_INFINITY, 0];
  for (const each of quality) {
    least = Math.min(least, each);
    if (!(each > 0)) useless += 1;
  }
  const bytes = format === null ? null : (cellsFile(design as Sent, part, format, options) as Uint8Array<ArrayBuffer>);
  return { count: quality.length, least, useless, bytes };
}
