// Nothing is said that is not in the catalogue: the page in a language whose every letter is changed, in all that can be opened.

import { expect, test } from "vitest";
import { marked } from "../../web/src/words/pseudo.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";
import { PSEUDO, said, unmarked } from "../support/words.ts";

const here = stay();

/** What was opened has a title and names that cannot be taken for words of the page. */
const SCENE = {
  pasu: 1,
  title: "12",
  parts: [
    { shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 2 }, name: "1" },
    { shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 2 }, place: { shift: [3, 0, 0] } },
  ],
};

/** As {@link Visit}, by the English words. */
class Stranger {
  constructor(readonly pot: Visit) {}

  button(name: string) {
    return this.pot.button(marked(name));
  }

  async command(name: string): Promise<void> {
    if (!(await this.button(name).isVisible())) await this.button("More").click();
    await this.button(name).click();
  }

  async tab(name: string): Promise<void> {
    await this.pot.page.getByRole("tab", { name: marked(name) }).click();
  }

  async type(name: string, text: string): Promise<void> {
    await this.pot.type(marked(name), text);
  }

  /** A dialogue that is open, until it is closed again. */
  async dialogue(name: string, then: () => Promise<void>): Promise<void> {
    await this.command(name);
    await this.pot.page.getByRole("dialog").waitFor();
    await then();
    await this.pot.page.keyboard.press("Escape");
    await this.pot.page.getByRole("dialog").waitFor({ state: "detached" });
  }

  async check(where: string): Promise<void> {
    // One run tells of every place.
    expect.soft(await unmarked(this.pot), where).toEqual([]);
  }
}

async function enter(link: string, options: VisitOptions = {}): Promise<Stranger> {
  const pot = await here.enter({ ...options, link: `${PSEUDO}${link}` });
  await pot.fingerprint();
  return new Stranger(pot);
}

test.each<[string, VisitOptions]>([
  ["on a desk", {}],
  ["on a phone", PHONE],
])(
  "every panel, tab, menu and dialogue speaks the words of the catalogue alone, %s",
  { timeout: 400_000 },
  async (_, options) => {
    const page = await enter("#1/second-order", options);
    const { pot } = page;
    await page.button("Explain").click();
    expect(await said(pot)).toBeGreaterThan(60);
    expect(await pot.page.evaluate(() => document.documentElement.lang)).toBe("en-XA");
    await page.check("the page and its parameters");
    await page.tab("Profile");
    await pot.page.locator("pasu-profile svg[role]").waitFor();
    await page.check("the profile");
    await page.tab("Equation");
    await page
      .button("Show side by side with Fourth order")
      .or(pot.button(/⟦Šĥöŵ šîðé/).first())
      .first()
      .click();
    await pot.page.locator("pasu-captions p").first().waitFor();
    await page.check("the orders, two side by side");
    await page.tab("Look");
    await pot.page.locator("pasu-look select").first().waitFor();
    await page.check("the look");
    await page.tab("Wall");
    await page.check("the wall of a surface");
    await page.button("Make it a pot").click();
    await pot.page
      .locator("pasu-wall .holds")
      .getByText(/^⟦Ĥöļðš/)
      .waitFor();
    await page.check("the wall");
    await pot.page
      .locator("pasu-wall")
      .getByRole("checkbox", { name: marked("Foot ring") })
      .check();
    await page.type("Ring width", "0.6");
    await page.tab("Measures");
    await pot.page.locator("pasu-measures .sentences li").first().waitFor();
    await pot.page.locator("pasu-measures .groups").waitFor();
    await page.check("the measures");
    await page.button("Fill it").click();
    await pot.page.locator("pasu-water .volume").getByText(/\d/).waitFor();
    for (const map of ["mean curvature", "gaussian curvature", "wall thickness", "overhang"]) {
      await pot.page.getByRole("combobox", { name: marked("Colours show") }).selectOption({ label: marked(map) });
      await pot.page.locator("pasu-legend .ramp").waitFor();
      await page.check(`the map of ${map}`);
    }
    await page.button("How exact").click();
    await page.check("the exact measures, water and a map");
    await page.button("Pour it out").click();
    await page.button("Overlays").click();
    await pot.page.getByRole("checkbox", { name: marked("Axes and dimensions") }).check();
    await page.check("the overlays");
    await page.dialogue("Link with this view", async () => {
      await page.button("Copy").click();
      await pot.page.locator("pasu-link .copied").filter({ hasText: /\S/ }).waitFor();
      await page.check("the link with the view");
    });
    await page.button("Overlays").click();
    await pot.page.keyboard.press("Escape");
    if (await page.button("View").isVisible()) {
      await page.button("View").click();
      await page.check("the views");
      await pot.page.keyboard.press("Escape");
    }
    await page.dialogue("Export", async () => {
      await pot.page.locator("pasu-export .outcome .sentences li").first().waitFor();
      const fields = pot.page.locator("pasu-export input.field");
      await fields.first().fill("60");
      await pot.page.locator("pasu-export .wrong").waitFor();
      await page.check("the dialogue “Export”");
      for (const format of ["3mf", "stl", "step", "svg", "a4.svg", "letter.svg", "glb", "obj", "obj.zip", "ply"]) {
        const radio = pot.page
          .locator("pasu-export .formats input")
          .nth(["3mf", "stl", "step", "svg", "a4.svg", "letter.svg", "glb", "obj", "obj.zip", "ply"].indexOf(format));
        await radio.check({ force: true });
        await page.check(`the format ${format}`);
      }
    });
    await page.dialogue("New", async () => {
      await pot.page.locator("pasu-new summary").first().click();
      await pot.page.locator("pasu-new button[data-exhibit=own-star-dish]").waitFor();
      await page.check("the dialogue “New”, with sections to choose from");
      await pot.page.locator("pasu-new summary").last().click();
      await pot.page.locator("pasu-new button[data-exhibit=new-free]").waitFor();
      await page.check("the dialogue “New”, with the families of the equations");
    });
    for (const name of ["Gallery", "My designs", "Picture", "Embed", "Help"]) {
      await page.dialogue(name, () => page.check(`the dialogue “${name}”`));
    }
    await page.dialogue("My designs", async () => {
      await page.button("Save to the shelf").click();
      await page.button("Undo").last().waitFor();
      await pot.page.locator("pasu-shelf .pieces li").waitFor();
      await page.check("a design on the shelf");
    });
  },
);

