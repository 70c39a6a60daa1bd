// For everyone: with a keyboard alone, with a screen reader, in light and in dark.
//
// What its time buys: axe looks at every state of the page at two sizes and in two themes.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { sight } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, PHONE, type Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();

/** What a Tab stop is called, and whether the focus can be seen there. */
interface Stop {
  readonly name: string;
  readonly visible: boolean;
}

async function stop(pot: Visit): Promise<Stop | null> {
  return await pot.page.evaluate(() => {
    let active = document.activeElement;
    while (active?.shadowRoot?.activeElement) active = active.shadowRoot.activeElement;
    if (!active || active === document.body) return null;
    const labels = (active as HTMLInputElement).labels;
    const name =
      active.getAttribute("aria-label") || labels?.[0]?.textContent?.trim() || active.textContent?.trim() || "";
    // A swatch draws the ring of the radio button inside it.
    const ringed = [active, active.closest("label")].some((element) => {
      const style = element && getComputedStyle(element);
      return (
        style && ((style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0) || style.boxShadow !== "none")
      );
    });
    const own = active.shadowRoot === null && active.querySelector(".ring");
    const ring = own ? getComputedStyle(own) : null;
    return { name, visible: ringed || (ring !== null && ring.stroke !== "none" && ring.opacity !== "0") };
  });
}

test.each<[string, VisitOptions]>([
  ["light", { colorScheme: "light" }],
  ["dark", { colorScheme: "dark" }],
  ["on a phone", PHONE],
])("axe-core finds nothing, %s", { timeout: 400_000 }, async (_, options) => {
  const pot = await here.enter({ link: "#1/second-order", ...options });
  const before = await pot.fingerprint();
  const check = async (where: string) => expect(await findings(pot), where).toEqual([]);
  await check("the page");
  for (const name of ["Profile", "Equation", "Look"] as const) {
    await pot.tab(name);
    await check(`the panel “${name}”`);
  }
  await pot.makePot();
  await check("the wall");
  await pot.tab("Measures");
  await pot.button("Fill it").click();
  await pot.page.getByRole("combobox", { name: "Colours show" }).selectOption({ label: "overhang" });
  await pot.page.getByRole("img", { name: /^Overhang: colours/ }).waitFor();
  await pot.button("How exact").click();
  await check("the measures");
  await pot.button("Pour it out").click();
  await pot.command("Export");
  // The panel says so as well, before the dialogue is there.
  await pot.page.locator("pasu-export").getByText("The mesh is closed").waitFor();
  await check("the dialogue “Export”");
  await pot.page.keyboard.press("Escape");
  await pot.page.getByRole("dialog").waitFor({ state: "detached" });
  await pot.tab("Wall");
  await pot.button("Remove the wall").click();
  await pot.button("Make it a pot").waitFor();
  await check("the panel “Wall” of a surface");
  await pot.fingerprint();
  await pot.tab("Shape");
  await pot.button("Explain").click();
  await check("the parameters explained");
  await pot.type("Wall stiffness", "0");
  await pot.page.getByRole("alert").first().waitFor();
  await check("an impossible value");
  await pot.undo();
  await pot.shows(before);
  await pot.button("Overlays").click();
  await check("the overlays");
  await pot.page.keyboard.press("Escape");
  for (const name of ["New", "Gallery", "Picture", "Help"] as const) {
    await pot.command(name);
    await pot.page.getByRole("dialog").waitFor();
    await check(`the dialogue “${name}”`);
    await pot.page.keyboard.press("Escape");
    await pot.page.getByRole("dialog").waitFor({ state: "detached" });
  }
  await pot.type("Height", "5");
  const mine = await pot.fingerprintOtherThan(before);
  await pot.openLink("#1/fourth-order");
  await pot.dialog("Open this link?").waitFor();
  await check("the question about unsaved work");
  await pot.button("Open the link").click();
  // Until then the address is about to be written.
  await pot.fingerprintOtherThan(mine);
  await pot.openLink("#1~AAAA");
  await pot.page.getByRole("alert").waitFor();
  await check("a damaged link");
});

