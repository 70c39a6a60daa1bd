// A pot with a wall: seen, measured, filled, coloured, and told whether it can be made.
//
// What its time buys: walls are made, checked and measured as they are for people, with nothing left out, while the page draws in software.

import { expect, test } from "vitest";
import { difference, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, type Visit } from "../support/visit.ts";

const here = stay();
const JAR = "#1/fourth-order";

/** A pot that goes inwards above its foot, where its ring would come out of it. */
const RINGED =
  "#1~eNoljkEOgyAQRe8y65HAiBK4inFBKy1EqwZs2sRw947pZvKSefn_n7D78gankCEfBdxwQol-D-BOmNM6gYNX-oap2fIUMiBkdjphWoVStJawE5p6ZqVoRFj5q9AwxZCe8eDoXnTKIjAOUpC9XL5s5FS4piEprGorwscvy1V7xHSf11B4DVf0BuHmL1MKLQnhsW3_LK0NZ2kyY61j_QHEszf6";

/** A pot with sixteen flutes, of which an offset would have to be thinned. */
const FLUTED =
  "#1~eNqVjkEOgjAQRe_y1w2hYl30KsbFiI00YCUMSmLTuzsFjcHEhav2z7x5-RE98Q1WK_kMI8PuI7ih3sFGtD6cYDH4cGao15sJuSglZ-biKMBWChPd3bKVrHcK9VViWWzSISk8PmyZkloUhVlJzG9J9S0xb4leKbZ_9NBSJI8m6ro8HRtft8HxTIvoSOzmkhl7AgVOWTI";

/** The number at the beginning of a text, such as that of “13.1 ml”. */
const numberOf = (text: string) => Number(text.replaceAll("\u2212", "-").match(/-?[\d.]+/)?.[0]);

/** What the panel says of one measure. */
async function measure(pot: Visit, name: string): Promise<string> {
  const line = pot.page.locator("pasu-measures dl div").filter({ has: pot.page.getByText(name, { exact: true }) });
  return await line.locator("dd").innerText();
}

/** The pot from above, where its wall is seen. */
async function fromAbove(pot: Visit): Promise<Buffer> {
  await pot.page.getByRole("application", { name: "The pot" }).press("4");
  return await stagePicture(pot);
}

test("a wall makes a surface a pot, is seen, and is taken back step by step", async () => {
  const pot = await here.enter({ ...CLEAR, link: JAR });
  await pot.fingerprint();
  const bare = await fromAbove(pot);
  await pot.makePot();
  await expect.poll(async () => difference(bare, await stagePicture(pot)).share).toBeGreaterThan(0.02);
  await expect.poll(() => pot.address()).not.toBe(JAR);
  const held = await pot.page.getByText(/^Holds/).innerText();

  await pot.type("Thickness", "0.05");
  await expect.poll(() => pot.page.getByText(/^Holds/).innerText()).not.toBe(held);
  await pot.page.getByRole("checkbox", { name: "Foot ring" }).check();
  expect(await pot.field("Ring width").isVisible()).toBe(true);
  await pot.page.getByRole("radio", { name: /^Rounded/ }).check();
  // The address may be one of the steps before for a moment.
  const { hash } = new URL(await pot.copyLink());
  await expect.poll(() => pot.address()).toBe(hash);
  await pot.page.reload();
  await pot.fingerprint();
  await expect.poll(() => pot.page.getByRole("radio", { name: /^Rounded/ }).isChecked()).toBe(true);
  expect(await pot.field("Thickness").inputValue()).toBe("0.05");

  await pot.button("Remove the wall").click();
  await pot.button("Make it a pot").waitFor();
  await pot.undo();
  expect(await pot.field("Thickness").inputValue()).toBe("0.05");
  await pot.fingerprint();
});

test("dragging the thickness moves the wall under the hand and is one step", async () => {
  const pot = await here.enter({ ...CLEAR, link: JAR });
  await pot.fingerprint();
  await pot.makePot();
  const before = await pot.field("Thickness").inputValue();
  const thin = await fromAbove(pot);
  await pot.drag("Thickness", 0.5, {
    held: async () => {
      await expect.poll(async () => difference(thin, await stagePicture(pot)).share).toBeGreaterThan(0.01);
    },
  });
  expect(await pot.field("Thickness").inputValue()).not.toBe(before);
  await pot.undo();
  expect(await pot.field("Thickness").inputValue()).toBe(before);
});

