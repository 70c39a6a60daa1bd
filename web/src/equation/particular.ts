/** A polynomial that meets a force which is one, whatever is given at the ends. */

import type { Roots } from "./roots";

/** A solution of `q'' - b q = f`, or of `q'''' - b q'' + c q = f`, by ascending powers of `u`. */
export function particular({ order }: Roots, [b, c]: readonly [number, number], force: readonly number[]): number[] {
  if (order === 2) return b === 0 ? integrated(force, 2) : inverted(b, force);
  if (c === 0) return integrated(b === 0 ? force : inverted(b, force), b === 0 ? 4 : 2);
  const found: number[] = [];
  for (let m = force.length - 1; m >= 0; m -= 1) {
    const second = (m + 2) * (m + 1) * (found[m + 2] ?? 0);
    const fourth = (m + 4) * (m + 3) * (m + 2) * (m + 1) * (found[m + 4] ?? 0);
    found[m] = ((force[m] ?? 0) + b * second - fourth) / c;
  }
  return found;
}

/** Of `q'' - b q = f`. */
function inverted(b: number, force: readonly number[]): number[] {
  const found: number[] = [];
  for (let m = force.length - 1; m >= 0; m -= 1) {
    found[m] = ((m + 2) * (m + 1) * (found[m + 2] ?? 0) - (force[m] ?? 0)) / b;
  }
  return found;
}

function integrated(polynomial: readonly number[], times: number): number[] {
  let sum = [...polynomial];
  for (let n = 0; n < times; n += 1) sum = [0, ...sum.map((term, power) => term / (power + 1))];
  return sum;
}

/** A polynomial with its first two derivatives. */
export function polynomialAt(polynomial: readonly number[], u: number): readonly [number, number, number] {
  let [value, slope, bend] = [0, 0, 0];
  for (let power = polynomial.length - 1; power >= 0; power -= 1) {
    bend = bend * u + 2 * slope;
    slope = slope * u + value;
    value = value * u + (polynomial[power] ?? 0);
  }
  return [value, slope, bend];
}
