// A pot beside another: the same however it was written, and otherwise what became of each part.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const bowl = { kind: "second-order", r: [3, 0, 2, 0], height: 2 };
const vase = { kind: "second-order", r: [1, 0, 2, 0], height: 8 };
const at = (x: number) => ({ shift: [x, 0, 0] });
const scene = (...parts: object[]) => JSON.stringify({ pasu: 1, title: "Shelf", parts });

const SHELF = scene({ name: "Bowl", shape: bowl }, { name: "Vase", shape: vase, place: at(6) });

async function entered(text: string, options = {}): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("shelf.json", text);
  await pot.fingerprintOtherThan(first);
  return pot;
}

const dialogue = (pot: Visit) => pot.page.locator("pasu-compare");
const verdict = (pot: Visit) => dialogue(pot).locator(".verdict");

async function compare(pot: Visit, text: string): Promise<void> {
  await dialogue(pot).locator("textarea").fill(text);
  await dialogue(pot).getByRole("button", { name: "Compare", exact: true }).click();
}

/** The parts of each fate, as they are called. */
const told = (pot: Visit) =>
  dialogue(pot)
    .locator("[data-fate]")
    .evaluateAll((fates) =>
      Object.fromEntries(
        fates.map((fate) => [
          fate.getAttribute("data-fate"),
          [...fate.querySelectorAll(".part")].map((part) => (part.textContent ?? "").replace(/\s+/g, " ").trim()),
        ]),
      ),
    );

test("one scene in other words is the same pot", async () => {
  const pot = await entered(SHELF);
  await pot.command("Compare with…");
  await compare(pot, scene({ shape: vase, place: at(6), object: 5 }, { shape: bowl, object: 5 }));
  await expect.poll(() => verdict(pot).getAttribute("data-same")).toBe("true");
  expect(await told(pot)).toEqual({});
  // The address of the page itself, and what was saved from it.
  await compare(pot, await pot.page.evaluate(() => location.href));
  await expect.poll(() => verdict(pot).getAttribute("data-same")).toBe("true");
  expect(await findings(pot)).toEqual([]);
});

test("what became of each part is told, and a press selects it", async () => {
  const pot = await entered(SHELF);
  await pot.command("Compare with…");
  const wider = { ...bowl, r: [4, 0, 2, 0] };
  await compare(
    pot,
    scene({ name: "Vase", shape: vase, place: at(9) }, { name: "Bowl", shape: wider }, { shape: vase }),
  );
  await expect.poll(() => verdict(pot).getAttribute("data-same")).toBe("false");
  expect(await told(pot)).toEqual({ moved: ["Vase"], changed: ["Bowl"], gone: ["Part 3"] });
  expect(await findings(pot)).toEqual([]);
  await dialogue(pot).getByRole("button", { name: "Vase" }).click();
  await dialogue(pot).waitFor({ state: "detached" });
  expect(await pot.page.locator("pasu-parts [aria-selected=true] > span:first-child").innerText()).toBe("Vase");
});

test("what is no design is refused in words, and the pot stays as it was", async () => {
  const pot = await entered(SHELF);
  const shelf = await pot.fingerprint();
  await pot.command("Compare with…");
  for (const [text, words] of [
    ["", "There is nothing"],
    ["<img src=x onerror=alert(1)>", "link"],
    ['{ "pasu": 1, "parts": [{ "shape": { "kind": "amphora" } }] }', "amphora"],
  ] as const) {
    await compare(pot, text);
    await expect.poll(() => dialogue(pot).locator(".problem").innerText()).toContain(words);
  }
  // The same words are read aloud again: they are gone, and come back.
  await dialogue(pot)
    .locator(".problem")
    .evaluate((said) => void said.setAttribute("data-before", ""));
  await compare(pot, '{ "pasu": 1, "parts": [{ "shape": { "kind": "amphora" } }] }');
  await expect.poll(() => dialogue(pot).locator(".problem").getAttribute("data-before")).toBe(null);
  await pot.page.keyboard.press("Escape");
  await pot.shows(shelf);
});

test("by keys alone, on a phone, in every language", async () => {
  const pot = await here.enter({ ...PHONE, link: PSEUDO });
  await pot.fingerprint();
  // The words of the button are not those of English.
  await pot.page.locator("pasu-top-bar").evaluate((bar) => {
    const asked = new Event("command-chosen", { bubbles: true, composed: true });
    bar.dispatchEvent(Object.assign(asked, { command: "compare" }));
  });
  await dialogue(pot)
    .locator("textarea")
    .fill(JSON.stringify({ pasu: 1, parts: [{ shape: vase }, { shape: bowl }] }));
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => verdict(pot).getAttribute("data-same")).toBe("false");
  expect(await unmarked(pot)).toEqual([]);
  const over = await pot.page.evaluate(() => (document.scrollingElement?.scrollWidth ?? 0) - innerWidth);
  expect(over).toBeLessThanOrEqual(0);
  expect(await findings(pot)).toEqual([]);
});
