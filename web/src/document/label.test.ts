import { expect, test } from "vitest";
import { labelOf } from "./label";

test("a label is plain text on one line, of so many characters", () => {
  expect(labelOf("\t a\r\nb\u0000\u007fc\u0085d ")).toBe("a b c d ");
  expect(labelOf("🏺🏺🏺", 2)).toBe("🏺🏺");
  expect([...labelOf("x".repeat(230))]).toHaveLength(200);
  expect(labelOf("a\ud83cb\udffa🏺", 5)).toBe("a b 🏺");
  expect(labelOf("")).toBe("");
});
