// The part of `cargo xtask bench` that runs on a blank page of Chromium: the same groups as in Node.

import { readFile } from "node:fs/promises";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { type Group, QUICK, record } from "./rows.ts";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
/** Secure by its name, and never asked for over a network. */
const ORIGIN = "http://localhost";
const TYPES: Readonly<Record<string, string>> = {
  ".js": "text/javascript",
  ".json": "application/json",
  ".mjs": "text/javascript",
  ".wasm": "application/wasm",
};
/** Isolated from other origins: the clock then goes in steps of 5 microseconds in place of 100. */
const ISOLATED = { "cross-origin-opener-policy": "same-origin", "cross-origin-embedder-policy": "require-corp" };
const PAGE = `<!doctype html>
<title>Bench</title>
<script type="importmap">{ "imports": { "three": "/web/node_modules/three/build/three.module.js" } }</script>
<script type="module" src="/tests/bench/page.mjs"></script>`;

test("kernel", async () => {
  const browser = await launch({ webgl: false, flags: ["--js-flags=--expose-gc"] });
  try {
    const page = await browser.newPage();
    const failed = new Promise<never>((_, fail) => page.on("pageerror", fail));
    await serveRepository(page);
    await page.exposeFunction("handOver", (group: Group) => record(group));
    await page.goto(`${ORIGIN}/`);
    const done = page.evaluate((quick) => globalThis.measure({ quick }), QUICK);
    await Promise.race([done, failed]);
  } finally {
    await browser.close();
  }
});

/** Lets a page load files of the repository. */
async function serveRepository(page: Page): Promise<void> {
  await page.route(`${ORIGIN}/**`, async (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname === "/") {
      await route.fulfill({ body: PAGE, contentType: "text/html", headers: ISOLATED });
      return;
    }
    const body = await readFile(`${ROOT}${pathname}`).catch(() => undefined);
    const contentType = TYPES[extname(pathname)] ?? "application/octet-stream";
    await route.fulfill(body === undefined ? { status: 404 } : { body, contentType, headers: ISOLATED });
  });
}

declare global {
  /** Of page.mjs. */
  var measure: (options: { quick: boolean }) => Promise<void>;
}