test.each(["light", "dark"] as const)(
  "where a field is can be seen: its border stands out from what is round it, %s",
  async (colorScheme) => {
    const pot = await here.enter({ link: "#1/second-order", colorScheme });
    // The pot may stand on the stage before its numbers are there.
    await pot.page.getByRole("spinbutton").nth(5).waitFor();
    const ratios = await pot.page.getByRole("spinbutton").evaluateAll((fields) =>
      fields.map((field) => {
        const light = (colour: string) => {
          const [r = 0, g = 0, b = 0] = (colour.match(/[\d.]+/g) ?? []).map((part) => {
            const share = Number(part) / 255;
            return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
          });
          return 0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05;
        };
        const { borderTopColor, backgroundColor } = getComputedStyle(field);
        const [border, ground] = [light(borderTopColor), light(backgroundColor)];
        return Math.max(border, ground) / Math.min(border, ground);
      }),
    );
    expect(ratios.length).toBeGreaterThan(5);
    expect(Math.min(...ratios)).toBeGreaterThanOrEqual(3);
  },
);

test("free boundary data pass axe-core as well", async () => {
  const pot = await here.enter();
  const before = await pot.fingerprint();
  await pot.command("New");
  await pot.page.locator("pasu-new summary").last().click();
  await pot.button(/^Free boundary data/).click();
  await pot.fingerprintOtherThan(before);
  expect(await findings(pot)).toEqual([]);
});

test("every stop of the Tab key has a name and a visible focus, there and back", async () => {
  const pot = await here.enter({ link: "#1/second-order?height=5" });
  await pot.fingerprint();
  const stops: Stop[] = [];
  for (let i = 0; i < 120; i += 1) {
    await pot.page.keyboard.press("Tab");
    const here = await stop(pot);
    if (here === null) break;
    stops.push(here);
  }
  expect(stops.filter((each) => each.name === "")).toEqual([]);
  expect(stops.filter((each) => !each.visible)).toEqual([]);
  const names = stops.map((each) => each.name);
  expect(names[0]).toBe("Skip to the parameters");
  for (const name of ["Title", "Copy link", "The pot", "Overlays", "Height", "Set Height"]) {
    expect(
      names.some((each) => each.startsWith(name)),
      `${name} in ${names.join(", ")}`,
    ).toBe(true);
  }
  expect(stops.length).toBeLessThan(120);
});

test("a tour of the page without a mouse", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const { keyboard } = pot.page;
  const first = await pot.fingerprint();
  // Past the bar, to the parameters; the arrow keys go from panel to panel.
  await keyboard.press("Tab");
  await keyboard.press("Enter");
  expect((await stop(pot))?.name).toBe("Shape");
  await keyboard.press("ArrowRight");
  await expect.poll(async () => (await stop(pot))?.name).toBe("Profile");
  await keyboard.press("ArrowLeft");
  await expect.poll(async () => (await stop(pot))?.name).toBe("Shape");
  // On to the first number.
  for (let i = 0; i < 10 && !(await stop(pot))?.name.startsWith("Rim radius"); i += 1) await keyboard.press("Tab");
  await keyboard.type("1,25");
  await keyboard.press("Enter");
  const second = await pot.fingerprintOtherThan(first);
  await keyboard.press("Tab");
  await keyboard.press("PageUp");
  const third = await pot.fingerprintOtherThan(second);
  await keyboard.press("Control+z");
  await pot.shows(second);
  await keyboard.press("Control+Shift+z");
  await pot.shows(third);
  // Help by its key, and back to where the focus was.
  const was = (await stop(pot))?.name;
  await keyboard.press("?");
  await pot.dialog("Help").waitFor();
  await keyboard.press("Escape");
  await pot.dialog("Help").waitFor({ state: "detached" });
  await expect.poll(async () => (await stop(pot))?.name).toBe(was);
  // A pot from the gallery.
  await pot.history("Undo").focus();
  for (let i = 0; i < 5 && (await stop(pot))?.name !== "Gallery"; i += 1) await keyboard.press("Tab");
  await keyboard.press("Enter");
  await pot.dialog("Gallery").waitFor();
  for (let i = 0; i < 5 && !(await stop(pot))?.name.startsWith("Dint vase"); i += 1) await keyboard.press("Tab");
  await keyboard.press("Enter");
  await expect.poll(() => pot.page.title()).toBe("Dint vase · Pasu");
  await pot.fingerprintOtherThan(third);
  expect(await stop(pot)).not.toBeNull();
});

