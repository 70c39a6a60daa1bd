// On a phone: what fingers do. That everything can be reached there, fits.test says.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import { PHONE } from "../support/visit.ts";

const here = stay();

test("fingers change the pot, and a swipe that scrolls past a slider does not", async () => {
  const pot = await here.enter({ ...PHONE, link: "#1/second-order" });
  const before = await pot.fingerprint();
  const slider = pot.slider("Rim radius");
  await slider.scrollIntoViewIfNeeded();
  const place = async () => {
    const box = (await slider.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
    return { x: box.x + 0.8 * box.width, y: box.y + box.height / 2 };
  };
  const value = await slider.inputValue();
  const cdp = await pot.context.newCDPSession(pot.page);
  const { x, y } = await place();
  await cdp.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  for (const step of [20, 60, 100, 140]) {
    await cdp.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x, y: y - step }] });
  }
  await cdp.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await expect.poll(() => pot.page.locator("pasu-panel .body").evaluate((body) => body.scrollTop)).toBeGreaterThan(0);
  await expect.poll(() => slider.inputValue()).toBe(value);
  await pot.shows(before);
  expect(await pot.history("Undo").isDisabled()).toBe(true);
  await slider.scrollIntoViewIfNeeded();
  // The panel glides on after a swipe, and a tap would do no more than stop it.
  const glided = () =>
    pot.page.locator("pasu-panel .body").evaluate(async (body) => {
      const { scrollTop } = body;
      for (let frame = 0; frame < 10; frame++) await new Promise(requestAnimationFrame);
      return Math.abs(body.scrollTop - scrollTop);
    });
  await expect.poll(glided).toBe(0);
  const there = await place();
  await pot.page.touchscreen.tap(there.x, there.y);
  await pot.fingerprintOtherThan(before);
});

test.each([
  [320, 256],
  [427, 320],
  [480, 270],
  [568, 320],
  [640, 360],
  [844, 390],
])("at %i by %i nothing of the panel is cut off", async (width, height) => {
  const pot = await here.enter({ viewport: { width, height } });
  await pot.fingerprint();
  const aside = pot.page.locator("aside");
  for (const tab of ["Wall", "Measures", "Look", "Shape"] as const) {
    await pot.tab(tab);
    await pot.page.getByRole("tab", { name: tab }).scrollIntoViewIfNeeded();
    const cut = await aside.evaluate((it) => [it.scrollLeft, it.scrollWidth - it.clientWidth]);
    expect([tab, ...cut]).toEqual([tab, 0, 0]);
    const body = pot.page.locator("pasu-panel .body");
    expect([tab, await body.evaluate((it) => it.scrollWidth - it.clientWidth)]).toEqual([tab, 0]);
  }
  // The body is wide enough to be read, and the pot to be seen.
  const boxes = await Promise.all(
    [pot.page.locator("pasu-panel .body"), pot.page.locator("pasu-stage")].map((it) => it.boundingBox()),
  );
  expect(boxes.map((box) => [(box?.width ?? 0) >= 170, (box?.height ?? 0) >= 50])).toEqual([
    [true, true],
    [true, true],
  ]);
});
