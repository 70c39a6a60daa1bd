// The examples of docs/embedding.md, each opened as it is, and the policies that it states.

import { execFileSync } from "node:child_process";
import { cp, mkdir, mkdtemp, rm, symlink } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import type {} from "../../web/pot/pasu-pot.d.ts";
import { findings } from "../support/axe.ts";
import { counted, EXAMPLES, loaded, town } from "../support/guests.ts";
import { sight } from "../support/sight.ts";

const here = town();
const inWeb = (path: string) => fileURLToPath(new URL(`../../web/${path}`, import.meta.url));
let project = "";

beforeAll(async () => {
  // A project of React's has a bundler, which takes the element from its npm package.
  project = await mkdtemp(join(tmpdir(), "pasu-react-"));
  await cp(join(EXAMPLES, "react"), project, { recursive: true });
  const modules = join(project, "node_modules");
  await mkdir(modules);
  for (const name of ["react", "react-dom"]) await symlink(inWeb(`node_modules/${name}`), join(modules, name));
  await symlink(inWeb("pot/pkg"), join(modules, "pasu-pot"));
  const vite = ["build", "--base", "./", "--target", "es2022", "--logLevel", "error"];
  execFileSync(process.execPath, [inWeb("node_modules/vite/bin/vite.js"), ...vite], { cwd: project });
  here.add("react", join(project, "dist"));
});

afterAll(async () => {
  await rm(project, { recursive: true });
});

test("an ES module makes the element and hears its events", async () => {
  const guest = await here.open("module.html");
  await guest.page.getByText("4 dints").waitFor();
  const field = guest.page.getByRole("spinbutton", { name: "Number of dints" });
  await field.fill("6");
  await field.blur();
  await guest.page.getByText("6 dints: #1/bloor-wilson?n1=6").waitFor();
  expect(await findings(guest)).toEqual([]);
});

for (const [name, path] of [
  ["React", "react/index.html"],
  ["Vue", "vue.html"],
] as const) {
  test(`${name} sets its attributes and hears its events`, async () => {
    const guest = await here.open(path);
    await guest.page.getByText("#1/bloor-wilson?n1=5").waitFor();
    await guest.page.getByLabel("Dints").fill("3");
    await guest.page.getByText("#1/bloor-wilson?n1=3").waitFor();
    expect(sight(await guest.page.locator("pasu-pot").screenshot()).tones).toBeGreaterThan(100);
    expect(await counted(guest)).toMatchObject({ contexts: 1, workers: 1 });
  });
}

test("through a bundler a pot shows what takes the whole module, too", async () => {
  const { page } = await here.open("react/index.html");
  await page.waitForFunction(() => document.querySelector("pasu-pot")?.loaded);
  const section = (radius: number, z: number) =>
    ({ form: "rectangle", radius: [radius, radius], z, taper: 0, dz: 6 }) as const;
  const shape = { kind: "blend", start: section(2, 0), end: section(3, 6) };
  for (const part of [
    { shape },
    { shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 2 }, wall: { thickness: 0.05, base: 0.05 } },
  ]) {
    await page.evaluate(async (part) => {
      const pot = document.querySelector("pasu-pot");
      if (!pot) throw new Error("there is no pot");
      const ended = new Promise<void>((resolve, reject) => {
        pot.addEventListener("load", () => resolve(), { once: true });
        pot.addEventListener("error", ({ detail }) => reject(new Error(detail.message)), { once: true });
      });
      pot.design = { pasu: 1, parts: [part] } as never;
      await ended;
    }, part);
    expect(sight(await page.locator("pasu-pot").screenshot()).tones).toBeGreaterThan(100);
  }
});

test("on a slide a pot is there when its turn comes, and the keys are the slides' until it has the focus", async () => {
  const guest = await here.open("slides.html");
  const { page } = guest;
  await page.locator(".reveal.ready").waitFor();
  expect(await page.locator("section.present h1").isVisible()).toBe(true);
  await page.keyboard.press("ArrowRight");
  await loaded(guest);
  const pot = page.locator("pasu-pot");
  expect(sight(await pot.screenshot()).tones).toBeGreaterThan(100);
  const orbit = () => page.evaluate(() => String(document.querySelector("pasu-pot")?.getCameraOrbit()));
  const before = await orbit();
  await pot.click();
  await page.keyboard.press("ArrowLeft");
  await expect.poll(orbit).not.toBe(before);
  expect(await page.locator("section.present h2").isVisible()).toBe(true);
});

test("a frame that may run scripts and nothing else shows a pot", async () => {
  const guest = await here.open("frame.html");
  const frame = guest.page.frameLocator("iframe");
  await frame.locator("pasu-pot").waitFor();
  const inner = guest.page.frames()[1];
  if (!inner) throw new Error("there is no frame");
  await inner.waitForFunction(() => document.querySelector("pasu-pot")?.loaded);
  expect(await inner.evaluate(() => [document.querySelector("pasu-pot")?.alt, globalThis.origin])).toEqual([
    "A small vase with five dints",
    "null",
  ]);
  expect(sight(await guest.page.locator("iframe").screenshot()).tones).toBeGreaterThan(200);
});

const html = (body: string) =>
  `<!doctype html><html lang="en"><meta charset="utf-8"><title>A page</title>
  <script type="module" src="https://pasu.example/pot/0.1/pasu-pot.js"></script><body>${body}`;

test("a strict policy that names the element's origin is enough", async () => {
  const { origin } = new URL(here.site.url);
  const policy = [
    "default-src 'none'",
    `script-src ${origin} 'wasm-unsafe-eval'`,
    "worker-src blob:",
    `connect-src ${origin}`,
  ].join("; ");
  const pot = '<pasu-pot src="#1/second-order" controls="height"></pasu-pot>';
  const guest = await here.open({ html: html(pot) }, { headers: { "content-security-policy": policy } });
  await loaded(guest);
  await guest.page.getByRole("slider").waitFor();
  expect(await counted(guest)).toMatchObject({ contexts: 1, workers: 1 });
});

test.each(["worker-src 'none'", "require-trusted-types-for 'script'"])(
  "a policy that forbids the worker is told, and what the page put there instead stays: %s",
  async (forbidding) => {
    const { origin } = new URL(here.site.url);
    const policy = `script-src ${origin} 'unsafe-inline' 'wasm-unsafe-eval'; ${forbidding}`;
    const listening =
      "<script>addEventListener('error', ({ detail }) => { document.title = detail?.code }, true)</script>";
    const pot = '<pasu-pot src="#1/second-order"><p slot="poster">A vase</p></pasu-pot>';
    const guest = await here.open(
      { html: html(listening + pot) },
      { headers: { "content-security-policy": policy }, expected: /Content Security Policy|violates|TrustedScriptURL/ },
    );
    await guest.page.getByText("This pot could not be shown.").waitFor();
    await expect.poll(() => guest.page.title()).toBe("solver-stopped");
    expect(await guest.page.getByText("A vase").isVisible()).toBe(true);
  },
);
