/** Regimes in words, and what the numbers of a formula are called and do. */

import { getPath, pathOf, pathText } from "../document/path";
import { familyOf, fieldValue } from "../document/schema";
import type { BoundaryValue, Shape } from "../document/types";
import type { Pair, Roots } from "../equation/roots";
import { listed } from "../language";
import { formatNumber } from "../number";
import { equation } from "./english/equation";
import { modes } from "./english/modes";
import { rings } from "./english/rings";
import { fieldWords } from "./parameters";

export function rootsWords(roots: Roots, digits: number): string {
  const number = (value: number) => formatNumber(value, digits);
  const words = equation.roots;
  switch (roots.kind) {
    case "single": {
      const { z, rate } = roots.pair;
      return z === 0 ? words.line : z > 0 ? words.real(number(rate)) : words.swing(number(rate));
    }
    case "double": {
      const { z, rate } = roots.pair;
      return z === 0 ? words.cubic : z > 0 ? words.doubleReal(number(rate)) : words.doubleSwing(number(rate));
    }
    case "complex":
      return words.complex(number(roots.sigma), number(roots.delta));
    case "two":
      return pairsWords(roots.pairs, number);
  }
}

function pairsWords(pairs: readonly [Pair, Pair], number: (value: number) => string): string {
  const words = equation.roots;
  const [one, other] = pairs[0].z >= pairs[1].z ? pairs : [pairs[1], pairs[0]];
  if (one.z > 0 && other.z > 0) return words.twoReal(number(one.rate), number(other.rate));
  if (one.z > 0 && other.z < 0) return words.realAndSwing(number(one.rate), number(other.rate));
  if (one.z > 0) return words.realAndNone(number(one.rate));
  if (one.z < 0) return words.twoSwings(number(one.rate), number(other.rate));
  return words.swingAndNone(number(other.rate));
}

/** What a number of a formula is: its name with its value and what it does, or the names of those that it is made of. */
export function numbersWords(shape: Shape, places: readonly string[]): string {
  const told = places.map((place) => numberWords(shape, place));
  const [first] = told;
  if (!first) return "";
  // The same numbers of x and of y say nothing twice.
  const names = [...new Set(told.map(({ name }) => name))];
  if (names.length > 1 && new Set(told.map(({ help }) => help)).size > 1) return equation.madeOf(listed(names));
  return equation.named(equation.valued(listed(names), formatNumber(first.value)), first.help);
}

interface NumberWords {
  readonly name: string;
  readonly value: number;
  readonly help: string;
}

function numberWords(shape: Shape, place: string): NumberWords {
  const family = familyOf(shape.kind);
  if (family) {
    const field = family.fields.find((each) => pathText(each.path) === place);
    if (!field) return { value: 0, name: place, help: "" };
    return { value: fieldValue(shape, field), ...fieldWords(family.kind, field.key) };
  }
  const found = getPath(shape, pathOf(place));
  const value = typeof found === "number" ? found : place === "a" ? 1 : 0;
  return { value, ...(shape.kind === "rings" ? ofRings(shape.rings.length, place) : ofModes(shape, place)) };
}

type Named = Omit<NumberWords, "value">;

function ofRings(count: number, place: string): Named {
  const { helps, names } = equation;
  const path = pathOf(place);
  if (place === "a") return { name: names.smoothing, help: helps.a };
  const [head, index] = path;
  const isSlope = head === "foot" || head === "rim";
  const [what, kind, wave, part] = path.slice(isSlope ? 1 : 2);
  const ring =
    index === 0 ? rings.foot : index === count - 1 ? rings.rim : rings.ring(typeof index === "number" ? index : 0);
  if (what === "u") return { name: rings.of(rings.place, ring), help: helps.u };
  const quantity = what === "z" ? rings.height : rings.radius;
  const where = isSlope ? names[`${head}Slope`](quantity) : rings.of(quantity, ring);
  if (kind === "mean")
    return { name: where, help: isSlope ? helps[head === "foot" ? "start_u" : "end_u"] : helps.mean };
  const number = typeof wave === "number" ? wave + 1 : 1;
  if (part === "n") return { name: names.frequency(number, where), help: helps.n };
  return { name: names.wave(number, where), help: part === "sin" ? helps.sin : helps.cos };
}

function ofModes(shape: Shape, place: string): Named {
  const { helps, names } = equation;
  const path = pathOf(place);
  if (place === "span") return { name: modes.span, help: helps.span };
  const [head] = path;
  if (head === "rings") return { name: names.ringPlace(Number(path[1]) + 1), help: helps.u };
  if (head !== "x" && head !== "y" && head !== "z") return { name: place, help: "" };
  const weight = path[1];
  if (weight === "s" || weight === "t" || weight === "w")
    return { name: modes.weightOf(weight, head), help: helps[weight] };
  const [, , mode, wave, datum, at] = path;
  const index = typeof mode === "number" ? mode : 0;
  if (wave === "n") return { name: modes.frequency(index + 1, head), help: helps.n };
  const n = formatNumber((shape as BoundaryValue)[head].modes[index]?.n ?? 0);
  const of = names.datum(wave === "sin" ? modes.sin : modes.cos, n, head);
  if (datum === "rings") return { name: names.ringValue(Number(at) + 1, of), help: helps.rings };
  if (datum === "force") return { name: names.force(of), help: helps.force };
  if (datum === "start" || datum === "end" || datum === "start_u" || datum === "end_u")
    return { name: modes.datumOf(modes.data[datum], wave === "sin" ? "sin" : "cos", n, head), help: helps[datum] };
  return { name: of, help: "" };
}
