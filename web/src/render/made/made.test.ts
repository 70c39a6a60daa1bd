import { expect, test, vi } from "vitest";
import type { Camera } from "../camera";
import type { Uniforms } from "../gl/material";
import { IDENTITY } from "../gl/view";
import type { StageLook } from "../glaze";
import type { StagePart } from "../mesh";
import { Pot } from "../pot";
import type { Place } from "../stage";
import { newStudio } from "../studio";
import type { Triple } from "../triple";
import type { StageSolid } from "./faces";
import { Made } from "./made";

const LOOK: StageLook = { glaze: "celadon", inside: "celadon", line: 0, clay: "stoneware" };
const LOOKS = [LOOK, LOOK, LOOK];

/** Faces of three parts, one triangle each. */
function solid(): StageSolid {
  return {
    positions: new Float32Array(27),
    normals: new Float32Array(27),
    wares: new Float32Array(36),
    indices: new Uint32Array(9),
    groups: Uint32Array.of(0, 3, 0, 3, 3, 1, 6, 3, 2),
    bounds: null,
    sides: ["inside", "inside", "inside"],
    outsides: [[1, 2], null, null],
  };
}

function bench() {
  const studio = newStudio("light");
  const changed = vi.fn();
  const pot = new Pot(studio);
  const made = new Made({ studio, pot, overlay: {}, root: null, changed } as unknown as Place);
  /** What is drawn of the wall: which indices, and by which motion. */
  const drawn = () =>
    made.drawables.flatMap(({ range, uniforms }) => (range ? [[range, uniforms?.model?.value] as const] : []));
  return { made, pot, drawn, changed };
}

/** A part of one triangle, which belongs to an object of this middle. */
function part(id: number, middle?: Triple): StagePart {
  const texels = new Float32Array(4);
  const mesh = {
    positions: new Float32Array(9),
    normals: new Float32Array(9),
    uvs: new Float32Array(6),
    indices: Uint32Array.of(0, 1, 2),
    ware: { texels, rows: 1, columns: 1 },
  };
  return { id, revision: 1, mesh, matrix: IDENTITY, look: LOOK, span: [0, 1], ...(middle && { middle }) };
}

const BOUNDS = { min: [-1, -1, 0], max: [11, 1, 2], centre: [5, 0, 1], radius: 6 } as const;
const camera = (azimuth: number) => ({ pose: { azimuth }, view: {} }) as unknown as Camera;

const shifted = (x: number, z = 0) => [...IDENTITY.slice(0, 12), x, 0, z, 1];

test("what looks the same and stands where it was made is drawn at once", () => {
  const { made, drawn } = bench();
  made.show(solid(), LOOKS);
  expect(drawn()).toEqual([[[0, 9], IDENTITY]]);
});

test("the faces of a part that was moved go along, and those of the others stay, before it and after it", () => {
  const { made, drawn } = bench();
  const faces = solid();
  for (const place of [0, 1, 2]) {
    const motions = [0, 1, 2].map((part) => (part === place ? shifted(5) : IDENTITY));
    made.show(faces, LOOKS, motions);
    expect(drawn().map(([, model]) => model)).toEqual(
      place === 1 ? [IDENTITY, shifted(5), IDENTITY] : place === 0 ? [shifted(5), IDENTITY] : [IDENTITY, shifted(5)],
    );
    expect(drawn().find(([, model]) => model?.[12 as never] === (5 as never))?.[0]).toEqual([3 * place, 3]);
    expect(made.faces.map(({ uniforms }) => uniforms.model?.value)).toEqual(motions);
  }
  made.show(faces, LOOKS, [IDENTITY, IDENTITY, IDENTITY]);
  expect(drawn()).toEqual([[[0, 9], IDENTITY]]);
});

test("a part that moves on takes no new draw calls, and its glaze ends where it is", () => {
  const { made, drawn, changed } = bench();
  const faces = solid();
  made.show(faces, LOOKS, [shifted(1), IDENTITY, IDENTITY]);
  const before = made.drawables[0];
  changed.mockClear();
  expect(made.show(faces, [...LOOKS], [shifted(2, 4), IDENTITY, IDENTITY])).toEqual({ walls: null, changed: null });
  expect(made.drawables[0]).toBe(before);
  expect(drawn()[0]).toEqual([[0, 3], shifted(2, 4)]);
  expect(before?.uniforms?.span?.value).toEqual([5, 6]);
  expect(changed).toHaveBeenCalled();
});

