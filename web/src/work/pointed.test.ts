import { effect } from "@preact/signals-core";
import { expect, test } from "vitest";
import { Pointed } from "./pointed";

test("what is pointed at is told elsewhere, and is over when whoever points leaves", () => {
  const pointed = new Pointed();
  const told: (readonly string[])[] = [];
  effect(() => {
    told.push(pointed.elsewhere("field"));
  });
  pointed.point("formula", ["r[0]", "r[1]"]);
  pointed.point("field", ["a"]);
  expect(pointed.places).toEqual(["a"]);
  // A formula that is left behind takes nothing from a field.
  pointed.leave("formula");
  expect(pointed.places).toEqual(["a"]);
  pointed.leave("field");
  expect(pointed.places).toEqual([]);
  expect(told).toEqual([[], ["r[0]", "r[1]"], [], []]);
});
