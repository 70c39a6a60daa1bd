/** The problems that the named families stand for (ZY01 equations 1 to 17, IA equations 15 to 18), in the papers' symbols. */

import { numberAt, type Path } from "../document/path";
import type { BloorWilson, FourthOrder, MixedOrder, SecondOrder, Shape } from "../document/types";
import { type Amount, added, amountAt, decided, NOTHING, ONE } from "./amount";
import { type Component, type Harmonic, type Problem, SILENT } from "./problem";

const CLAMPED = { start: false, end: false };
const NO_W = { w: NOTHING, free: CLAMPED };

/** Numbers of a family by their place and their symbol. */
function reader(shape: Shape): (path: Path, name: string) => Amount {
  return (path, name) => amountAt(path, numberAt(shape, path, Number.NaN), name);
}

/** Equations 1 to 8, and 9 to 12 where the height is of fourth order. The rim is at `u = 0`. */
export function planar(shape: SecondOrder | MixedOrder): Problem {
  const number = reader(shape);
  const radius = (index: number) => number(["r", index], `r_{${index + 1}}`);
  const [turns, waves] = [number(["n", 0], "n_{1}"), number(["n", 1], "n_{2}")];
  const square = (2 * Math.PI * turns.value) ** 2;
  const push = (index: number) => {
    const force = number(["force", index], `p_{${index}}`);
    return decided(square * force.value, [force, turns], `\\left(2\\pi n_{1}\\right)^{2} p_{${index}}`);
  };
  const force = [push(0), push(1)];
  const wall = (index: number, axis: "x" | "y", wave: "cos" | "sin"): Component => ({
    ...NO_W,
    order: 2,
    s: number(["s", index], `s_{${axis}}`),
    t: number(["t", index], `t_{${axis}}`),
    harmonics: [
      { ...SILENT, n: turns, wave, start: radius(0), end: radius(2), force },
      { ...SILENT, n: waves, wave, start: radius(1), end: radius(3) },
    ],
  });
  const height: Harmonic = { ...SILENT, n: NOTHING, wave: "cos", start: number(["height"], "h_{0}") };
  const straight: Component = { ...NO_W, order: 2, s: ONE, t: ONE, harmonics: [height] };
  const risen: Component = {
    ...straight,
    order: 4,
    w: ONE,
    harmonics: [{ ...height, start_u: number(["rise"], "h_{0}'") }],
  };
  return {
    span: "one",
    rings: [],
    components: {
      x: wall(0, "x", "cos"),
      y: wall(1, "y", "sin"),
      z: shape.kind === "mixed-order" ? risen : straight,
    },
    smoothing: null,
    hoops: null,
  };
}

/** Equations 13 to 17. The foot is at `u = 0`. */
export function fourthOrder(shape: FourthOrder): Problem {
  const number = reader(shape);
  const [r0, r1, rm] = [number(["r0"], "r_{0}"), number(["r1"], "r_{1}"), number(["rm"], "r_{m}")];
  const swell = 4 * rm.value - r1.value - 3 * r0.value;
  const lean = (index: number) => {
    const eta = number(["eta", index], `\\eta_{${index + 1}}`);
    const name = `${eta.name}\\left(4 r_{m} - r_{1} - 3 r_{0}\\right)`;
    return decided(eta.value * swell, [eta, rm, r1, r0], name);
  };
  const wall = (index: number, axis: "x" | "y", wave: "cos" | "sin"): Component => ({
    order: 4,
    s: number(["s", index], `s_{${axis}}`),
    t: number(["t", index], `t_{${axis}}`),
    w: number(["w", index], `w_{${axis}}`),
    free: CLAMPED,
    harmonics: [{ ...SILENT, n: ONE, wave, start: r0, end: r1, start_u: lean(0), end_u: lean(1) }],
  });
  const height: Harmonic = {
    ...SILENT,
    n: NOTHING,
    wave: "cos",
    end: number(["h1"], "h_{1}"),
    start_u: number(["dz", 0], "h_{0}'"),
    end_u: number(["dz", 1], "h_{1}'"),
  };
  return {
    span: "turn",
    rings: [],
    components: {
      x: wall(0, "x", "cos"),
      y: wall(1, "y", "sin"),
      z: { order: 4, s: ONE, t: ONE, w: ONE, free: CLAMPED, harmonics: [height] },
    },
    smoothing: null,
    hoops: null,
  };
}

/** Of `(d2/du2 + a^2 d2/dv2)^2 X = 0`. */
export function smoothed(
  a: Amount,
  harmonics: readonly Harmonic[],
  { start, end }: Component["free"] = CLAMPED,
): Component {
  const square = a.value * a.value;
  return {
    order: 4,
    s: ONE,
    t: decided(2 * square, [a]),
    w: decided(square * square, [a]),
    free: { start, end },
    harmonics,
  };
}

/** IA equations 15 to 18. The rim is at `u = 0`. */
export function bloorWilson(shape: BloorWilson): Problem {
  const number = reader(shape);
  const a = number(["a"], "a");
  const value = (index: number) => number(["r", index], `r_{${index + 1}}`);
  const slope = (index: number) => number(["R", index], `R_{${index + 1}}`);
  const both = (one: Amount, other: Amount) => ({ ...added(one, other), name: `${one.name} + ${other.name}` });
  const round = { ...SILENT, n: ONE, start: value(0), start_u: slope(0), end: value(3), end_u: slope(3) };
  const skew = { ...SILENT, n: ONE, start: both(value(1), value(2)), start_u: both(slope(1), slope(2)) };
  const height = (index: number) => ({
    ...SILENT,
    start: number(["h", index], `h_{${index}}`),
    start_u: number(["H", index], `H_{${index}}`),
  });
  return {
    span: "turn",
    rings: [],
    components: {
      x: smoothed(a, [
        { ...round, wave: "cos" },
        { ...skew, wave: "sin" },
      ]),
      y: smoothed(a, [
        { ...skew, wave: "cos" },
        { ...round, wave: "sin" },
      ]),
      z: smoothed(a, [
        { ...height(0), n: NOTHING, wave: "cos" },
        { ...height(1), n: number(["n1"], "n_{1}"), wave: "sin" },
      ]),
    },
    smoothing: a,
    hoops: null,
  };
}