test("faces of a part that is another one by now are neither drawn nor picked, and cut nothing", () => {
  const { made, drawn } = bench();
  made.cut(true);
  made.show(solid(), LOOKS, [IDENTITY, null, IDENTITY]);
  expect(drawn().map(([range]) => range)).toEqual([
    [0, 3],
    [6, 3],
  ]);
  expect(made.faces.map(({ part }) => part)).toEqual([0, 2]);
  expect([0, 1, 2].map((place) => made.coreOf(place))).toEqual([-1, 0, -1]);
});

test("what a hand changed stands in place of what was there, glazed and cut as that, and is given back when it goes", () => {
  const { made, drawn } = bench();
  const faces = solid();
  const other: StageSolid = { ...solid(), groups: Uint32Array.of(0, 9, 1), sides: [null, "outside", null] };
  made.cut(true);
  made.show(faces, LOOKS, [IDENTITY, null, IDENTITY], null, { made: other, motions: [null, IDENTITY, null] });
  expect(drawn().map(([range]) => range)).toEqual([
    [0, 3],
    [6, 3],
    [0, 9],
  ]);
  expect(made.faces.map(({ part }) => part)).toEqual([0, 2, 1]);
  expect([0, 1, 2].map((part) => made.coreOf(part))).toEqual([-1, 1, -1]);
  expect(made.show(faces, LOOKS, [IDENTITY, IDENTITY, IDENTITY])).toEqual({ walls: null, changed: other });
  expect(drawn().map(([range]) => range)).toEqual([[0, 9]]);
});

test("of several objects each is cut open through its own middle, and one alone through that of all", () => {
  const { made, pot } = bench();
  const cuts = () => pot.parts.map(({ cut }) => cut.value);
  pot.update({ parts: [part(1, [0, 0, 1]), part(2, [10, 0, 1])], bounds: BOUNDS });
  made.cut(true);
  made.show(solid(), LOOKS);
  made.prepare(camera(0), 100, 100);
  expect(made.cutPlane.value).toEqual([1, 0, 0, 5]);
  expect(cuts()).toEqual([
    [1, 0, 0, 0],
    [1, 0, 0, 10],
  ]);
  // Walls are cut as what they are of, and so is what is picked of them.
  const planes = (all: readonly { readonly uniforms?: Uniforms }[]) => all.map(({ uniforms }) => uniforms?.cut?.value);
  expect(planes(made.drawables).slice(0, 2)).toEqual(cuts());
  expect(planes(made.faces).slice(0, 2)).toEqual(cuts());
  pot.update({ parts: [part(1), part(2)], bounds: BOUNDS });
  made.prepare(camera(0), 100, 100);
  expect(cuts()).toEqual([made.cutPlane.value, made.cutPlane.value]);
  made.cut(false);
  made.prepare(camera(0), 100, 100);
  expect(cuts()).toEqual([
    [0, 0, 0, 1],
    [0, 0, 0, 1],
  ]);
});

test("the water of each object is cut as that is", () => {
  const { made, pot } = bench();
  const square = (x: number) => [x - 1, -1, 1, x + 1, -1, 1, x, 1, 1];
  const water = {
    level: 1,
    positions: new Float32Array([...square(10), ...square(0)]),
    indices: Uint32Array.of(0, 1, 2, 3, 4, 5),
  };
  pot.update({ parts: [part(1, [0, 0, 1]), part(2, [10, 0, 1])], bounds: BOUNDS });
  made.cut(true);
  made.pour(water, null);
  made.pour(water, 1);
  made.onHold = () => {};
  made.prepare({ pose: { azimuth: 0 }, view: { see: () => ({ before: false }) } } as unknown as Camera, 100, 100);
  expect(made.drawables.map(({ range, uniforms }) => [range, uniforms?.cut])).toEqual([
    [[0, 3], pot.parts[1]?.cut],
    [[3, 3], pot.parts[0]?.cut],
  ]);
});
