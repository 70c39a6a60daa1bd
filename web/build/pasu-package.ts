// What every build of the page's code shares: where the package is that holds the solver, and how a worker's file is called.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const PACKAGE = "../../crates/pasu-wasm/pkg/";
const inPackage = (file: string) => fileURLToPath(new URL(PACKAGE + file, import.meta.url));
const folderOf = (module: string | null) => module?.split("/").at(-2);

/** The package as it was built. */
export const aliases = { "pasu/drawing": inPackage("drawing.js"), pasu: inPackage("pasu.js") };

/** The version of everything that is built here. */
export function version(): string {
  return (JSON.parse(readFileSync(inPackage("package.json"), "utf8")) as { version: string }).version;
}

/** A worker is called like its folder, by which web/weight.json knows it. */
export const workers = {
  format: "es" as const,
  rolldownOptions: {
    output: {
      entryFileNames: (chunk: { facadeModuleId: string | null }) =>
        `assets/${folderOf(chunk.facadeModuleId) ?? "[name]"}-[hash].js`,
    },
  },
};
