// The panel of a network of patches.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { LEAF, openLeaf, told } from "../support/network.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { stay } from "../support/stay.ts";
import { PHONE } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

test("the angle below which edges look smooth and the rule of strips are numbers of the panel", async () => {
  const { pot } = await openLeaf(here);
  const { page } = pot;
  const shape = () =>
    page.evaluate(() => {
      const { designer } = document.querySelector("pasu-app") as unknown as {
        designer: { store: { design: { parts: { shape: { crease?: number; rule?: unknown } }[] } } };
      };
      const { crease, rule } = designer.store.design.parts[0]?.shape ?? {};
      return { crease, rule };
    });
  const { rule: before } = await shape();
  const panel = page.locator("pasu-network-whole");
  await panel.getByText("All patches").first().click();
  const crease = panel.getByRole("spinbutton", { name: "Smooth up to" });
  expect(await crease.inputValue()).toBe("28.6479");
  const type = async (field: typeof crease, text: string) => {
    await field.fill(text);
    await field.press("Enter");
  };
  await type(crease, "90");
  await expect.poll(async () => (await shape()).crease).toBe(1.57079632679);
  await type(crease, "200");
  await panel.getByText("An angle from 0° to 180°.").waitFor();
  expect((await shape()).crease).toBe(1.57079632679);
  await type(crease, "0");
  await expect.poll(async () => (await shape()).crease).toBe(0);
  await page.keyboard.press("Tab");
  await pot.undo();
  await pot.undo();
  await expect.poll(() => crease.inputValue()).toBe("28.6479");

  await panel.getByRole("radio", { name: "its first patch" }).check();
  await expect.poll(async () => (await shape()).rule).toEqual({ seed: 0 });
  const seed = panel.getByRole("spinbutton", { name: "Counted from patch" });
  await type(seed, "2");
  await panel.getByText("Patches have the numbers 1 to 1.").waitFor();
  expect(await findings(pot)).toEqual([]);
  await type(seed, "1");
  expect(await panel.getByText("Patches have the numbers").count()).toBe(0);
  await panel.getByRole("radio", { name: "all its patches" }).check();
  await expect.poll(async () => (await shape()).rule).toBe("global");
  await pot.undo();
  await pot.undo();
  await expect.poll(async () => (await shape()).rule).toEqual(before);
});

test("everything is from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-network-panel [data-pick=all]").click();
  await pot.page.locator("pasu-network-patch .acts button").first().click();
  await pot.page.locator("pasu-network-patch .force").waitFor();
  expect(await unmarked(pot)).toEqual([]);
  await pot.page.locator("pasu-network-panel [data-command=patches]").click();
  await pot.page.locator("pasu-patches .stage canvas").waitFor();
  expect(await unmarked(pot)).toEqual([]);
});

test("patches are compared over the same edges, and what cannot be says so", async () => {
  const { pot } = await openLeaf(here);
  await pot.button("Patches compared…").click();
  const dialogue = pot.page.locator("pasu-patches");
  await dialogue.locator(".stage canvas").waitFor();
  expect(await findings(pot)).toEqual([]);
  await dialogue.locator(".stage").focus();
  await pot.page.keyboard.press("ArrowLeft");
  await pot.type("Height of the force", "-5");
  await pot.type("a₁, across", "3");
  expect(await dialogue.getByRole("alert").count()).toBe(0);
  const tooWide = dialogue.getByText("expected a region of the patch, up to 1");
  await pot.type("Width of its region", "1.5");
  await tooWide.waitFor();
  // An answer to what was typed before, which comes late, does not take that back.
  const shown = () =>
    dialogue.evaluate((element) => JSON.stringify((element as unknown as { shown: { design: object } }).shown.design));
  const before = await shown();
  const fields = await Promise.all(
    ["a₁, across", "Width of its region"].map((name) => pot.field(name).elementHandle()),
  );
  await pot.page.evaluate((both) => {
    for (const [at, text] of ["4", "1.6"].entries()) {
      const field = both[at] as HTMLInputElement;
      field.value = text;
      field.dispatchEvent(new InputEvent("input", { bubbles: true, composed: true }));
    }
  }, fields);
  await expect.poll(shown).not.toBe(before);
  expect(await tooWide.count()).toBe(1);
  await pot.type("Width of its region", "0.8");
  await expect.poll(() => dialogue.getByRole("alert").count()).toBe(0);
  await pot.type("a₂, along", "0");
  // A strip needs it: the solver's own words.
  await dialogue.getByText("This cannot be shown").waitFor();
  await pot.page.keyboard.press("Escape");
  await dialogue.waitFor({ state: "detached" });
});

test("on a phone the panel fits, and everything in it can be pressed", async () => {
  const { pot } = await openLeaf(here, { ...PHONE });
  await pot.page.locator("pasu-network-panel [data-pick=all]").tap();
  await pot.page.locator("pasu-network-patch .acts button").first().tap();
  await pot.page.locator("pasu-network-patch .force").waitFor();
  expect(await overhang(pot)).toBeLessThanOrEqual(0);
  expect(await unreachable(pot)).toEqual([]);
  expect(await findings(pot)).toEqual([]);
});

test("a new network is one of the pictures", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  await pot.command("New");
  await pot.page.getByText("From patches").click();
  await pot.page.locator('pasu-new button[data-exhibit="own-mug"]').click();
  await pot.fingerprintOtherThan(first);
  expect(await told(pot)).toContain("110 patches through 330 points");
});
