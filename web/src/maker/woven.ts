/** A form as a network of patches through points of it, and how far both are apart at the same parameters. */

import { evaluate } from "pasu";
import type { Network } from "../document/network/network";
import { Weaving } from "../document/network/weaving";
import type { Design, Sent, Triple } from "../document/types";
import { highestFrequency } from "../document/waves";

export interface WovenAsk {
  readonly kind: "woven";
  readonly design: Design;
  readonly part: number;
  /** Patches from end to end, and round. */
  readonly rows: number;
  /** Null for as many as its waves take. */
  readonly columns: number | null;
  /** How far `v` goes. */
  readonly span: number;
}

export interface WovenShape {
  readonly shape: Network;
  readonly columns: number;
  /** The largest distance between points at the same parameters, of all that were compared, before placement. */
  readonly distance: number;
}

/** Round a circle, for each wave, and at most where nobody says how many. */
const [ROUND, WAVE, MOST] = [12, 4, 120];

/** Where along each way of a patch both are compared: on its edges, and a fifth from an end, where a curve is furthest from one through its middle. */
const COMPARED = [0, 0.1, 0.21, 0.36, 0.64, 0.79, 0.9, 1];

export function wovenOf({ design, part, rows, columns: wanted, span }: WovenAsk): WovenShape {
  const form = design.parts[part]?.shape;
  const columns = wanted ?? Math.min(Math.max(ROUND, WAVE * Math.ceil(form ? highestFrequency(form) : 1)), MOST);
  const at: number[] = [];
  for (let row = 0; row <= 2 * rows; row += 1) {
    for (let column = 0; column <= 2 * columns; column += 1) at.push(row / (2 * rows), (span * column) / (2 * columns));
  }
  const found = evaluate(design as Sent, part, at);
  const size = found.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1;
  const digits = Math.min(Math.max(6 - Math.ceil(Math.log10(size)), 0), 12);
  const point = (row: number, column: number): Triple => {
    const place = 3 * (row * (2 * columns + 1) + column);
    return [0, 1, 2].map((axis) => Number((found[place + axis] ?? 0).toFixed(digits)) + 0) as unknown as Triple;
  };
  const weaving = new Weaving(digits);
  for (let row = 0; row < 2 * rows; row += 2) {
    for (let column = 0; column < 2 * columns; column += 2) {
      const corner = (up: number, right: number) => point(row + up, column + right);
      weaving.patch([
        corner(0, 0),
        corner(0, 1),
        corner(0, 2),
        corner(1, 2),
        corner(2, 2),
        corner(2, 1),
        corner(2, 0),
        corner(1, 0),
      ]);
    }
  }
  const shape = weaving.network();
  return { shape, columns, distance: apart({ design, part, rows, columns, span }, shape) };
}

function apart(
  { design, part, rows, columns, span }: Omit<WovenAsk, "kind" | "columns"> & { readonly columns: number },
  shape: Network,
): number {
  const [own, there]: [number[], number[]] = [[], []];
  for (let patch = 0; patch < rows * columns; patch += 1) {
    const [row, column] = [Math.floor(patch / columns), patch % columns];
    for (const u of COMPARED) {
      for (const v of COMPARED) {
        there.push(patch, u, v);
        own.push((row + v) / rows, (span * (column + u)) / columns);
      }
    }
  }
  const [form, network] = [
    evaluate(design as Sent, part, own),
    evaluate({ pasu: 1, parts: [{ shape }] } as unknown as Sent, 0, there),
  ];
  let most = 0;
  for (let place = 0; place < form.length; place += 3) {
    const gap = [0, 1, 2].map((axis) => (form[place + axis] ?? 0) - (network[place + axis] ?? 0));
    most = Math.max(most, Math.hypot(...gap));
  }
  return most;
}
