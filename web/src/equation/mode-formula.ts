/** One function of `u` in closed form, between the ends or from ring to ring. */

import { type Amount, decided, NOTHING, ONE } from "./amount";
import { isHeldAtEndsAlone, type Mode } from "./modes";
import { particular, polynomialAt } from "./particular";
import type { Problem } from "./problem";
import { coefficients, fastest, type Roots } from "./roots";
import { polynomialTerms } from "./series";
import { slopesOf } from "./slopes";
import { allZero } from "./systems";
import { aligned, type Formula, type Hand, type Term, Writer } from "./writer";

export interface Written {
  readonly formula: Formula;
  /** Whether it is left as a problem, because its closed form would take more digits than a number has. */
  readonly open: boolean;
}

/** Goes on in the next line. */
const NEXT = "\\\\&\\quad ";

/** So many digits more than the others have a few numbers, before the form is left open. */
const MOST_MORE = { 2: 8, 4: 5 } as const;

export function modeFormula(problem: Problem, mode: Mode, roots: Roots, system: number, hand: Hand): Written {
  const { component, harmonic, index, k } = mode;
  const equation = coefficients(component, k);
  const forced = harmonic.force.some(({ value }) => value !== 0);
  const force = forced ? harmonic.force.map(({ value }) => value / component.s.value) : [];
  const polynomial = particular(roots, equation, force);
  const more = moreDigits(mode, polynomial, force, fastest(roots));
  const writer = new Writer(more === 0 ? hand : { ...hand, digits: hand.digits + more });
  if (!(more <= MOST_MORE[component.order])) return { formula: posed(mode, equation, hand), open: true };
  const under = [...harmonic.force, component.s, component.t, component.w, harmonic.n];
  const beam: Held = {
    problem,
    mode,
    roots,
    system,
    places: [NOTHING, ...problem.rings.map(({ u }) => u), ONE],
    values: [],
    slopes: [],
    by: [component.s, component.t, component.w, harmonic.n],
  };
  const given = [harmonic.start, ...problem.rings.map((_, at) => harmonic.rings[at] ?? NOTHING), harmonic.end];
  const rest = (amount: Amount, taken: number) => (forced ? decided(amount.value - taken, [amount, ...under]) : amount);
  const values = given.map((amount, at) => rest(amount, polynomialAt(polynomial, beam.places[at]?.value ?? 0)[0]));
  const slopes = found(beam, given, polynomial, equation).map((pair) =>
    pair.map(({ at, slope }) => rest(slope, polynomialAt(polynomial, beam.places[at]?.value ?? 0)[1])),
  );
  const pieces = slopes.map((_, bay) => piece(writer, { ...beam, values, slopes }, bay));
  const sum = `P_{${index}}(u)`;
  const homogeneous = pieces.length === 1 ? (pieces[0] ?? "0") : cases(writer, beam, pieces);
  const name = `q_{${index}}(u)`;
  if (!forced) {
    const isLong = homogeneous.includes(NEXT);
    const tex = isLong ? aligned([`${name}&=${homogeneous}`]) : `${name}=${homogeneous}`;
    return { formula: writer.formula(tex), open: false };
  }
  const terms = polynomialTerms(polynomial.map((value) => decided(value, under)));
  const lines = [
    `${name}&=${sum}${NEXT}${homogeneous.startsWith("-") ? "" : "+"}${homogeneous}`,
    `${sum}&=${writer.sum(terms)}`,
  ];
  return { formula: writer.formula(aligned(lines)), open: false };
}

interface Held {
  readonly problem: Problem;
  readonly mode: Mode;
  readonly roots: Roots;
  readonly system: number;
  readonly places: readonly Amount[];
  readonly values: readonly Amount[];
  /** At both ends of each stretch. */
  readonly slopes: readonly (readonly Amount[])[];
  /** What decides the roots. */
  readonly by: readonly Amount[];
}

