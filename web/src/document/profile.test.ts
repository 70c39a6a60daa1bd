import init, { handles } from "pasu/drawing";
import { beforeAll, describe, expect, test } from "vitest";
import { isFree, moveHandle, sharesHandles } from "./profile";
import { familyOf } from "./schema";
import type { BloorWilson, BoundaryValue, FourthOrder, Handle, HandleId, Shape } from "./types";

const KINDS = ["second-order", "mixed-order", "fourth-order", "bloor-wilson"] as const;
const reset = (kind: (typeof KINDS)[number]) => familyOf(kind)?.reset as Shape;

const FREE = {
  kind: "boundary-value",
  span: "2pi",
  x: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, cos: { start: 1, end: 0.5 } }] },
  y: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, sin: { start: 1, end: 0.5 } }] },
  z: { order: 4, s: 1, t: 1, w: 0, modes: [{ n: 0, cos: { start: 3 } }] },
} as const satisfies BoundaryValue;

beforeAll(() => init());

/** What the solver says of a shape. */
function handlesOf(shape: Shape): readonly Handle[] {
  return handles(shape as Parameters<typeof handles>[0]).list;
}

function moved(shape: Shape, id: HandleId, radial: number, axial: number): Shape {
  const handle = handlesOf(shape).find((each) => each.id === id);
  if (!handle) throw new Error(id);
  return moveHandle(shape, handle, radial, axial);
}

describe.each(KINDS)("%s", (kind) => {
  test("has four handles, and says why one is not free", () => {
    const all = handlesOf(reset(kind));
    expect(all.map(({ id }) => id)).toEqual(["rim", "rim-slope", "foot-slope", "foot"]);
    for (const handle of all) {
      const free = handle.radial.length > 0 && handle.axial.length > 0;
      expect(handle.restraints.length === 0).toBe(free);
      expect(isFree(handle)).toBe(handle.radial.length > 0 || handle.axial.length > 0);
    }
  });

  test("moves exactly the handles that are free", () => {
    const shape = reset(kind);
    for (const handle of handlesOf(shape)) {
      expect(moveHandle(shape, handle, 0.25, 0) !== shape).toBe(handle.radial.length > 0);
      expect(moveHandle(shape, handle, 0, 0.25) !== shape).toBe(handle.axial.length > 0);
      expect(moveHandle(shape, handle, 0, 0)).toBe(shape);
    }
  });
});

test("what a document leaves out moves from its default", () => {
  expect(moved(reset("second-order"), "rim", 0, 0.4)).toMatchObject({ height: 4 });
});

test("fourth order: moving an end keeps both slopes, moving a slope keeps both ends", () => {
  const shape = reset("fourth-order") as FourthOrder;
  const slopes = ({ rm, r1, r0, eta }: FourthOrder) => eta.map((e) => e * (4 * rm - r1 - 3 * r0));
  const dragged = moved(moved(shape, "rim", 0.1, 0.2), "foot", 0.3, 0) as FourthOrder;
  expect(slopes(dragged)[0]).toBeCloseTo(slopes(shape)[0] ?? 0, 6);
  expect(slopes(dragged)[1]).toBeCloseTo(slopes(shape)[1] ?? 0, 6);
  expect([dragged.r0, dragged.r1, dragged.h1]).toEqual([0.7, 0.4, 2.2]);
  const leaned = moved(shape, "rim-slope", 0.5, -1) as FourthOrder;
  expect(slopes(leaned)[1]).toBeCloseTo((slopes(shape)[1] ?? 0) + 0.5, 6);
  expect(leaned.dz).toEqual([6, 5]);
  expect(leaned.eta[0]).toBe(shape.eta[0]);
});

test("bloor-wilson: each handle is a number of the paper", () => {
  const shape = reset("bloor-wilson") as BloorWilson;
  const next = moved(shape, "rim-slope", 0.5, 0.25) as BloorWilson;
  expect([next.R[0], next.H[0]]).toEqual([-2.5, -0.25]);
  expect((moved(shape, "foot-slope", -1, 0) as BloorWilson).R[3]).toBe(1);
});

test("free boundary data: x and y move together, z has its own mode", () => {
  const next = moved(FREE, "rim", 0.5, 1) as BoundaryValue;
  expect(next.x.modes[0]?.cos?.start).toBe(1.5);
  expect(next.y.modes[0]?.sin?.start).toBe(1.5);
  expect(next.z.modes[0]?.cos?.start).toBe(4);
  const flat = moved({ ...FREE, z: { ...FREE.z, modes: [] } }, "foot", 0, -1) as BoundaryValue;
  expect(flat.z.modes).toEqual([{ n: 0, cos: { end: -1 } }]);
  const slope = moved(FREE, "foot-slope", 0.5, 0) as BoundaryValue;
  expect(slope.x.modes[0]?.cos?.end_u).toBe(0.5);
});

test("the handle that was grabbed moves a whole drag, also where its first step adds a mode", () => {
  const flat: BoundaryValue = { ...FREE, z: { ...FREE.z, modes: [{ n: 3, cos: { start: 0.1 } }] } };
  const grabbed = handlesOf(flat).find(({ id }) => id === "rim") as Handle;
  let shape: Shape = flat;
  for (let step = 0; step < 4; step += 1) shape = moveHandle(shape, grabbed, 0.25, 0.5);
  expect((shape as BoundaryValue).x.modes[0]?.cos?.start).toBe(2);
  expect((shape as BoundaryValue).z.modes[1]).toEqual({ n: 0, cos: { start: 2 } });
  expect(sharesHandles(flat, shape)).toBe(true);
});

test("handles of one shape are no handles of another kind, or of other modes", () => {
  expect(sharesHandles(reset("second-order"), reset("mixed-order"))).toBe(false);
  expect(sharesHandles(reset("fourth-order"), moved(reset("fourth-order"), "rim", 1, 1))).toBe(true);
  expect(sharesHandles(FREE, moved(FREE, "rim", 1, 1))).toBe(true);
  const renumbered: BoundaryValue = { ...FREE, x: { ...FREE.x, modes: [{ ...FREE.x.modes[0], n: 2 }] } };
  expect(sharesHandles(FREE, renumbered)).toBe(false);
  expect(sharesHandles(FREE, { ...FREE, y: { ...FREE.y, modes: [] } })).toBe(false);
});
