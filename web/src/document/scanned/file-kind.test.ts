import { expect, test } from "vitest";
import { scanKind } from "./file-kind";

test.each([
  ["pot.stl", "stl"],
  ["My pot.v2.OBJ", "obj"],
  ["a.Ply", "ply"],
  ["stl", null],
  ["pot.stl.json", null],
  ["pot.3mf", null],
] as const)("%s is %s", (name, kind) => {
  expect(scanKind(name)).toBe(kind);
});
