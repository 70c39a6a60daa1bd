// Several designs: each tab keeps its own, and the shelf those that a person saved.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PHONE, Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();

/** Where pictures for the eye go, when somebody wants them. */
const SHOTS = process.env.PASU_SHOTS;

/** Another tab of the same browser. */
async function anotherTab(pot: Visit, link = ""): Promise<Visit> {
  const there = new Visit(pot.context, await pot.context.newPage(), pot.url);
  await there.page.goto(pot.url + link);
  return there;
}

test("two tabs keep two designs, and a closed tab's work is gone on with", async () => {
  const mine = await here.enter({ link: "#1/second-order" });
  const first = await mine.fingerprint();
  await mine.type("Height", "5");
  const tall = await mine.fingerprintOtherThan(first);
  await expect.poll(() => mine.address()).toContain("height=5");
  const other = await anotherTab(mine, "#1/second-order");
  await other.shows(first);
  await other.type("Height", "2");
  const low = await other.fingerprintOtherThan(first);
  await expect.poll(() => other.address()).toContain("height=2");
  await mine.page.bringToFront();
  await mine.page.goto(mine.url);
  await mine.shows(tall);
  await other.page.bringToFront();
  await other.page.goto(mine.url);
  await other.shows(low);
  const third = await anotherTab(mine);
  const fresh = await third.fingerprint();
  expect([tall, low]).not.toContain(fresh);
  await other.page.close();
  const fourth = await anotherTab(mine);
  await fourth.shows(low);
});

test.each<[string, VisitOptions]>([
  ["light", { colorScheme: "light", viewport: { width: 1280, height: 800 } }],
  ["dark, on a phone", { ...PHONE, colorScheme: "dark" }],
])("designs are saved, renamed, duplicated, deleted, taken back and opened, %s", async (name, options) => {
  const pot = await here.enter({ link: "#1/second-order?title=Cup", ...options });
  const cup = await pot.fingerprint();
  await pot.command("My designs");
  const shelf = pot.page.locator("pasu-shelf");
  await shelf.getByText("Nothing is on the shelf yet.").waitFor();
  await shelf.getByRole("button", { name: "Save to the shelf" }).click();
  await shelf.getByText("The pot on the stage is on the shelf.").waitFor();
  const titles = () =>
    shelf.getByRole("textbox").evaluateAll((all) => all.map((each) => (each as HTMLInputElement).value));
  expect(await titles()).toEqual(["Cup"]);
  await shelf.getByRole("button", { name: "Duplicate “Cup”" }).click();
  await expect.poll(titles).toEqual(["Cup (copy)", "Cup"]);
  await shelf.getByRole("textbox").first().fill("Beaker");
  await pot.page.keyboard.press("Enter");
  await expect.poll(titles).toEqual(["Beaker", "Cup"]);
  await shelf.locator("canvas[data-drawn=true]").nth(1).waitFor();
  expect(await findings(pot)).toEqual([]);
  if (SHOTS) await pot.page.screenshot({ path: `${SHOTS}/shelf-${name}.png` });
  await shelf.getByRole("button", { name: "Delete “Cup”" }).click();
  await expect.poll(titles).toEqual(["Beaker"]);
  await pot.page.keyboard.press("Enter");
  await expect.poll(titles).toEqual(["Beaker", "Cup"]);
  await pot.page.keyboard.press("Escape");

  await pot.type("Height", "5");
  const tall = await pot.fingerprintOtherThan(cup);
  await pot.command("My designs");
  await shelf.getByText("is not on the shelf as it is now").waitFor();
  await shelf.getByRole("button", { name: "Replace “Beaker” with the pot on the stage" }).click();
  await shelf.getByText("“Beaker” is as on the stage now.").waitFor();
  await shelf.getByRole("button", { name: "Undo" }).click();
  await shelf.getByText("Taken back.").waitFor();
  await shelf.getByRole("button", { name: "Open “Beaker”" }).click();
  await shelf.waitFor({ state: "detached" });
  await pot.shows(cup);
  expect(await pot.page.title()).toBe("Beaker · Pasu");
  await pot.undo();
  await pot.shows(tall);
});

