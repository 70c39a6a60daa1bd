import { parseAst } from "vite";
import { expect, test } from "vitest";
import { withoutUnmentioned } from "./unmentioned";

function shaken(code: string, words: string[] = []): string {
  const [text] = withoutUnmentioned([{ code, tree: parseAst(code) }], words);
  return (text ?? "").replace(/\s+/g, " ").trim();
}

test("a method that nobody mentions goes, and what only it mentions", () => {
  const code = "class A { used() {} unused() { helper(); } } function helper() {} new A().used();";
  expect(shaken(code)).toBe("class A { used() {} } var helper; new A().used();");
  expect(shaken(code, ["unused"])).toBe(code);
});

test("a method that mentions only itself goes", () => {
  expect(shaken("class A { again() { this.again(); } } new A();")).toBe("class A { } new A();");
});

test("constructors, computed names and fields of tables stay", () => {
  const code = "class A { constructor() {} [Symbol.iterator]() {} } const table = { a() {} }; use(A, table);";
  expect(shaken(code)).toBe(code);
});

test("a name in a text is a mention: it may be put together with an object", () => {
  const code = 'class A { copy() {} } new A()["copy"]();';
  expect(shaken(code)).toBe(code);
});

test("functions set on objects and handed out in them go with their commas", () => {
  const code =
    "function Maker() { this.a = function () {}; this.b = inner; function inner() {} return { c, d: inner, e() {} }; } Maker().e();";
  expect(shaken(code)).toBe("function Maker() { return { e() {} }; } Maker().e();");
});

test("what is set beside a class goes with it, and an export keeps a name to export", () => {
  const code = "class A {} A.prototype.size = 1; class B {} B.Part = A; export { A, B };";
  expect(shaken(code)).toBe("var A; var B; export { A, B };");
  expect(shaken(code, ["B"])).toBe(code);
});
