// Points of a network of patches: picked, dragged, typed and moved by keys.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { drag, item, middle, number, openCan, openLeaf, points } from "../support/network.ts";
import { atRest } from "../support/sight.ts";
import { stay } from "../support/stay.ts";

const here = stay();

test("points are dragged by the mouse, along axes too, and a drag is one step", async () => {
  const { pot, plain } = await openLeaf(here);
  await points(pot);
  expect(await findings(pot)).toEqual([]);
  await drag(pot, "vertex 2", 30, -40);
  const dragged = await pot.fingerprintOtherThan(plain);
  expect(await item(pot, "vertex 2").getAttribute("aria-pressed")).toBe("true");
  await pot.undo();
  await pot.shows(plain);
  await pot.redo();
  await pot.shows(dragged);
  await pot.page.getByRole("radio", { name: "z", exact: true }).check();
  const [x, y] = [await number(pot, "x"), await number(pot, "y")];
  await drag(pot, "vertex 2", 0, -40);
  await pot.fingerprintOtherThan(dragged);
  expect([await number(pot, "x"), await number(pot, "y")]).toEqual([x, y]);
  // Typed to a place.
  await pot.type("z", "9");
  expect(await item(pot, "vertex 2").getAttribute("aria-label")).toMatch(/, 9 cm$/);
});

test("a drag that ends where it began is no step, and neither it nor one that is given up takes what can be redone", async () => {
  const { pot, plain } = await openLeaf(here);
  const { page } = pot;
  await points(pot);
  await drag(pot, "vertex 2", 30, -40);
  const dragged = await pot.fingerprintOtherThan(plain);
  await pot.undo();
  await pot.shows(plain);
  const [x, y] = await middle(pot, "vertex 4");
  const away = async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y + 20, { steps: 3 });
    await expect.poll(() => number(pot, "x")).not.toBe(6);
  };
  await away();
  await page.mouse.move(x, y, { steps: 3 });
  await page.mouse.up();
  await pot.shows(plain);
  await away();
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await pot.shows(plain);
  await pot.redo();
  await pot.shows(dragged);
  await pot.undo();
  await pot.shows(plain);
  // The one step before is the network that was opened.
  await pot.undo();
  await page.locator("pasu-network-panel").waitFor({ state: "detached" });
});

test("where nothing can be picked it is said what to pick first, and a number is read as it was typed", async () => {
  const { pot } = await openLeaf(here);
  await pot.button("Patches").click();
  await pot.page.getByText("Pick a point first.").waitFor();
  await pot.button("Ring").click();
  await pot.page.getByText("Pick the middle of an edge first.").waitFor();
  await pot.type("Point", "1");
  await pot.type("x", "1.2345");
  await expect.poll(() => number(pot, "x")).toBe(1.2345);
});

test("where nothing is picked no number stands, and one that nothing has is told", async () => {
  const { pot } = await openLeaf(here);
  const [point, patch] = [pot.field("Point"), pot.field("Patch")];
  expect([await point.inputValue(), await patch.inputValue()]).toEqual(["", ""]);
  expect(await point.getAttribute("aria-valuenow")).toBeNull();
  expect(await point.getAttribute("aria-valuetext")).toBe("none");
  expect(await findings(pot)).toEqual([]);
  for (const [field, number, said] of [
    // 0 first, where the field is empty still.
    ["Point", "0", "Points have the numbers 1 to 8."],
    ["Point", "9", "Points have the numbers 1 to 8."],
    ["Point", "2.5", "Points have the numbers 1 to 8."],
    ["Patch", "-1", "Patches have the numbers 1 to 1."],
  ] as const) {
    await pot.type(field, number);
    await pot.page.getByText(said).waitFor();
    await pot.page.getByText("Nothing is picked").waitFor();
  }
  await pot.type("Point", "3");
  await pot.page.getByText("1 point and 0 patches picked.").waitFor();
  expect(await pot.page.getByText("have the numbers").count()).toBe(0);
  // By keys from where nothing is.
  await pot.button("None").click();
  await patch.press("ArrowUp");
  await pot.page.getByText("8 points and 1 patch picked.").waitFor();
  expect(await patch.inputValue()).toBe("1");
});

test("digits on the way to a number pick nothing beside it", async () => {
  const { pot } = await openCan(here);
  const { page } = pot;
  const status = page.locator("pasu-network-panel .told").first();
  await pot.button("Pick several").click();
  await pot.type("Point", "7");
  await pot.field("Point").click();
  await page.keyboard.type("23");
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^2 points and 0 patches/);
  expect(await item(pot, "vertex 1").getAttribute("aria-pressed")).toBe("false");
  // 10 there is, 100 there is none.
  await pot.field("Point").click();
  await page.keyboard.type("100");
  await page.getByText("Points have the numbers").waitFor();
  await expect.poll(() => status.innerText()).toMatch(/^2 points and 0 patches/);
  await page.keyboard.press("Enter");
  await pot.button("None").click();
  await pot.field("Patch").click();
  await page.keyboard.type("12");
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^8 points and 1 patch /);
  expect(await item(pot, "patch 11").getAttribute("aria-pressed")).toBe("true");
});

