// On a phone: nothing hangs over the edge, and every control can be reached and is large enough to press.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";

const here = stay();

/** The largest width that anything on the page needs beyond the window's. */
async function overhang(pot: Visit): Promise<number> {
  return await pot.page.evaluate(() => (document.scrollingElement?.scrollWidth ?? 0) - innerWidth);
}

/** Controls that cannot be pressed: hidden behind something, outside the window or smaller than 24 pixels (WCAG 2.5.8). */
async function unreachable(pot: Visit): Promise<string[]> {
  return await pot.page.evaluate(async () => {
    const controls: HTMLElement[] = [];
    const collect = (root: Document | ShadowRoot) => {
      for (const element of root.querySelectorAll<HTMLElement>("*")) {
        if (element.matches("button, input, select, summary, a[href], [role=tab], g[role=button]"))
          controls.push(element);
        if (element.shadowRoot) collect(element.shadowRoot);
      }
    };
    collect(document);
    const deepest = (x: number, y: number) => {
      let hit = document.elementFromPoint(x, y);
      for (let inner = hit; inner?.shadowRoot; hit = inner) {
        const next: Element | null = inner.shadowRoot.elementFromPoint(x, y);
        if (!next || next === inner) break;
        inner = next;
        hit = next;
      }
      return hit;
    };
    const problems: string[] = [];
    for (const control of controls) {
      const pressed = control.closest("label") ?? control;
      if (!pressed.checkVisibility({ visibilityProperty: true }) || control.matches(":disabled, .skip")) continue;
      pressed.scrollIntoView({ block: "center", inline: "nearest" });
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const box = pressed.getBoundingClientRect();
      if (box.width === 0 || box.height === 0) continue;
      const name = control.getAttribute("aria-label") ?? control.textContent?.trim() ?? control.tagName;
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      if (box.width < 24 || box.height < 24) problems.push(`${name}: ${box.width} × ${box.height}`);
      if (box.left < 0 || box.right > innerWidth + 0.5) problems.push(`${name}: outside the window`);
      const hit = deepest(x, y);
      if (!hit || !(pressed.contains(hit) || hit.contains(pressed))) {
        problems.push(`${name}: covered by ${hit?.tagName.toLowerCase() ?? "nothing"}.${hit?.className ?? ""}`);
      }
    }
    if (controls.length < 10) problems.push("there are hardly any controls");
    return problems;
  });
}

test.each([390, 320])(
  "%d pixels wide, every panel fits and every control can be pressed",
  { timeout: 120_000 },
  async (width) => {
    const pot = await here.enter({ ...PHONE, viewport: { width, height: 844 }, link: "#1/fourth-order" });
    await pot.fingerprint();
    for (const name of ["Profile", "Order", "Look", "Shape"] as const) {
      await pot.tab(name);
      expect(await overhang(pot), name).toBeLessThanOrEqual(0);
      expect(await unreachable(pot), name).toEqual([]);
    }
    await pot.button("Explain").click();
    expect(await overhang(pot)).toBeLessThanOrEqual(0);
    await pot.makePot();
    expect(await overhang(pot), "Wall").toBeLessThanOrEqual(0);
    expect(await unreachable(pot), "Wall").toEqual([]);
    await pot.tab("Measures");
    await pot.button("Fill it").click();
    await pot.page.locator("pasu-water [data-volume]").waitFor();
    expect(await overhang(pot), "Measures").toBeLessThanOrEqual(0);
    expect(await unreachable(pot), "Measures").toEqual([]);
    for (const name of ["New", "Gallery", "Export", "Picture", "Help"] as const) {
      await pot.command(name);
      const dialog = pot.page.getByRole("dialog");
      await dialog.waitFor();
      const box = await dialog.boundingBox();
      expect((box?.x ?? 0) >= 0 && (box?.x ?? 0) + (box?.width ?? 0) <= width, name).toBe(true);
      expect(await overhang(pot), name).toBeLessThanOrEqual(0);
      await pot.button("Close").click();
      await dialog.waitFor({ state: "detached" });
    }
  },
);

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
  const there = await place();
  await pot.page.touchscreen.tap(there.x, there.y);
  await pot.fingerprintOtherThan(before);
});
