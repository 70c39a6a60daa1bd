// How the designer is built: relative addresses so that it runs from any folder of a static host, one chunk per
// thing that changes at its own pace, a strict Content-Security-Policy and a service worker.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { brief } from "./build/briefly.ts";
import { contentSecurityPolicy } from "./build/content-security-policy.ts";
import { offline } from "./build/offline.ts";
import { aliases, workers } from "./build/pasu-package.ts";
import { potFolder, potOnSite } from "./build/pot.ts";
import { preload } from "./build/preload.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const DRAWING =
  /[\\/]src[\\/]render[\\/](?!stage\.ts|thumbnail\.ts|(?:made|pull|place|inside|under|contrast)[\\/])|[\\/]node_modules[\\/](twgl\.js|gl-matrix)[\\/]/;
/** What is said before anything is opened: the rest of the words comes with what says it. */
const WORDS =
  /[\\/]src[\\/](language|number|words[\\/](english[\\/](controls|description|page|parameters|quantities|refusals)|description|languages|parameters|parts|quantities|refusals|typed))\.ts/;
/** Symbols of equations are written with it by the panel and on paper, the button that explains is in every panel of numbers, and how far points reach is told before anything is drawn: they are too little to be files of their own. */
const LIT =
  /[\\/]node_modules[\\/](lit|lit-html|lit-element|@lit)[\\/]|[\\/]src[\\/](ui[\\/]symbol|app[\\/]panels[\\/]explain-button|document[\\/](box|extents))\.ts/;

export default defineConfig({
  base: "./",
  // A path that does not exist is an honest 404, in development and preview as on a static host.
  appType: "mpa",
  clearScreen: false,
  resolve: { alias: aliases },
  server: { fs: { allow: [here("..")] } },
  worker: workers,
  // Where pages of other people find the element.
  define: { __PASU_POT__: JSON.stringify(potFolder()) },
  build: {
    target: "es2022",
    outDir: "dist",
    emptyOutDir: true,
    manifest: true,
    // Small pictures as data: addresses would escape the offline list and the weight report.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    // The weight that counts is measured, gzipped, by `cargo xtask build`.
    chunkSizeWarningLimit: 1000,
    rolldownOptions: {
      output: {
        codeSplitting: {
          groups: [
            // What draws, in one piece: the parts that are fetched later share it.
            { name: "tableau", test: DRAWING },
            { name: "words", test: WORDS },
            { name: "lit", test: LIT },
          ],
        },
      },
    },
  },
  plugins: [
    brief(),
    contentSecurityPolicy(),
    potOnSite(),
    preload({ renderer: here("src/render/stage.ts") }),
    offline({ worker: here("src/sw/worker.ts") }),
  ],
});