test("what goes wrong is said in the words of the catalogue", { timeout: 400_000 }, async () => {
  const page = await enter("#1/second-order");
  const { pot } = page;
  const first = await pot.fingerprint();
  const alert = pot.page.getByRole("alert").first();
  await page.type("Wall stiffness", "0");
  await alert.waitFor();
  await page.check("an impossible value");
  await page.type("Height", "?");
  await page.check("what is no number");
  await page.button("Undo").first().click();
  await pot.shows(first);
  await pot.openLink("#1~AAAA");
  await alert.waitFor();
  await page.check("a damaged link");
  await page.button("Dismiss").click();
  for (const [name, text] of [
    ["1", '{ "beach": true }'],
    ["2", "1, 2"],
    ["3", '{ "pasu": 1, "parts": [{ "shape": { "kind": "teapot" } }] }'],
    ["4.svg", "00"],
  ] as const) {
    await pot.dropFile(name, text);
    await alert.waitFor();
    await page.check(`the file ${name}`);
    await page.button("Dismiss").click();
    await alert.waitFor({ state: "detached" });
  }
  await pot.dropFile("5.stl", "00");
  await pot.page.locator("pasu-scan .trouble").waitFor();
  await page.check("triangles that are none");
  await pot.page.keyboard.press("Escape");
  await pot.page.locator("pasu-scan").waitFor({ state: "detached" });
  await page.button("Copy link").click();
  await pot.page.locator(".toast").waitFor();
  // Whoever is given the link has a language of their own.
  expect(await pot.page.evaluate(() => navigator.clipboard.readText())).not.toContain("lang");
  await page.check("a notice");
  await page.type("Height", "5");
  await pot.fingerprintOtherThan(first);
  await pot.openLink("#1/fourth-order");
  await pot.page.getByRole("dialog").waitFor();
  await page.check("the question about unsaved work");
});

