// The picture of the pot: it turns, rests when nothing changes, and survives the loss of the graphics card.

import { expect, test } from "vitest";
import { atRest, countDraws, sight, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, type Visit } from "../support/visit.ts";

const here = stay();
const DINT = "#1/bloor-wilson?n1=5";
/** Fewer tones than this is an empty stage: ground and backdrop alone. */
const POT = 400;

/** Opens a pot with every drawing counted. */
async function watched(): Promise<Visit> {
  const pot = await here.enter(CLEAR);
  await pot.fingerprint();
  await countDraws(pot);
  await pot.page.goto("about:blank");
  await pot.page.goto(pot.url + DINT);
  await pot.fingerprint();
  return pot;
}

test("the pot turns by mouse, keys and buttons, and the stage rests in between", async () => {
  const pot = await watched();
  const seen: Buffer[] = [await stagePicture(pot)];
  expect(sight(seen[0] ?? Buffer.alloc(0)).tones).toBeGreaterThan(POT);
  const stage = pot.page.getByRole("application", { name: "The pot" });
  const box = (await stage.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const { mouse, keyboard } = pot.page;
  const gestures: readonly (() => Promise<unknown>)[] = [
    async () => {
      await mouse.move(x, y);
      await mouse.down();
      await mouse.move(x + 60, y - 30, { steps: 3 });
      await mouse.up();
    },
    () => mouse.wheel(0, -200),
    async () => {
      await stage.focus();
      await keyboard.press("ArrowLeft");
    },
    () => keyboard.press("Shift+ArrowUp"),
    () => keyboard.press("-"),
    () => keyboard.press("4"),
  ];
  for (const gesture of gestures) {
    const before = await atRest(pot);
    await gesture();
    const after = seen.at(-1);
    await expect.poll(async () => (await stagePicture(pot)).equals(after ?? Buffer.alloc(0))).toBe(false);
    expect(await atRest(pot)).toBeGreaterThan(before);
    seen.push(await stagePicture(pot));
  }
});

test("overlays are drawn over the pot and taken away again", async () => {
  const pot = await watched();
  const plain = await stagePicture(pot);
  for (const name of ["Lines round the pot (u)", "Lines up the wall (v)", "Wireframe", "Rim, foot and tangents"]) {
    await pot.button("Overlays").click();
    const box = pot.page.getByRole("checkbox", { name });
    await box.check();
    await pot.page.keyboard.press("Escape");
    await expect.poll(async () => (await stagePicture(pot)).equals(plain), { timeout: 20_000 }).toBe(false);
    await pot.button("Overlays").click();
    await box.uncheck();
    await pot.page.keyboard.press("Escape");
    await expect.poll(async () => (await stagePicture(pot)).equals(plain), { timeout: 20_000 }).toBe(true);
  }
});

test("a lost graphics context comes back with the pot of the moment", async () => {
  const pot = await watched();
  const before = await pot.fingerprint();
  const canvas = pot.page.locator("pasu-stage .host canvas");
  const card = await canvas.evaluateHandle((element) =>
    (element as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context"),
  );
  await card.evaluate((extension) => extension?.loseContext());
  const note = pot.page.getByText("The graphics card was taken away");
  await note.waitFor();
  await pot.type("Rim radius", "1.6");
  await pot.fingerprintOtherThan(before);
  await card.evaluate((extension) => extension?.restoreContext());
  await note.waitFor({ state: "detached" });
  const restored = await stagePicture(pot);
  expect(sight(restored).tones).toBeGreaterThan(POT);
  await pot.page.reload();
  await pot.fingerprint();
  const fresh = await stagePicture(pot);
  expect(Math.abs(sight(fresh).tones - sight(restored).tones)).toBeLessThan(0.2 * sight(fresh).tones);
});

test("the picture is saved in the size that was chosen", async () => {
  const pot = await here.enter({ ...CLEAR, link: DINT });
  await pot.fingerprint();
  await pot.command("Picture");
  await pot.page.getByRole("radio", { name: /My own/ }).check();
  await pot.page.getByLabel("Width in pixels").fill("300");
  await pot.page.getByLabel("Height in pixels").fill("9000");
  await pot.button("Save PNG").click();
  expect(await pot.page.getByText("whole numbers from 16 to 8192").isVisible()).toBe(true);
  await pot.page.getByLabel("Height in pixels").fill("420");
  const file = await pot.download("Save PNG");
  expect(file.name).toBe("Pot.png");
  const { width, height, tones } = sight(file.bytes);
  expect([width, height]).toEqual([300, 420]);
  expect(tones).toBeGreaterThan(POT);
});
