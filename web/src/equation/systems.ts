/**
 * The functions that a mode of order 4 is written in. `C` starts like a cube at 0, `B = C'` and `A = B'` (each up to one factor, which goes out), so that what has value and slope 0 at the far end is made of `B` and `C` alone:
 * `H` has the value 1 and the slope 0 at the near end, `K` the value 0 and the slope 1. For roots that are all 0 they are the cubics of Hermite. Written so, no number is the difference of large ones, whatever the roots.
 */

import { type Amount, decided } from "./amount";
import type { Pair, Roots } from "./roots";
import { aligned, type Formula, type Hand, Writer } from "./writer";

export interface System {
  readonly index: number;
  readonly roots: Roots;
  /** What decides its roots. */
  readonly by: readonly Amount[];
}

/** What a mode of these roots is written in is told apart by; empty where it needs nothing. */
export function systemOf(roots: Roots, endsAlone: boolean): string {
  if (roots.order === 2 || (endsAlone && allZero(roots))) return "";
  switch (roots.kind) {
    case "double":
      return `double ${roots.pair.z}`;
    case "two":
      return `two ${roots.pairs.map(({ z }) => z).join(" ")}`;
    case "complex":
      return `complex ${roots.sigma} ${roots.delta}`;
  }
}

export function allZero(roots: Roots): boolean {
  return roots.kind === "double" && roots.pair.z === 0;
}

/** What all of them have in common, then each by itself. */
export function systemFormulas(systems: readonly System[], endsAlone: boolean, hand: Hand): Formula[] {
  if (systems.length === 0) return [];
  const common = systems.some(({ roots }) => !allZero(roots)) ? [new Writer(hand).formula(cardinal(endsAlone))] : [];
  return [...common, ...systems.map((each) => written(each, hand))];
}

function cardinal(endsAlone: boolean): string {
  const [x, h, rest] = endsAlone ? ["x", "1", "1-x"] : ["x,h", "h", "h-x"];
  const below = `B_{j}(${h})^{2}-A_{j}(${h})\\,C_{j}(${h})`;
  return aligned([
    `H_{j}(${x})&=\\frac{B_{j}(${h})\\,B_{j}(${rest})-A_{j}(${h})\\,C_{j}(${rest})}{${below}}`,
    `K_{j}(${x})&=\\frac{C_{j}(${h})\\,B_{j}(${rest})-B_{j}(${h})\\,C_{j}(${rest})}{${below}}`,
  ]);
}

function written({ index, roots, by }: System, hand: Hand): Formula {
  const writer = new Writer(hand);
  const rate = (value: number): Rate => ({
    text: () => writer.amount(decided(value, by)),
    squared: () => writer.power(decided(value, by), 2),
  });
  const [a, b, c] = abc(roots, rate, writer);
  if (a === undefined || b === undefined || c === undefined) {
    return writer.formula(
      aligned([
        `H_{${index}}(x,h)&=\\left(1-\\frac{x}{h}\\right)^{2}\\left(1+\\frac{2\\,x}{h}\\right)`,
        `K_{${index}}(x,h)&=x\\left(1-\\frac{x}{h}\\right)^{2}`,
      ]),
    );
  }
  return writer.formula(aligned([`A_{${index}}(y)&=${a}`, `B_{${index}}(y)&=${b}`, `C_{${index}}(y)&=${c}`]));
}

interface Rate {
  readonly text: () => string;
  readonly squared: () => string;
}

type Rates = (value: number) => Rate;

function abc(roots: Roots, rate: Rates, writer: Writer): string[] {
  if (roots.kind === "complex") {
    const [s, d] = [rate(roots.sigma), rate(roots.delta)];
    const by = (one: string, other: string) => `\\${one}(${s.text()}\\,y)\\,\\${other}(${d.text()}\\,y)`;
    return [
      `${s.text()}\\,${by("cosh", "sin")}+${d.text()}\\,${by("sinh", "cos")}`,
      by("sinh", "sin"),
      `\\frac{${s.text()}\\,${by("cosh", "sin")}-${d.text()}\\,${by("sinh", "cos")}}{${s.squared()}+${d.squared()}}`,
    ];
  }
  if (roots.kind === "two" && !looksDouble(roots.pairs, writer)) return apart(roots.pairs, rate);
  const pair = roots.kind === "two" ? roots.pairs[0] : roots.pair;
  if (pair.z === 0) return [];
  const r = rate(pair.rate);
  const [even, odd] = pair.z > 0 ? ["cosh", "sinh"] : ["cos", "sin"];
  const [cosine, sine] = [() => `\\${even}(${r.text()}\\,y)`, () => `\\${odd}(${r.text()}\\,y)`];
  const [one, other] = [() => `${r.text()}\\,y\\,${cosine()}`, sine];
  const difference = pair.z > 0 ? `${one()}-${other()}` : `${other()}-${one()}`;
  return [`${sine()}+${one()}`, `y\\,${sine()}`, `\\frac{${difference}}{${r.squared()}}`];
}

/** Roots that differ by less than is written are one root twice. */
function looksDouble([one, other]: readonly [Pair, Pair], writer: Writer): boolean {
  return Math.sign(one.z) === Math.sign(other.z) && writer.plain(one.rate) === writer.plain(other.rate);
}

function apart(pairs: readonly [Pair, Pair], rate: Rates): string[] {
  const [one, other] = pairs.map((pair) => functions(pair, rate));
  if (!one || !other) return [];
  const difference = (first: string, second: string) => {
    if (first === "") return second.startsWith("-") ? second.slice(1) : `-${second}`;
    if (second === "") return first;
    return second.startsWith("-") ? `${first}+${second.slice(1)}` : `${first}-${second}`;
  };
  return [
    difference(one.slope(), other.slope()),
    difference(one.value(), other.value()),
    difference(one.integral(), other.integral()),
  ];
}

/** `cosh(r y)` or what it is for such a pair, with its derivative and the integral from 0. */
function functions({ z, rate }: Pair, rates: Rates) {
  if (z === 0) return { slope: () => "", value: () => "1", integral: () => "y" };
  const r = rates(rate);
  const [even, odd] = z > 0 ? ["cosh", "sinh"] : ["cos", "sin"];
  return {
    slope: () => `${z > 0 ? "" : "-"}${r.text()}\\,\\${odd}(${r.text()}\\,y)`,
    value: () => `\\${even}(${r.text()}\\,y)`,
    integral: () => `\\frac{\\${odd}(${r.text()}\\,y)}{${r.text()}}`,
  };
}