test("the focus stays on what has nothing more to do, and goes from a button that goes to its opposite", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const { keyboard } = pot.page;
  const surface = await pot.fingerprint();
  const focused = async () => (await stop(pot))?.name;
  await pot.tab("Wall");
  await pot.button("Make it a pot").focus();
  for (const next of ["Remove the wall", "Make it a pot"]) {
    await keyboard.press("Enter");
    await pot.button(next).waitFor();
    expect(await focused()).toBe(next);
  }
  for (const name of ["Undo", "Redo"] as const) {
    await pot.history(name).focus();
    // Once more than there is anything to do.
    for (let step = 0; step < 3; step += 1) await keyboard.press("Enter");
    await expect.poll(() => pot.history(name).isDisabled()).toBe(true);
    expect(await focused()).toBe(name);
  }
  await pot.shows(surface);
});

test("sliders have a track where the colours are forced", async () => {
  const pot = await here.enter({ link: "#1/second-order", ...CLEAR, forcedColors: "active" });
  await pot.fingerprint();
  const slider = pot.page.getByRole("slider", { name: "Height" });
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  // What is left of its ends, where the thumb is not.
  for (const from of [0.03, 0.85]) {
    const clip = { x: box.x + from * box.width, y: box.y, width: 0.1 * box.width, height: box.height };
    expect(sight(await pot.page.screenshot({ clip })).tones).toBeGreaterThan(1);
  }
});

test("only the tab that is shown has a line where the colours are forced", async () => {
  const pot = await here.enter({ link: "#1/second-order", ...CLEAR, forcedColors: "active" });
  await pot.fingerprint();
  await pot.tab("Look");
  const lines = await pot.page.getByRole("tab").evaluateAll((tabs) =>
    tabs.map((tab) => {
      const { borderTopColor, borderBottomColor } = getComputedStyle(tab);
      return { isShown: tab.ariaSelected === "true", borderTopColor, borderBottomColor };
    }),
  );
  const unseen = lines.find(({ isShown }) => !isShown)?.borderTopColor;
  expect(unseen).toBe("rgb(255, 255, 255)");
  for (const { isShown, borderTopColor, borderBottomColor } of lines) {
    expect(borderTopColor).toBe(unseen);
    expect(borderBottomColor === unseen).toBe(!isShown);
  }
});

test("the shape is told in words, and told again when it changes", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  const told = pot.page.locator("pasu-app p.spoken[role=status]");
  await expect.poll(() => told.innerText()).toMatch(/^A .* 3\.6 cm high .*7 petals/);
  await pot.type("Height", "4.8");
  await pot.fingerprintOtherThan(before);
  await expect.poll(() => told.innerText()).toMatch(/^A .* 4\.8 cm high/);
});

