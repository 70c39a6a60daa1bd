import { expect, test } from "vitest";
import { IDENTITY } from "../gl/view";
import type { StageLook } from "../glaze";
import type { StagePart } from "../mesh";
import { Pot } from "../pot";
import { newStudio } from "../studio";
import type { Triple } from "../triple";
import { Overlays, type StageLines } from "./overlays";

const LOOK: StageLook = { glaze: "celadon", inside: "celadon", line: 0, clay: "stoneware" };

function part(id: number, middle: Triple, hidden: boolean): StagePart {
  const mesh = {
    positions: new Float32Array(9),
    normals: new Float32Array(9),
    uvs: new Float32Array(6),
    indices: Uint32Array.of(0, 1, 2),
    ware: { texels: new Float32Array(4), rows: 1, columns: 1 },
  };
  return { id, revision: 1, mesh, matrix: IDENTITY, look: LOOK, span: [0, 1], middle, hidden };
}

/** Two lines along u of two pieces each, and a rim and a foot of one. */
function lines(x: number): StageLines {
  const two = new Float32Array([x, 0, 0, x, 1, 0, x, 2, 0]);
  const end = new Float32Array([x, 0, 0, x, 1, 0]);
  return { iso_u: [two, two], iso_v: [], rim: end, foot: end, tangents: [] };
}

test("lines are those of the parts that are seen, each cut open as the object that it is on", () => {
  const studio = newStudio("light");
  const pot = new Pot(studio);
  const overlays = new Overlays(studio, {} as HTMLElement, "light", String);
  const bounds = { min: [-1, -1, 0], max: [11, 1, 2], centre: [5, 0, 1], radius: 6 } as const;
  overlays.lines = [lines(0), lines(10)];
  overlays.overlays = { isoU: true, isoV: false, wireframe: false, boundary: true, axes: false };
  const drawn = (hidden: boolean) => {
    pot.update({ parts: [part(1, [0, 0, 1], false), part(2, [10, 0, 1], hidden)], bounds });
    overlays.forget();
    overlays.prepare(pot, [1, 0]);
    const seen = overlays.sources.flatMap(({ drawables }) => drawables).filter(({ visible }) => visible);
    // Of each stroke one of the drawings.
    const strokes = [...new Map(seen.map((each) => [each.geometry, each])).values()];
    return strokes.map(({ geometry, instances }) => [instances, [...(geometry.attributes.middle?.array ?? [])]]);
  };
  const [first, second] = [
    [0, 0, 1],
    [10, 0, 1],
  ] as const;
  expect(drawn(false)).toEqual([
    [8, [...first, ...first, ...first, ...first, ...second, ...second, ...second, ...second]],
    [2, [...first, ...second]],
    [2, [...first, ...second]],
    [0, []],
  ]);
  expect(drawn(true)).toEqual([
    [4, [...first, ...first, ...first, ...first]],
    [1, [...first]],
    [1, [...first]],
    [0, []],
  ]);
});
