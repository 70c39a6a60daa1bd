import { describe, expect, test } from "vitest";
import { convert, ORDER_KINDS } from "./convert";
import { PAPERS } from "./gallery/papers";
import { filled } from "./kinds";
import { familyOf } from "./schema";
import type { FourthOrder, SecondOrder, Shape } from "./types";

const TAU = 2 * Math.PI;

function edges(shape: Shape): { rim: number; foot: number; height: number } {
  switch (shape.kind) {
    case "second-order":
    case "mixed-order":
      return { rim: shape.r[0], foot: shape.r[2], height: filled(shape).height ?? 0 };
    case "fourth-order":
      return { rim: shape.r1, foot: shape.r0, height: shape.h1 };
    case "bloor-wilson":
      return { rim: shape.r[0], foot: shape.r[3], height: shape.h[0] };
    case "boundary-value":
      throw new Error("no edges");
  }
}

describe.each(PAPERS.map((exhibit) => [exhibit.id, exhibit.shape] as const))("%s", (_id, shape) => {
  test.each(ORDER_KINDS)("keeps rim, foot and height in %s", (kind) => {
    const next = convert(shape, kind)?.shape;
    expect(next?.kind).toBe(kind);
    if (next) expect(edges(next)).toEqual(edges(shape));
    expect(JSON.stringify(next)).not.toMatch(/null/);
  });
});

test("the same order is the same shape", () => {
  const shape = familyOf("second-order")?.reset as Shape;
  expect(convert(shape, "second-order")).toEqual({ shape, lost: [] });
});

test("free boundary data cannot be switched as a whole", () => {
  const component = { order: 2, s: 1, t: 1, modes: [] } as const;
  expect(
    convert({ kind: "boundary-value", span: 1, x: component, y: component, z: component }, "fourth-order"),
  ).toBeNull();
});

test("a second order wall is the same wall in fourth order", () => {
  const second: SecondOrder = { kind: "second-order", r: [1, 0, 0.6, 0], t: [0.5, 0.5], s: [1, 1], height: 3.6 };
  const fourth = convert(second, "fourth-order")?.shape as FourthOrder;
  // q'' = K q from the rim down; the fourth order equation s q'''' - t q'' + w q = 0 must hold for it, with its end slopes.
  const k = TAU * Math.sqrt(0.5);
  expect(fourth.s[0] * k ** 4 - fourth.t[0] * k ** 2 + fourth.w[0]).toBeCloseTo(0, 6);
  const slope = (u: number) => (k * (-Math.cosh(k * (1 - u)) + 0.6 * Math.cosh(k * u))) / Math.sinh(k);
  const swell = 4 * fourth.rm - fourth.r1 - 3 * fourth.r0;
  expect(fourth.eta[0] * swell).toBeCloseTo(-slope(1), 9);
  expect(fourth.eta[1] * swell).toBeCloseTo(-slope(0), 9);
  expect(fourth.dz).toEqual([3.6, 3.6]);
});

test("second to fourth order and back gives the pot that one started from", () => {
  const second: SecondOrder = { kind: "second-order", r: [1, 0, 0.6, 0], t: [0.5, 0.25], s: [1, 1], height: 3.6 };
  const fourth = convert(second, "fourth-order")?.shape as Shape;
  const back = convert(fourth, "second-order");
  expect(back).toEqual({ shape: second, lost: [] });
});

test("mixed order keeps its rise in fourth order", () => {
  const mixed = { kind: "mixed-order", r: [1, 0, 0.6, 0], rise: -10, height: 3.6 } as const;
  const fourth = convert(mixed, "fourth-order")?.shape as FourthOrder;
  expect(fourth.dz).toEqual([0, 10]);
});

test("a straight wall has slopes in fourth order too", () => {
  const straight: SecondOrder = { kind: "second-order", r: [1, 0, 1, 0], t: [0, 0], s: [1, 1], height: 2 };
  const fourth = convert(straight, "fourth-order")?.shape as FourthOrder;
  const swell = 4 * fourth.rm - fourth.r1 - 3 * fourth.r0;
  expect(swell).not.toBe(0);
  expect(fourth.eta).toEqual([0, 0]);
});

test("says what is left behind", () => {
  const petals: SecondOrder = { kind: "second-order", r: [1, 0.1, 0.6, 0.06], force: [1, 0] };
  expect(convert(petals, "fourth-order")?.lost.join(" ")).toMatch(/petals.*push/);
  const dint = familyOf("bloor-wilson")?.reset as Shape;
  expect(convert(dint, "second-order")?.lost.join(" ")).toMatch(/dints.*skew.*slopes/);
});
