import { describe, expect, test } from "vitest";
import { formatNumber, parseLength, parseNumber, stepped } from "./number";

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
    ["12’000'000,5", 12000000.5],
    ["-0", 0],
  ])("%j is %d", (text, expected) => {
    expect(value(text)).toBe(expected);
  });

  test.each([
    "",
    "   ",
    "abc",
    "1.2.3",
    "1,2,3",
    "--1",
    "1e",
    "0x10",
    "Infinity",
    "NaN",
    "1e999",
    "5 cm",
    "1;2",
    "2'",
    "1' 2",
    "12'00",
  ])("%j is refused", (text) => {
    const typed = parseNumber(text);
    expect("problem" in typed && typed.problem.code).toMatch(/^(empty|no-number|too-large)$/);
  });
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
    [`1' 2"`, "in", 14],
    [`5'10"`, "in", 70],
    ["5’ 10½″", "in", 70.5],
    ["5 ft 10 in", "cm", 177.8],
    ["2 ft. 6 1/2", "in", 30.5],
    ["−1'6", "in", -18],
    ["2'", "cm", 60.96],
    ["12'000", "mm", 12000],
    [`1'000"`, "in", 12],
    ["½ in", "in", 0.5],
    ["1 ½", "cm", 1.5],
    ["-¼", "cm", -0.25],
  ])("%j in %s is %d", (text, unit, expected) => {
    const typed = parseLength(text, unit);
    expect("value" in typed && typed.value).toBeCloseTo(expected, 9);
  });

  test.each(["", "wide", "12 furlongs", "1/0 in", "in", "12 in in", "1e999 mm", "1' two", "2 ft high", "½½"])(
    "%j is no length",
    (text) => {
      expect(parseLength(text, "cm")).toHaveProperty("problem");
    },
  );

  test.each(["12 km", "1,5 yd", "½ furlong", "3 l", "1e3 kg."])("%j is a number in a unit of no length", (text) => {
    expect(parseLength(text, "cm")).toEqual({ problem: { code: "no-length", typed: text } });
  });

  test.each(["about 12", "12 in in", "2 ft high", "1.2.3 km", "km", "2x3"])("%j is no number", (text) => {
    expect(parseLength(text, "cm")).toEqual({ problem: { code: "no-number", typed: text } });
  });

  test("a number without a unit of length takes none", () => {
    expect(parseLength("12 in", "°")).toHaveProperty("problem");
    expect(parseLength("12", "°")).toEqual({ value: 12 });
    expect(parseLength("1/2", "")).toEqual({ value: 0.5 });
  });
});
