/** What is said of a file before it is saved. */

import { MOST_SHRINKAGE, type Problem, scaleOf } from "../document/saving";
import type { Format, Making, Measures, Unit } from "../document/types";
import { formatNumber } from "../number";
import { exporting } from "./english/export";
import { quantities } from "./english/quantities";
import { lengthWords } from "./quantities";

/** Whether a file that is dropped on the page opens the design again. */
export function opensAgain(format: Format): string {
  return format === "stl" ? exporting.stlOpens : exporting.opensAgain;
}

export function problemWords({ code }: Problem): string {
  return exporting.problems[code](formatNumber(MOST_SHRINKAGE));
}

/** What is said of the size before saving. */
export interface Sizes {
  /** The file, in millimetres. */
  readonly file: string;
  /** The finished pot, where that is another size. */
  readonly fired: string | null;
  /** What was applied; empty when nothing was. */
  readonly applied: string;
}

export function sizesOf(making: Making, measures: Measures, unit: Unit): Sizes {
  const { size, shrinkage, millimetres } = scaleOf(making, measures, unit);
  const factor = formatNumber(size, 4);
  const applied = [
    ...(size === 1 || factor === formatNumber(1) ? [] : [exporting.scaledBy(factor)]),
    ...(shrinkage > 1 ? [exporting.larger(quantities.percent(formatNumber(100 * (shrinkage - 1), 3)))] : []),
  ];
  return {
    file: sizeWords(measures, millimetres),
    fired: shrinkage > 1 ? sizeWords(measures, millimetres / shrinkage) : null,
    applied: exporting.applied(applied),
  };
}

/** "84 mm wide, 120 mm high" */
function sizeWords({ height, width }: Measures, scale: number): string {
  return exporting.size(lengthWords(width.greatest.value * scale, "mm"), lengthWords(height.value * scale, "mm"));
}
