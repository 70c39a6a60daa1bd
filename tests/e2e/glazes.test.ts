// Colours of one's own for glaze and clay, a glaze for the inside, and a glaze line: chosen, drawn, kept.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { colour, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, type Visit } from "../support/visit.ts";

const here = stay();
/** A straight cup: red clay, blue above the middle, white inside. */
const CUP = "#1/second-order?r=1,0,1,0&t=0,0&height=2&glaze=1030d0&inside=f0f0e8&line=.5&clay=b03010";

const isBlue = ([red, , blue]: readonly [number, number, number]) => blue > 1.5 * red;
const isRed = ([red, , blue]: readonly [number, number, number]) => red > 1.5 * blue;
const isPale = ([red, , blue]: readonly [number, number, number]) => red > 90 && blue > 0.75 * red;

/** What is seen in the middle of the stage: where the cup begins, above its middle and below it. */
async function seen(pot: Visit) {
  const picture = await stagePicture(pot);
  const at = (y: number) => colour(picture, [0.46, y - 0.02, 0.54, y + 0.02]);
  return { upper: at(0.45), lower: at(0.92) };
}

test("a pot is glazed as its link says, with a wall and without, down to the line", async () => {
  const pot = await here.enter({ ...CLEAR, link: CUP });
  await pot.fingerprint();
  await pot.page.getByRole("application", { name: "The pot" }).focus();
  await pot.page.keyboard.press("1");
  let now = await seen(pot);
  expect(isBlue(now.upper), String(now.upper)).toBe(true);
  expect(isRed(now.lower), String(now.lower)).toBe(true);
  await pot.makePot();
  now = await seen(pot);
  expect(isBlue(now.upper), String(now.upper)).toBe(true);
  expect(isRed(now.lower), String(now.lower)).toBe(true);
  // From above one sees the floor, which is glazed as the inside.
  await pot.page.getByRole("application", { name: "The pot" }).focus();
  await pot.page.keyboard.press("3");
  const floor = colour(await stagePicture(pot), [0.45, 0.5, 0.55, 0.7]);
  expect(isPale(floor), String(floor)).toBe(true);
});

test("glaze, clay, inside and line are chosen with a hand and by the keyboard, undone, and in the link", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  await pot.fingerprint();
  await pot.tab("Look");
  const { page } = pot;
  const glaze = page.getByRole("group", { name: "Glaze", exact: true });
  const clay = page.getByRole("group", { name: "Clay", exact: true });
  await glaze.getByRole("radio", { name: "Own colour" }).check();
  // It begins with the colour of the glaze that there was.
  const own = page.getByLabel("Own colour of the glaze", { exact: true });
  expect(await own.inputValue()).toBe("#9dbfa6");
  await own.fill("#1030d0");
  await page.getByLabel("Glaze inside", { exact: true }).selectOption("Tin white");
  await page.getByLabel("Glaze inside", { exact: true }).selectOption("Own colour");
  await page.getByLabel("Own colour of the glaze inside").fill("#f0f0e8");
  await pot.type("Bare foot, up to", "25 %");
  await clay.getByRole("radio", { name: "Own colour" }).focus();
  await page.keyboard.press("Space");
  await page.getByLabel("Own colour of the clay").fill("#b03010");
  const link = "#1/second-order?glaze=1030d0&inside=f0f0e8&line=.25&clay=b03010";
  await expect.poll(() => pot.address()).toContain(link);
  expect(await findings(pot)).toEqual([]);
  await pot.undo();
  await pot.undo();
  await expect.poll(() => pot.address()).toContain("#1/second-order?glaze=1030d0&inside=f0f0e8&line=.25");
  await expect.poll(() => pot.address()).not.toContain("clay");
  await pot.redo();
  await pot.redo();
  await expect.poll(() => pot.address()).toContain(link);
  // A number beyond the pot is told, and nothing changes; a glaze that is not there ends nowhere.
  await pot.type("Bare foot, up to", "140");
  await page.getByText("A percentage from 0 to 100.").waitFor();
  expect(await pot.address()).toContain(link);
  await pot.type("Bare foot, up to", "100");
  await expect.poll(() => pot.address()).toContain("line=1&");
  expect(await page.getByText("A percentage from 0 to 100.").count()).toBe(0);
  await glaze.getByRole("radio", { name: "No glaze" }).check();
  await expect.poll(() => pot.address()).not.toContain("line");
  await page.getByLabel("Glaze inside", { exact: true }).selectOption("As outside");
  await expect.poll(() => pot.address()).toContain("#1/second-order?glaze=bare&clay=b03010");
});

test("a solid has no inside to be glazed, and one that was glazed there can be told otherwise", async () => {
  const octant = (look: string) =>
    `{ "pasu": 1, "parts": [{ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "scale": [5, 5, 5] }${look} }] }`;
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  const inside = pot.page.getByLabel("Glaze inside", { exact: true });
  await pot.tab("Look");
  await inside.waitFor();
  await pot.dropFile("octant.json", octant(""));
  const plain = await pot.fingerprintOtherThan(jar);
  await pot.page.getByText("Celadon", { exact: true }).first().waitFor();
  await expect.poll(() => inside.count()).toBe(0);
  await pot.dropFile("glazed.json", octant(`, "look": { "inside": "cobalt" }`));
  await inside.waitFor();
  expect(await inside.inputValue()).toBe("cobalt");
  await inside.selectOption("As outside");
  await pot.shows(plain);
  await expect.poll(() => inside.count()).toBe(0);
});
