// How a script under vitest hands over what it measured: a line of JSON for each group, in a file that `cargo xtask bench` names.

import { appendFileSync } from "node:fs";

/** Contenders that took turns. */
export interface Group {
  /** Where it was measured, if not in Chromium. */
  readonly runner?: "Node";
  /** What the group is called. */
  readonly group: string;
  /** What the samples are. */
  readonly unit: "ns per vertex" | "us" | "ms" | "frames";
  /** Whether it is the slow turns that matter: the 95th of a hundred is then shown in place of the slowest. */
  readonly tail?: boolean;
  readonly rows: readonly Row[];
}

/** One contender, or one part of what was timed. */
export interface Row {
  readonly name: string;
  /** One number for each turn. */
  readonly samples: readonly number[];
  /** Another row of the group; the ratio of the two is taken within each turn, so both have as many samples. */
  readonly against?: string;
  /** The targets of that ratio. */
  readonly at_least?: number;
  readonly at_most?: number;
  /** The target of the median of the samples. */
  readonly median_at_most?: number;
  /** Printed below the table. */
  readonly note?: string;
}

/** Whether a few turns are enough. */
export const QUICK = process.env.PASU_BENCH_QUICK !== undefined;

/** Hands over a group. Run by hand, a script shows it instead. */
export function record(group: Group): void {
  const line = JSON.stringify({ runner: "Chromium", ...group });
  const file = process.env.PASU_BENCH_ROWS;
  if (file === undefined) console.warn(line);
  else appendFileSync(file, `${line}\n`);
}