test("a place is typed digit by digit through the mirror, and what stands in it says that it stays", async () => {
  const { pot, plain } = await openLeaf(here);
  const { page } = pot;
  await page.getByLabel("Mirror").selectOption("x");
  await pot.type("Point", "8");
  const x = page.locator("pasu-network-place").getByRole("spinbutton", { name: "x", exact: true });
  const typed = async (text: string) => {
    await x.click();
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
  };
  // On the way to it stands a 0, where it would meet its image.
  await typed("-0.5");
  await pot.fingerprintOtherThan(plain);
  await expect.poll(() => x.inputValue()).toBe("\u22120.5");
  await pot.type("Point", "4");
  await expect.poll(() => x.inputValue()).toBe("0.5");
  await pot.undo();
  await pot.shows(plain);
  await pot.type("Point", "2");
  await typed("3");
  await page.getByText("What stands in the mirror stays there.").waitFor();
  await page.keyboard.press("Tab");
  expect(await x.inputValue()).toBe("0");
  await pot.shows(plain);
  // Nor is there a step to undo: what was undone before can still be redone.
  await pot.redo();
  await pot.fingerprintOtherThan(plain);
});

test("the middle of what goes round an axis is on it, whatever rounding leaves", async () => {
  const { pot } = await openCan(here);
  await pot.button("All").click();
  const place = pot.page.locator("pasu-network-place").getByRole("spinbutton");
  expect(await place.evaluateAll((all) => all.map((each) => each.getAttribute("aria-valuenow")))).toEqual([
    "0",
    "0",
    "5",
  ]);
});

test("arrow keys keep to the grid", async () => {
  const { pot, plain } = await openLeaf(here);
  const { page } = pot;
  await points(pot);
  await page.getByLabel("To a grid of").check();
  await item(pot, "vertex 1").focus();
  await page.keyboard.press("ArrowRight");
  const once = await pot.fingerprintOtherThan(plain);
  await page.keyboard.press("ArrowUp");
  await pot.fingerprintOtherThan(once);
  const [x, y, z] = [await number(pot, "x"), await number(pot, "y"), await number(pot, "z")];
  expect([x, y, z].map((each) => (2 * each) % 1)).toEqual([0, 0, 0].map((zero) => expect.closeTo(zero, 9)));
  expect([x, y, z]).not.toEqual([0, -7, 3]);
});

test("points are picked in a box, keep to a grid and to their mirror image, and are turned and scaled", async () => {
  const { pot, plain } = await openLeaf(here);
  const { page } = pot;
  pot.page.setDefaultTimeout(20_000);
  await points(pot);
  await page.locator("pasu-stage .host").press("4");
  await atRest(pot);
  // Both corners at the right, with the middle between them.
  await page.getByRole("radio", { name: "picks in a box" }).check();
  const [[left, top], [right, bottom]] = [await middle(pot, "vertex 4"), await middle(pot, "vertex 2")];
  await page.mouse.move(Math.min(left, right) - 14, Math.min(top, bottom) - 25);
  await page.mouse.down();
  await page.mouse.move(Math.max(left, right) + 60, Math.max(top, bottom) + 25, { steps: 4 });
  await page.mouse.up();
  const status = page.locator("pasu-network-panel .told").first();
  await expect.poll(() => status.innerText()).toMatch(/^3 points/);
  await page.getByRole("radio", { name: "Turn", exact: true }).check();
  await drag(pot, "vertex 2", 30, 10);
  const turned = await pot.fingerprintOtherThan(plain);
  await page.getByRole("radio", { name: "Scale", exact: true }).check();
  await drag(pot, "vertex 2", 10, 30);
  await pot.fingerprintOtherThan(turned);
  await pot.undo();
  await pot.shows(turned);
  await pot.undo();
  await pot.shows(plain);
  await page.getByRole("radio", { name: "Move", exact: true }).check();
  await page.getByLabel("Mirror").selectOption("x");
  await page.getByLabel("To a grid of").check();
  await page.getByRole("radio", { name: "turns the view" }).check();
  await pot.button("None").click();
  await drag(pot, "vertex 3", 37, 11);
  await pot.fingerprintOtherThan(plain);
  const place = async (name: string) =>
    (/: (.*)$/.exec((await item(pot, name).getAttribute("aria-label")) ?? "")?.[1] ?? "")
      .split(", ")
      .map((each) => Number.parseFloat(each.replace("\u2212", "-")));
  const [[x = 0, y = 0], [mx = 0, my = 0]] = [await place("vertex 3"), await place("vertex 7")];
  expect(x).toBeGreaterThan(7);
  expect([2 * x, 2 * y].map((each) => Math.abs(each - Math.round(each)) < 1e-6)).toEqual([true, true]);
  expect([mx, my]).toEqual([-x, y]);
  // What cannot be done is said in words, and nothing changes.
  const before = await pot.fingerprint();
  await pot.button("Bridge").click();
  await page.getByText("Pick two whole rims first").waitFor();
  await pot.shows(before);
});
