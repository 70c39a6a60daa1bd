// Numbers to reckon with: doubles, and fixed-point numbers with so many binary digits behind the point, for formulas whose terms are larger than what is left of them by more than a double can tell.

export interface Arithmetic<T> {
  /** From decimals. */
  of(text: string): T;
  from(value: number): T;
  to(value: T): number;
  readonly pi: T;
  add(one: T, other: T): T;
  multiply(one: T, other: T): T;
  divide(one: T, other: T): T;
  readonly functions: Readonly<Record<"sin" | "cos" | "sinh" | "cosh", (x: T) => T>>;
}

export const DOUBLES: Arithmetic<number> = {
  of: Number,
  from: (value) => value,
  to: (value) => value,
  pi: Math.PI,
  add: (one, other) => one + other,
  multiply: (one, other) => one * other,
  divide: (one, other) => one / other,
  functions: { sin: Math.sin, cos: Math.cos, sinh: Math.sinh, cosh: Math.cosh },
};

/** Numbers with `digits` binary digits behind the point and as many as it takes before it. */
export function fixed(digits: number): Arithmetic<bigint> {
  const point = BigInt(digits);
  const one = 1n << point;
  const multiply = (a: bigint, b: bigint) => (a * b) >> point;
  const divide = (a: bigint, b: bigint) => (a << point) / b;
  /** The sum of `x^n / n!` with every `step`-th `n` from `first` on, its signs in turn where `turns`. */
  const series = (x: bigint, first: number, step: number, turns: boolean) => {
    let term = first === 0 ? one : x;
    let sum = 0n;
    for (let n = first, sign = 1n; term !== 0n && term !== -1n; n += step, sign = turns ? -sign : sign) {
      sum += sign * term;
      for (let k = 1; k <= step; k += 1) term = multiply(term, x) / BigInt(n + k);
    }
    return sum;
  };
  const exponential = (x: bigint) => {
    // Halved until the series is short, then squared as often.
    const halvings = Math.max(0, (x < 0n ? -x : x).toString(2).length - digits + 6);
    let power = series(x >> BigInt(halvings), 0, 1, false);
    for (let n = 0; n < halvings; n += 1) power = multiply(power, power);
    return power;
  };
  const hyperbolic = (x: bigint, sign: bigint) => {
    const power = exponential(x < 0n ? -x : x);
    const value = (power + sign * divide(one, power)) / 2n;
    return x < 0n && sign < 0n ? -value : value;
  };
  /** Machin's formula. */
  const inverse = (of: bigint) => {
    let [sum, term] = [0n, one / of];
    for (let n = 1n, sign = 1n; term !== 0n; n += 2n, sign = -sign, term /= of * of) sum += (sign * term) / n;
    return sum;
  };
  const of = (text: string) => {
    const [whole = "0", part = ""] = text.split(".");
    return (BigInt(whole + part) << point) / 10n ** BigInt(part.length);
  };
  return {
    of,
    from: (value) => (value < 0 ? -1n : 1n) * of(Math.abs(value).toFixed(40)),
    to: (value) => Number((value << 80n) >> point) / 2 ** 80,
    pi: 4n * (4n * inverse(5n) - inverse(239n)),
    add: (a, b) => a + b,
    multiply,
    divide,
    functions: {
      sin: (x) => series(x, 1, 2, true),
      cos: (x) => series(x, 0, 2, true),
      sinh: (x) => hyperbolic(x, -1n),
      cosh: (x) => hyperbolic(x, 1n),
    },
  };
}
