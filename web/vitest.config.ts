// Unit tests of the front end: no browser, no document object model; the solver runs in Node.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const packaged = (file: string) => fileURLToPath(new URL(`../crates/pasu-wasm/pkg/${file}`, import.meta.url));

export default defineConfig({
  resolve: { alias: { "pasu/drawing": packaged("drawing.js"), pasu: packaged("pasu.js") } },
  test: { environment: "node", include: ["src/**/*.test.ts", "build/**/*.test.ts"], passWithNoTests: true },
});
