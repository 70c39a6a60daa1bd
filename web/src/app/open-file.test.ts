import { expect, test } from "vitest";
import { isDocument } from "./open-file";

test.each([
  ["vase.json", "milk, eggs", true],
  ["link.txt", "anything", true],
  ["vase", ' {"pasu": 1}', true],
  ["vase", "\ufeff{", true],
  ["vase.url", "https://example.org/#1/second-order", true],
  ["vase", "#1/second-order?height=5", true],
  ["vase", "1~abcd", true],
  ["vase.obj", "# Pasu 1\nv 0 0 0", false],
  ["vase.stl", "\0\0\0", false],
  ["vase.step", "ISO-10303-21;", false],
  ["vase.svg", "<svg", false],
])("%s beginning with %j", (name, beginning, document) => {
  expect(isDocument(name, beginning)).toBe(document);
});