test("a pot with a wall is spoken of once, with its wall, and not again for a title", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const told = pot.page.locator("pasu-app p.spoken[role=status]");
  await expect.poll(() => told.innerText(), { timeout: 30_000 }).toMatch(/^A /);
  const before = await told.innerText();
  await told.evaluate((region) => {
    const all: string[] = [];
    Object.assign(globalThis, { all });
    new MutationObserver(() => all.push((region as HTMLElement).innerText)).observe(region, {
      subtree: true,
      childList: true,
      characterData: true,
    });
  });
  const said = () => pot.page.evaluate(() => (globalThis as unknown as { all: string[] }).all);
  await pot.tab("Wall");
  await pot.button("Make it a pot").click();
  await pot.button("Remove the wall").waitFor();
  await expect.poll(async () => (await said()).length, { timeout: 30_000 }).toBe(1);
  expect((await said())[0]).not.toBe(before);
  // All that is measured is known.
  await pot.page
    .getByText(/^Holds /)
    .first()
    .waitFor({ timeout: 30_000 });
  await pot.page.getByRole("textbox", { name: "Title" }).fill("Another");
  await pot.page.keyboard.press("Enter");
  await pot.type("Thickness", "0.4");
  // It speaks of the other wall next, and of nothing before.
  await expect.poll(async () => (await said()).length, { timeout: 30_000 }).toBe(2);
});

test("what is chosen is marked where the colours are forced", async () => {
  const pot = await here.enter({ link: "#1/second-order", ...CLEAR, forcedColors: "active" });
  await pot.fingerprint();
  await pot.tab("Wall");
  await pot.button("Make it a pot").click();
  await pot.button("Remove the wall").waitFor();
  const outlines = (inside: string) =>
    pot.page
      .locator(`${inside} label:has(input[type=radio])`)
      .evaluateAll((labels) =>
        labels.map((label) => [
          (label.querySelector("input") as HTMLInputElement).checked,
          getComputedStyle(label).outlineStyle === "solid",
        ]),
      );
  const marks = await outlines("pasu-wall");
  expect(marks.length).toBeGreaterThanOrEqual(2);
  for (const [chosen, outlined] of marks) expect(outlined).toBe(chosen);
  await pot.tab("Look");
  await pot.page.locator("pasu-look .swatch").first().waitFor();
  const looks = await outlines("pasu-look");
  expect(looks.filter(([chosen]) => chosen)).toHaveLength(2);
  for (const [chosen, outlined] of looks) expect(outlined).toBe(chosen);
  // Colours are what a glaze is chosen by.
  const dots = await pot.page
    .locator("pasu-look .dot:not(.any)")
    .evaluateAll((all) => all.map((dot) => getComputedStyle(dot).backgroundColor));
  expect(new Set(dots).size).toBeGreaterThan(5);
});

test("the focus is never lost where something goes or is busy, and a menu closes when it goes elsewhere", async () => {
  const pot = await here.enter({ link: "#1/rings" });
  const { keyboard } = pot.page;
  const plain = await pot.fingerprint();
  const focused = async () => (await stop(pot))?.name;
  // Out of a menu with the Tab key.
  const change = pot.button("Change Ring 1");
  await change.focus();
  await keyboard.press("Enter");
  await pot.button("Delete").waitFor();
  for (let step = 0; step < 8 && (await change.getAttribute("aria-expanded")) === "true"; step += 1)
    await keyboard.press("Tab");
  expect(await change.getAttribute("aria-expanded")).toBe("false");
  expect(await focused()).not.toBeUndefined();
  // With the ring goes the button that had the focus.
  await change.focus();
  await keyboard.press("Enter");
  await pot.button("Delete").focus();
  await keyboard.press("Enter");
  const fewer = await pot.fingerprintOtherThan(plain);
  await expect.poll(focused).toBe("Change Foot");
  // A size that is tried for a pot with a wall.
  await pot.tab("Measures");
  const height = pot.page.locator("pasu-size").getByRole("textbox", { name: "Height" });
  await expect.poll(() => height.isEnabled()).toBe(true);
  await height.fill("8");
  await keyboard.press("Enter");
  await pot.fingerprintOtherThan(fewer);
  await expect.poll(() => height.inputValue()).toBe("8");
  expect(await height.evaluate((it) => it.matches(":focus"))).toBe(true);
  // What is said of it belongs to it.
  await height.fill("-3");
  await keyboard.press("Enter");
  await expect.poll(() => height.getAttribute("aria-describedby")).toBe("problem");
  await expect.poll(() => height.getAttribute("aria-invalid")).toBe("true");
});
