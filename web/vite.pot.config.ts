// How the element for other people's pages is built: one module that defines it, whatever is only needed once a pot comes near the screen in
// modules of their own beside it, worker and WebAssembly among them, all found by their place relative to it, whatever the page's address is.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { brief } from "./build/briefly.ts";
import { aliases, workers } from "./build/pasu-package.ts";
import { POT_PACKAGE, potPackage } from "./build/pot.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  base: "./",
  publicDir: false,
  clearScreen: false,
  resolve: { alias: aliases },
  // In one file each: a bundler that takes the package copies a worker's file and knows nothing of what that imports.
  worker: {
    ...workers,
    rolldownOptions: { output: { ...workers.rolldownOptions.output, codeSplitting: false } },
  },
  build: {
    target: "es2022",
    outDir: POT_PACKAGE,
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: false,
    reportCompressedSize: false,
    chunkSizeWarningLimit: 1000,
    rolldownOptions: {
      input: { "pasu-pot": here("src/element/pot/define.ts"), embed: here("src/embed.ts") },
      preserveEntrySignatures: "exports-only",
      output: { entryFileNames: "[name].js", chunkFileNames: "assets/[name]-[hash].js" },
    },
  },
  plugins: [brief(), potPackage()],
});
