// Writes dist/sw.js: the service worker of src/sw/worker.ts with the exact list of the files that were built.

import { createHash } from "node:crypto";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join, relative, sep } from "node:path";
import { type Plugin, type ResolvedConfig, transformWithOxc } from "vite";

/** Built files that the designer never asks for: what other people's pages take is not kept for later either. */
const NOT_CACHED = [/^sw\.js$/, /^\.vite\//, /\.map$/, /^pot\//, /^embed\.html$/];

/** Files that only browsers with SIMD can use, and only those without. */
const SIMD = /\/pasu(_drawing)?_bg-[^/]*\.wasm$/;
const SCALAR = /\/pasu_scalar_bg-[^/]*\.wasm$/;

/** Emits the service worker after everything else has been written. */
export function offline(options: { worker: string }): Plugin {
  let config: ResolvedConfig;
  return {
    name: "pasu:offline",
    apply: "build",
    configResolved(resolved) {
      config = resolved;
    },
    writeBundle: {
      order: "post",
      sequential: true,
      async handler() {
        const folder = join(config.root, config.build.outDir);
        const files = await cachedFiles(folder);
        const paths = files.map((file) => (file === "index.html" ? "./" : `./${file}`));
        const simd = paths.filter((path) => SIMD.test(path));
        const scalar = paths.filter((path) => SCALAR.test(path));
        if (simd.length !== 2 || scalar.length !== 1) throw new Error("the solver's modules are not called as before");
        const all = paths.filter((path) => !simd.includes(path) && !scalar.includes(path));
        const version = await contentHash(folder, files);
        const source = await readFile(options.worker, "utf8");
        const { code } = await transformWithOxc(source, options.worker, { sourcemap: false });
        await writeFile(
          join(folder, "sw.js"),
          code
            .replaceAll("__PASU_PRECACHE__", JSON.stringify({ all, simd, scalar }))
            .replaceAll("__PASU_VERSION__", JSON.stringify(version)),
        );
      },
    },
  };
}

/** The built files worth keeping, as forward-slash paths in alphabetical order. */
async function cachedFiles(folder: string): Promise<string[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join("/"))
    .filter((file) => !NOT_CACHED.some((pattern) => pattern.test(file)))
    .sort();
}

/** One hash over names and contents: a new worker is installed when, and only when, something changed. */
async function contentHash(folder: string, files: string[]): Promise<string> {
  const hash = createHash("sha256");
  for (const file of files) {
    hash.update(`${file}\0`);
    hash.update(await readFile(join(folder, file)));
  }
  return hash.digest("hex").slice(0, 16);
}