/** The slopes at both ends of each stretch, with the number of the place where each is: those given, and those that the rings decide. */
function found(
  { problem, mode, roots, places }: Held,
  values: readonly Amount[],
  polynomial: readonly number[],
  equation: readonly [number, number],
): { readonly at: number; readonly slope: Amount }[][] {
  const { component, harmonic } = mode;
  const last = places.length - 1;
  const decidedBy =
    roots.order === 4 && (last > 1 || component.free.start || component.free.end)
      ? slopesOf({
          roots,
          equation,
          places: places.map(({ value }) => value),
          values: values.map(({ value }) => value),
          corners: places.map((_, index) => index > 0 && index < last && problem.rings[index - 1]?.sharp === true),
          ends: [
            component.free.start ? null : harmonic.start_u.value,
            component.free.end ? null : harmonic.end_u.value,
          ],
          particular: polynomial,
        })
      : null;
  return places.slice(1).map((_, bay) => {
    const at = (end: 0 | 1): Amount => {
      if (bay + end === 0 && !component.free.start) return harmonic.start_u;
      if (bay + end === last && !component.free.end) return harmonic.end_u;
      return { value: decidedBy?.[bay]?.[end] ?? 0, at: [] };
    };
    return [
      { at: bay, slope: at(0) },
      { at: bay + 1, slope: at(1) },
    ];
  });
}

/** `beta - u` and `u - alpha`, and the length between. */
function lengths(writer: Writer, places: readonly Amount[], bay: number) {
  const [from, to] = [places[bay] ?? NOTHING, places[bay + 1] ?? ONE];
  return {
    behind: () => (bay === 0 ? "u" : `u-${writer.amount(from)}`),
    ahead: () => `${writer.amount(to)}-u`,
    length: () => writer.amount(bay === 0 ? to : decided(to.value - from.value, [from, to])),
    isWhole: bay === 0 && places.length === 2,
  };
}

function piece(writer: Writer, held: Held, bay: number): string {
  return held.roots.order === 2 ? ofSecond(writer, held, bay) : ofFourth(writer, held, bay);
}

function ofSecond(writer: Writer, { roots, places, values, by }: Held, bay: number): string {
  if (roots.kind !== "single") return "0";
  const { behind, ahead, length, isWhole } = lengths(writer, places, bay);
  const [start, end] = [values[bay] ?? NOTHING, values[bay + 1] ?? NOTHING];
  const { z, rate } = roots.pair;
  const terms = (of: (x: string) => string): Term[] => [
    ...(start.value === 0 ? [] : [{ amount: start, body: of(ahead()) }]),
    ...(end.value === 0 ? [] : [{ amount: end, body: of(behind()) }]),
  ];
  if (start.value === 0 && end.value === 0) return "0";
  if (z === 0) {
    const sum = writer.sum(terms((x) => (x === "u" ? x : `(${x})`)));
    return isWhole ? sum : `\\frac{${sum}}{${length()}}`;
  }
  const name = z > 0 ? "\\sinh" : "\\sin";
  const r = () => writer.amount(decided(rate, by));
  const below = () => `${name}(${r()}${isWhole ? "" : `\\cdot ${length()}`})`;
  const fractions = terms((x) => `${name}(${r()}\\,${x === "u" ? x : `(${x})`})`).map((term) => {
    const sign = term.amount.value < 0 ? "-" : "+";
    const above = writer.sum([{ ...term, amount: { ...term.amount, value: Math.abs(term.amount.value) } }]);
    return `${sign}\\frac{${above}}{${below()}}`;
  });
  // Two are wide: between the ends alone there is a line for each.
  return fractions.join(places.length === 2 ? NEXT : "").replace(/^\+/, "");
}

