// Unit tests of the front end: no browser, no document object model; the solver runs in Node.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const inPackage = (file: string) => fileURLToPath(new URL(`../crates/pasu-wasm/pkg/${file}`, import.meta.url));

/** What is about the first call of the library in a page. */
const FRESH = ["src/solver/perform.test.ts", "src/work/keeper.test.ts"];

export default defineConfig({
  resolve: { alias: { "pasu/drawing": inPackage("drawing.js"), pasu: inPackage("pasu.js") } },
  test: {
    environment: "node",
    passWithNoTests: true,
    maxWorkers: 2,
    // No test judges a time: solver and maker are the real ones, and a machine may be busy.
    testTimeout: 120_000,
    expect: { poll: { timeout: 60_000 } },
    projects: [
      {
        extends: true,
        // Files share what they import: to load the library and its module anew for each took longer than most of them.
        test: {
          name: "together",
          include: ["src/**/*.test.ts", "build/**/*.test.ts"],
          exclude: FRESH,
          isolate: false,
          sequence: { groupOrder: 0 },
        },
      },
      { extends: true, test: { name: "fresh", include: FRESH, sequence: { groupOrder: 1 } } },
    ],
  },
});
