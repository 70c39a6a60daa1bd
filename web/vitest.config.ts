// Unit tests of the front end: no browser, no document object model; the solver runs in Node.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

export default defineConfig({
  resolve: { alias: { pasu: fileURLToPath(new URL("../crates/pasu-wasm/pkg/node.js", import.meta.url)) } },
  test: { environment: "node", include: ["src/**/*.test.ts", "build/**/*.test.ts"], passWithNoTests: true },
});