test("what cannot be a pot says why, and the surface stays", async () => {
  const pot = await here.enter({ link: JAR });
  await pot.fingerprint();
  await pot.makePot();
  // It says beforehand already that it is thinned: that is no objection.
  const why = pot.page
    .locator("pasu-wall .problem")
    .filter({ hasText: "The rim is lower than what is to lie within it." });
  expect(await why.count()).toBe(0);
  await pot.type("Base", "9");
  // Below the number, and for the whole wall.
  await expect.poll(() => why.count()).toBe(2);
  expect(await why.first().innerText()).toMatch(/base/);
  await pot.undo();
  await expect.poll(() => why.count()).toBe(0);
  await pot.page.getByText(/^Holds .* to the brim/).waitFor();
});

test("measures have units, follow the design, and tell their errors", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const first = await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  await pot.page.getByRole("heading", { name: "Size" }).waitFor();
  expect(await measure(pot, "Height")).toMatch(/^3\.\d+\u00a0cm$/);
  expect(await measure(pot, "To the brim")).toMatch(/ml$/);
  expect(await measure(pot, "Mass, fired")).toMatch(/g$/);
  expect(await measure(pot, "Tips when tilted by")).toMatch(/°$/);
  await pot.button("How exact").click();
  expect(await measure(pot, "To the brim")).toMatch(/±|exact/);
  const verdict = pot.page.locator("pasu-measures .sentences li");
  await verdict.first().waitFor();
  const sentences = await verdict.allInnerTexts();
  expect(sentences.some((text) => /support|hangs over/.test(text))).toBe(true);
  expect(sentences.some((text) => /stands|tips|falls/i.test(text))).toBe(true);
  await pot.tab("Shape");
  await pot.type("Height", "5");
  await pot.fingerprintOtherThan(first);
  await pot.tab("Measures");
  await expect.poll(() => measure(pot, "Height")).toMatch(/^5/);
});

