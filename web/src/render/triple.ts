/** A point or a direction in model or scene space. */
export type Triple = readonly [number, number, number];

/** Reads a number that is known to be there: the callers' loops stay within the array. */
export function at(values: ArrayLike<number>, index: number): number {
  return values[index] as number;
}

export function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** `a + s b` */
export function along(a: Triple, b: Triple, s: number): Triple {
  return [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
}

export function distance(a: Triple, b: Triple): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
