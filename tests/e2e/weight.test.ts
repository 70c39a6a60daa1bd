// What a browser that was never here asks for until the first picture is on the screen, and what that weighs.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { expect, test } from "vitest";
import { DIST, serve } from "../support/server.ts";
import { stay } from "../support/stay.ts";
import { COARSE, SHARP, type Visit, visit } from "../support/visit.ts";

const here = stay();

/** `web/weight.json`: the files of the first picture, by their names without the hash, and how many bytes they may be, each as gzip. */
const RULES = JSON.parse(readFileSync(fileURLToPath(new URL("../../web/weight.json", import.meta.url)), "utf8")) as {
  readonly budget: number;
  readonly first: readonly string[];
};

/** `assets/index-0a1b2c3d.js` as `assets/index.js`. */
const plain = (file: string) => file.replace(/^(assets\/.*)-[\w-]{8}(\.\w+)$/, "$1$2");

/** Notes when the first picture was drawn. That a slow GPU is done with it later makes no difference to what it took. */
async function watchPicture({ context }: Visit): Promise<void> {
  await context.addInitScript(() => {
    const watched = globalThis as unknown as { pasuTrace(moment: string): void; pasuPictured: Promise<number> };
    watched.pasuPictured = new Promise((resolve) => {
      watched.pasuTrace = (moment) => {
        if (moment === "drawn") resolve(Date.now());
      };
    });
  });
}

test.for([
  ["the first visit", "", COARSE],
  ["a link", "#1/bloor-wilson?n1=5", COARSE],
  ["a sharp picture", "", SHARP],
] as const)(
  "until the first picture a browser asks for what is listed, within the budget: %s",
  async ([_, link, options], { annotate, onTestFinished }) => {
    // A site of its own: for a page that was left a moment ago the copy for later may still be under way.
    const site = await serve();
    onTestFinished(() => site.close());
    const pot = await visit(here.browser, site.url, { ...options, link, before: watchPicture });
    const pictured = await pot.page.evaluate(
      () => (globalThis as unknown as { pasuPictured: Promise<number> }).pasuPictured,
    );
    const until = site.asked.filter(({ at }) => at <= pictured).map(({ file }) => file);
    expect([...new Set(until)]).toHaveLength(until.length);
    const sizes = until.map((file) => gzipSync(readFileSync(join(DIST, file)), { level: 9 }).length);
    const sum = sizes.reduce((a, b) => a + b, 0);
    const lines = until.map((file, i) => `${((sizes[i] ?? 0) / 1000).toFixed(1)} kB ${plain(file)}`);
    await annotate(`${(sum / 1000).toFixed(1)} kB until the first picture:\n${lines.join("\n")}`);
    // What is asked for beside the pot may come a moment later on another machine: the list has all of it.
    expect(until.map(plain).filter((file) => !RULES.first.includes(file))).toEqual([]);
    expect(sum).toBeLessThanOrEqual(RULES.budget);
    await expect
      .poll(() => RULES.first.filter((file) => !site.asked.some((asked) => plain(asked.file) === file)))
      .toEqual([]);
    await pot.leave();
    expect(site.missing).toEqual([]);
  },
);