test("what was deleted can be taken back when the shelf is closed", async () => {
  const pot = await here.enter({ link: "#1/second-order?title=Cup" });
  await pot.fingerprint();
  await pot.command("My designs");
  const shelf = pot.page.locator("pasu-shelf");
  await shelf.getByRole("button", { name: "Save to the shelf" }).click();
  await shelf.getByRole("button", { name: "Delete “Cup”" }).click();
  await shelf.getByText("“Cup” is deleted.").waitFor();
  await pot.page.keyboard.press("Escape");
  await shelf.waitFor({ state: "detached" });
  const toast = pot.page.locator("pasu-app .toast");
  await toast.getByText("“Cup” is deleted.").waitFor();
  expect(await findings(pot)).toEqual([]);
  await toast.getByRole("button", { name: "Undo" }).click();
  await toast.getByText("Taken back.").waitFor();
  expect(await toast.getByRole("button").count()).toBe(0);
  await pot.command("My designs");
  await shelf.getByRole("button", { name: "Open “Cup”" }).waitFor();
  // What takes nothing away is not told again.
  await shelf.getByRole("button", { name: "Duplicate “Cup”" }).click();
  await shelf.getByText("There are two of “Cup” now.").waitFor();
  await pot.page.keyboard.press("Escape");
  await shelf.waitFor({ state: "detached" });
  expect(await toast.getByText("There are two").count()).toBe(0);
});

test("what can be done with a saved design is within its card on the narrowest phone", async () => {
  const pot = await here.enter({ link: "#1/fourth-order", ...PHONE, viewport: { width: 320, height: 640 } });
  await pot.fingerprint();
  await pot.command("My designs");
  await pot.button("Save to the shelf").click();
  const card = pot.page.locator("pasu-shelf li");
  await card.waitFor();
  const out = await card.evaluate((li) => {
    const { left, right } = li.getBoundingClientRect();
    return [...li.querySelectorAll("button")]
      .map((button) => button.getBoundingClientRect())
      .filter((box) => box.left < left || box.right > right).length;
  });
  expect(out).toBe(0);
});

test("where nothing can be stored the shelf says so", async () => {
  const before = async ({ context }: Visit) => {
    await context.addInitScript(() => {
      Storage.prototype.setItem = () => {
        throw new DOMException("full", "QuotaExceededError");
      };
    });
  };
  const pot = await here.enter({ link: "#1/second-order", before });
  await pot.fingerprint();
  await pot.command("My designs");
  await pot.button("Save to the shelf").click();
  await pot.page.locator("pasu-shelf").getByText("This browser has no room for it").waitFor();
});

test("undo survives a reload", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const first = await pot.fingerprint();
  await pot.type("Height", "5");
  const second = await pot.fingerprintOtherThan(first);
  await pot.type("Height", "6");
  const third = await pot.fingerprintOtherThan(second);
  await pot.undo();
  await pot.shows(second);
  await expect.poll(() => pot.address()).toContain("height=5");
  await pot.page.reload();
  await pot.shows(second);
  await pot.redo();
  await pot.shows(third);
  await pot.undo();
  await pot.shows(second);
  await pot.undo();
  await pot.shows(first);
  expect(await pot.history("Undo").isDisabled()).toBe(true);
});

test("a link carries the view, the cut and the overlay when that is chosen", async () => {
  const mine = await here.enter({ link: "#1/second-order" });
  const cup = await mine.fingerprint();
  await mine.button("Overlays").click();
  await mine.page.getByRole("checkbox", { name: "Cut open" }).check();
  await mine.page.getByRole("checkbox", { name: "Wireframe" }).check();
  await mine.button("Link with this view").click();
  const dialog = mine.page.locator("pasu-link");
  const shown = dialog.getByRole("textbox", { name: "Link" });
  expect(await shown.inputValue()).toBe(`${mine.url}#1/second-order`);
  await dialog.getByRole("checkbox", { name: "With this view" }).check();
  expect(await findings(mine)).toEqual([]);
  await dialog.getByRole("button", { name: "Copy" }).click();
  await dialog.getByText("Copied.").waitFor();
  const address = await mine.page.evaluate(() => navigator.clipboard.readText());
  expect(address).toContain("&cut=1&show=wireframe&map=none#1/second-order");

  const other = address.replace(/view=[^&]*/, "view=90,20,2").slice(mine.url.length);
  const theirs = await here.enter({ link: other });
  await theirs.shows(cup);
  await expect.poll(() => theirs.page.evaluate(() => location.href)).toBe(`${theirs.url}#1/second-order`);
  await theirs.button("Overlays").click();
  expect(await theirs.page.getByRole("checkbox", { name: "Cut open" }).isChecked()).toBe(true);
  expect(await theirs.page.getByRole("checkbox", { name: "Wireframe" }).isChecked()).toBe(true);
  await theirs.button("Link with this view").click();
  await theirs.page.getByRole("checkbox", { name: "With this view" }).check();
  expect(await theirs.page.getByRole("textbox", { name: "Link" }).inputValue()).toContain("?view=90,20,2&cut=1");

  const damaged = await here.enter({ link: "?view=up&cut=1#1/second-order" });
  await damaged.page.getByText("Part of how this link shows the pot could not be read").waitFor();
  await damaged.shows(cup);
});
