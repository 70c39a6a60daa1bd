// Beginning: a new pot from a form, from a family of the equations, or from chance.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";

const here = stay();

const form = (pot: Visit, id: string) => pot.page.locator(`pasu-new button[data-exhibit="${id}"]`);

/** Opens the dialogue. */
async function begin(pot: Visit): Promise<void> {
  await pot.command("New");
  await pot.dialog("New pot").waitFor();
}

const caption = (pot: Visit) => pot.page.locator("pasu-stage #description").innerText();

/** Waits until what is on the stage is measured and nothing stands in the way of making it. */
async function made(pot: Visit): Promise<void> {
  await pot.tab("Measures");
  await pot.page.getByText(/It stands: empty it tips/).waitFor();
  await pot.page.getByText("The mesh is closed, every edge is shared").waitFor();
  expect(await pot.page.locator("pasu-measures .sentences li.error").count()).toBe(0);
}

test("each of twelve forms has its picture; the one that is pressed opens as a pot with its wall, and undo brings the old one back", async () => {
  const pot = await here.enter({ viewport: { width: 1280, height: 800 } });
  const jar = await pot.fingerprint();
  await begin(pot);
  const forms = pot.page.locator("pasu-new button[data-exhibit^=form-]");
  expect(await forms.count()).toBe(12);
  for (const each of await forms.all()) {
    await each.scrollIntoViewIfNeeded();
    await expect.poll(() => each.locator("canvas").getAttribute("data-drawn"), { timeout: 60_000 }).toBe("true");
  }
  expect(await findings(pot)).toEqual([]);
  // No picture is empty, and no two are the same.
  const pictures = await forms
    .locator("canvas")
    .evaluateAll((all) => all.map((each) => (each as HTMLCanvasElement).toDataURL()));
  expect(new Set(pictures).size).toBe(12);
  await form(pot, "form-jug").click();
  await pot.page.locator("pasu-new").waitFor({ state: "detached" });
  const jug = await pot.fingerprintOtherThan(jar);
  await expect.poll(() => caption(pot)).toMatch(/^A \w+ 2\d(\.\d+)? cm high/);
  await made(pot);
  await pot.button("Undo").first().click();
  await pot.shows(jar);
  await pot.button("Redo").first().click();
  await pot.shows(jug);
});

test("by keys alone: a form, then a family of the equations one step further on", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  await begin(pot);
  await form(pot, "form-cup").focus();
  await pot.page.keyboard.press("Enter");
  const cup = await pot.fingerprintOtherThan(jar);
  await begin(pot);
  expect(await form(pot, "new-dints").isVisible()).toBe(false);
  const more = pot.page.locator("pasu-new summary").last();
  expect(await more.innerText()).toBe("By its equation");
  await more.focus();
  await pot.page.keyboard.press("Enter");
  await form(pot, "new-dints").waitFor();
  // What was opened is where it can be seen.
  await expect
    .poll(() => form(pot, "new-vase").locator("canvas").getAttribute("data-drawn"), { timeout: 60_000 })
    .toBe("true");
  expect(await findings(pot)).toEqual([]);
  await form(pot, "new-dints").focus();
  await pot.page.keyboard.press("Enter");
  await pot.fingerprintOtherThan(cup);
  await pot.field("Smoothing").waitFor();
});

test("chance draws a pot that can be made, another each time, and each is one step", async () => {
  const pot = await here.enter({ viewport: { width: 1280, height: 800 } });
  const jar = await pot.fingerprint();
  await begin(pot);
  await pot.page.locator("pasu-new").getByRole("button", { name: "Surprise me" }).click();
  const first = await pot.fingerprintOtherThan(jar);
  await made(pot);
  await pot.button("Surprise me").click();
  const second = await pot.fingerprintOtherThan(first);
  expect(second).not.toBe(jar);
  await pot.page.keyboard.press("Control+z");
  await pot.shows(first);
  await pot.page.keyboard.press("Control+z");
  await pot.shows(jar);
  expect(await pot.button("Undo").first().isDisabled()).toBe(true);
});

test("on a phone a finger finds the forms, and chance in the menu", async () => {
  const pot = await here.enter(PHONE);
  const jar = await pot.fingerprint();
  await pot.button("More").tap();
  await pot.button("New").tap();
  await form(pot, "form-gourd").scrollIntoViewIfNeeded();
  await form(pot, "form-gourd").tap();
  const gourd = await pot.fingerprintOtherThan(jar);
  await pot.button("More").tap();
  await pot.button("Surprise me").tap();
  await pot.fingerprintOtherThan(gourd);
  await pot.button("Undo").first().tap();
  await pot.shows(gourd);
});
