import { expect, test } from "vitest";
import { ringStep } from "./ring-keys";

const press = (key: string, more = {}) => ringStep({ key, shiftKey: false, altKey: false, ...more }, 0.05);

test("arrows move a ring by round numbers, with shift by ten times as much", () => {
  expect(press("ArrowRight")).toEqual({ out: 0.1, up: 0, round: 0 });
  expect(press("ArrowLeft")?.out).toBe(-0.1);
  expect(press("ArrowUp", { shiftKey: true })?.up).toBe(1);
  expect(press("ArrowDown")?.up).toBe(-0.1);
});

test("with alt they go round the axis by degrees, and other keys mean nothing", () => {
  expect(press("ArrowRight", { altKey: true })?.round).toBeCloseTo(Math.PI / 180);
  expect(press("ArrowRight", { altKey: true })?.out).toBe(0);
  expect(press("Enter")).toBeNull();
});
