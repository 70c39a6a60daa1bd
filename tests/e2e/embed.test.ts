// The Embed dialogue of the designer: both snippets, with the pot as it will be seen.

import { expect, test } from "vitest";
import type {} from "../../web/pot/pasu-pot.d.ts";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PHONE } from "../support/visit.ts";

const here = stay();

/** What a browser makes of a snippet. */
const read = (html: string, name: string) => {
  const tag = new RegExp(`<${name} ([^>]*)>`).exec(html)?.[1] ?? "";
  const attributes = [...tag.matchAll(/([\w-]+)(?:="([^"]*)")?/g)].map(([, key, value = ""]) => [
    key,
    value.replaceAll("&amp;", "&"),
  ]);
  return Object.fromEntries(attributes) as Readonly<Record<string, string>>;
};

test("both snippets say the pot on the stage, and the preview shows it with the page's own solver and context", async () => {
  const pot = await here.enter({ link: "#1/bloor-wilson?n1=5" });
  await pot.fingerprint();
  await pot.button("Embed").focus();
  await pot.page.keyboard.press("Enter");
  const dialog = pot.dialog("Put the pot into a page");
  await dialog.waitFor();
  const loaded = (link: string) =>
    pot.page.waitForFunction((wanted) => {
      const preview = document
        .querySelector("pasu-app")
        ?.shadowRoot?.querySelector("pasu-embed")
        ?.shadowRoot?.querySelector("pasu-pot");
      return preview?.loaded && preview.link === wanted;
    }, link);
  await loaded("#1/bloor-wilson?n1=5");
  expect(pot.page.workers()).toHaveLength(1);
  expect(await findings(pot)).toEqual([]);
  const inside = pot.page.locator("pasu-embed");
  const element = inside.getByLabel("For a page that may have scripts", { exact: true });
  const frame = inside.getByLabel("For a system that allows only frames", { exact: true });
  const { alt } = read(await element.inputValue(), "pasu-pot");
  expect(alt).toMatch(/^A vase .* 5 waves/);
  expect(read(await element.inputValue(), "script").src).toBe(`${here.site.url}pot/0.1/pasu-pot.js`);

  await inside.getByLabel("What is seen, for people who do not see it").fill("Mine");
  await inside.getByLabel("Turns by itself").check();
  await inside.getByText("Sliders below it").click();
  await inside.getByRole("checkbox", { name: "Smoothing a" }).check();
  await inside.getByRole("checkbox", { name: "Number of dints n1" }).check();
  expect(read(await element.inputValue(), "pasu-pot")).toEqual({
    src: "#1/bloor-wilson?n1=5",
    alt: "Mine",
    controls: "a, n1",
    "auto-rotate": "",
  });
  const address = new URL(read(await frame.inputValue(), "iframe").src ?? "");
  expect([...address.searchParams]).toEqual([
    ["alt", "Mine"],
    ["controls", "a,n1"],
    ["auto-rotate", ""],
  ]);
  // The frame's own page says the same.
  const inFrame = await pot.context.newPage();
  await inFrame.goto(address.href);
  await inFrame.waitForFunction(() => document.querySelector("pasu-pot")?.loaded);
  expect(await inFrame.evaluate(() => document.querySelector("pasu-pot")?.link)).toBe("#1/bloor-wilson?n1=5");
  // They come after the pot.
  await expect.poll(() => inFrame.getByRole("slider").count()).toBe(2);
  // Without the link it says why it is empty, and shows the next pot all the same.
  await inFrame.goto(address.href.replace(/#.*/, ""));
  await inFrame.getByText("No pot is shown: the address of this frame ends without the link of one.").waitFor();
  await inFrame.evaluate(() => {
    location.hash = "#1/second-order?height=5";
  });
  await inFrame.waitForFunction(() => document.querySelector("pasu-pot")?.link === "#1/second-order?height=5");
  await inFrame.close();

  await inside.getByRole("button", { name: "Copy: For a page that may have scripts" }).click();
  await inside.getByText("Copied.").waitFor();
  expect(await pot.page.evaluate(() => navigator.clipboard.readText())).toBe(await element.inputValue());
  expect(await findings(pot)).toEqual([]);
  await pot.page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
  expect(await pot.page.evaluate(() => document.querySelector("pasu-app")?.shadowRoot?.activeElement?.localName)).toBe(
    "pasu-top-bar",
  );
  // The stage has the context to itself again, and goes on.
  await pot.drag("Rim radius", 0.7);
  await pot.fingerprint();
});

test("on a phone the dialogue is in the menu and fits", async () => {
  const pot = await here.enter({ ...PHONE, link: "#1/second-order" });
  await pot.fingerprint();
  await pot.command("Embed");
  const dialog = pot.dialog("Put the pot into a page");
  await dialog.waitFor();
  const box = await dialog.boundingBox();
  expect(box && box.x >= 0 && box.x + box.width <= 390).toBe(true);
  expect(await findings(pot)).toEqual([]);
});
