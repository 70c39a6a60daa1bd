// Any number of `<pasu-pot>` on one page: one context, one worker, nothing before one comes near the screen, and nothing left of those that are gone.

import { expect, test } from "vitest";
import type {} from "../../web/pot/pasu-pot.d.ts";
import { counted, type Guest, loaded, town } from "../support/guests.ts";

const here = town();

const HEAD = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Many pots</title>
  <script type="module" src="https://pasu.example/pot/0.1/pasu-pot.js"></script>
  <style>
    main { display: grid; grid-template-columns: repeat(4, 1fr); gap: 8px }
    pasu-pot { width: 100%; height: 200px }
    .far { margin-top: 5000px }
  </style><main>`;

const MANY = 60;
const pots = (many: number, attributes = "") =>
  Array.from({ length: many }, (_, i) => `<pasu-pot src="#1/bloor-wilson?n1=${2 + (i % 9)}" ${attributes}></pasu-pot>`);

/** Files of the element that were asked for since the last time, but for the module that defines it. */
function asked(): readonly string[] {
  return here.site.asked.splice(0).flatMap(({ file }) => (/assets\/(?!define)/.test(file) ? [file] : []));
}

const gone = async (guest: Guest) =>
  await guest.page.evaluate(() => {
    for (const pot of document.querySelectorAll("pasu-pot")) pot.remove();
  });

test("nothing is fetched or made before a pot comes near the screen", async () => {
  asked();
  const guest = await here.open({ html: `${HEAD}<p class="far">${pots(1).join("")}</p>` });
  await guest.page.waitForFunction(() => customElements.get("pasu-pot"));
  await guest.page.evaluate(() => new Promise((resolve) => requestIdleCallback(resolve)));
  expect(asked()).toEqual([]);
  expect(await counted(guest)).toEqual({ contexts: 0, workers: 0, loads: 0 });
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.scrollIntoView());
  await loaded(guest);
  expect(asked().length).toBeGreaterThan(2);
  expect(await counted(guest)).toEqual({ contexts: 1, workers: 1, loads: 1 });
});

test("sixty pots share one context and one worker, and those on the screen come first", async ({ annotate }) => {
  // Events of this name do not reach the window.
  const listening = `<script>document.addEventListener("load", ({ target }) => (window.order ??= []).push(target), true)</script>`;
  const guest = await here.open({ html: `${HEAD}${listening}${pots(MANY).join("")}` });
  const times = await guest.page.evaluate(async () => {
    const all = [...document.querySelectorAll("pasu-pot")];
    const seen = all.filter((pot) => pot.getBoundingClientRect().top < innerHeight);
    while (!seen.every((pot) => pot.loaded)) await new Promise((resolve) => requestAnimationFrame(resolve));
    const ms = Math.round(performance.now());
    const order = (window as unknown as { readonly order: readonly Element[] }).order.filter(
      (each) => each.localName === "pasu-pot",
    );
    return { visible: seen.length, first: seen.filter((pot) => order.indexOf(pot) < seen.length).length, ms };
  });
  await annotate(`${times.visible} visible pots of ${MANY} after ${times.ms} ms`);
  expect(times.visible).toBeGreaterThanOrEqual(12);
  expect(times.first).toBe(times.visible);
  const first = await counted(guest);
  expect(first).toMatchObject({ contexts: 1, workers: 1 });
  // Those far below wait.
  expect(first.loads).toBeLessThan(MANY / 2);
  await guest.page.evaluate(async () => {
    for (const pot of document.querySelectorAll("pasu-pot")) {
      pot.scrollIntoView();
      while (!pot.loaded) await new Promise((resolve) => requestAnimationFrame(resolve));
    }
  });
  expect(await counted(guest)).toEqual({ contexts: 1, workers: 1, loads: MANY });
  await annotate(`all ${MANY} pots after ${await guest.page.evaluate(() => Math.round(performance.now()))} ms`);
  await gone(guest);
  await expect.poll(() => counted(guest)).toMatchObject({ contexts: 0, workers: 0 });
});

test("what was removed leaves nothing behind", async ({ annotate }) => {
  const guest = await here.open({ html: HEAD });
  const session = await guest.context.newCDPSession(guest.page);
  const holding = async () => {
    await session.send("HeapProfiler.collectGarbage");
    await session.send("HeapProfiler.collectGarbage");
    const { usedSize, backingStorageSize } = (await session.send("Runtime.getHeapUsage")) as {
      usedSize: number;
      backingStorageSize: number;
    };
    const { nodes } = (await session.send("Memory.getDOMCounters")) as { nodes: number };
    return { heap: usedSize, arrays: backingStorageSize, nodes };
  };
  const round = async () => {
    await guest.page.evaluate(
      (html) =>
        document
          .querySelector("main")
          ?.replaceChildren(...new DOMParser().parseFromString(html, "text/html").body.children),
      pots(12, 'loading="eager"').join(""),
    );
    await loaded(guest, 12);
    await gone(guest);
    await expect.poll(() => counted(guest)).toMatchObject({ contexts: 0, workers: 0 });
  };
  // Code is compiled once.
  for (let i = 0; i < 2; i += 1) await round();
  const before = await holding();
  const rounds = 4;
  for (let i = 0; i < rounds; i += 1) await round();
  // What the last round left is let go of with the next frames.
  await expect.poll(async () => (await holding()).nodes - before.nodes).toBeLessThan(10);
  const after = await holding();
  await annotate(`before ${JSON.stringify(before)}, after ${rounds} rounds of 12 pots ${JSON.stringify(after)}`);
  // One mesh has 0.4 MB of arrays; one element of these 48 that stayed would show.
  expect(after.arrays - before.arrays).toBeLessThan(200_000);
  expect(after.heap - before.heap).toBeLessThan(1_000_000);
});

test("a pot that is moved lives on, one that comes back is shown again, and hidden ones wait", async () => {
  const guest = await here.open({ html: `${HEAD}${pots(2).join("")}<aside></aside>` });
  await loaded(guest, 2);
  const { loads } = await counted(guest);
  const moved = await guest.page.evaluate(async () => {
    const pot = document.querySelector("pasu-pot") as HTMLElementTagNameMap["pasu-pot"];
    const canvas = () => pot.shadowRoot?.querySelector(".stage canvas");
    const before = canvas();
    document.querySelector("aside")?.append(pot);
    await new Promise((resolve) => setTimeout(resolve));
    return { same: canvas() === before, loaded: pot.loaded };
  });
  expect(moved).toEqual({ same: true, loaded: true });
  expect((await counted(guest)).loads).toBe(loads);
  const link = await guest.page.evaluate(async () => {
    const pot = document.querySelector("pasu-pot") as HTMLElementTagNameMap["pasu-pot"];
    pot.remove();
    await new Promise((resolve) => setTimeout(resolve));
    const freed = pot.loaded;
    document.querySelector("main")?.append(pot);
    while (!pot.loaded) await new Promise((resolve) => requestAnimationFrame(resolve));
    return [freed, pot.link];
  });
  expect(link).toEqual([false, "#1/bloor-wilson?n1=3"]);
  expect(await counted(guest)).toMatchObject({ contexts: 1, workers: 1 });
});
