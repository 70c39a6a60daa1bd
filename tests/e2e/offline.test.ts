// The copy of the site that the service worker keeps: what is in it, and how it mends itself.

import { cp, mkdtemp, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "vitest";
import { launch } from "../support/browser.ts";
import { DIST } from "../support/server.ts";
import { stay } from "../support/stay.ts";
import { COARSE, type Visit, visit } from "../support/visit.ts";

const here = stay({}, { ...COARSE, painted: false });
const LINK = "#1/second-order";

/** What is there for other people's pages, which the designer never asks for. */
const FOR_OTHERS = /^pot\/|^embed\.html$/;

/** The files of the designer, as addresses below the site. */
async function files(): Promise<string[]> {
  const entries = await readdir(DIST, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(DIST.length + 1))
    .filter((file) => file !== "sw.js" && !file.startsWith(".vite") && !FOR_OTHERS.test(file))
    .map((file) => (file === "index.html" ? "" : file));
}

/** What the copy holds. */
async function kept(pot: Visit): Promise<string[]> {
  return await pot.page.evaluate(async () => {
    const found: string[] = [];
    for (const name of await caches.keys()) {
      for (const { url } of await (await caches.open(name)).keys())
        found.push(url.replace(document.baseURI.replace(/#.*/, ""), ""));
    }
    return found.sort();
  });
}

/** Opens the page and waits until all of the copy is there. */
async function settled(pot: Visit, expected: readonly string[]): Promise<void> {
  await pot.fingerprint();
  await expect.poll(() => kept(pot)).toEqual([...expected].sort());
  await pot.page.evaluate(async () => {
    const { serviceWorker } = navigator;
    if (!serviceWorker.controller) {
      await new Promise((resolve) => serviceWorker.addEventListener("controllerchange", resolve, { once: true }));
    }
  });
}

const SCALAR = /pasu_scalar_bg/;
const SIMD = /pasu(_drawing)?_bg/;

test("a browser with SIMD keeps everything but the module without, and one without the reverse", async () => {
  const all = await files();
  expect(all.filter((file) => SCALAR.test(file))).toHaveLength(1);
  expect(all.filter((file) => SIMD.test(file))).toHaveLength(2);
  const pot = await here.enter({ link: LINK });
  await settled(
    pot,
    all.filter((file) => !SCALAR.test(file)),
  );
  const old = await launch({ flags: ["--js-flags=--no-enable-sse4-1 --no-enable-ssse3 --no-enable-avx"] });
  try {
    const there = await visit(old, here.site.url, { ...COARSE, link: LINK });
    const fingerprint = await there.fingerprint();
    expect(fingerprint).toBe(await pot.fingerprint());
    await settled(
      there,
      all.filter((file) => !SIMD.test(file)),
    );
    await there.goOffline();
    await there.page.reload();
    await there.shows(fingerprint);
    await there.leave();
  } finally {
    await old.close();
  }
});

test("a copy that lost files has them again after the next visit", async () => {
  const all = (await files()).filter((file) => !SCALAR.test(file));
  const pot = await here.enter({ link: LINK });
  await settled(pot, all);
  const lost = await pot.page.evaluate(async () => {
    const [name] = await caches.keys();
    const cache = await caches.open(name as string);
    const keys = await cache.keys();
    // The page itself, what it asks for at once, and what it asks for only when it is needed.
    const gone = keys.filter(({ url }) => /\/pot\/$|index-[^/]*\.js|gallery-dialog|pasu_bg/.test(url));
    for (const key of gone) await cache.delete(key);
    return gone.length;
  });
  expect(lost).toBe(4);
  await pot.page.reload();
  await settled(pot, all);
  const fingerprint = await pot.fingerprint();
  await pot.goOffline();
  await pot.page.reload();
  await pot.shows(fingerprint);
  await pot.command("Gallery");
  await expect.poll(() => pot.page.locator("pasu-gallery canvas").first().getAttribute("data-drawn")).toBe("true");
});

test("a copy that was emptied is there again after the next visit", async () => {
  const all = (await files()).filter((file) => !SCALAR.test(file));
  const pot = await here.enter({ link: LINK });
  await settled(pot, all);
  await pot.page.evaluate(async () => {
    for (const name of await caches.keys()) await caches.delete(name);
  });
  await pot.page.reload();
  await settled(pot, all);
  const fingerprint = await pot.fingerprint();
  await pot.goOffline();
  await pot.page.reload();
  await pot.shows(fingerprint);
});

test("a copy is mended with files of its own version alone", async () => {
  const all = (await files()).filter((file) => !SCALAR.test(file));
  const pot = await here.enter({ link: LINK });
  await settled(pot, all);
  const next = await mkdtemp(join(tmpdir(), "pasu-"));
  try {
    await cp(DIST, next, { recursive: true });
    const page = join(next, "index.html");
    await writeFile(page, (await readFile(page, "utf8")).replaceAll(/index-[\w-]{8}\.css/g, "index-01234567.css"));
    here.site.replace(next);
    // Files are put back one after the other, the page before the manifest.
    await pot.page.evaluate(async () => {
      const [name] = await caches.keys();
      const cache = await caches.open(name as string);
      for (const file of ["./", "./manifest.webmanifest"]) await cache.delete(file);
      await (await fetch("./")).text();
      navigator.serviceWorker.controller?.postMessage({ type: "pasu:idle" });
    });
    await expect.poll(async () => (await kept(pot)).includes("manifest.webmanifest")).toBe(true);
    expect(await kept(pot)).toEqual(all.filter((file) => file !== "").sort());
  } finally {
    here.site.replace(DIST);
    await rm(next, { recursive: true });
  }
  await pot.page.reload();
  await settled(pot, all);
});
