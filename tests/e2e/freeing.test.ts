// Any form becomes one of rings: offered in the panel with how many and how far it is off, and where a hand asks more of a family than it can do.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { dragFrom, onStage, ring, ringsOf, spotOf, takeUp } from "../support/pulling.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const DINTED = "#1/bloor-wilson";
/** Its wall does not close. */
const OPEN = "#1/bloor-wilson?n1=5.5";

const card = (pot: Visit) => pot.page.locator("pasu-free-card");
const told = (pot: Visit) => card(pot).locator(".found");

async function offer(pot: Visit): Promise<void> {
  await pot.button("Make it rings…").click();
  await expect.poll(() => told(pot).textContent(), { timeout: 30_000 }).toMatch(/off at most/);
}

/** How many rings it would be. */
async function count(pot: Visit): Promise<number> {
  await expect.poll(() => told(pot).textContent(), { timeout: 30_000 }).toMatch(/^\d+ rings, [\d.]+ cm off at most\.$/);
  return Number.parseInt((await told(pot).textContent()) ?? "", 10);
}

test("a family becomes rings by keys alone, as fine as it is asked to be, and is back with one step", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: DINTED });
  const before = await pot.fingerprint();
  await pot.button("Make it rings…").focus();
  await pot.page.keyboard.press("Enter");
  const coarse = await count(pot);
  expect(await findings(pot)).toEqual([]);
  expect(
    await pot.page.locator("pasu-free-card pasu-number").evaluate((element) => element.matches(":focus-within")),
  ).toBe(true);
  // Nothing has changed yet. Less takes more rings.
  await pot.shows(before);
  await pot.type("No further off than", "0.00005");
  await expect.poll(() => count(pot)).toBeGreaterThan(coarse);
  await pot.button("Use the rings").focus();
  await pot.page.keyboard.press("Enter");
  const freed = await pot.fingerprintOtherThan(before);
  // They come with the rings' part of the program.
  const cards = pot.page.locator("pasu-ring-cards");
  await expect.poll(() => cards.evaluate((element) => element.matches(":focus-within"))).toBe(true);
  expect(await pot.page.locator(".toast").textContent()).toMatch(/It is \d+ rings now, [\d.]+ cm off at most\./);
  await pot.undo();
  await pot.shows(before);
  expect(await pot.history("Undo").isEnabled()).toBe(false);
  await pot.redo();
  await pot.shows(freed);
});

test("what does not close cannot be rings, and it says so", async () => {
  const pot = await here.enter({ link: OPEN });
  const before = await pot.fingerprint();
  await pot.button("Make it rings…").click();
  await expect
    .poll(() => told(pot).textContent(), { timeout: 30_000 })
    .toMatch(/its wall does not close round the axis/);
  expect(await pot.button("Use the rings").isDisabled()).toBe(true);
  expect(await findings(pot)).toEqual([]);
  await pot.button("Leave it as it is").click();
  await card(pot).waitFor({ state: "detached" });
  expect(await pot.button("Make it rings…").evaluate((element: HTMLElement) => element.matches(":focus"))).toBe(true);
  // Another number, and it closes.
  await pot.button("Make it rings…").click();
  await pot.type("Number of dints", "6");
  await expect.poll(() => told(pot).textContent(), { timeout: 30_000 }).toMatch(/off at most/);
  await pot.fingerprintOtherThan(before);
});

test("a hand that asks more of a family than it can do is offered rings, and pulls on", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  await takeUp(pot);
  // It has no number that turns it.
  await pot.page.getByRole("radio", { name: "Round" }).check();
  await dragFrom(pot, await onStage(pot, 0.5, 0.5), { x: 150, y: 0 });
  const pulled = await pot.fingerprintOtherThan(before);
  const note = pot.page.locator("pasu-pull-bar .note");
  await note.getByRole("button", { name: "Make it rings" }).waitFor();
  expect(await findings(pot)).toEqual([]);
  await note.getByRole("button", { name: "Make it rings" }).click();
  const freed = await pot.fingerprintOtherThan(pulled);
  await expect.poll(() => ringsOf(pot)).toBeGreaterThan(3);
  await note.waitFor({ state: "hidden" });
  await dragFrom(pot, await spotOf(ring(pot, 0)), { x: 12, y: 0 });
  const further = await pot.fingerprintOtherThan(freed);
  expect(further).not.toBe(freed);
  await pot.undo();
  await pot.undo();
  await pot.shows(pulled);
});

test("on a phone the offer can be read and pressed, in every language", async () => {
  const pot = await here.enter({ ...PHONE, link: DINTED });
  await pot.button("Make it rings…").scrollIntoViewIfNeeded();
  await offer(pot);
  expect(await unreachable(pot)).toEqual([]);
  expect(await overhang(pot)).toBe(0);
  const other = await here.enter({ link: PSEUDO + DINTED });
  await other.page.locator("pasu-parameters .offer button").click();
  await other.page.locator("pasu-free-card .primary:enabled").waitFor();
  expect(await unmarked(other)).toEqual([]);
});
