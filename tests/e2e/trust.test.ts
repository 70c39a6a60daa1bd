// What the page says is so: numbers, thumbs and ranges agree, a reset says where it leads, and what was said of one pot ends with it.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";

const here = stay();

const slider = (pot: Visit, name: string) =>
  pot.slider(name).evaluate((input: HTMLInputElement) => ({
    value: input.valueAsNumber,
    min: Number(input.min),
    max: Number(input.max),
    fill: Number.parseFloat(getComputedStyle((input.getRootNode() as ShadowRoot).host).getPropertyValue("--fill")),
  }));

/** Where the camera is, as the stage says it. */
const distance = (pot: Visit) =>
  pot.page.locator("pasu-stage").evaluate((element) => {
    const { stage } = element as unknown as { stage: { pose: { distance: number } } };
    return stage.pose.distance;
  });

async function exhibit(pot: Visit, title: string): Promise<void> {
  const before = await pot.fingerprint();
  await pot.command("Gallery");
  await pot.page
    .locator("pasu-gallery li button")
    .filter({ has: pot.page.getByText(title, { exact: true }) })
    .click();
  await pot.fingerprintOtherThan(before);
}

test("a reset leads back to the pot that was opened, says to what, and still knows it after a reload", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  await pot.type("Height", "26");
  const higher = await pot.fingerprintOtherThan(jar);
  await pot.button("Reset Height to 20 cm, as opened").click();
  await pot.shows(jar);
  await pot.undo();
  await pot.shows(higher);
  await pot.page.reload();
  await pot.shows(higher);
  await pot.button("Set Height to 2 cm, as in the paper").click();
  await pot.fingerprintOtherThan(higher);
  await pot.button("Reset Height to 20 cm, as opened").click();
  await pot.shows(jar);
  expect(await pot.button(/^Reset Height/).count()).toBe(0);
});

test("a typed number beyond the slider widens it, and no other number changes its range", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  expect(await slider(pot, "Height")).toMatchObject({ value: 20, min: 1, max: 50 });
  const rim = await slider(pot, "Rim radius");
  await pot.type("Height", "80");
  const tall = await pot.fingerprintOtherThan(jar);
  expect(await slider(pot, "Height")).toEqual({ value: 80, min: 1, max: 100, fill: 79.8 });
  expect(await slider(pot, "Rim radius")).toEqual(rim);
  await pot.type("Belly radius", "50");
  await pot.fingerprintOtherThan(tall);
  expect(await slider(pot, "Height")).toMatchObject({ value: 80, min: 1, max: 100 });
  await pot.type("Height", "30");
  expect(await slider(pot, "Height")).toMatchObject({ value: 30, min: 1, max: 100 });
});

test("the thumb of a wall's thickness is where its number is, after a reload too", async () => {
  const pot = await here.enter();
  await pot.makePot();
  await pot.type("Thickness", "1.2");
  await expect.poll(() => slider(pot, "Thickness")).toMatchObject({ value: 1.2 });
  const before = await slider(pot, "Thickness");
  expect(before.fill).toBeCloseTo(120 / before.max, 2);
  await expect
    .poll(() =>
      pot.page.evaluate(() => Object.entries(localStorage).find(([key]) => key.startsWith("pasu.work."))?.[1]),
    )
    .toContain('thickness\\":1.2');
  await pot.page.reload();
  await pot.fingerprint();
  await expect.poll(() => slider(pot, "Thickness")).toEqual(before);
});

test("a pot that is opened is fitted and whole, whatever the one before was", async () => {
  const fresh = await here.enter();
  await fresh.fingerprint();
  await exhibit(fresh, "Carafe");
  const fitted = await distance(fresh);

  const pot = await here.enter({ link: "#1/fourth-order" });
  await pot.makePot();
  await pot.tab("Measures");
  await pot.button("Fill it").click();
  const map = pot.page.getByLabel("Colours show");
  await map.selectOption("overhang");
  await exhibit(pot, "Carafe");
  expect(await distance(pot)).toBeCloseTo(fitted, 3);
  await pot.button("Fill it").waitFor();
  expect(await map.inputValue()).toBe("");
  expect(await pot.page.getByRole("checkbox", { name: "Cut open" }).count()).toBe(0);
});

test("what hangs over inside is told, and nothing is told of the surface once it is a pot", async () => {
  const pot = await here.enter();
  await pot.fingerprint();
  await pot.tab("Measures");
  await pot.page.getByText("To the brim", { exact: true }).waitFor();
  await pot.tab("Wall");
  // Every word that the panel of measures shows from now on, frame by frame.
  await pot.page.evaluate(() => {
    const watched = globalThis as unknown as { pasuSaid: string[] };
    watched.pasuSaid = [];
    const look = () => {
      const panel = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-panel");
      const text = panel?.shadowRoot?.querySelector("pasu-measures")?.shadowRoot?.textContent;
      if (text && text !== watched.pasuSaid.at(-1)) watched.pasuSaid.push(text);
      requestAnimationFrame(look);
    };
    look();
  });
  await pot.button("Make it a pot").click();
  await pot.tab("Measures");
  await pot.page.getByText(/Overhang of 7\d degrees inside the rim: a printer needs support there/).waitFor();
  await pot.page.getByText("Largest overhang, inside").waitFor();
  const said = await pot.page.evaluate(() => (globalThis as unknown as { pasuSaid: string[] }).pasuSaid);
  expect(said[0]).toContain("Checking…");
  expect(said.filter((text) => /no wall|prints without support/.test(text))).toEqual([]);
});

