// Browser tests: tests/e2e against the built site on a static server, one file after the other, because software WebGL
// takes every core there is. `cargo xtask test` builds the site and finds a browser first.

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

export default defineConfig({
  root,
  plugins: [packagesOfWeb()],
  resolve: { alias: { pasu: fileURLToPath(new URL("../crates/pasu-wasm/pkg/pasu.js", import.meta.url)) } },
  test: {
    environment: "node",
    include: ["tests/e2e/**/*.test.ts"],
    passWithNoTests: true,
    fileParallelism: false,
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
