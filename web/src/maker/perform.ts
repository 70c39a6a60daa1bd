/** What the maker's worker answers: everything that the package can do besides drawing. */

import type { Ringed } from "pasu";
import {
  check,
  compare,
  constraints,
  fit as fitted,
  free,
  levels,
  measure,
  mesh,
  paint,
  pick,
  provenance,
  sketch,
  solid,
  water,
  write,
} from "pasu";
import type { MapName, Sent } from "../document/types";
import { cellsOf } from "./cells";
import { apart, together } from "./clearing";
import { readFaces } from "./faces";
import { holding } from "./holding";
import { insideOf } from "./inside";
import { liningValues } from "./lining";
import type { Answers, Ask, Kind, Lined, Quick, Request, RingedShape, Solid } from "./messages";
import { methodsOf } from "./methods";
import { paintedOf } from "./painted";
import { pulling } from "./pulling";
import { push } from "./pushing";
import { solidOf } from "./solid";
import { ofSome } from "./some";
import { wovenOf } from "./woven";

/** `tell` hears how far the work is that may take long: from 0 to 1. */
export function perform({ ask }: Request, tell: (done: number) => void): Answers[Kind] {
  const progress = (done: number) => {
    tell(done);
    return true;
  };
  switch (ask.kind) {
    case "solid":
      return drawn(ask.design as Sent, ask.tolerance);
    case "quick":
      return quick(ask);
    case "measure":
      return measure(ask.design as Sent, { product: ask.product, ...(ask.fill === null ? {} : { fill: ask.fill }) });
    case "check":
      return check(ask.design as Sent, { ...ask.making, progress });
    case "paint":
      return paintedOf(paint(ask.design as Sent, ask.map, { rows: ask.rows, columns: ask.columns }));
    case "lining":
      return lined(ask);
    case "water":
      return { ...water(ask.design as Sent, ask.level), level: ask.level };
    case "constraints":
      return constraints(ask.design as Sent, { progress });
    case "pick": {
      const { origin, direction } = ask.ray;
      return pick(ask.design as Sent, { origin: [...origin], direction: [...direction] });
    }
    case "apart":
      return apart(ask);
    case "together":
      return together(ask);
    case "push":
      return push(ask);
    case "write":
      return { bytes: write(ask.design as Sent, ask.format, { ...ask.making, progress }) };
    case "open":
      return provenance(ask.bytes);
    case "faces":
      return readFaces(ask.bytes);
    case "pull":
      return pulling(ask);
    case "hold":
      return holding(ask);
    case "cells":
      return cellsOf(ask);
    case "inside":
      return insideOf(ask);
    case "methods":
      return methodsOf(ask);
    case "woven":
      return wovenOf(ask);
    case "free":
      return ringed(free(ask.design as Sent, ask.part, { tolerance: ask.tolerance }), ask.part);
    case "compare":
      return compare(ask.before as Sent, ask.after as Sent);
    case "fit":
      return ringed(fitted(ask.profile, { tolerance: ask.tolerance }), 0);
    case "levels":
      return levels({ positions: ask.positions });
    case "scanned": {
      const { design, ...apart } = fitted(ask.levels, { tolerance: ask.tolerance });
      return { ...apart, shape: ringed({ design, distance: apart.distance }, 0).shape };
    }
  }
}

/** What a part has become; everything else of the design is as it was. */
function ringed({ design, distance }: Ringed, part: number): RingedShape {
  const shape = design.parts[part]?.shape;
  if (shape?.kind !== "rings") throw new Error("what is freed or fitted is of rings");
  return { shape, distance };
}

/** Parts that are no pots are drawn by the solver alone. */
function drawn(design: Sent, tolerance: number): Solid {
  const walled = [...design.parts.keys()].filter((part) => design.parts[part]?.wall !== undefined);
  const whole = walled.length === design.parts.length;
  return solidOf(
    design,
    whole ? solid(design, { tolerance }) : ofSome(design, walled, (some) => solid(some, { tolerance })),
  );
}

/** What a map shows inside, from what is known of the surface before it. */
function lined({ design, map, rows, columns, points }: Extract<Ask, { kind: "lining" }>): Lined {
  const options = { rows, columns };
  const of = (name: MapName) => paint(design as Sent, name, options).values;
  const { positions, normals } = mesh(design as Sent, options);
  const [mean, gaussian, thickness] = [of("mean-curvature"), of("gaussian-curvature"), of("thickness")];
  const values = liningValues(map, { positions, normals, mean, gaussian, thickness }, points);
  let [least, greatest] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  return { values, range: least <= greatest ? { least, greatest } : null };
}

/** A pot under the hand, in the arrays of an earlier one. */
function quick({ design, parts, tolerance, fill, spare }: Extract<Ask, { kind: "quick" }>): Quick {
  const begun = performance.now();
  const sketched = (of: Sent) =>
    sketch(of, { tolerance, ...(fill !== null && { fill }), ...(spare && { into: spare }) });
  const made = parts ? ofSome(design as Sent, parts, sketched) : sketched(design as Sent);
  const solid = solidOf(design, made, spare);
  return { solid, water: made.water ?? null, took: performance.now() - begun };
}

/** Arrays travel; they are not copied. */
export function buffersOf(answer: Answers[Kind]): Transferable[] {
  if (typeof answer !== "object" || answer === null) return [];
  const parts = "solid" in answer ? [answer.solid, answer.water ?? {}] : [answer];
  return parts
    .flatMap((part) => Object.values(part))
    .flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []));
}
