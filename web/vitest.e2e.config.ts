// Browser tests: tests/e2e against the built site on a static server. Two files run side by side: while one waits for the
// next frame the other draws. What counts frames runs by itself afterwards. `cargo xtask test` builds the site and finds a browser first.

import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";

const root = fileURLToPath(new URL("..", import.meta.url));
const packages = fileURLToPath(new URL("package.json", import.meta.url));

/** The tests lie outside web/, whose packages they use. */
function packagesOfWeb(): Plugin {
  return {
    name: "pasu:packages-of-web",
    enforce: "pre",
    async resolveId(source, importer) {
      const bare = /^[a-z@]/.test(source) && !source.startsWith("node:");
      if (!bare || importer === undefined || importer === packages || !importer.startsWith(`${root}tests/`))
        return null;
      return await this.resolve(source, packages, { skipSelf: true });
    },
  };
}

const ALONE = ["tests/e2e/drag.test.ts"];

export default defineConfig({
  root,
  plugins: [packagesOfWeb()],
  resolve: { alias: { pasu: fileURLToPath(new URL("../crates/pasu-wasm/pkg/pasu.js", import.meta.url)) } },
  test: {
    environment: "node",
    passWithNoTests: true,
    testTimeout: 60_000,
    hookTimeout: 60_000,
    maxWorkers: 2,
    // As patient as a gesture: what is waited for comes late on a busy machine.
    expect: { poll: { timeout: 30_000 } },
    projects: [
      {
        extends: true,
        test: { name: "together", include: ["tests/e2e/**/*.test.ts"], exclude: ALONE, sequence: { groupOrder: 0 } },
      },
      {
        extends: true,
        test: { name: "alone", include: ALONE, fileParallelism: false, sequence: { groupOrder: 1 } },
      },
    ],
  },
});
