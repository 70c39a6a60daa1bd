// The equation beside the pot: its numbers are those of the fields, they light up together, and they follow the hand.

import type { Locator } from "playwright-core";
import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stageOf } from "../support/on-stage.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();

const VASE = "#1/second-order?r=1,0.1,0.6,0.06";
const BOTTLE = "#1/rings?r=3,6~3:.5,1.6,2.2&z=0,6,15,20&u=.35,.7&sharp=2";

async function enter(link: string, options: VisitOptions = {}): Promise<Visit> {
  const pot = await here.enter({ link, ...options });
  await pot.fingerprint();
  await pot.tab("Equation");
  await pot.page.locator("pasu-formula math").first().waitFor();
  return pot;
}

/** A formula by its name. */
function formula(pot: Visit, name: string): Locator {
  return pot.page.getByRole("group", { name, exact: true });
}

/** The numbers and symbols of a formula that can be pointed at, by what they say. */
function numbers(pot: Visit, name: string, text: string): Locator {
  return formula(pot, name)
    .locator('[class^="m"]')
    .filter({ hasText: new RegExp(`^${text}$`) });
}

function told(pot: Visit): Locator {
  return pot.page.locator("pasu-equation .help");
}

/** The fields that are marked, by the numbers that they are of. */
async function marked(pot: Visit): Promise<(string | null)[]> {
  return await pot.page
    .locator("pasu-number[data-pointed]")
    .evaluateAll((all) => all.map((each) => each.dataset.at ?? null));
}

/** What is marked in the formulas. */
async function pointed(pot: Visit): Promise<string[]> {
  return await pot.page
    .locator("pasu-formula .pointed")
    .evaluateAll((all) => all.map((each) => each.textContent ?? ""));
}

/** The first point of each curve that is drawn on the pot. */
async function curves(pot: Visit): Promise<number[][]> {
  const stage = await stageOf(pot);
  return await stage.evaluate(({ overlay }) => overlay.hinted.map((curve) => [...curve.subarray(0, 3)]));
}

test("a number, its field and its edge of the pot light up together, from either side", async () => {
  const pot = await enter(VASE);
  await numbers(pot, "At u = 0", "0.1").first().hover();
  await expect.poll(() => marked(pot)).toEqual(["r[1]"]);
  expect(await told(pot).innerText()).toBe(
    "Rim petal depth = 0.1: How far the petals of the rim swing out and in. 0 gives a round rim.",
  );
  // The symbol and the number, in x and in y, there and in the closed form.
  expect(await pointed(pot)).toEqual(["r2", "0.1", "r2", "0.1", "0.1"]);
  await expect.poll(() => curves(pot)).toEqual([[expect.closeTo(1.1, 5), 0, expect.closeTo(3.6, 5)]]);
  await pot.field("Foot radius").hover();
  await expect.poll(() => pointed(pot)).toEqual(["r3", "0.6", "r3", "0.6", "0.6"]);
  // Nobody needs to be told what is under the hand.
  expect(await marked(pot)).toEqual([]);
  await expect.poll(() => curves(pot)).toEqual([[expect.closeTo(0.66, 5), 0, 0]]);
  await pot.page.locator("pasu-stage .host").hover();
  await expect.poll(() => pointed(pot)).toEqual([]);
  await expect.poll(() => curves(pot)).toEqual([]);
});

test("a press on a number leads to its field, and what is typed there is in every formula", async () => {
  const pot = await enter(VASE);
  const before = await pot.fingerprint();
  await numbers(pot, "At u = 0", "3.6").click();
  await expect.poll(() => pot.slider("Height").evaluate((slider) => slider.matches(":focus"))).toBe(true);
  await pot.type("Height", "4.25");
  await pot.fingerprintOtherThan(before);
  await expect.poll(() => numbers(pot, "At u = 0", "4.25").count()).toBe(1);
  expect(await numbers(pot, "Function q 3", "4.25").count()).toBe(1);
});

test("with the keyboard alone", async () => {
  const pot = await enter(VASE);
  await formula(pot, "At u = 0").focus();
  const { keyboard } = pot.page;
  await keyboard.press("ArrowRight");
  await expect.poll(() => told(pot).innerText()).toMatch(/^Rim radius = 1: /);
  expect(await marked(pot)).toEqual(["r[0]"]);
  await keyboard.press("End");
  await expect.poll(() => told(pot).innerText()).toMatch(/^Height = 3.6: /);
  await keyboard.press("Home");
  await keyboard.press("Enter");
  await expect.poll(() => pot.slider("Rim radius").evaluate((slider) => slider.matches(":focus"))).toBe(true);
  // The field has the focus: what stands for it is marked.
  await expect.poll(() => pointed(pot)).toEqual(["r1", "1", "r1", "1", "1"]);
  await keyboard.press("ArrowUp");
  await expect.poll(() => numbers(pot, "At u = 0", "1.01").count()).toBe(2);
  await keyboard.press("ArrowDown");
  await formula(pot, "At u = 0").focus();
  await keyboard.press("ArrowRight");
  await keyboard.press("Escape");
  await expect.poll(() => pointed(pot)).toEqual([]);
});

