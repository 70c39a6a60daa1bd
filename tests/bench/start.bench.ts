// The start of the built designer: from navigation to the first picture, in a browser that has never been here, and what has
// to travel for it.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import type { Browser } from "playwright-core";
import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { DIST, ISOLATED, serve } from "../support/server.ts";
import { visit } from "../support/visit.ts";
import { QUICK, record } from "./rows.ts";

const TURNS = QUICK ? 3 : 11;
const LINK = "#1/second-order";

/** Milliseconds since navigation, and the files that were asked for until the picture. */
interface Start {
  readonly solver: number;
  readonly renderer: number;
  readonly asked: number;
  readonly solved: number;
  readonly drawn: number;
  readonly files: readonly string[];
}

test("start", async () => {
  const site = await serve(undefined, 0, () => ISOLATED);
  const browser = await launch();
  try {
    const starts: Start[] = [];
    // The first visit of a browser finds nothing of itself ready either.
    for (let turn = 0; turn <= TURNS; turn += 1) starts.push(await started(browser, site.url));
    starts.shift();
    const row = (name: string, of: (start: Start) => number, note?: string) => ({
      name,
      samples: starts.map(of),
      ...(note === undefined ? {} : { note }),
    });
    record({
      group: "start, since navigation",
      unit: "ms",
      rows: [
        row("the solver's module is there", ({ solver }) => solver),
        row("the renderer is there", ({ renderer }) => renderer),
        row("first question to the solver", ({ asked }) => asked),
        row("first mesh", ({ solved }) => solved),
        row("first picture", ({ drawn }) => drawn, weights(starts[0]?.files ?? [])),
      ],
    });
  } finally {
    await browser.close();
    await site.close();
  }
});

/** One visit in a fresh profile. */
async function started(browser: Browser, url: string): Promise<Start> {
  const pot = await visit(browser, url, {
    link: LINK,
    before: async ({ context }) => {
      await context.addInitScript(() => {
        const moments: Record<string, number> = {};
        const measured = globalThis as unknown as { pasuTrace(moment: string): void; pasuStart: Promise<object> };
        measured.pasuStart = new Promise((resolve) => {
          measured.pasuTrace = (moment) => {
            if (moments[moment] !== undefined) return;
            if (moment === "drawn") {
              const stage = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-stage");
              const gl = stage?.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
              // Waits until the GPU has drawn it.
              gl?.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
              gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
            }
            moments[moment] = performance.now();
            if (moment === "drawn") resolve(moments);
          };
        });
      });
    },
  });
  const start = await pot.page.evaluate(async () => {
    const moments = (await (globalThis as unknown as { pasuStart: Promise<object> }).pasuStart) as Record<
      "asked" | "solved" | "drawn",
      number
    >;
    const fetched = performance.getEntriesByType("resource") as PerformanceResourceTiming[];
    const there = (pattern: RegExp) => fetched.find(({ name }) => pattern.test(name))?.responseEnd ?? Number.NaN;
    const before = fetched.filter(({ startTime }) => startTime < moments.drawn);
    return {
      ...moments,
      solver: there(/\.wasm$/),
      renderer: there(/tableau-[^/]*\.js$/),
      files: before.map(({ name }) => name),
    };
  });
  await pot.leave();
  return start;
}

/** What was fetched for the picture, by part, as a host sends it. */
function weights(files: readonly string[]): string {
  const parts = { wasm: 0, drawing: 0, page: gzipped("index.html") };
  for (const address of new Set(files)) {
    const file = /assets\/[^/?]*$/.exec(address)?.[0];
    if (!file) continue;
    const part = file.endsWith(".wasm") ? "wasm" : /\/(tableau|stage)-/.test(file) ? "drawing" : "page";
    parts[part] += gzipped(file);
  }
  const all = parts.wasm + parts.drawing + parts.page;
  const kilobytes = (bytes: number) => `${(bytes / 1000).toFixed(1)} kB`;
  return `${kilobytes(all)} gzip until then: wasm ${kilobytes(parts.wasm)}, drawing ${kilobytes(parts.drawing)}, page ${kilobytes(parts.page)}.`;
}

function gzipped(file: string): number {
  return gzipSync(readFileSync(join(DIST, file)), { level: 9 }).length;
}
