import { describe, expect, test } from "vitest";
import { convert } from "./convert";
import { HANDLE_IDS, handles, moveHandle, rimAt } from "./profile";
import { familyOf } from "./schema";
import type { BloorWilson, BoundaryValue, FourthOrder, Shape } from "./types";

const KINDS = ["second-order", "mixed-order", "fourth-order", "bloor-wilson"] as const;
const reset = (kind: (typeof KINDS)[number]) => familyOf(kind)?.reset as Shape;

const FREE: BoundaryValue = {
  kind: "boundary-value",
  span: "2pi",
  x: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, cos: { start: 1, end: 0.5 } }] },
  y: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, sin: { start: 1, end: 0.5 } }] },
  z: { order: 4, s: 1, t: 1, w: 0, modes: [{ n: 0, cos: { start: 3 } }] },
};

describe.each(KINDS)("%s", (kind) => {
  test("has four handles, and says why one is not free", () => {
    const all = handles(reset(kind));
    expect(all.map((handle) => handle.id).sort()).toEqual([...HANDLE_IDS].sort());
    for (const handle of all) {
      if (!handle.radial || !handle.axial) expect(handle.why).toMatch(/\.$/);
    }
  });

  test("moves exactly the handles that are free", () => {
    const shape = reset(kind);
    for (const { id, radial, axial } of handles(shape)) {
      expect(moveHandle(shape, id, 0.25, 0) !== shape).toBe(radial);
      expect(moveHandle(shape, id, 0, 0.25) !== shape).toBe(axial);
      expect(moveHandle(shape, id, 0, 0)).toBe(shape);
    }
  });
});

test("the rim is where the height is", () => {
  expect(rimAt(reset("second-order"))).toBe(0);
  expect(rimAt(reset("fourth-order"))).toBe(1);
  expect(rimAt(FREE)).toBe(0);
});

test("fourth order: moving an end keeps both slopes, moving a slope keeps both ends", () => {
  const shape = reset("fourth-order") as FourthOrder;
  const slopes = ({ rm, r1, r0, eta }: FourthOrder) => eta.map((e) => e * (4 * rm - r1 - 3 * r0));
  const moved = moveHandle(moveHandle(shape, "rim", 0.1, 0.2), "foot", 0.3, 0) as FourthOrder;
  expect(slopes(moved)[0]).toBeCloseTo(slopes(shape)[0] ?? 0, 6);
  expect(slopes(moved)[1]).toBeCloseTo(slopes(shape)[1] ?? 0, 6);
  expect([moved.r0, moved.r1, moved.h1]).toEqual([0.7, 0.4, 2.2]);
  const leaned = moveHandle(shape, "rim-slope", 0.5, -1) as FourthOrder;
  expect(slopes(leaned)[1]).toBeCloseTo((slopes(shape)[1] ?? 0) + 0.5, 6);
  expect(leaned.dz).toEqual([6, 5]);
  expect(leaned.eta[0]).toBe(shape.eta[0]);
});

test("fourth order without a swell has no lean to drag", () => {
  const shape: FourthOrder = { ...(reset("fourth-order") as FourthOrder), r0: 1, r1: 1, rm: 1 };
  expect(handles(shape).find((handle) => handle.id === "rim-slope")?.radial).toBe(false);
});

test("bloor-wilson: each handle is a number of the paper", () => {
  const shape = reset("bloor-wilson") as BloorWilson;
  const next = moveHandle(shape, "rim-slope", 0.5, 0.25) as BloorWilson;
  expect([next.R[0], next.H[0]]).toEqual([-2.5, -0.25]);
  expect((moveHandle(shape, "foot-slope", -1, 0) as BloorWilson).R[3]).toBe(1);
});

test("free boundary data: x and y move together, z has its own mode", () => {
  const next = moveHandle(FREE, "rim", 0.5, 1) as BoundaryValue;
  expect(next.x.modes[0]?.cos?.start).toBe(1.5);
  expect(next.y.modes[0]?.sin?.start).toBe(1.5);
  expect(next.z.modes[0]?.cos?.start).toBe(4);
  const flat = moveHandle({ ...FREE, z: { ...FREE.z, modes: [] } }, "foot", 0, -1) as BoundaryValue;
  expect(flat.z.modes).toEqual([{ n: 0, cos: { end: -1 } }]);
  const slope = moveHandle(FREE, "foot-slope", 0.5, 0) as BoundaryValue;
  expect(slope.x.modes[0]?.cos?.end_u).toBe(0.5);
});

test("a converted pot has the handles of its new order", () => {
  const mixed = convert(reset("second-order"), "mixed-order")?.shape as Shape;
  expect(handles(mixed).find((handle) => handle.id === "rim-slope")).toMatchObject({ radial: false, axial: true });
});
