// Two pots mixed by a slider: chosen by their pictures, seen on the stage at once, one step of undo.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";

const here = stay();

/** A plain bottle of four rings. */
const BOTTLE = "#1/rings?title=Mine";

const choice = (pot: Visit, id: string) => pot.page.locator(`pasu-mix-dialog button[data-exhibit="${id}"]`);
const share = (pot: Visit) => pot.field("Share");

async function choose(pot: Visit, id: string): Promise<void> {
  await pot.command("Mix with…");
  await choice(pot, id).scrollIntoViewIfNeeded();
  await choice(pot, id).click();
  await share(pot).waitFor();
}

/** Radius and height of the rim, as the document in the page has them. */
const rim = (pot: Visit) =>
  pot.page.evaluate(() => {
    const app = document.querySelector("pasu-app") as unknown as {
      designer: {
        store: { design: { parts: { shape: { rings: { r: { mean: number }; z: { mean: number } }[] } }[] } };
      };
    };
    const last = app.designer.store.design.parts[0]?.shape.rings.at(-1);
    return last ? ([last.r.mean, last.z.mean] as const) : null;
  });

/** The name of what has the focus, however deep in shadow trees. */
const focused = (pot: Visit) =>
  pot.page.evaluate(() => {
    let active = document.activeElement;
    while (active?.shadowRoot?.activeElement) active = active.shadowRoot.activeElement;
    return active?.getAttribute("aria-label") ?? null;
  });

test("a drag shows every share on the stage, and all drags together are one step", { timeout: 240_000 }, async () => {
  const pot = await here.enter({ link: BOTTLE, viewport: { width: 1280, height: 800 } });
  const bottle = await pot.fingerprint();
  await pot.command("Mix with…");
  await choice(pot, "own-twisted-gourd").waitFor();
  expect(await findings(pot)).toEqual([]);
  await choice(pot, "form-jar").click();
  await share(pot).waitFor();
  // Nothing has changed yet, and the slider has the focus.
  expect(await pot.button("Undo").first().isDisabled()).toBe(true);
  expect(await share(pot).inputValue()).toBe("0");
  expect(await findings(pot)).toEqual([]);
  const [r, z] = (await rim(pot)) ?? [0, 0];
  const seen: number[] = [];
  await pot.drag("Share", 0.5, { held: async () => void seen.push((await rim(pot))?.[1] ?? 0) });
  const half = await pot.fingerprintOtherThan(bottle);
  expect(seen[0]).toBeCloseTo((await rim(pot))?.[1] ?? 0, 0);
  expect(Number(await share(pot).inputValue())).toBeCloseTo(50, -1);
  await pot.type("Share", "50");
  await expect.poll(() => rim(pot)).toEqual([(r + 5.2) / 2, (z + 18) / 2]);
  await pot.drag("Share", 1);
  const jar = await pot.fingerprintOtherThan(half);
  expect(await rim(pot)).toEqual([5.2, 18]);
  await pot.button("Keep").click();
  await pot.page.locator("pasu-mix").waitFor({ state: "detached" });
  expect(await pot.page.title()).toBe("Mine · Pasu");
  await pot.button("Undo").first().click();
  await pot.shows(bottle);
  expect(await pot.button("Undo").first().isDisabled()).toBe(true);
  await pot.button("Redo").first().click();
  await pot.shows(jar);
});

test("by keys: chosen, mixed, taken back, mixed again and left as it was", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const bottle = await pot.fingerprint();
  const { keyboard } = pot.page;
  await pot.button("Mix with…").focus();
  await keyboard.press("Enter");
  await choice(pot, "own-dancing-bottle").focus();
  await keyboard.press("Enter");
  await share(pot).waitFor();
  await expect.poll(() => focused(pot)).toBe("Share");
  await pot.slider("Share").focus();
  for (let i = 0; i < 3; i += 1) await keyboard.press("Shift+ArrowRight");
  const mixed = await pot.fingerprintOtherThan(bottle);
  expect(await share(pot).inputValue()).toBe("30");
  await pot.button("Undo").first().click();
  await pot.shows(bottle);
  expect(await share(pot).inputValue()).toBe("0");
  await pot.button("Redo").first().click();
  await pot.shows(mixed);
  expect(await share(pot).inputValue()).toBe("30");
  await pot.type("Share", "150");
  await pot.page.getByText("Type a number from 0 to 100.").waitFor();
  await pot.shows(mixed);
  await pot.button("Cancel").focus();
  await keyboard.press("Enter");
  await pot.page.locator("pasu-mix").waitFor({ state: "detached" });
  await pot.shows(bottle);
});

test("a drag that the system takes away leaves what was mixed before it, in one step", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const bottle = await pot.fingerprint();
  await choose(pot, "form-cup");
  const box = await pot.slider("Share").boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  const { mouse } = pot.page;
  const drag = async (from: number, to: number) => {
    await mouse.move(box.x + from * box.width, box.y + box.height / 2);
    await mouse.down();
    await mouse.move(box.x + to * box.width, box.y + box.height / 2, { steps: 4 });
  };
  await drag(0.02, 0.5);
  await mouse.up();
  const mixed = await pot.fingerprintOtherThan(bottle);
  const half = await share(pot).inputValue();
  await drag(0.5, 0.9);
  await expect.poll(() => share(pot).inputValue()).not.toBe(half);
  await pot.slider("Share").dispatchEvent("pointercancel");
  await pot.shows(mixed);
  expect(await share(pot).inputValue()).toBe(half);
  await mouse.up();
  await pot.button("Undo").first().click();
  await pot.shows(bottle);
});

test("on a phone with a finger, and with a design of one's own", async () => {
  const pot = await here.enter({ ...PHONE, link: BOTTLE });
  const bottle = await pot.fingerprint();
  await pot.command("My designs");
  await pot.button("Save to the shelf").tap();
  await pot.page.locator("pasu-shelf .pieces li").waitFor();
  await pot.page.keyboard.press("Escape");
  await pot.command("New");
  await pot.page.locator("pasu-new button[data-exhibit=form-gourd]").tap();
  const gourd = await pot.fingerprintOtherThan(bottle);
  await pot.button("Mix with…").tap();
  await pot.page.locator("pasu-mix-dialog").getByRole("button", { name: "Mine" }).tap();
  await share(pot).waitFor();
  const box = await pot.slider("Share").boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  await pot.page.touchscreen.tap(box.x + 0.7 * box.width, box.y + box.height / 2);
  await pot.fingerprintOtherThan(gourd);
  expect(Number(await share(pot).inputValue())).toBeGreaterThan(50);
  await pot.button("Keep").tap();
  await pot.button("Undo").first().tap();
  await pot.shows(gourd);
});

test("whoever opens another pot has had enough of mixing, and only single pots of rings are mixed", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const bottle = await pot.fingerprint();
  await choose(pot, "form-cup");
  await pot.openLink("#1/second-order");
  const vase = await pot.fingerprintOtherThan(bottle);
  expect(vase).not.toBe(bottle);
  await pot.page.locator("pasu-mix").waitFor({ state: "detached" });
  expect(await pot.button("Mix with…").count()).toBe(0);
});
