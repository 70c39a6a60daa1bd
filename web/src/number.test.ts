import { describe, expect, test } from "vitest";
import { customary, formatNumber, parseLength, parseNumber, parseVolume, stepped } from "./number";

const value = (text: string) => {
  const typed = parseNumber(text);
  return "value" in typed ? typed.value : typed.problem.code;
};

describe("typed numbers", () => {
  test.each([
    ["1.5", 1.5],
    ["1,5", 1.5],
    ["  0,06 ", 0.06],
    ["−3", -3],
    ["–3,25", -3.25],
    ["+2", 2],
    [".5", 0.5],
    [",5", 0.5],
    ["5.", 5],
    ["1e-3", 0.001],
    ["1.5E3", 1500],
    ["1,5 × 10^−3", 0.0015],
    ["1 234,5", 1234.5],
    ["1\u202f234.5", 1234.5],
    ["1.234,5", 1234.5],
    ["1,234.5", 1234.5],
    ["12'000", 12000],
    ["-0", 0],
  ])("%j is %d", (text, expected) => {
    expect(value(text)).toBe(expected);
  });

  test.each(["", "   ", "abc", "1.2.3", "1,2,3", "--1", "1e", "0x10", "Infinity", "NaN", "1e999", "5 cm", "1;2"])(
    "%j is refused",
    (text) => {
      const typed = parseNumber(text);
      expect("problem" in typed && typed.problem.code).toMatch(/^(empty|no-number|too-large)$/);
    },
  );
});

describe("shown numbers", () => {
  test.each([
    [0.1 + 0.2, "0.3"],
    [-0.75, "−0.75"],
    [0, "0"],
    [-0, "0"],
    [1e-9, "1e−9"],
    [123456.7, "123457"],
    [1e12, "1e12"],
  ])("%d is shown as %j", (number, expected) => {
    expect(formatNumber(number)).toBe(expected);
  });

  test("what is shown can be typed again", () => {
    for (const number of [0, -1.25, 1e-12, -3e20, 0.000123456, 98765.4]) {
      expect(value(formatNumber(number, 15))).toBe(number);
    }
  });
});

test("steps leave no dust", () => {
  expect(stepped(0.1, 0.1, 2)).toBe(0.3);
  expect(stepped(0.3, 0.005, -60)).toBe(0);
  expect(stepped(1.23456, 0.01, 1)).toBeCloseTo(1.2446, 4);
});

describe("typed lengths", () => {
  test.each([
    ["12 in", "cm", 30.48],
    ["12in.", "cm", 30.48],
    ['12"', "cm", 30.48],
    ["12″", "mm", 304.8],
    ["30mm", "cm", 3],
    ["30 MM", "in", 1.1811023622],
    ["1/2 in", "cm", 1.27],
    ["1 1/2 in", "in", 1.5],
    ["−1/4", "in", -0.25],
    ["3/8", "cm", 0.375],
    ["0,5 m", "cm", 50],
    ["2 feet", "in", 24],
    ["5 inches", "mm", 127],
    ["2 centimetres", "mm", 20],
    ["1,5 × 10^-3 m", "mm", 1.5],
    ["7", "in", 7],
    ["1e-3", "cm", 0.001],
  ])("%j in %s is %d", (text, unit, expected) => {
    const typed = parseLength(text, unit);
    expect("value" in typed && typed.value).toBeCloseTo(expected, 9);
  });

  test.each(["", "wide", "12 furlongs", "1/0 in", "in", "12 in in", "1e999 mm"])("%j is no length", (text) => {
    expect(parseLength(text, "cm")).toHaveProperty("problem");
  });

  test("a number without a unit of length takes none", () => {
    expect(parseLength("12 in", "°")).toHaveProperty("problem");
    expect(parseLength("12", "°")).toEqual({ value: 12 });
  });
});

test.each([
  ["330", "ml", 330],
  ["0,75", "l", 750],
  ["0.5 l", "ml", 500],
  ["33 cl", "l", 330],
  ["12 fl oz", "ml", 354.88235475],
  ["12 oz.", "l", 354.88235475],
  ["1/2 pint", "ml", 236.5882365],
  ["2 gal", "l", 7570.823568],
  ["1 gallon", "ml", 3785.411784],
  ["2 litres", "ml", 2000],
  ["5 millilitres", "l", 5],
] as const)("%j in %s is %d millilitres", (text, unit, expected) => {
  const typed = parseVolume(text, unit);
  expect("value" in typed && typed.value).toBeCloseTo(expected, 9);
});

test.each(["", "a cup", "12 in"])("%j is no volume", (text) => {
  expect(parseVolume(text, "ml")).toHaveProperty("problem");
});

test("ounces below a pint, pints below a gallon, gallons from there on", () => {
  const units = [330, 473.176473, 3785, 3785.411784, 4481].map((each) => customary(each).unit);
  expect(units).toEqual(["ounce", "pint", "pint", "gallon", "gallon"]);
  expect(customary(330).value).toBeCloseTo(11.16, 2);
});
