import { expect, test } from "vitest";
import { frozen, getPath, pathOf, pathText, setPath } from "./path";

const document = frozen({ title: "Pot", parts: [{ shape: { r: [1, 2, 3, 4] } }, { shape: { r: [5] } }] });

test("reads what is there and nothing where the path leaves the data", () => {
  expect(getPath(document, ["parts", 0, "shape", "r", 2])).toBe(3);
  expect(getPath(document, ["parts", 7, "shape"])).toBeUndefined();
  expect(getPath(document, ["title", "length", "x"])).toBeUndefined();
});

test("replaces one value and shares the rest", () => {
  const next = setPath(document, ["parts", 0, "shape", "r", 1], 9);
  expect(next.parts[0]?.shape.r).toEqual([1, 9, 3, 4]);
  expect(next.parts[1]).toBe(document.parts[1]);
  expect(document.parts[0]?.shape.r).toEqual([1, 2, 3, 4]);
});

test("gives the same object back when nothing changes", () => {
  expect(setPath(document, ["parts", 0, "shape", "r", 1], 2)).toBe(document);
  expect(setPath(document, ["missing"], undefined)).toBe(document);
});

test("makes what is missing and removes what is undefined", () => {
  expect(setPath({}, ["look", "glaze"], "tenmoku")).toEqual({ look: { glaze: "tenmoku" } });
  expect(setPath({}, ["force", 1], 2)).toEqual({ force: [undefined, 2] });
  expect(setPath<object>(document, ["title"], undefined)).toEqual({ parts: document.parts });
});

test("names a place as the solver does", () => {
  expect(pathText(["parts", 2, "shape", "s", 0])).toBe("parts[2].shape.s[0]");
});

test("freezes all the way down", () => {
  expect(Object.isFrozen(document.parts[0]?.shape.r)).toBe(true);
});

test("the solver's names of places lead there, and back", () => {
  for (const text of ["r[0]", "height", "x.modes[12].cos.start_u", "parts[0].shape.s[1]", ""]) {
    expect(pathText(pathOf(text))).toBe(text);
  }
  expect(pathOf("x.modes[12].cos.start_u")).toEqual(["x", "modes", 12, "cos", "start_u"]);
});