test("water is poured in, follows the slider, the keys and the hand on the stage, and its volume with it", async () => {
  const pot = await here.enter({ ...CLEAR, link: JAR });
  await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  await pot.button("Fill it").click();
  const volume = pot.page.locator("pasu-water [data-volume]");
  const now = async () => numberOf(await volume.innerText());
  await expect.poll(now).toBeGreaterThan(0);
  const poured = await stagePicture(pot);
  const first = await now();

  await pot.slider("Water level").focus();
  await pot.page.keyboard.press("PageDown");
  await expect.poll(now).toBeLessThan(first);
  const second = await now();

  const handle = pot.slider("Water on the stage");
  const box = (await handle.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  await pot.page.mouse.move(x, y + 15, { steps: 3 });
  await pot.page.mouse.move(x, y + 40, { steps: 3 });
  await pot.page.mouse.up();
  await expect.poll(now).toBeLessThan(second);
  expect((await handle.boundingBox())?.y).toBeGreaterThan(box.y);
  expect(difference(poured, await stagePicture(pot)).share).toBeGreaterThan(0.001);

  await handle.focus();
  await pot.page.keyboard.press("End");
  const brim = numberOf(await measure(pot, "To the brim"));
  await expect.poll(now).toBeCloseTo(brim, 1);
  expect(await handle.getAttribute("aria-valuetext")).toMatch(/ml|l$/);
  await pot.button("Pour it out").click();
  await expect.poll(() => handle.isVisible()).toBe(false);
});

test("colours show a map with its legend, and the glaze comes back", async () => {
  const pot = await here.enter({ ...CLEAR, link: JAR });
  await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  const glazed = await stagePicture(pot);
  const choice = pot.page.getByRole("combobox", { name: "Colours show" });
  let before = glazed;
  for (const [name, unit] of [
    ["mean curvature", "/cm"],
    ["gaussian curvature", "/cm²"],
    ["wall thickness", "cm"],
    ["overhang", "°"],
  ] as const) {
    await choice.selectOption({ label: name });
    const legend = pot.page.getByRole("img", { name: new RegExp(`^${name}: colours from`, "i") });
    await legend.waitFor();
    expect(await legend.getAttribute("aria-label")).toContain(unit);
    const picture = await stagePicture(pot);
    expect(difference(before, picture).share, name).toBeGreaterThan(0.01);
    before = picture;
  }
  await choice.selectOption({ label: "the glaze" });
  await expect
    .poll(async () => difference(glazed, await stagePicture(pot)).share, { timeout: 20_000 })
    .toBeLessThan(0.001);
});

test("a ring that has no room is fitted, and a button says so in the document", async () => {
  const pot = await here.enter({ link: RINGED });
  await pot.fingerprint();
  await pot.tab("Wall");
  // It is a pot all the same, and the panel says with which ring.
  await pot.page.getByText(/^Holds/).waitFor();
  const told = pot.page.getByText(/no room for the foot ring that was asked for: it is made .* wide and .* high/);
  await told.waitFor();
  const asked = await pot.field("Ring width").inputValue();
  const height = await pot.field("Ring height").inputValue();
  const remedy = pot.page.getByRole("button", { name: /^Make it with a ring .* wide and .* high$/ });
  await remedy.click();
  await told.waitFor({ state: "detached" });
  expect(await remedy.count()).toBe(0);
  expect([await pot.field("Ring width").inputValue(), await pot.field("Ring height").inputValue()]).not.toEqual([
    asked,
    height,
  ]);
  await pot.page.getByText(/^Holds/).waitFor();
  // One step back it is fitted again.
  await pot.undo();
  await told.waitFor();
});

test("a wall that has to be thinned keeps its thickness with a round inside, by one button", async () => {
  const pot = await here.enter({ ...CLEAR, link: FLUTED });
  await pot.fingerprint();
  await pot.tab("Wall");
  await pot.page.getByText(/^Holds/).waitFor();
  const told = pot.page.getByText("the wall is thinner than asked for", { exact: false }).first();
  await told.waitFor();
  const inside = (name: RegExp) => pot.page.getByRole("radio", { name });
  expect(await inside(/^Follows the outside/).isChecked()).toBe(true);
  const offer = pot.page.getByRole("button", { name: /^Make the inside round/ });
  await offer.click();
  await offer.waitFor({ state: "detached" });
  await expect.poll(() => inside(/^Round(?!ed)/).isChecked()).toBe(true);
  await pot.page.getByText(/^Holds/).waitFor();
  expect(await told.count()).toBe(0);
  // One step back it is thinned again.
  await pot.undo();
  await told.waitFor();
  await offer.waitFor();
  // And by the choice in the panel; how many waves it keeps is a number.
  await inside(/^Keeps broad waves/).check();
  expect(await pot.field("Waves inside").inputValue()).toBe("3");
  await offer.waitFor({ state: "detached" });
  await pot.undo();
  await told.waitFor();
});

test("what is told for ears alone makes the dialogue no longer than it is seen", async () => {
  const pot = await here.enter({ viewport: { width: 390, height: 500 } });
  const jar = await pot.fingerprint();
  const cup = (object: number) => ({
    shape: { kind: "second-order", r: [3, 0, 2, 0], t: [0, 0], height: 5 },
    wall: { thickness: 0.03, base: 0.03 },
    object,
    place: { shift: [8 * object, 0, 0] },
  });
  await pot.dropFile("cups.json", JSON.stringify({ pasu: 1, parts: [0, 1, 2, 3].map(cup) }));
  await pot.fingerprintOtherThan(jar);
  await pot.command("Export");
  const dialog = pot.page.locator("pasu-dialog dialog");
  await pot.page.getByText("True to within").waitFor();
  const [body, beyond] = await dialog.evaluate((element) => {
    const scrolled = element.querySelector(".body") as HTMLElement;
    scrolled.scrollTop = 10_000;
    element.scrollTop = 10_000;
    return [scrolled.scrollTop, element.scrollTop];
  });
  expect(body).toBeGreaterThan(100);
  expect(beyond).toBe(0);
});
