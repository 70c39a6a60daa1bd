/** The problem that free boundary data are: it stands in the document as it is. */

import { type Axis, hasSine } from "../document/boundary-value";
import type { Path } from "../document/path";
import type { BoundaryValue } from "../document/types";
import { amountAt, NOTHING } from "./amount";
import type { Component, Harmonic, Problem } from "./problem";

export function free(shape: BoundaryValue): Problem {
  const rings = shape.rings ?? [];
  return {
    span: shape.span === "2pi" ? "turn" : shape.span === 1 ? "one" : shape.span,
    rings: rings.map(({ u, sharp }, index) => ({ u: amountAt(["rings", index, "u"], u), sharp: sharp ?? false })),
    components: { x: component(shape, "x"), y: component(shape, "y"), z: component(shape, "z") },
    smoothing: null,
    hoops: null,
  };
}

function component(shape: BoundaryValue, axis: Axis): Component {
  const { order, s, t, w, free: end, modes } = shape[axis];
  const harmonics = modes.flatMap((mode, index) => {
    const waves: readonly Harmonic["wave"][] = hasSine(mode) ? ["cos", "sin"] : ["cos"];
    return waves.flatMap((wave) => {
      const datum = mode[wave];
      if (datum === undefined) return [];
      const number = (name: "start" | "end" | "start_u" | "end_u") =>
        datum[name] === undefined ? NOTHING : amountAt([axis, "modes", index, wave, name], datum[name]);
      const list = (name: "rings" | "force", values: readonly number[]) =>
        values.map((value, at) => amountAt([axis, "modes", index, wave, name, at], value));
      const given = datum.rings ?? [];
      return {
        n: amountAt([axis, "modes", index, "n"], mode.n),
        wave,
        start: number("start"),
        end: number("end"),
        start_u: number("start_u"),
        end_u: number("end_u"),
        rings: list(
          "rings",
          (shape.rings ?? []).map((_, at) => given[at] ?? 0),
        ),
        force: list("force", datum.force ?? []),
      };
    });
  });
  const at = (name: string): Path => [axis, name];
  return {
    order,
    s: amountAt(at("s"), s, `s_{${axis}}`),
    t: amountAt(at("t"), t, `t_{${axis}}`),
    w: order === 4 ? amountAt(at("w"), w ?? 0, `w_{${axis}}`) : NOTHING,
    free: { start: end === "start" || end === "both", end: end === "end" || end === "both" },
    harmonics,
  };
}
