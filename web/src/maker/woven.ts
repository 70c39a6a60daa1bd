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
  /** The largest distance between points at the same parameters, before placement: to a thousandth of it. */
  readonly distance: number;
}

/** Round a circle, for each wave, and at most where nobody says how many. */
const [ROUND, WAVE, MOST] = [12, 4, 120];

/** Where along each way of a patch both are compared at first: on its edges, and a fifth from an end, where a curve is furthest from one through its middle. */
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

/** A place of the network: patch, `u`, `v`; and how far it is from the form there. */
interface Gap {
  readonly at: Triple;
  readonly distance: number;
}

/** Once all patches were looked at, those that may have the largest distance are looked at again: as far as this share of the largest so far, and so many at most. */
const [SHARE, AGAIN] = [0.6, 64];
/** How far to each side of where it is largest so far, and in how many steps; at first all of the patch. */
const CLOSER = [
  [0.5, 24],
  [1 / 24, 8],
  [1 / 96, 8],
] as const;

function apart(
  { design, part, rows, columns, span }: Omit<WovenAsk, "kind" | "columns"> & { readonly columns: number },
  shape: Network,
): number {
  const woven = { pasu: 1, parts: [{ shape }] } as unknown as Sent;
  /** Of each list of places the one with the largest distance; all at once, because whatever is asked of is solved anew. */
  const largest = (lists: readonly (readonly Triple[])[]): Gap[] => {
    const places = lists.flat();
    const own = places.flatMap(([patch, u, v]) => {
      const [row, column] = [Math.floor(patch / columns), patch % columns];
      return [(row + v) / rows, (span * (column + u)) / columns];
    });
    const [form, network] = [evaluate(design as Sent, part, own), evaluate(woven, 0, places.flat())];
    let index = 0;
    return lists.map((list) => {
      let most: Gap = { at: list[0] ?? [0, 0, 0], distance: 0 };
      for (const at of list) {
        const gap = [0, 1, 2].map((axis) => (form[3 * index + axis] ?? 0) - (network[3 * index + axis] ?? 0));
        const distance = Math.hypot(...gap);
        if (distance > most.distance) most = { at, distance };
        index += 1;
      }
      return most;
    });
  };
  const crossed = (patch: number, us: readonly number[], vs: readonly number[]) =>
    us.flatMap((u) => vs.map((v): Triple => [patch, u, v]));
  const patches = Array.from({ length: rows * columns }, (_, patch) => crossed(patch, COMPARED, COMPARED));
  const all = largest(patches).sort((one, other) => other.distance - one.distance);
  const least = SHARE * (all[0]?.distance ?? 0);
  let near = all.filter(({ distance }) => distance >= least).slice(0, AGAIN);
  for (const [half, steps] of CLOSER) {
    const along = (middle: number) =>
      Array.from({ length: steps + 1 }, (_, step) =>
        Math.min(Math.max(middle + half * ((2 * step) / steps - 1), 0), 1),
      );
    const found = largest(
      near.map(({ at: [patch, u, v] }) =>
        half === 0.5 ? crossed(patch, along(0.5), along(0.5)) : crossed(patch, along(u), along(v)),
      ),
    );
    near = found.map((each, place) => {
      const known = near[place] as Gap;
      return each.distance > known.distance ? each : known;
    });
  }
  return Math.max(0, ...near.map(({ distance }) => distance));
}
