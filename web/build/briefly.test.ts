import { expect, test } from "vitest";
import { briefly } from "./briefly";

test("shaders lose remarks and indentation, and keep their lines", () => {
  const code = `const A = /* glsl */ \`
precision highp float;
#if MAPPED
  // Two lines
  // of a remark.
  float a = 1.0 / 2.0;  // and one behind it
#endif
/* Of several
   lines. */
\${MORE_GLSL}
void main() {

  discard;
}
\`;
// a remark of the code`;
  expect(briefly(code)).toBe(
    `const A = \`
precision highp float;
#if MAPPED
float a = 1.0 / 2.0;
#endif
\${MORE_GLSL}
void main() {
discard;
}
\`;
// a remark of the code`,
  );
});

test("style sheets lose remarks and indentation, and nothing that tells two words apart", () => {
  const code =
    'static styles = [base, css`\n  .a,\n  .b {\n    /* why */\n    grid-template:\n      "x y" auto\n      / 1fr;\n  }\n`];\nconst x = `\n  left alone\n`;';
  expect(briefly(code)).toBe(
    'static styles = [base, css` .a, .b { grid-template: "x y" auto / 1fr; } `];\nconst x = `\n  left alone\n`;',
  );
});
