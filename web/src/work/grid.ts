/** How finely a design is sampled for the screen: as fine as the hand allows during a gesture, fine at rest. */

import type { Design } from "../document/types";
import { type GridSize, wavesOf } from "../document/waves";

/** Rows and columns are counted in these, so that the overlay's lines stand at the same places on every grid. */
const CELLS_UP = 12;
const CELLS_ROUND = 24;

interface Fineness {
  /** In cells: a grid has one row, and one column, more than these. */
  readonly up: number;
  readonly round: number;
  /** Columns that one wave needs to look round. */
  readonly perWave: number;
}

/** From the finest, which is that at rest, to the coarsest. */
const STEPS: readonly Fineness[] = [
  { up: 192, round: 336, perWave: 16 },
  { up: 144, round: 240, perWave: 12 },
  { up: 96, round: 168, perWave: 10 },
  { up: 72, round: 120, perWave: 8 },
  { up: 48, round: 96, perWave: 8 },
];

/** The index of the coarsest grid. */
export const COARSEST = STEPS.length - 1;

const MOST_ROUND = 1032;
/** All parts together: while one of them is dragged the others stay as fine as at rest, and are drawn again with every frame. */
const MAX_VERTICES = 600_000;

/** The grid of every part; `step` is from 0, as at rest, to {@link COARSEST}. */
export function gridFor(design: Design, step: number): GridSize {
  const { up, round, perWave } = STEPS[Math.min(step, COARSEST)] as Fineness;
  const wanted = Math.min(MOST_ROUND, Math.max(round, perWave * wavesOf(design)));
  const share = Math.min(1, Math.sqrt(MAX_VERTICES / (up * wanted * design.parts.length)));
  const whole = (cells: number, of: number) => Math.max(1, Math.floor((share * cells) / of)) * of + 1;
  return { rows: whole(up, CELLS_UP), columns: whole(wanted + CELLS_ROUND - 1, CELLS_ROUND) };
}

/** Thumbnails are small. */
export const THUMBNAIL_GRID: GridSize = { rows: 64, columns: 161 };
