// What people do with a pot that is theirs: say how large it is, in their unit, and begin with one as large as a hand.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";

const here = stay();

const caption = (pot: Visit) => pot.page.locator("pasu-stage #description").innerText();

/** Types a size, once the sizes are known. */
async function size(pot: Visit, name: "Height" | "Width" | "Holds", text: string): Promise<void> {
  const field = pot.page.locator("pasu-size").getByLabel(name);
  await expect.poll(() => field.isEnabled()).toBe(true);
  await field.fill(text);
  await field.press("Enter");
}

const sizes = (pot: Visit) =>
  pot.page
    .locator("pasu-size .typed input")
    .evaluateAll((inputs) => inputs.map((input) => (input as HTMLInputElement).value));

test("a pot takes the size that is typed, in any unit, and a change of unit converts it", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  await pot.tab("Measures");
  await size(pot, "Height", "12 in");
  const higher = await pot.fingerprintOtherThan(jar);
  await expect.poll(() => caption(pot)).toContain("30.5 cm high and 35.6 cm wide");
  await pot.page.locator("pasu-size").getByLabel("Unit").selectOption("in");
  await pot.fingerprintOtherThan(higher);
  await expect.poll(() => caption(pot)).toContain("12 in high and 14 in wide");
  await expect.poll(() => sizes(pot)).toEqual(["12", "14", "20.8"]);
  await pot.page.locator("pasu-size").getByText("5.49 US gal", { exact: true }).waitFor();
  await size(pot, "Height", "wide");
  await pot.page.getByText("“wide” is not a number").waitFor();
  // What it was opened as has become larger and has changed its unit along with it.
  await pot.tab("Shape");
  await pot.type("Height", "5 1/2");
  await pot.button("Reset Height to 12 in, as opened").waitFor();
  for (let i = 0; i < 3; i += 1) await pot.undo();
  await pot.shows(jar);
});

test("beside inches a capacity for a file is asked for in US measures, as it is told", async () => {
  const pot = await here.enter({ link: "#1/bloor-wilson" });
  await pot.makePot();
  const before = await pot.fingerprint();
  await pot.tab("Measures");
  await pot.page.locator("pasu-size").getByLabel("Unit").selectOption("in");
  await pot.fingerprintOtherThan(before);
  await pot.command("Export");
  const field = pot.page.locator("pasu-export").getByLabel("Holds to the brim");
  await pot.page
    .getByRole("option", { name: "Capacity" })
    .and(pot.page.locator(":enabled"))
    .waitFor({ state: "attached" });
  await pot.page.locator("pasu-export select").first().selectOption("capacity");
  await pot.page.locator("pasu-export").getByText("US\u00a0fl\u00a0oz", { exact: true }).waitFor();
  const told = Number(await field.inputValue());
  const file = pot.page.locator("pasu-export dd").first();
  const asDesigned = await file.innerText();
  // Eight times as much is twice as large, in whichever measure.
  await field.fill(`${(told * 8) / 16} US pt`);
  await pot.page.getByText("scaled by 2").waitFor();
  expect(await file.innerText()).not.toBe(asDesigned);
});

test("a wall stays as thick as it was said to be, or grows along and says so", async () => {
  const pot = await here.enter();
  await pot.makePot();
  const jar = await pot.fingerprint();
  await pot.tab("Measures");
  await pot.page.getByLabel("The wall scales too").uncheck();
  await pot.page.getByText("It stays 1 cm thick.").waitFor();
  await size(pot, "Holds", "1 l");
  const small = await pot.fingerprintOtherThan(jar);
  await expect.poll(async () => (await sizes(pot))[2]).toBe("1");
  await pot.tab("Wall");
  expect(await pot.field("Thickness").inputValue()).toBe("1");
  await pot.tab("Measures");
  await size(pot, "Holds", "2000 ml");
  await pot.fingerprintOtherThan(small);
  await expect.poll(async () => (await sizes(pot))[2]).toBe("2");
  await pot.tab("Wall");
  expect(Number(await pot.field("Thickness").inputValue())).toBeCloseTo(2 ** (1 / 3), 4);
});

test("a field of a length takes inches and fractions", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  await pot.type("Height", "1 1/2 in");
  await pot.fingerprintOtherThan(before);
  expect(await pot.field("Height").inputValue()).toBe("3.81");
});

test("a figure of a paper opens 20 cm high, or as it was printed", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  const open = async (size: "20 cm high" | "As printed") => {
    await pot.command("Gallery");
    await pot.page.getByLabel(size).check();
    await pot.page.locator('pasu-gallery button[data-exhibit="zhang-you-1a"]').click();
  };
  await open("20 cm high");
  const usable = await pot.fingerprintOtherThan(jar);
  expect(await caption(pot)).toContain("A vase 20 cm high");
  expect(Number(await pot.field("Height").inputValue())).toBeCloseTo(20, 3);
  await open("As printed");
  await pot.fingerprintOtherThan(usable);
  expect(await pot.field("Height").inputValue()).toBe("3.6");
});

test("of several files that are dropped together, each is told what became of it", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  const design = (height: number) =>
    JSON.stringify({ pasu: 1, parts: [{ shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height } }] });
  await pot.dropFiles([
    ["notes.txt", "milk, eggs"],
    ["five.json", design(5)],
    ["six.json", design(6)],
  ]);
  await pot.fingerprintOtherThan(jar);
  await pot.page
    .getByText(
      "Opened “five.json”. “notes.txt” could not be opened. Not opened: “six.json”, because one design is shown at a time.",
    )
    .waitFor();
  expect(await pot.field("Height").inputValue()).toBe("5");
  await pot.dropFiles([
    ["notes.txt", "milk, eggs"],
    ["list.txt", "flour"],
  ]);
  await pot.page.getByText("None of “notes.txt” and “list.txt” could be opened.").waitFor();
});
