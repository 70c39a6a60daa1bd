// On a static host: below any path, under a strict policy, without a network, and across a new version.

import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "vitest";
import { DIST } from "../support/server.ts";
import { stay } from "../support/stay.ts";
import { COARSE, type Visit } from "../support/visit.ts";

const here = stay({}, { ...COARSE, painted: false });

/** Waits until the copy for later is complete and answers for this page. */
async function copied(pot: Visit): Promise<void> {
  await pot.page.evaluate(async () => {
    const { serviceWorker } = navigator;
    await serviceWorker.ready;
    if (!serviceWorker.controller) {
      await new Promise((resolve) => serviceWorker.addEventListener("controllerchange", resolve, { once: true }));
    }
  });
}

test("the first picture comes soon", async ({ annotate }) => {
  const pot = await here.enter();
  const found = await pot.page.waitForFunction(() => {
    const app = document.querySelector<HTMLElement>("pasu-app");
    const stage = app?.shadowRoot?.querySelector("pasu-stage")?.shadowRoot;
    const pictured = stage?.querySelector(".host canvas") && !stage.querySelector(".wheel");
    return app?.dataset.state === "ready" && pictured ? performance.now() : null;
  });
  const ms = Math.round((await found.jsonValue()) ?? 0);
  await annotate(`first picture after ${ms} ms`);
  expect(ms).toBeGreaterThan(0);
});

test("the policy is strict, and what breaks it is noticed", async () => {
  const pot = await here.enter();
  await pot.fingerprint();
  const policy = await pot.page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  expect(policy).toContain("default-src");
  expect(policy).not.toMatch(/unsafe-inline|'unsafe-eval'|https?:|\*/);
  expect(pot.troubles).toEqual([]);
  await pot.page.evaluate(() => {
    const image = document.createElement("img");
    image.src = "https://example.invalid/pixel.png";
    document.body.append(image);
    document.body.setAttribute("style", "color: red");
  });
  await expect.poll(() => pot.troubles.filter((each) => each.startsWith("policy: ")).length).toBe(2);
  pot.troubles.length = 0;
});

test("after the first visit everything works without a network", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  await copied(pot);
  await pot.goOffline();
  await pot.page.reload();
  await pot.shows(before);
  await pot.drag("Height", 0.8);
  await pot.fingerprintOtherThan(before);
  await pot.command("Gallery");
  const canvas = pot.page.locator("pasu-gallery canvas").first();
  await expect.poll(() => canvas.getAttribute("data-drawn")).toBe("true");
  await pot.page.goto("about:blank");
  await pot.page.goto(`${pot.url}?from=a-bookmark#1/bloor-wilson?n1=3`);
  await pot.dialog("Open this link?").waitFor();
});

test("a new version says so, takes over on reload and keeps the work", async () => {
  const next = await mkdtemp(join(tmpdir(), "pasu-"));
  try {
    const pot = await here.enter({ link: "#1/second-order" });
    const before = await pot.fingerprint();
    await copied(pot);
    await pot.type("Height", "5");
    const mine = await pot.fingerprintOtherThan(before);
    await cp(DIST, next, { recursive: true });
    const page = join(next, "index.html");
    await writeFile(page, (await readFile(page, "utf8")).replace("<body", '<body data-version="next"'));
    const worker = join(next, "sw.js");
    const text = await readFile(worker, "utf8");
    const other = text.replace(/"[0-9a-f]{16}"/, '"0123456789abcdef"');
    expect(other).not.toBe(text);
    await writeFile(worker, other);
    here.site.replace(next);
    await pot.page.evaluate(async () => {
      await (await navigator.serviceWorker.ready).update();
    });
    await pot.page.getByText("A new version of Pasu is ready").waitFor();
    await pot.shows(mine);
    await pot.button("Reload").click();
    await pot.page.locator('body[data-version="next"]').waitFor();
    await pot.shows(mine);
  } finally {
    here.site.replace(DIST);
    await rm(next, { recursive: true });
  }
});
