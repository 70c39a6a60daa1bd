// The design on the stage held against another scene: coloured parts, hatched ones, and a list that follows the design.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { atRest } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, PHONE, type Visit, type VisitOptions } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const block = (name: string, object: number, shift: readonly number[], scale: readonly number[] = [1, 1, 1]) => ({
  name,
  object,
  shape: { kind: "octant", exponents: [8, 8, 8] },
  place: { scale, shift },
});
/** Of a form that the other scene has not: what is of one form is one part, whatever it is called. */
const LID = { ...block("Lid", 3, [-2, 0, 0]), shape: { kind: "octant", exponents: [3, 3, 3] } };
const scene = (...parts: readonly object[]) => JSON.stringify({ pasu: 1, title: "Table", parts });
const BEFORE = scene(block("Jar", 0, [0, 0, 0]), block("Cup", 1, [2, 0, 0]), block("Bowl", 2, [4, 0, 0]));
const AFTER = scene(block("Jar", 0, [0, 0, 0]), block("Cup", 1, [2, 2, 0]), LID);

async function compared(options: VisitOptions = {}, [before, after] = [BEFORE, AFTER]): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("table.json", after);
  await pot.fingerprintOtherThan(first);
  // The words of the button are not always those of English.
  await pot.page.locator("pasu-top-bar").evaluate((bar) => {
    const asked = new Event("command-chosen", { bubbles: true, composed: true });
    bar.dispatchEvent(Object.assign(asked, { command: "compare" }));
  });
  const dialogue = pot.page.locator("pasu-compare");
  await dialogue.locator("textarea").fill(before);
  await pot.page.keyboard.press("Enter");
  await dialogue.locator(".verdict").waitFor();
  return pot;
}

const panel = (pot: Visit) => pot.page.locator("pasu-contrast");
async function onStage(pot: Visit): Promise<void> {
  await pot.page.locator("pasu-compare .start button").click();
  await pot.page.locator("pasu-compare").waitFor({ state: "detached" });
  await panel(pot).locator("section").waitFor();
}

/** The parts of each fate, as the list has them. */
async function told(pot: Visit): Promise<Readonly<Record<string, readonly string[]>>> {
  return await panel(pot)
    .locator("[data-fate]")
    .evaluateAll((fates) =>
      Object.fromEntries(
        fates.map((fate) => [
          fate.getAttribute("data-fate"),
          [...fate.querySelectorAll(".part")].map((part) => (part.textContent ?? "").trim()),
        ]),
      ),
    );
}

test("the list follows what is done to the design, by pointer and keys, until it is closed", async () => {
  const pot = await compared();
  await onStage(pot);
  await expect.poll(() => told(pot)).toEqual({ moved: ["Cup"], added: ["Lid"], gone: ["Bowl"], kept: ["Jar"] });
  expect(await findings(pot)).toEqual([]);
  await panel(pot).getByRole("button", { name: "Lid" }).click();
  expect(await pot.page.locator("pasu-parts [aria-selected=true] > span:first-child").innerText()).toBe("Lid");
  await pot.page.getByRole("listbox", { name: "Parts" }).focus();
  await pot.page.keyboard.press("Delete");
  await expect.poll(() => told(pot)).toEqual({ moved: ["Cup"], gone: ["Bowl"], kept: ["Jar"] });
  await pot.undo();
  await expect.poll(() => told(pot)).toEqual({ moved: ["Cup"], added: ["Lid"], gone: ["Bowl"], kept: ["Jar"] });
  // Another design is held against the same one.
  await pot.dropFile("before.json", BEFORE);
  await panel(pot).getByText("The same pot").waitFor();
  const fold = panel(pot).getByRole("button", { name: "Compared with Table" });
  await fold.focus();
  await pot.page.keyboard.press("Enter");
  expect(await fold.getAttribute("aria-expanded")).toBe("false");
  await pot.page.keyboard.press("Tab");
  await pot.page.keyboard.press("Enter");
  await panel(pot).waitFor({ state: "detached" });
  expect(await pot.page.evaluate(() => document.activeElement?.shadowRoot?.activeElement?.localName)).toBe(
    "pasu-stage",
  );
});

/** How many pixels of the stage are far more of one colour than of both others: red, green and blue. */
async function coloured(pot: Visit): Promise<readonly number[]> {
  await atRest(pot);
  const shot = (await pot.page.locator("pasu-stage").screenshot()).toString("base64");
  return await pot.page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const paper = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!paper) throw new Error("no paper");
    paper.drawImage(image, 0, 0);
    const { data } = paper.getImageData(0, 0, image.width, image.height);
    const counts = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const colour = [data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0];
      const most = colour.indexOf(Math.max(...colour));
      const others = colour.filter((_, k) => k !== most);
      if ((colour[most] ?? 0) > 1.45 * Math.max(...others, 20)) counts[most] = (counts[most] ?? 0) + 1;
    }
    return counts;
  }, shot);
}

test("on the stage what was moved is blue, what is new green and what is gone red, until that is closed", async () => {
  const pot = await compared({ ...CLEAR, serviceWorkers: "block" });
  await onStage(pot);
  await expect.poll(() => told(pot)).toHaveProperty("kept");
  // The list is in front of nothing that counts.
  await panel(pot).getByRole("button", { name: "Compared with Table" }).click();
  const [red = 0, green = 0, blue = 0] = await coloured(pot);
  expect(Math.min(red, green, blue)).toBeGreaterThan(300);
  await pot.page.locator("pasu-contrast").getByRole("button", { name: "Compare no longer" }).click();
  const [red0 = 0, green0 = 0, blue0 = 0] = await coloured(pot);
  expect(red0).toBeLessThan(red / 10);
  expect(green0).toBeLessThan(green / 10);
  expect(blue0).toBeLessThan(blue / 10);
});

test("on a phone, in the dark, in every language", async () => {
  const plain = (text: string) =>
    text
      .replace(/"name":"(\w+)"/g, (_, name: string) => `"name":"${name.length}${name.charCodeAt(0)}"`)
      .replace("Table", "1");
  const pot = await compared({ ...PHONE, colorScheme: "dark", link: PSEUDO }, [plain(BEFORE), plain(AFTER)]);
  await onStage(pot);
  const fold = panel(pot).locator(".bar button").first();
  expect(await fold.getAttribute("aria-expanded")).toBe("false");
  await fold.tap();
  await expect.poll(async () => Object.keys(await told(pot))).toEqual(["moved", "added", "gone", "kept"]);
  expect(await unmarked(pot)).toEqual([]);
  expect(await findings(pot)).toEqual([]);
  const over = await pot.page.evaluate(() => (document.scrollingElement?.scrollWidth ?? 0) - innerWidth);
  expect(over).toBeLessThanOrEqual(0);
});
