// Leaves out of shaders and style sheets what only their readers need, remarks and indentation: they are texts in the code, which no compiler of it shortens.

import type { Plugin } from "vite";

const SHADER = /\/\* glsl \*\/ `[^`]*`/g;
const SHEET = /(?<![\w$.])css`[^`]*`/g;

/** The same code with shorter texts. Line ends stay in shaders, where directives end with them. */
export function briefly(code: string): string {
  return code
    .replace(SHADER, (shader) =>
      shader
        .replace("/* glsl */ ", "")
        .replace(/\/\*[\s\S]*?\*\//g, "")
        .replace(/\/\/.*$/gm, "")
        .replace(/[^\S\n]*\n\s*/g, "\n"),
    )
    .replace(SHEET, (sheet) => sheet.replace(/\/\*[\s\S]*?\*\//g, "").replace(/\s*\n\s*/g, " "));
}

export function brief(): Plugin {
  return {
    name: "pasu:briefly",
    apply: "build",
    enforce: "pre",
    transform: {
      filter: { id: /[\\/]src[\\/].*\.ts$/ },
      handler: (code) => ({ code: briefly(code), map: null }),
    },
  };
}
