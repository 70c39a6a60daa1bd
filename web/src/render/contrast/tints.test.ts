import { expect, test } from "vitest";
import type { Geometry } from "../gl/geometry";
import { Pot } from "../pot";
import type { Bench } from "../stage";
import { newStudio } from "../studio";
import { Tints } from "./tints";

test("of a part with a wall the inside is coloured too, and of others nothing", () => {
  const studio = newStudio("light");
  const faces = [0, 1].map((part) => ({ geometry: {} as Geometry, uniforms: {}, range: [3 * part, 3] as const, part }));
  const bench = {
    studio,
    pot: new Pot(studio),
    overlay: { pen: { ratio: { value: 1 } } },
    cut: () => [0, 0, 0, 1],
    faces: () => faces,
    changed: () => {},
  } as unknown as Bench;
  const tints = new Tints(bench);
  tints.show(new Map([[1, [0, 0, 1]]]), { parts: [], bounds: null }, []);
  expect(tints.drawables.map(({ range, uniforms }) => [range, uniforms?.tint?.value])).toEqual([
    [
      [3, 3],
      [0, 0, 1],
    ],
  ]);
});
