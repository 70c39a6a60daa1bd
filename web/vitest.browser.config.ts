// What everything that runs in a browser under vitest shares: the browser tests, the benchmarks, the pictures of the documents.

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
    passWithNoTests: true,
    fileParallelism: false,
    testTimeout: 300_000,
    hookTimeout: 120_000,
    // As patient as a gesture: what is waited for comes late on a busy machine.
    expect: { poll: { timeout: 120_000 } },
  },
});
