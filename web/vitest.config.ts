// Unit tests of the front end: no browser, no document object model; the solver runs in Node.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const inPackage = (file: string) => fileURLToPath(new URL(`../crates/pasu-wasm/pkg/${file}`, import.meta.url));

export default defineConfig({
  resolve: { alias: { "pasu/drawing": inPackage("drawing.js"), pasu: inPackage("pasu.js") } },
  test: {
    environment: "node",
    include: ["src/**/*.test.ts", "build/**/*.test.ts"],
    passWithNoTests: true,
    // No test judges a time: solver and maker are the real ones, and a machine may be busy.
    testTimeout: 120_000,
    expect: { poll: { timeout: 60_000 } },
  },
});
