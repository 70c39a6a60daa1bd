import { expect, test, vi } from "vitest";
import { IDENTITY } from "../gl/view";
import type { StageLook } from "../glaze";
import { Pot } from "../pot";
import type { Place } from "../stage";
import { newStudio } from "../studio";
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
  const made = new Made({ studio, pot: new Pot(studio), overlay: {}, root: null, changed } as unknown as Place);
  /** What is drawn of the wall: which indices, and by which motion. */
  const drawn = () =>
    made.drawables.flatMap(({ range, uniforms }) => (range ? [[range, uniforms?.model?.value] as const] : []));
  return { made, drawn, changed };
}

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
