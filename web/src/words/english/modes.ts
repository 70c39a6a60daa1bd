/** Free boundary data. `x`, `y`, `z`, `n`, `s`, `t`, `u`, `v` and `w` are those of the equations. */

import type { Axis, DatumName } from "../../document/boundary-value";
import { phrases, plural } from "../../language";

export const modes = phrases("modes", {
  lead: "Free boundary data.",
  waves: "Each direction is a sum of waves round the pot: frequency n, with its values at both edges.",
  wavesAndSlopes:
    "Each direction is a sum of waves round the pot: frequency n, with its values at both edges and, for order 4, its slopes.",
  rings: (count: number) =>
    plural(count, {
      one: "It passes through 1 ring between the edges: the card above.",
      other: `It passes through ${count} rings between the edges: the cards above.`,
    }),
  span: "Length of v",
  spanNumber: "Length of v, number",
  aNumber: "A number",
  axes: { x: "x, to the right", y: "y, to the back", z: "z, upwards" } satisfies Readonly<Record<Axis, string>>,
  summary: (order: number, count: number) =>
    plural(count, { one: `order ${order}, ${count} mode`, other: `order ${order}, ${count} modes` }),
  order: "Order",
  orderOf: (axis: Axis) => `Order of ${axis}`,
  weightOf: (weight: string, axis: Axis) => `${weight} of ${axis}`,
  showMore: (count: number, hidden: number) => `Show ${count} more of ${hidden}`,
  add: (axis: Axis) => `Add a mode to ${axis}`,
  frequency: (mode: number, axis: Axis) => `Frequency of mode ${mode} of ${axis}`,
  remove: "Remove",
  removeMode: (mode: number, axis: Axis) => `Remove mode ${mode} of ${axis}`,
  constant: "Constant",
  cos: "Cosine",
  sin: "Sine",
  data: {
    start: "Value at u = 0",
    end: "Value at u = 1",
    start_u: "Slope at u = 0",
    end_u: "Slope at u = 1",
  } satisfies Readonly<Record<DatumName, string>>,
  datumOf: (datum: string, wave: "cos" | "sin", n: string, axis: Axis) => `${datum}, ${wave} ${n} of ${axis}`,
  force: "Force, powers of u (separate with ;)",
  forceOf: (wave: "cos" | "sin", n: string, axis: Axis) => `Force, ${wave} ${n} of ${axis}, ascending powers of u`,
});
