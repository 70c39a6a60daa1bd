// What is built of patches with the mouse, with the keyboard and with a finger.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { drag, item, middle, number, openCan, openLeaf, points, told } from "../support/network.ts";
import { stay } from "../support/stay.ts";
import { PHONE } from "../support/visit.ts";

const here = stay();

/** Patches of the can that look to the front, below and above: out of these comes a handle. */
const [LOWER, UPPER] = ["patch 7", "patch 15"];

test("a mug's handle is built with the mouse", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan(here);
  const { page } = pot;
  const click = async (name: string, more = false) => {
    const [x, y] = await middle(pot, name);
    if (more) await page.keyboard.down("Shift");
    await page.mouse.click(x, y);
    if (more) await page.keyboard.up("Shift");
    await expect.poll(() => item(pot, name).getAttribute("aria-pressed")).toBe("true");
  };
  await click(LOWER);
  await click(UPPER, true);
  await pot.button("Delete").click();
  const opened = await pot.fingerprintOtherThan(plain);
  expect(await told(pot)).toContain("18 patches");
  // The rims of both openings are picked, and are drawn out and joined.
  await pot.button("Extrude").click();
  await pot.button("Bridge").click();
  await expect.poll(() => told(pot)).toContain("30 patches");
  const bridged = await pot.fingerprintOtherThan(opened);
  await drag(pot, "pivot", 40, 10);
  const drawn = await pot.fingerprintOtherThan(bridged);
  await pot.undo();
  await pot.shows(bridged);
  await pot.redo();
  await pot.shows(drawn);
  expect(await findings(pot)).toEqual([]);
});

test("a mug's handle is built with the keyboard", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan(here);
  const { page } = pot;
  const press = async (name: string) => {
    await page.getByRole("button", { name, exact: true }).focus();
    await page.keyboard.press("Enter");
  };
  await item(pot, LOWER).focus();
  await page.keyboard.press("Enter");
  await item(pot, UPPER).focus();
  await page.keyboard.press("Shift+Enter");
  expect(await page.locator("pasu-network-panel .told").first().innerText()).toMatch(/^16 points and 2 patches/);
  await press("Delete");
  const opened = await pot.fingerprintOtherThan(plain);
  await press("Extrude");
  await press("Bridge");
  await expect.poll(() => told(pot)).toContain("30 patches");
  const bridged = await pot.fingerprintOtherThan(opened);
  await page.getByRole("radio", { name: "y", exact: true }).focus();
  await page.keyboard.press("Space");
  const before = await number(pot, "y");
  await item(pot, "pivot").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(bridged);
  expect(await number(pot, "y")).toBeGreaterThan(before + 0.5);
  await pot.undo();
  await pot.shows(bridged);
});

test("a mug's handle is built with a finger", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan(here, { ...PHONE });
  const { page } = pot;
  const cdp = await pot.context.newCDPSession(page);
  const touch = async (name: string, dx = 0, dy = 0) => {
    const [x, y] = await middle(pot, name);
    await cdp.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
    for (let step = 1; step <= 4 && (dx !== 0 || dy !== 0); step += 1) {
      const there = { x: x + (dx * step) / 4, y: y + (dy * step) / 4 };
      await cdp.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [there] });
    }
    await cdp.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  };
  const tap = (name: string) => page.getByRole("button", { name, exact: true }).tap();
  await page.evaluate(() => scrollTo(0, 0));
  await touch(UPPER);
  await expect.poll(() => item(pot, UPPER).getAttribute("aria-pressed")).toBe("true");
  await tap("Delete");
  const once = await pot.fingerprintOtherThan(plain);
  await tap("Extrude");
  const drawn = await pot.fingerprintOtherThan(once);
  // A finger has no shift: the other opening is made in its turn.
  await page.evaluate(() => scrollTo(0, 0));
  await touch(LOWER);
  await expect.poll(() => item(pot, LOWER).getAttribute("aria-pressed")).toBe("true");
  await tap("Delete");
  await tap("Extrude");
  const both = await pot.fingerprintOtherThan(drawn);
  await expect.poll(() => told(pot)).toContain("26 patches");
  await page.evaluate(() => scrollTo(0, 0));
  await touch("pivot", 20, 10);
  const moved = await pot.fingerprintOtherThan(both);
  await pot.undo();
  await pot.shows(both);
  expect(moved).not.toBe(both);
});

test("a finger picks two patches apart, and takes one of them back", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan(here, { ...PHONE });
  const { page } = pot;
  const cdp = await pot.context.newCDPSession(page);
  const down = async (name: string) => {
    const [x, y] = await middle(pot, name);
    await cdp.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  };
  const up = () => cdp.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  const touch = async (name: string) => {
    await down(name);
    await up();
  };
  const picked = (name: string, is: boolean) =>
    expect.poll(() => item(pot, name).getAttribute("aria-pressed")).toBe(is ? "true" : "false");
  const tap = (name: string) => page.getByRole("button", { name, exact: true }).tap();
  const status = page.locator("pasu-network-panel .told").first();
  const toStage = () => page.evaluate(() => scrollTo(0, 0));
  await toStage();
  await touch(LOWER);
  await picked(LOWER, true);
  // A finger that rests picks beside what there is; lifted it changes nothing more.
  await down(UPPER);
  await picked(UPPER, true);
  await picked(LOWER, true);
  await up();
  expect(await status.innerText()).toMatch(/^16 points and 2 patches/);
  // Resting on one once more leaves it out.
  await down(UPPER);
  await picked(UPPER, false);
  await up();
  expect(await status.innerText()).toMatch(/^8 points and 1 patch /);
  // A tap alone picks one in place of the other, until several are asked for.
  await touch(UPPER);
  await picked(UPPER, true);
  await picked(LOWER, false);
  await tap("Pick several");
  expect(await findings(pot)).toEqual([]);
  await toStage();
  await touch(LOWER);
  await picked(LOWER, true);
  await picked(UPPER, true);
  // Which is all that a handle takes.
  await tap("Delete");
  const opened = await pot.fingerprintOtherThan(plain);
  await tap("Extrude");
  await tap("Bridge");
  await expect.poll(() => told(pot)).toContain("30 patches");
  await pot.fingerprintOtherThan(opened);
});

test("with Pick several the Enter key and numbers pick beside what there is", async () => {
  const { pot } = await openLeaf(here);
  const { page } = pot;
  await points(pot);
  const status = page.locator("pasu-network-panel .told").first();
  await item(pot, "vertex 0").focus();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Pick several", exact: true }).focus();
  await page.keyboard.press("Enter");
  await item(pot, "vertex 2").focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^2 points/);
  await pot.type("Point", "5");
  await expect.poll(() => status.innerText()).toMatch(/^3 points/);
  await item(pot, "vertex 2").focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^2 points/);
});