test("the formulas follow every step of a drag, and are not made anew", async () => {
  const pot = await enter(VASE);
  const first = await formula(pot, "Function q 1").locator("mfrac").first().elementHandle();
  const shown = () => formula(pot, "At u = 1").innerText();
  const before = await shown();
  await pot.drag("Foot radius", 0.9, {
    held: async () => {
      await expect.poll(shown).not.toBe(before);
      const typed = await pot.field("Foot radius").inputValue();
      await expect.poll(() => numbers(pot, "At u = 1", typed.replace(".", "\\.")).count()).toBe(2);
      expect(await numbers(pot, "Function q 1", typed.replace(".", "\\.")).count()).toBe(1);
      expect(await first?.evaluate((fraction) => fraction.isConnected)).toBe(true);
    },
  });
  await pot.undo();
  await expect.poll(shown).toBe(before);
});

test("a pot of rings shows where it passes, and which curve is which", async () => {
  const pot = await enter(BOTTLE);
  const ring = formula(pot, "At u = 0.7, with a corner");
  expect(await ring.locator("math").textContent()).toContain("1.6");
  await numbers(pot, "At u = 0.35", "0.5").hover();
  await expect.poll(() => told(pot).innerText()).toMatch(/^Wave 1 of Radius, Ring 1 = 0.5: /);
  await expect.poll(() => curves(pot)).toEqual([[expect.closeTo(6.5, 5), 0, 6]]);
  await numbers(pot, "At u = 0.35", "6").first().hover();
  await expect.poll(() => marked(pot)).toEqual(["rings[1].r.mean"]);
  // A cubic along the height, and roots twice where the smoothing is.
  await pot.page.getByText("All four roots are 0: a cubic").waitFor();
  await pot.page.getByText("Real roots ±2, each twice").first().waitFor();
});

test.each<[string, VisitOptions]>([
  ["on a desk", {}],
  ["on a dark phone", { ...PHONE, colorScheme: "dark" }],
])("every formula can be heard, reached and scrolled, %s", async (_, options) => {
  const pot = await enter(BOTTLE, options);
  await formula(pot, "At u = 0.35").focus();
  await pot.page.keyboard.press("ArrowRight");
  await expect.poll(() => told(pot).innerText()).toMatch(/^Place u, Ring 1 = 0\.35: /);
  expect(await findings(pot)).toEqual([]);
  expect(await overhang(pot)).toBe(0);
  expect(await unreachable(pot, "pasu-equation *")).toEqual([]);
});

test("of many waves the first are shown, and all on demand", async () => {
  const pot = await here.enter();
  const before = await pot.fingerprint();
  const modes = Array.from({ length: 40 }, (_, n) => ({
    n,
    cos: { start: 1 / (n + 1), end: 2 },
    sin: { end: n / 99 },
  }));
  const x = { order: 4, s: 1, t: 3, w: 1, modes };
  const shape = {
    kind: "boundary-value",
    span: "2pi",
    x,
    y: x,
    z: { order: 2, s: 1, t: 0, modes: [{ n: 0, cos: { start: 4 } }] },
  };
  await pot.dropFile("waves.json", JSON.stringify({ pasu: 1, parts: [{ shape }] }));
  await pot.fingerprintOtherThan(before);
  await pot.tab("Equation");
  const functions = pot.page.getByRole("group", { name: /^Function q/ });
  await expect.poll(() => functions.count()).toBe(6);
  const more = pot.button("and 74 more");
  expect(await more.getAttribute("aria-expanded")).toBe("false");
  await more.click();
  await expect.poll(() => functions.count()).toBe(80);
  await pot.button("Show fewer").click();
  await expect.poll(() => functions.count()).toBe(6);
});

test("LaTeX with all digits is copied", async () => {
  const pot = await enter("#1/bloor-wilson?a=0.123456789");
  expect(await formula(pot, "The differential equation").innerText()).toContain("0.12346");
  await pot.button("Copy as LaTeX").click();
  await pot.button("LaTeX copied").waitFor();
  const text = await pot.page.evaluate(() => navigator.clipboard.readText());
  expect(text).toContain("\\partial_{u}^{2}+0.123456789^{2}\\,\\partial_{v}^{2}");
  expect(text).toContain("% Closed form\n\\[ x(u,v)=q_{1}(u)\\,\\cos(v)+q_{2}(u)\\,\\sin(v) \\]");
  expect(text).not.toContain("\\class");
});

test("what has no solution says why, and finds back", async () => {
  const pot = await enter("#1/fourth-order");
  const before = await pot.fingerprint();
  await pot.type("Wall stiffness", "0");
  await pot.page.getByText(/^This equation has no solution\. ./).waitFor();
  expect(await pot.page.getByRole("group", { name: /^Function q/ }).count()).toBe(0);
  await pot.undo();
  await pot.shows(before);
  await formula(pot, "Function q 1").waitFor();
});

test("with a finger", async () => {
  const pot = await enter(VASE, PHONE);
  await numbers(pot, "At u = 0", "0.1").first().scrollIntoViewIfNeeded();
  await numbers(pot, "At u = 0", "0.1").first().tap();
  await expect.poll(() => pot.slider("Rim petal depth").evaluate((slider) => slider.matches(":focus"))).toBe(true);
  await expect.poll(() => pointed(pot)).toEqual(["r2", "0.1", "r2", "0.1", "0.1"]);
  expect(await told(pot).innerText()).toMatch(/^Rim petal depth = 0.1: /);
});
