import { evaluate } from "pasu";
import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import { RINGED } from "../document/gallery/rings";
import { edgesOf, faultOf, isFree } from "../document/network/network";
import { spanOf } from "../document/network/span";
import type { Design, Sent, Shape } from "../document/types";

const { maker } = realMaker({ free: true });
const CYLINDER: Shape = { kind: "second-order", r: [3, 0, 3, 0], height: 8 };

async function woven(shape: Shape, rows: number, columns: number | null) {
  const design: Design = { pasu: 1, parts: [{ shape }] };
  const found = await maker.ask({ kind: "woven", design, part: 0, rows, columns, span: spanOf(shape) });
  if (found.state !== "done") throw new Error(JSON.stringify(found));
  return found.value;
}

test("a cylinder becomes a tube of patches, the nearer the more there are", async () => {
  const coarse = await woven(CYLINDER, 10, 6);
  expect([coarse.shape.patches.length, faultOf(coarse.shape)]).toEqual([60, null]);
  // Closed round the axis, with two rims.
  expect([...edgesOf(coarse.shape).values()].filter(isFree).length).toBe(12);
  expect(coarse.distance).toBeGreaterThan(1e-3);
  expect(coarse.distance).toBeLessThan(0.05);
  const fine = await woven(CYLINDER, 20, 24);
  expect(fine.distance).toBeLessThan(coarse.distance / 10);
});

test("a form with petals becomes a network too", async () => {
  const found = await woven({ kind: "second-order", r: [2, 0.2, 1, 0.1] }, 6, null);
  // Eight petals take four patches each.
  expect([found.columns, found.shape.patches.length, faultOf(found.shape)]).toEqual([32, 192, null]);
  expect(found.distance).toBeLessThan(0.2);
});

test("it is looked at along the edges of patches too", async () => {
  const { shape, distance } = await woven(CYLINDER, 10, 6);
  const steps = Array.from({ length: 31 }, (_, step) => step / 30);
  const [form, network] = [
    evaluate(
      { pasu: 1, parts: [{ shape: CYLINDER }] } as unknown as Sent,
      0,
      steps.flatMap((u) => [0, (spanOf(CYLINDER) / 6) * u]),
    ),
    evaluate(
      { pasu: 1, parts: [{ shape }] } as unknown as Sent,
      0,
      steps.flatMap((u) => [0, u, 0]),
    ),
  ];
  const off = steps.map((_, at) =>
    Math.hypot(...[0, 1, 2].map((axis) => (form[3 * at + axis] ?? 0) - (network[3 * at + axis] ?? 0))),
  );
  expect(distance).toBeGreaterThan(0.98 * Math.max(...off));
});

test("the distance that is told is the largest there is, wherever on a patch", async () => {
  // Places on the edges, a tenth and a fifth from them and so on miss the largest by a sixth.
  const shape = RINGED.find(({ id }) => id === "own-squeezed-bottle")?.shape as Shape;
  const [rows, columns, steps] = [2, 5, 40];
  const { shape: network, distance } = await woven(shape, rows, columns);
  const [form, there]: [number[], number[]] = [[], []];
  for (let patch = 0; patch < rows * columns; patch += 1) {
    for (let i = 0; i <= steps; i += 1) {
      for (let j = 0; j <= steps; j += 1) {
        const [u, v] = [i / steps, j / steps];
        there.push(patch, u, v);
        form.push((Math.floor(patch / columns) + v) / rows, (spanOf(shape) * ((patch % columns) + u)) / columns);
      }
    }
  }
  const own = evaluate({ pasu: 1, parts: [{ shape }] } as unknown as Sent, 0, form);
  const other = evaluate({ pasu: 1, parts: [{ shape: network }] } as unknown as Sent, 0, there);
  let most = 0;
  for (let place = 0; place < own.length; place += 3)
    most = Math.max(
      most,
      Math.hypot(...[0, 1, 2].map((axis) => (own[place + axis] ?? 0) - (other[place + axis] ?? 0))),
    );
  expect(distance).toBeGreaterThan(0.999 * most);
  expect(distance).toBeLessThan(1.01 * most);
});