function ofFourth(writer: Writer, { problem, roots, system, places, values, slopes }: Held, bay: number): string {
  const { behind, ahead, length } = lengths(writer, places, bay);
  const [start, end] = [values[bay] ?? NOTHING, values[bay + 1] ?? NOTHING];
  const [start_u = NOTHING, end_u = NOTHING] = slopes[bay] ?? [];
  const endsAlone = isHeldAtEndsAlone(problem);
  const turned = { ...end_u, value: -end_u.value };
  if (endsAlone && allZero(roots)) {
    return writer.sum([
      { amount: start, body: "(1-u)^{2}(1+2u)" },
      { amount: start_u, body: "u(1-u)^{2}" },
      { amount: end, body: "u^{2}(3-2u)" },
      { amount: turned, body: "u^{2}(1-u)" },
    ]);
  }
  const of = (name: string, x: string) => `${name}_{${system}}(${x}${endsAlone ? "" : `,${length()}`})`;
  const near = (amount: Amount, name: string) => (amount.value === 0 ? [] : [{ amount, body: of(name, behind()) }]);
  const far = (amount: Amount, name: string) => (amount.value === 0 ? [] : [{ amount, body: of(name, ahead()) }]);
  const [begin, rest] = [
    [...near(start, "H"), ...near(start_u, "K")],
    [...far(end, "H"), ...far(turned, "K")],
  ];
  if (!endsAlone || begin.length === 0 || rest.length === 0) return writer.sum([...begin, ...rest]);
  const second = writer.sum(rest);
  return `${writer.sum(begin)}${NEXT}${second.startsWith("-") ? "" : "+"}${second}`;
}

/** One line for each stretch; of many the first. */
function cases(writer: Writer, { places }: Held, pieces: readonly string[]): string {
  const shown = pieces.slice(0, writer.hand.most);
  const lines = shown.map((text, bay) => {
    const [from, to] = [places[bay] ?? NOTHING, places[bay + 1] ?? ONE];
    return `${text}&${writer.amount(from)}\\le u\\le ${writer.amount(to)}`;
  });
  if (shown.length < pieces.length) lines.push("\\vdots&");
  return `\\begin{cases}${lines.join("\\\\")}\\end{cases}`;
}

/** How many digits more the numbers of a mode under a force need: those by which the polynomial outgrows what it stands for, and those by which slow functions answer to their rates. */
function moreDigits(
  { component, harmonic }: Mode,
  polynomial: readonly number[],
  force: readonly number[],
  rate: number,
): number {
  if (force.length === 0 || rate === 0) return 0;
  const size = (numbers: readonly number[]) => numbers.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const { start, end, start_u, end_u, rings } = harmonic;
  const given = size([start, end, start_u, end_u, ...rings].map(({ value }) => value));
  const grown = size(polynomial) / Math.max(given, size(force) / Math.max(1, rate ** 2), Number.MIN_VALUE);
  const lost = rate < 1 ? -2 * Math.log10(rate) : 0;
  // Of second order the rates count for less: what is off is of the size of their square.
  const slow = component.order === 4 ? lost : Math.min(2, lost);
  return Math.max(0, Math.ceil(Math.log10(Math.max(grown, 1)) + slow));
}

/** The problem itself. */
function posed({ index, harmonic, component }: Mode, [b, c]: readonly [number, number], hand: Hand): Formula {
  const writer = new Writer(hand);
  const by = [component.s, component.t, component.w, harmonic.n];
  const q = (mark: string) => ({ ...decided(1, []), mark: `q_{${index}}${mark}` });
  const terms: Term[] =
    component.order === 2
      ? [{ amount: decided(-b, by), body: q("").mark }]
      : [
          { amount: decided(-b, by), body: q("''").mark },
          { amount: decided(c, by), body: q("").mark },
        ];
  const highest = q(component.order === 2 ? "''" : "''''").mark;
  const left = writer.sum(terms);
  const force = harmonic.force.map((amount) => decided(amount.value / component.s.value, [amount, component.s]));
  const shown = polynomialTerms(force).filter(({ amount }) => amount.value !== 0);
  const { most } = hand;
  const right = writer.sum(shown.slice(0, most), shown.length > most);
  return writer.formula(`${highest}${left === "0" ? "" : left.startsWith("-") ? left : `+${left}`}=${right}`);
}
