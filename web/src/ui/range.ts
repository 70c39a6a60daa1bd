/** What a slider reaches. */

export interface Range {
  readonly low: number;
  readonly high: number;
}

const NICE = [1, 2, 5, 10];

/** The range, made wider where a number lies outside of it, up to the next 1, 2 or 5 times a power of ten; the same range where there is no need. */
export function reaching(range: Range, value: number): Range {
  if (!Number.isFinite(value) || (value >= range.low && value <= range.high)) return range;
  return value > range.high
    ? { ...range, high: value > 0 ? beyond(value) : 0 }
    : { ...range, low: value < 0 ? -beyond(-value) : 0 };
}

/** A range that was made wider than this many times is of no use for what is within the usual one. */
const WIDEST = 5;

/** The range, or the usual one where the number is within that and the range is far wider. */
export function usable(range: Range, usual: Range, value: number): Range {
  const isWithin = value >= usual.low && value <= usual.high;
  return isWithin && range.high - range.low > WIDEST * (usual.high - usual.low) ? usual : range;
}

function beyond(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const nice = NICE.find((step) => step * power >= size) ?? 10;
  const end = Number((nice * power).toPrecision(1));
  return Number.isFinite(end) && end >= size ? end : size;
}
