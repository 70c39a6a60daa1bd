import { expect, test } from "vitest";
import { customary, parseVolume } from "./volume-units";

test.each([
  ["330", "ml", 330],
  ["0,75", "l", 750],
  ["0.5 l", "ml", 500],
  ["33 cl", "l", 330],
  ["12 fl oz", "ml", 354.88235475],
  ["12 oz.", "l", 354.88235475],
  ["1/2 pint", "ml", 236.5882365],
  ["2 quarts", "ml", 1892.705892],
  ["2 gal", "l", 7570.823568],
  ["1 gallon", "ml", 3785.411784],
  ["12", "fl oz", 354.88235475],
  ["5.49 US gal", "l", 20781.91069416],
  ["2 litres", "ml", 2000],
  ["5 millilitres", "l", 5],
  ["300 cm3", "l", 300],
  ["300cm³", "fl oz", 300],
  ["20 cc", "ml", 20],
  ["1 cup", "ml", 236.5882365],
  ["2½ cups", "l", 591.47059125],
] as const)("%j in %s is %d millilitres", (text, unit, expected) => {
  const typed = parseVolume(text, unit);
  expect("value" in typed && typed.value).toBeCloseTo(expected, 9);
});

test.each(["", "a cup", "12 in"])("%j is no volume", (text) => {
  expect(parseVolume(text, "ml")).toHaveProperty("problem");
});

test("a number in a unit of no volume is told as such", () => {
  expect(parseVolume("12 in", "ml")).toEqual({ problem: { code: "no-volume", typed: "12 in" } });
  expect(parseVolume("a cup", "ml")).toEqual({ problem: { code: "no-number", typed: "a cup" } });
});

test("ounces below a pint, pints below a gallon, gallons from there on", () => {
  const units = [330, 473.176473, 3785, 3785.411784, 4481].map((each) => customary(each).unit);
  expect(units).toEqual(["ounce", "pint", "pint", "gallon", "gallon"]);
  expect(customary(330).value).toBeCloseTo(11.16, 2);
});
