// How much wet clay a pot begins with: counted from what it is once fired, and remembered.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";

const here = stay();

test("the clay to wedge goes by the fired pot, its shrinkage and what is trimmed, in kilograms or pounds", async () => {
  const pot = await here.enter({ link: "#1/second-order?r=5,0,5,0&t=0,0&height=12" });
  await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  const { page } = pot;
  const section = page.getByRole("region", { name: "Clay to wedge" });
  await section.waitFor();
  const all = section.getByRole("status");
  const grams = async () => {
    const [number = "", unit] = ((await all.textContent()) ?? "").split("\u00a0");
    return Number(number) * ({ g: 1, kg: 1000, lb: 453.59237 }[unit ?? ""] ?? Number.NaN);
  };
  // What is told of the fired clay, wet and a fifth more of it.
  const told = page.locator("pasu-measures dl div", { hasText: "Volume" }).locator("dd");
  const volume = Number.parseFloat((await told.textContent()) ?? "");
  await expect.poll(async () => (await grams()) / (1.95 * volume * 1.2)).toBeCloseTo(1, 2);
  await pot.type("Shrinkage, wet to fired", "12 %");
  const wet = (1.95 * volume) / 0.88 ** 3;
  await expect.poll(async () => (await grams()) / (1.2 * wet)).toBeCloseTo(1, 2);
  await pot.type("For trimming and waste", "50");
  await expect.poll(async () => (await grams()) / (1.5 * wet)).toBeCloseTo(1, 2);
  expect(await section.textContent()).toContain("for the pot itself");
  await pot.type("For trimming and waste", "300");
  await section.getByText("A percentage from 0 to less than 200.").waitFor();
  expect((await grams()) / (1.5 * wet)).toBeCloseTo(1, 2);
  await pot.type("For trimming and waste", "50");
  await page.getByRole("combobox", { name: "Unit", exact: true }).selectOption("in");
  await expect.poll(async () => (await all.textContent())?.includes("lb")).toBe(true);
  await expect.poll(async () => (await grams()) / (1.5 * wet)).toBeCloseTo(1, 2);
  expect(await findings(pot)).toEqual([]);
  await page.reload();
  await section.waitFor();
  expect(await pot.field("For trimming and waste").inputValue()).toBe("50");
  // It is the same shrinkage as for files.
  expect(await pot.field("Shrinkage, wet to fired").inputValue()).toBe("12");
});
