import { expect, test } from "vitest";
import { type Amount, amountAt, NOTHING, ONE } from "./amount";
import { WHOLE, Writer } from "./writer";

const shown = (digits = 5, decimal = ".") => new Writer({ ...WHOLE, digits, decimal, marked: true });

test.each([
  [0, "0"],
  [1, "1"],
  [-0.25, "-0.25"],
  [4.442882938, "4.4429"],
  [1234567, "1234600"],
  [0.000123456, "0.00012346"],
  [0.0000123456, "1.2346\\cdot 10^{-5}"],
  [-98765432100, "-9.8765\\cdot 10^{10}"],
  [5e-324, "5\\cdot 10^{-324}"],
])("%d is written as %s", (value, text) => {
  expect(shown().plain(value)).toBe(text);
});

test("with the mark of the language, which LaTeX takes for no comma of a list", () => {
  expect(shown(5, ",").plain(0.5)).toBe("0{,}5");
  expect(shown(5, ",").plain(1.5e-9)).toBe("1{,}5\\cdot 10^{-9}");
});

test("numbers are marked by where they are from, and symbols stand for them", () => {
  const writer = shown();
  const rim: Amount = amountAt(["r", 0], -2.5, "r_{1}");
  const both = { value: 3, at: ["r[1]", "r[2]"], name: "r_{2} + r_{3}" };
  const terms = [
    { amount: rim, body: "\\cos(v)" },
    { amount: NOTHING, body: "u" },
    { amount: both, body: "u" },
    { amount: ONE, body: "" },
  ];
  expect(writer.sum(terms)).toBe("-\\class{m0}{2.5}\\,\\cos(v)+\\class{m1}{3}\\,u+1");
  expect(writer.symbols(() => writer.sum(terms, true))).toBe(
    "\\class{m2}{r_{1}}\\,\\cos(v)+\\left(\\class{m3}{r_{2} + r_{3}}\\right)\\,u+1+\\cdots",
  );
  expect(writer.formula("").marks).toEqual([["r[0]"], ["r[1]", "r[2]"], ["r[0]"], ["r[1]", "r[2]"]]);
  expect(writer.sum([])).toBe("0");
});

test("a power has brackets where it needs them", () => {
  expect(shown().power(amountAt(["a"], 2), 2)).toBe("\\class{m0}{2}^{2}");
  expect(shown().power(amountAt(["a"], -2), 2)).toBe("\\left(-\\class{m0}{2}\\right)^{2}");
  expect(shown().power({ value: 1e-9, at: [] }, 2)).toBe("\\left(1\\cdot 10^{-9}\\right)^{2}");
});

test("waves go round once in their span", () => {
  const n = amountAt(["n1"], 5, "n_{1}");
  const writer = new Writer(WHOLE);
  expect(writer.wave("cos", n, "one")).toBe("\\cos(10\\pi v)");
  expect(writer.wave("sin", n, "turn")).toBe("\\sin(5\\,v)");
  expect(writer.wave("sin", ONE, "turn")).toBe("\\sin(v)");
  expect(writer.wave("cos", n, 4)).toBe("\\cos(2.5\\pi v)");
  expect(writer.symbols(() => writer.wave("cos", n, "one"))).toBe("\\cos(2\\pi\\,n_{1}\\,v)");
});
