/** Rings for what is drawn: found by the maker, read by the solver to be shown, and made the pot. */

import type { DrawnProfile } from "../document/drawn/sheet";
import { setPath } from "../document/path";
import type { Design, Rings, Unit } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { SolverClient } from "../solver/client";
import type { Change, State } from "../state/store";
import type { Outcome } from "../worker/port";

/** Radius (to the left below 0) and height. */
export type Place = readonly [across: number, up: number];

/** The rings, how far they are from the line at most, and what they look like from the side. */
export interface Drawn {
  readonly shape: Rings;
  readonly distance: number;
  readonly right: readonly Place[];
  readonly left: readonly Place[];
  /** Where every ring is, on the right and on the left. */
  readonly rings: readonly (readonly [right: Place, left: Place])[];
}

/** Points of a side. */
const POINTS = 240;

/** A wall that suits a pot so high, as parts of it. */
const WALL = 0.02;
const BASE = 0.025;

/** Of several profiles the last is answered. */
export async function drawnOf(
  maker: MakerClient,
  solver: SolverClient,
  profile: DrawnProfile,
  tolerance: number,
): Promise<Outcome<Drawn>> {
  const fitted = await maker.ask({ kind: "fit", profile, tolerance });
  if (fitted.state !== "done") return fitted;
  const { shape, distance } = fitted.value;
  const us = [...Array.from({ length: POINTS + 1 }, (_, i) => i / POINTS), ...shape.rings.map(({ u }) => u)];
  const at = new Float64Array(us.flatMap((u) => [u, 0, u, Math.PI]));
  const read = await solver.read("drawn", shape, at);
  if (read.state !== "done") return read;
  const { points } = read.value;
  const places = us.map((_, i): readonly [Place, Place] => [
    [points[6 * i] ?? 0, points[6 * i + 2] ?? 0],
    [points[6 * i + 3] ?? 0, points[6 * i + 5] ?? 0],
  ]);
  const line = places.slice(0, POINTS + 1);
  const [right, left] = [line.map(([place]) => place), line.map(([, place]) => place)];
  return { state: "done", value: { shape, distance, right, left, rings: places.slice(POINTS + 1) } };
}

/** A pot of these rings, with a wall in proportion to its height. */
export function drawnPot(shape: Rings, height: number, unit: Unit): Design {
  const short = (value: number) => Number(value.toPrecision(2));
  const wall = { thickness: short(WALL * height), base: short(BASE * height), rim: "rounded" as const };
  const look = { glaze: "celadon", clay: "stoneware" } as const;
  return { pasu: 1, ...(unit !== "cm" && { unit }), parts: [{ shape, wall, look }] };
}

/** The rings in the place of the selected part's shape, as large as they were drawn: what stretched the part goes. */
export function redraw(state: State, shape: Rings): Change {
  const { design, part } = state;
  const drawn = setPath(design, ["parts", part, "shape"], shape);
  const stretched = design.parts[part]?.place?.scale !== undefined;
  return { design: stretched ? setPath(drawn, ["parts", part, "place", "scale"], undefined) : drawn, undo: "step" };
}
