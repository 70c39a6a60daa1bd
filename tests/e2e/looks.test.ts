// What lies over the pot and under it: none of it gets in the way of what is looked at.

import { expect, test } from "vitest";
import { stageOf } from "../support/on-stage.ts";
import { brightness, colour, difference, sight, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, SHARP, type Visit } from "../support/visit.ts";

const here = stay();
const DINT = "#1/bloor-wilson?n1=5";

/** Shows or hides something over the pot. */
async function overlay(pot: Visit, name: string, shown = true): Promise<void> {
  await pot.button("Overlays").click();
  await pot.page.getByRole("checkbox", { name }).setChecked(shown);
  await pot.page.keyboard.press("Escape");
}

/** A part of the stage, by shares of its height from its lower left. */
async function strip(pot: Visit, [left, width]: readonly [number, number]): Promise<number> {
  await stagePicture(pot);
  const box = await pot.page.locator("pasu-stage .host").boundingBox();
  if (!box) throw new Error("the stage cannot be seen");
  const clip = {
    x: box.x + box.width / 2 + left * box.height,
    y: box.y + 0.81 * box.height,
    width: width * box.height,
    height: 0.05 * box.height,
  };
  return brightness(await pot.page.screenshot({ clip }));
}

test("a wireframe that is seen from afar does not blacken the pot", async () => {
  const pot = await here.enter({ ...SHARP, link: DINT });
  await pot.fingerprint();
  const stage = pot.page.getByRole("application", { name: "The pot" });
  await stage.focus();
  for (let i = 0; i < 5; i += 1) await pot.page.keyboard.press("-");
  const plain = await stagePicture(pot);
  await overlay(pot, "Wireframe");
  await expect.poll(async () => (await stagePicture(pot)).equals(plain), { timeout: 20_000 }).toBe(false);
  const { mean, share } = difference(plain, await stagePicture(pot));
  expect(share).toBeGreaterThan(0.002);
  // Where there is a line it darkens by half at most; all of it black was more than a hundred.
  expect(mean / share).toBeLessThan(75);
});

test("a wireframe keeps to the cut, and off it", async () => {
  const pot = await here.enter(CLEAR);
  const first = await pot.fingerprint();
  // A thick cup: its base is seen as a broad piece of the cut.
  const cup = {
    pasu: 1,
    parts: [
      {
        shape: { kind: "second-order", r: [1, 0, 1, 0], t: [0, 0], n: [1, 2], height: 2 },
        wall: { thickness: 0.3, base: 0.6 },
      },
    ],
  };
  await pot.dropFile("cup.json", JSON.stringify(cup));
  await pot.fingerprintOtherThan(first);
  const stage = pot.page.getByRole("application", { name: "The pot" });
  await stage.focus();
  await pot.page.keyboard.press("2");
  await overlay(pot, "Cut open");
  const box = await pot.page.locator("pasu-stage .host").boundingBox();
  if (!box) throw new Error("the stage cannot be seen");
  const piece = async (top: number) => {
    await stagePicture(pot);
    const clip = {
      x: box.x + 0.44 * box.width,
      width: 0.12 * box.width,
      y: box.y + top * box.height,
      height: 0.04 * box.height,
    };
    return await pot.page.screenshot({ clip });
  };
  await pot.page.locator("pasu-stage[data-wall=fine]").waitFor();
  const [base, lining] = [await piece(0.74), await piece(0.45)];
  await overlay(pot, "Wireframe");
  expect(difference(base, await piece(0.74)).mean).toBeLessThan(1);
  expect(difference(lining, await piece(0.45)).mean).toBeLessThan(1);
  await overlay(pot, "Cut open", false);
  expect(difference(base, await piece(0.74)).mean).toBeGreaterThan(5);
});

