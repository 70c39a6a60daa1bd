/** The problem that a pot of rings stands for: `x = r cos v`, `y = r sin v`, with products of waves written as sums. */

import type { Path } from "../document/path";
import type { Rings, Series } from "../document/types";
import { type Amount, added, amountAt, decided, NOTHING, ONE, scaled } from "./amount";
import { smoothed } from "./families";
import type { Ends, Harmonic, Hoop, Problem, Round } from "./problem";

type Wave = Harmonic["wave"];

/** What a curve is to a wave: the first ring and the last are the ends. */
type Curve = number | "foot" | "rim";

export function hoops(shape: Rings): Problem {
  const a: Amount = amountAt(["a"], shape.a ?? 1, "a");
  const list = shape.rings.map(
    (hoop, index): Hoop => ({
      u: amountAt(["rings", index, "u"], hoop.u),
      sharp: hoop.sharp ?? false,
      r: round(["rings", index, "r"], hoop.r),
      z: round(["rings", index, "z"], hoop.z),
    }),
  );
  const ends = (name: "foot" | "rim"): Ends | null => {
    const given = shape[name];
    return given ? { r: round([name, "r"], given.r), z: round([name, "z"], given.z) } : null;
  };
  const [foot, rim] = [ends("foot"), ends("rim")];
  const [x, y, z] = [new Waves(list.length), new Waves(list.length), new Waves(list.length)];
  const curves: readonly (readonly [Curve, Ends])[] = [
    ...list.map((hoop, index) => [index, hoop] as const),
    ...(foot ? [["foot", foot] as const] : []),
    ...(rim ? [["rim", rim] as const] : []),
  ];
  for (const [curve, { r, z: height }] of curves) {
    turn(x, y, curve, r);
    z.add(NOTHING, "cos", curve, height.mean);
    for (const { n, cos, sin } of height.waves) {
      z.add(n, "cos", curve, cos);
      z.add(n, "sin", curve, sin);
    }
  }
  const isFree = { start: foot === null, end: rim === null };
  return {
    span: "turn",
    rings: list.slice(1, -1).map(({ u, sharp }) => ({ u, sharp })),
    components: {
      x: smoothed(a, x.harmonics(), isFree),
      y: smoothed(a, y.harmonics(), isFree),
      z: smoothed(a, z.harmonics(), isFree),
    },
    smoothing: a,
    hoops: { list, foot, rim },
  };
}

function round(path: Path, { mean, waves = [] }: Series): Round {
  return {
    mean: amountAt([...path, "mean"], mean),
    waves: waves.map(({ n, cos, sin }, index) => ({
      n: amountAt([...path, "waves", index, "n"], n),
      cos: cos === undefined ? NOTHING : amountAt([...path, "waves", index, "cos"], cos),
      sin: sin === undefined ? NOTHING : amountAt([...path, "waves", index, "sin"], sin),
    })),
  };
}

function turn(x: Waves, y: Waves, curve: Curve, r: Round): void {
  x.add(ONE, "cos", curve, r.mean);
  y.add(ONE, "sin", curve, r.mean);
  for (const { n, cos, sin } of r.waves) {
    const [above, below] = [decided(n.value + 1, [n]), decided(n.value - 1, [n])];
    const [half, other] = [scaled(cos, 0.5), scaled(sin, 0.5)];
    // cos nv cos v, and sin nv cos v.
    x.add(above, "cos", curve, half);
    x.add(below, "cos", curve, half);
    x.add(above, "sin", curve, other);
    x.add(below, "sin", curve, other);
    // cos nv sin v, and sin nv sin v.
    y.add(above, "sin", curve, half);
    y.add(below, "sin", curve, scaled(half, -1));
    y.add(below, "cos", curve, other);
    y.add(above, "cos", curve, scaled(other, -1));
  }
}

/** The harmonics of one coordinate while they are gathered from the curves. */
class Waves {
  readonly #curves: number;
  readonly #all = new Map<string, { n: Amount; readonly wave: Wave; readonly data: Map<Curve, Amount> }>();

  constructor(curves: number) {
    this.#curves = curves;
  }

  add(n: Amount, wave: Wave, curve: Curve, amount: Amount): void {
    // sin(0 v) is 0.
    if (amount.value === 0 || (n.value === 0 && wave === "sin")) return;
    const key = `${n.value} ${wave}`;
    const found = this.#all.get(key) ?? { n, wave, data: new Map<Curve, Amount>() };
    found.n = decided(n.value, [found.n, n]);
    const before = found.data.get(curve);
    found.data.set(curve, before ? added(before, amount) : amount);
    this.#all.set(key, found);
  }

  /** By frequency, the cosine of each first. */
  harmonics(): Harmonic[] {
    const last = this.#curves - 1;
    const sorted = [...this.#all.values()].sort((one, other) =>
      one.n.value === other.n.value ? (one.wave < other.wave ? -1 : 1) : one.n.value - other.n.value,
    );
    return sorted.map(({ n, wave, data }) => {
      const of = (curve: Curve) => data.get(curve) ?? NOTHING;
      const rings = Array.from({ length: Math.max(0, last - 1) }, (_, index) => of(index + 1));
      return { n, wave, start: of(0), end: of(last), start_u: of("foot"), end_u: of("rim"), rings, force: [] };
    });
  }
}