test("several parts, free boundary data and a pot that cannot be made are told from the catalogue", {
  timeout: 400_000,
}, async () => {
  const page = await enter("");
  const { pot } = page;
  const first = await pot.fingerprint();
  await page.check("the first pot");
  await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { notices: { announceNewVersion(): void } };
    };
    designer.notices.announceNewVersion();
  });
  await page.button("Reload").waitFor();
  await page.check("a new version");
  const card = await pot.page
    .locator("pasu-stage canvas")
    .first()
    .evaluateHandle((element) =>
      (element as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context"),
    );
  await card.evaluate((extension) => extension?.loseContext());
  await pot.page.locator("pasu-stage .note").waitFor();
  await page.check("a graphics card that was taken away");
  await card.evaluate((extension) => extension?.restoreContext());
  await pot.page.locator("pasu-stage .note").waitFor({ state: "detached" });
  await pot.dropFile("1", JSON.stringify(SCENE));
  const scene = await pot.fingerprintOtherThan(first);
  await pot.page.getByRole("listbox").waitFor();
  await page.check("the parts");
  await page.button("Hide").click();
  await pot.page.locator("pasu-parts [data-hidden]").waitFor();
  await page.check("a hidden part");
  await pot.page.locator("pasu-arrange summary").click();
  await page.button("Make the ring").waitFor();
  await page.check("copies of a part");
  await pot.page.getByRole("listbox").focus();
  await pot.page.keyboard.press("Control+a");
  await page.button("Stand on it").waitFor();
  await pot.page.locator("pasu-glue-matrix summary").click();
  await page.check("several parts and what is glued");
  await page.button("Move").click();
  for (const name of ["Move", "Turn", "Scale"]) {
    // By keys: the notice of a new version lies over the bar.
    await pot.page.getByRole("radio", { name: marked(name), exact: true }).focus();
    await pot.page.keyboard.press("Space");
    await page.check(`handles of parts: ${name}`);
  }
  await page.button("Lock where it stands").click();
  await pot.page.locator("pasu-place-bar .note:not([hidden])").waitFor();
  await page.check("locked parts");
  await page.button("Unlock").click();
  await page.button("Move").click();
  await pot.page.locator("pasu-arrange summary").click();
  await pot.page.getByRole("listbox").focus();
  await pot.page.keyboard.press("Home");
  await page.tab("Wall");
  await page.button("Make it a pot").click();
  await page.type("Thickness", "3");
  await page.tab("Measures");
  await pot.page.locator("pasu-measures .sentences li.warning").first().waitFor();
  await page.check("a wall that had to be thinned, beside a part that has none");
  await page.tab("Shape");
  await page.command("New");
  await pot.page.locator("pasu-new summary").last().click();
  await pot.page.locator("pasu-new button[data-exhibit=new-free]").click();
  await pot.fingerprintOtherThan(scene);
  await pot.page.locator("pasu-modes").getByRole("combobox").first().waitFor();
  await page.check("free boundary data");
});

test("a pot of rings that is mixed with another is told from the catalogue", { timeout: 400_000 }, async () => {
  const page = await enter("#1/rings?title=1");
  const { pot } = page;
  await page.button("Mix with…").click();
  await pot.page.locator("pasu-mix-dialog button[data-exhibit=form-cup]").waitFor();
  await page.check("what to mix with");
  await pot.page.locator("pasu-mix-dialog button[data-exhibit=form-cup]").click();
  await pot.field(marked("Share")).waitFor();
  await page.check("the slider that mixes");
});

test("where there is no WebGL2 that is said from the catalogue", async () => {
  const before = async ({ context }: Visit) => {
    await context.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
        apply: (target, self, given) => (given[0] === "webgl2" ? null : Reflect.apply(target, self, given)),
      });
    });
  };
  const page = await enter("#1/second-order", { before });
  await page.pot.page.locator("pasu-stage .note").waitFor();
  await page.check("the page that stands still");
});

test("a person's browser never speaks it, and English numbers stay what they were", async () => {
  const pot = await here.enter({ locale: "de-DE", link: "#1/second-order?height=5.5" });
  await pot.fingerprint();
  expect(await pot.page.evaluate(() => document.documentElement.lang)).toBe("en");
  expect(await said(pot)).toBe(0);
  expect(await pot.field("Height").inputValue()).toBe("5.5");
});