test("a cut takes the shadow with it, and a map is seen inside", async () => {
  const pot = await here.enter(CLEAR);
  await pot.fingerprint();
  await pot.makePot();
  const whole = await stagePicture(pot);
  await overlay(pot, "Cut open");
  await expect.poll(async () => (await stagePicture(pot)).equals(whole), { timeout: 20_000 }).toBe(false);
  const ground = await strip(pot, [-0.5, 0.1]);
  expect(await strip(pot, [-0.2, 0.4])).toBeGreaterThan(ground - 14);
  await pot.tab("Measures");
  await pot.page.getByLabel("Colours show").selectOption("mean-curvature");
  await pot.page.getByText(/On the outside: .* Inside: .* Seen through the mouth, or cut open\./).waitFor();
  // Whatever the lining is coloured with, it is not the grey of faces without a number.
  const spread = async () => {
    const channels = colour(await stagePicture(pot), [0.47, 0.6, 0.53, 0.7]);
    return Math.max(...channels) - Math.min(...channels);
  };
  await expect.poll(spread, { timeout: 20_000 }).toBeGreaterThan(30);
  await pot.page.getByLabel("Colours show").selectOption("thickness");
  await pot.page.getByText("Inside the colours are the same").waitFor();
  await expect.poll(spread, { timeout: 20_000 }).toBeGreaterThan(30);
  await pot.page.getByLabel("Colours show").selectOption("overhang");
  await pot.page.getByText(/On the outside: /).waitFor();
  expect(await pot.page.getByText("Seen through the mouth").count()).toBe(0);
});

test("the caption stays off a fitted pot, and how true the picture is stands with the measures", async () => {
  const pot = await here.enter({ link: DINT, viewport: { width: 1100, height: 420 }, painted: true });
  await pot.fingerprint();
  const caption = pot.page.locator("pasu-stage #description");
  await expect.poll(() => caption.innerText()).toMatch(/waves in the rim\.$/);
  await stagePicture(pot);
  const stage = await stageOf(pot);
  const covered = await stage.evaluate((it) => {
    const box =
      document
        .querySelector("pasu-app")
        ?.shadowRoot?.querySelector("pasu-stage")
        ?.shadowRoot?.querySelector("#description")
        ?.getBoundingClientRect() ?? new DOMRect();
    const { left, top } = it.root.getBoundingClientRect();
    let found = 0;
    for (let x = box.left + 2; x < box.right; x += 8)
      for (let y = box.top + 2; y < box.bottom; y += 8) if (it.pick(x - left, y - top) !== null) found += 1;
    return found;
  });
  expect(covered).toBe(0);
  await pot.tab("Measures");
  await pot.page.getByText(/^Drawn to within 0\.\d+ cm of the true surface\.$/).waitFor();
});

test("a context that does not come back leaves a still picture, says so, and can be asked for again", async () => {
  const pot = await here.enter({ ...CLEAR, link: DINT });
  const before = await pot.fingerprint();
  const canvas = pot.page.locator("pasu-stage .host canvas");
  await canvas.evaluate((element) =>
    (element as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext(),
  );
  await pot.page.getByText("has not come back").waitFor();
  const still = pot.page.getByRole("img", { name: /vase/i });
  const sum = () =>
    still.evaluate((element: HTMLCanvasElement) =>
      [...(element.getContext("2d")?.getImageData(0, 0, element.width, element.height).data ?? [])].reduce(
        (all, each) => (all * 31 + each) % 1_000_003,
        0,
      ),
    );
  await expect.poll(sum).not.toBe(0);
  const first = await sum();
  await pot.type("Rim radius", "1.6");
  await pot.fingerprintOtherThan(before);
  await expect.poll(sum).not.toBe(first);
  await pot.button("Try again").click();
  await still.waitFor({ state: "detached" });
  await canvas.waitFor();
  expect(sight(await stagePicture(pot)).tones).toBeGreaterThan(400);
});

test("a choice that was taken back is shown as it was before", async () => {
  const pot = await here.enter({ link: DINT });
  const before = await pot.fingerprint();
  await pot.tab("Look");
  const unit = pot.page.getByRole("combobox", { name: "Unit of length" });
  expect(await unit.inputValue()).toBe("cm");
  await unit.selectOption("mm");
  await pot.fingerprintOtherThan(before);
  await pot.undo();
  await pot.shows(before);
  expect(await unit.inputValue()).toBe("cm");
});