test("the camera follows a pot that grows beyond the stage, and stays where a person put it", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  const fitted = await distance(pot);
  await pot.type("Height", "21");
  const higher = await pot.fingerprintOtherThan(jar);
  expect(await distance(pot)).toBe(fitted);
  await pot.type("Height", "60");
  const tall = await pot.fingerprintOtherThan(higher);
  const followed = await distance(pot);
  expect(followed).toBeGreaterThan(2 * fitted);
  // Smaller again, it is still seen whole.
  await pot.type("Height", "15");
  const small = await pot.fingerprintOtherThan(tall);
  expect(await distance(pot)).toBe(followed);
  // Whoever looks at a detail goes on looking at it.
  for (let i = 0; i < 9; i += 1) await pot.button("Zoom in").click();
  const close = await distance(pot);
  await pot.type("Height", "60");
  await pot.fingerprintOtherThan(small);
  expect(await distance(pot)).toBe(close);
});

test("caption, dimension lines and measures say one height and one width, with and without a wall", async () => {
  const pot = await here.enter();
  await pot.fingerprint();
  await pot.button("Overlays").click();
  await pot.page.getByLabel("Axes and dimensions").check();
  await pot.page.keyboard.press("Escape");
  for (const [title, wall] of [
    ["Dint vase", false],
    ["Tulip vase", false],
    ["Amphora", true],
  ] as const) {
    await exhibit(pot, title);
    if (wall) {
      await pot.makePot();
    }
    await pot.tab("Measures");
    const value = async (name: RegExp) => {
      const line = pot.page.locator("pasu-measures dl div").filter({ has: pot.page.getByText(name) });
      return (await line.locator("dd").innerText()).replace(/\s*cm\s*/, "");
    };
    await pot.page.locator("pasu-measures .groups:not([data-old])").waitFor();
    const [height, width] = [await value(/^Height$/), await value(/^(Greatest width|Width)$/)];
    await expect
      .poll(() => pot.page.locator("pasu-stage #description").innerText())
      .toContain(` ${height} cm high and ${width} cm wide`);
    const labels = () => pot.page.locator("pasu-stage .host").innerText();
    await expect.poll(labels).toContain(`${height} cm`);
    await expect.poll(labels).toContain(`${width} cm`);
  }
});

test("petals are asked for and counted as the eye counts them", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  const indices = pot.page.locator("pasu-number[data-field=n-1] .symbol sub");
  expect(await indices.allInnerTexts()).toEqual(["2", "1"]);
  const caption = () => pot.page.locator("pasu-stage #description").innerText();
  expect(await pot.field("Petals").inputValue()).toBe("7");
  expect(await caption()).toContain("7 petals");
  await pot.type("Petals", "8");
  const eight = await pot.fingerprintOtherThan(before);
  expect(await caption()).toContain("8 petals");
  await expect.poll(() => pot.address()).toContain("n=1,9");
  await pot.type("Petals", "999");
  await pot.fingerprintOtherThan(eight);
  expect(await caption()).toContain("999 petals");
});

test("a number that was far too large leaves neither an empty stage nor a slider of no use", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  const [near, ends] = [await distance(pot), await slider(pot, "Height")];
  await pot.type("Height", "2000");
  const huge = await pot.fingerprintOtherThan(jar);
  await expect.poll(() => distance(pot)).toBeGreaterThan(20 * near);
  expect((await slider(pot, "Height")).max).toBeGreaterThanOrEqual(2000);
  await pot.type("Height", "20");
  await pot.shows(jar);
  await expect.poll(() => distance(pot)).toBeLessThan(1.2 * near);
  await expect.poll(async () => (await slider(pot, "Height")).max).toBe(ends.max);
  // Undone it is as good.
  await pot.undo();
  await pot.shows(huge);
  await pot.undo();
  await pot.shows(jar);
  await expect.poll(() => distance(pot)).toBeLessThan(1.2 * near);
  // Where somebody has come nearer on purpose the camera stays.
  await pot.type("Height", "200");
  await pot.fingerprintOtherThan(jar);
  await pot.page.getByRole("application").focus();
  await pot.page.keyboard.press("+");
  await expect.poll(() => distance(pot)).toBeGreaterThan(2 * near);
  await pot.type("Height", "20");
  await pot.shows(jar);
  expect(await distance(pot)).toBeGreaterThan(2 * near);
});
