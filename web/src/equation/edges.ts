/** What is given at the ends of a shape and at its rings. */

import { AXES } from "../document/boundary-value";
import { type Amount, NOTHING, ONE } from "./amount";
import type { Harmonic, Hoop, Problem } from "./problem";
import { round, waves } from "./series";
import { aligned, type Formula, type Hand, Writer } from "./writer";

/** A curve on which something is given. */
export interface Edge {
  /** `u = 0`, `u = 1`, or a ring by its number from 0. */
  readonly place: "start" | "end" | number;
  readonly u: Amount;
  /** Whether the surface has a corner there. */
  readonly sharp: boolean;
  readonly formula: Formula;
}

/** From `u = 0` to `u = 1`. Of many rings the first, and both ends. */
export function edges(problem: Problem, hand: Hand): Edge[] {
  const { hoops, rings } = problem;
  if (hoops) {
    const last = hoops.list.length - 1;
    return hoops.list
      .map((hoop, index) => potted(problem, hoop, index, hand))
      .filter((_, index) => index === last || index <= hand.most);
  }
  return [
    { place: "start", u: NOTHING, sharp: false, formula: atEnd(problem, "start", hand) },
    ...rings
      .slice(0, hand.most)
      .map(({ u, sharp }, index) => ({ place: index, u, sharp, formula: atRing(problem, index, hand) })),
    { place: "end", u: ONE, sharp: false, formula: atEnd(problem, "end", hand) },
  ];
}

/** As radius and height, as a potter says it. */
function potted({ hoops }: Problem, hoop: Hoop, index: number, hand: Hand): Edge {
  const writer = new Writer(hand);
  const isEnd = index === 0 ? "start" : index + 1 === hoops?.list.length ? "end" : null;
  const u = isEnd ? writer.plain(hoop.u.value) : writer.amount(hoop.u);
  const lines = [`r(${u},v)&=${round(writer, hoop.r)}`, `z(${u},v)&=${round(writer, hoop.z)}`];
  const slopes = isEnd === "start" ? hoops?.foot : hoops?.rim;
  if (isEnd && slopes) {
    lines.push(`r_{u}(${u},v)&=${round(writer, slopes.r)}`, `z_{u}(${u},v)&=${round(writer, slopes.z)}`);
  } else if (isEnd) {
    lines.push(`\\mathbf{X}_{uu}(${u},v)&=0`);
  } else if (hoop.sharp) {
    lines.push(`\\mathbf{X}_{uu}(${u},v)&=0`);
  }
  return { place: isEnd ?? index - 1, u: hoop.u, sharp: hoop.sharp, formula: writer.formula(aligned(lines)) };
}

function atEnd({ components, span }: Problem, end: "start" | "end", hand: Hand): Formula {
  const writer = new Writer(hand);
  const u = end === "start" ? "0" : "1";
  const lines: string[] = [];
  for (const axis of AXES) {
    const { order, free, harmonics } = components[axis];
    const given = (name: string, of: (harmonic: Harmonic) => Amount) => {
      const left = `${name}(${u},v)`;
      const numbers = waves(writer, harmonics, span, of);
      const hasNames = harmonics.some((harmonic) => of(harmonic).name !== undefined);
      if (!hasNames) {
        lines.push(`${left}&=${numbers}`);
        return;
      }
      lines.push(`${left}&=${writer.symbols(() => waves(writer, harmonics, span, of))}`, `&=${numbers}`);
    };
    given(axis, (harmonic) => harmonic[end]);
    if (order === 2) continue;
    if (free[end]) lines.push(`${axis}_{uu}(${u},v)&=0`);
    else given(`${axis}_{u}`, (harmonic) => harmonic[`${end}_u`]);
  }
  return writer.formula(aligned(lines));
}

function atRing({ components, rings, span }: Problem, index: number, hand: Hand): Formula {
  const writer = new Writer(hand);
  const ring = rings[index];
  const u = ring ? writer.amount(ring.u) : "";
  const lines = AXES.flatMap((axis) => {
    const { order, harmonics } = components[axis];
    const value = `${axis}(${u},v)&=${waves(writer, harmonics, span, ({ rings: values }) => values[index] ?? NOTHING)}`;
    return ring?.sharp && order === 4 ? [value, `${axis}_{uu}(${u},v)&=0`] : [value];
  });
  return writer.formula(aligned(lines));
}
