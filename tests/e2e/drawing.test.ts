// A pot is drawn by mouse, by finger and by keys, or traced from an SVG file or a photograph, and becomes rings at the size that was said.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { fingers, type Spot } from "../support/pulling.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const LINK = "#1/rings";
const board = (pot: Visit) => pot.page.locator("pasu-drawing-board svg");
const told = (pot: Visit) => pot.page.locator("pasu-draw .found");
const knots = (pot: Visit) => pot.page.locator('pasu-drawing-board [data-knot]:not([data-knot="axis"])');
const trouble = (pot: Visit) => pot.page.locator("pasu-draw .trouble");

/** A place on the sheet, as shares of it. */
async function at(pot: Visit, x: number, y: number): Promise<Spot> {
  const box = await board(pot).boundingBox();
  if (!box) throw new Error("there is no sheet");
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

/** From New. */
async function open(pot: Visit): Promise<void> {
  await pot.command("New");
  await pot.button("Draw or trace…").click();
  await board(pot).waitFor();
}

/** How many rings there would be, once they are found. */
async function rings(pot: Visit): Promise<number> {
  await expect
    .poll(() => told(pot).textContent(), { timeout: 30_000 })
    .toMatch(/^\s*\d+ rings, [\d.]+\scm from the line at most\.\s*$/);
  return Number.parseInt(((await told(pot).textContent()) ?? "").trim(), 10);
}

/** A stroke of the mouse through places of the sheet. */
async function stroke(pot: Visit, places: readonly (readonly [number, number])[]): Promise<void> {
  const { mouse } = pot.page;
  const spots = await Promise.all(places.map(([x, y]) => at(pot, x, y)));
  const [first] = spots;
  if (!first) return;
  await mouse.move(first.x, first.y);
  await mouse.down();
  for (const { x, y } of spots.slice(1)) await mouse.move(x, y, { steps: 4 });
  await mouse.up();
}

/** A belly above a foot, as it is drawn on the right. */
const BELLY = Array.from({ length: 25 }, (_, i) => {
  const share = i / 24;
  return [0.62 + 0.15 * Math.sin(3.6 * share), 0.9 - 0.75 * share] as const;
});

/** The rings of the part in the document, as radius and height. */
const document = (pot: Visit) =>
  pot.page.evaluate(() => {
    const { designer } = globalThis.document.querySelector("pasu-app") as unknown as {
      designer: {
        store: {
          design: {
            parts: {
              shape: { rings: { sharp?: boolean; r: { mean: number; waves?: unknown[] }; z: { mean: number } }[] };
              wall?: object;
              look?: { glaze?: string };
            }[];
          };
        };
      };
    };
    const [part] = designer.store.design.parts;
    const all = part?.shape.rings ?? [];
    return {
      radii: all.map(({ r }) => r.mean),
      heights: all.map(({ z }) => z.mean),
      sharp: all.filter(({ sharp }) => sharp).length,
      waves: all.filter(({ r }) => (r.waves ?? []).length > 0).length,
      walled: part?.wall !== undefined,
      glaze: part?.look?.glaze,
    };
  });

/** Picks a file where a button asks for one. */
async function pick(pot: Visit, button: string, name: string, mimeType: string, bytes: Buffer): Promise<void> {
  const chooser = pot.page.waitForEvent("filechooser");
  await pot.button(button).click();
  await (await chooser).setFiles({ name, mimeType, buffer: bytes });
}

test("what takes back the first line has nothing more to do then, and has the focus still", async () => {
  const pot = await here.enter({ link: LINK, viewport: { width: 1280, height: 800 } });
  await pot.fingerprint();
  await open(pot);
  for (const name of ["Take back", "Clear"]) {
    await stroke(pot, BELLY);
    const button = pot.button(name);
    await button.focus();
    await pot.page.keyboard.press("Enter");
    await expect.poll(() => button.isDisabled()).toBe(true);
    await pot.page.keyboard.press("Enter");
    expect(await button.evaluate((it) => it.matches(":focus"))).toBe(true);
    expect(await told(pot).textContent()).toContain("Nothing is drawn yet.");
  }
  // One step it was, however often it was pressed.
  await pot.button("Take back").click();
  await expect.poll(() => knots(pot).count()).toBeGreaterThan(0);
});

test("a line that is drawn by the mouse becomes a pot with a wall, as high as it is to be, in one step", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: LINK, viewport: { width: 1280, height: 800 } });
  const before = await pot.fingerprint();
  await open(pot);
  expect(await told(pot).textContent()).toContain("Nothing is drawn yet.");
  expect(await pot.button("Use it").isDisabled()).toBe(true);
  expect(await findings(pot)).toEqual([]);
  await stroke(pot, BELLY);
  const few = await rings(pot);
  expect(few).toBeLessThan(8);
  expect(await findings(pot)).toEqual([]);
  // Half as far off takes no fewer rings.
  await pot.type("No further off than", "0.01");
  await expect.poll(() => rings(pot)).toBeGreaterThan(few);
  await pot.type("No further off than", "0.1");
  await pot.type("Height", "31");
  // However many letters it took, one step takes it back.
  await pot.button("Take back").click();
  await expect.poll(() => pot.field("Height").first().inputValue()).toBe("20");
  await pot.type("Height", "31");
  await expect.poll(() => rings(pot)).toBe(few);
  await pot.button("Use it").click();
  const drawn = await pot.fingerprintOtherThan(before);
  const { radii, heights, walled } = await document(pot);
  expect(heights[0]).toBeCloseTo(0, 0);
  expect(heights.at(-1)).toBeCloseTo(31, 0);
  // What was drawn: the foot 0.12 of the sheet from the axis, and 0.75 of it high.
  expect((radii[0] ?? 0) / 31).toBeCloseTo(0.12 / 0.75, 1.5);
  expect(Math.max(...radii) / 31).toBeCloseTo(0.27 / 0.75, 1.5);
  expect(walled).toBe(true);
  await pot.undo();
  await pot.shows(before);
  expect(await pot.history("Undo").isEnabled()).toBe(false);
  await pot.redo();
  await pot.shows(drawn);
});

test("in the place of a part it keeps what the part has, and corners are sharp", async () => {
  const pot = await here.enter({ link: "#1/rings?glaze=cobalt" });
  const before = await pot.fingerprint();
  await pot.tab("Profile");
  await pot.button("Draw or trace it…").click();
  await board(pot).waitFor();
  expect(await pot.field("Height").first().inputValue()).toBe("20");
  await stroke(pot, [
    [0.6, 0.9],
    [0.8, 0.5],
    [0.58, 0.4],
    [0.58, 0.15],
  ]);
  await rings(pot);
  // A point that is dragged takes the line along, and the pot is seen before the hand lets go.
  const count = await knots(pot).count();
  const corner = await at(pot, 0.8, 0.5);
  const { mouse } = pot.page;
  await mouse.move(corner.x, corner.y);
  await mouse.down();
  await mouse.move(corner.x + 20, corner.y, { steps: 3 });
  await expect.poll(() => pot.page.locator("pasu-drawing-board .fitted").count()).toBeGreaterThan(0);
  await mouse.up();
  expect(await knots(pot).count()).toBe(count);
  // A press beside everything is no line.
  const beside = await at(pot, 0.9, 0.1);
  await mouse.click(beside.x, beside.y);
  expect(await knots(pot).count()).toBe(count);
  // What is said of a level line is said of the next one too: to be read aloud again it is another element.
  const trouble = pot.page.locator("pasu-draw .trouble");
  const level = [
    [0.88, 0.1],
    [0.9, 0.1],
    [0.92, 0.1],
  ] as const;
  await stroke(pot, level);
  await trouble.evaluate((said) => void said.setAttribute("data-before", ""));
  await stroke(pot, level);
  await expect.poll(() => trouble.getAttribute("data-before")).toBe(null);
  await pot.button("Take back").click();
  await rings(pot);
  await pot.button("Use it").click();
  await pot.fingerprintOtherThan(before);
  const { sharp, glaze, heights } = await document(pot);
  expect(sharp).toBe(2);
  expect(glaze).toBe("cobalt");
  expect(heights.at(-1)).toBeCloseTo(20, 0);
  await pot.undo();
  await pot.shows(before);
});

test("by keys alone: points, arrows, corners and numbers, both sides apart", { timeout: 240_000 }, async () => {
  const pot = await here.enter({ link: LINK });
  const before = await pot.fingerprint();
  const { keyboard } = pot.page;
  await open(pot);
  await pot.button("Begin with points").focus();
  await keyboard.press("Enter");
  await rings(pot);
  const focus = () =>
    pot.page.evaluate(() => {
      let active = globalThis.document.activeElement;
      while (active?.shadowRoot?.activeElement) active = active.shadowRoot.activeElement;
      return active?.getAttribute("aria-label") ?? null;
    });
  expect(await focus()).toMatch(/^Point 1: radius 4\.4\scm, height 0\scm$/);
  await keyboard.press("ArrowRight");
  await expect.poll(focus).toMatch(/^Point 1: radius 4\.45\scm, height 0\scm$/);
  const spoken = () => pot.page.locator("pasu-drawing-board [role=status]").textContent();
  await keyboard.press("+");
  await expect.poll(() => knots(pot).count()).toBe(4);
  await expect.poll(spoken).toMatch(/^Added, 4 points\. Point 1: radius 4\.45/);
  await keyboard.press("Tab");
  await keyboard.press("s");
  await expect.poll(() => pot.page.locator("pasu-drawing-board rect.knob").count()).toBe(1);
  await expect.poll(spoken).toMatch(/^A corner\. Point 2: /);
  await keyboard.press("Delete");
  await expect.poll(() => knots(pot).count()).toBe(3);
  await expect.poll(spoken).toMatch(/^Taken away, 3 points left\. Point 2: /);
  await pot.page.getByText("Points as numbers").click();
  await pot.type("Radius, Point 2", "8");
  await pot.type("Height, Point 3", "24");
  // The scale stays where a point is moved.
  expect(await pot.field("Height").first().inputValue()).toBe("24");
  await pot.page.getByRole("checkbox", { name: "Both sides alike" }).uncheck();
  await expect.poll(() => knots(pot).count()).toBe(6);
  await pot.type("Radius, Point 2, Left", "5");
  expect(await findings(pot)).toEqual([]);
  await rings(pot);
  await pot.button("Use it").focus();
  await keyboard.press("Enter");
  await pot.fingerprintOtherThan(before);
  const { heights, waves } = await document(pot);
  expect(heights.at(-1)).toBeCloseTo(24, 0);
  expect(waves).toBeGreaterThan(0);
});

test("of a line of two points none is taken away, and that is said", async () => {
  const pot = await here.enter({ link: LINK });
  await open(pot);
  await pot.button("Begin with points").focus();
  await pot.page.keyboard.press("Enter");
  await rings(pot);
  const spoken = () => pot.page.locator("pasu-drawing-board [role=status]").textContent();
  await pot.page.keyboard.press("Delete");
  await expect.poll(spoken).toMatch(/^Taken away, 2 points left\./);
  await pot.page.keyboard.press("Delete");
  await expect.poll(spoken).toBe("A line has two points at least.");
  expect(await knots(pot).count()).toBe(2);
});

const VASE_SVG = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 200"><style>path { fill: red }</style><defs><path d="M0 0h90v190h-90z"/></defs>
  <g transform="translate(10 5)"><path id="outline" style="fill:none" d="M25 180 C10 120 5 80 30 50 L25 10 H55 L50 50 C75 80 70 120 55 180 Z" fill="#963"/></g>
  <path d="M2 2h6"/></svg>`;

test("the outline of an SVG file has both sides, and what is no drawing is refused in words", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: LINK });
  const before = await pot.fingerprint();
  await open(pot);
  const svg = (text: string) => pick(pot, "SVG file…", "vase.svg", "image/svg+xml", Buffer.from(text));
  const hostile = `<svg xmlns="http://www.w3.org/2000/svg" onload="globalThis.taken = 1"><script>globalThis.taken = 1</script><image href="https://example.org/x.png"/><foreignObject><img xmlns="http://www.w3.org/1999/xhtml" src="x" onerror="globalThis.taken = 1"/></foreignObject>`;
  for (const [text, words] of [
    ["this is no drawing", /no SVG file that could be read/],
    [`<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L1 1"`, /no SVG file that could be read/],
    [`<html xmlns="http://www.w3.org/1999/xhtml"><path d="M0 0L1 1"/></html>`, /no SVG file that could be read/],
    [
      `<!DOCTYPE svg [<!ENTITY a "M0 0"><!ENTITY b "&a;&a;">]><svg xmlns="http://www.w3.org/2000/svg"><path d="&b;"/></svg>`,
      /entities/,
    ],
    [`${hostile}</svg>`, /no line in this SVG/],
    [`<svg xmlns="http://www.w3.org/2000/svg"><path d="url(javascript:alert(1))"/></svg>`, /no line in this SVG/],
    [`<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 5H90"/></svg>`, /level/],
    [`<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0${"L1 2L3 4".repeat(60_000)}"/></svg>`, /too large/],
  ] as const) {
    await svg(text);
    await expect
      .poll(() =>
        trouble(pot)
          .textContent()
          .catch(() => ""),
      )
      .toMatch(words);
  }
  // Of a broken file the browser makes a page that says so, in a style that the policy forbids; nobody sees it.
  // Some browsers report handlers in a document that never runs as well: the policy has forbidden them.
  const forgive = () => {
    for (let i = pot.troubles.length - 1; i >= 0; i -= 1)
      if (/style|script-src-attr|inline event handler/.test(pot.troubles[i] ?? "")) pot.troubles.splice(i, 1);
  };
  forgive();
  // What is drawn beside all that is taken, and nothing else of it.
  await svg(`${hostile}${VASE_SVG.replace(/^<svg[^>]*>|<\/svg>$/g, "")}</svg>`);
  await rings(pot);
  expect(await trouble(pot).count()).toBe(0);
  expect(await pot.page.evaluate(() => (globalThis as { taken?: number }).taken ?? 0)).toBe(0);
  forgive();
  expect(await pot.page.getByRole("checkbox", { name: "Both sides alike" }).isChecked()).toBe(true);
  // Of several lines the longest is the pot; another can be chosen.
  await pot.page.getByRole("combobox", { name: "Line of the file" }).selectOption("1");
  await expect.poll(() => trouble(pot).textContent()).toMatch(/level/);
  await pot.page.getByRole("combobox", { name: "Line of the file" }).selectOption("0");
  expect(await findings(pot)).toEqual([]);
  await rings(pot);
  await pot.button("Use it").click();
  await pot.fingerprintOtherThan(before);
  const { radii, heights } = await document(pot);
  expect(heights.at(-1)).toBeCloseTo(20, 0);
  // Foot and rim are 30 wide, of 170.
  expect((radii[0] ?? 0) / 20).toBeCloseTo(15 / 170, 1.5);
  expect((radii.at(-1) ?? 0) / 20).toBeCloseTo(15 / 170, 1.5);
});

/** A photograph of a vase before a wall that darkens to the right, as a PNG. */
async function photograph(pot: Visit, bare = false): Promise<Buffer> {
  const data = await pot.page.evaluate((bare) => {
    const canvas = globalThis.document.createElement("canvas");
    canvas.width = 600;
    canvas.height = 800;
    const context = canvas.getContext("2d") as CanvasRenderingContext2D;
    const wall = context.createLinearGradient(0, 0, 600, 0);
    wall.addColorStop(0, "#e6e1d6");
    wall.addColorStop(1, "#b9b4aa");
    context.fillStyle = wall;
    context.fillRect(0, 0, 600, 800);
    if (!bare) {
      context.fillStyle = "#5b3a2c";
      context.beginPath();
      context.moveTo(240, 700);
      context.bezierCurveTo(120, 500, 140, 300, 260, 250);
      context.lineTo(230, 120);
      context.lineTo(410, 120);
      context.lineTo(380, 250);
      context.bezierCurveTo(500, 300, 520, 500, 400, 700);
      context.fill();
    }
    return canvas.toDataURL("image/png").split(",")[1] ?? "";
  }, bare);
  return Buffer.from(data, "base64");
}

test("a photograph lies behind, its outline is found, and points of it are dragged", { timeout: 240_000 }, async () => {
  const pot = await here.enter({ link: LINK });
  const before = await pot.fingerprint();
  await open(pot);
  await pick(pot, "Photograph…", "notes.png", "image/png", Buffer.from("this is no picture"));
  await expect
    .poll(() =>
      trouble(pot)
        .textContent()
        .catch(() => ""),
    )
    .toMatch(/no picture/);
  await pick(pot, "Photograph…", "wall.png", "image/png", await photograph(pot, true));
  await expect
    .poll(() =>
      trouble(pot)
        .textContent()
        .catch(() => ""),
    )
    .toMatch(/No pot can be told/);
  await pick(pot, "Photograph…", "vase.png", "image/png", await photograph(pot));
  await rings(pot);
  expect(await pot.page.locator("pasu-drawing-board canvas").count()).toBe(1);
  expect(await pot.page.getByRole("checkbox", { name: "Both sides alike" }).isChecked()).toBe(true);
  expect(await findings(pot)).toEqual([]);
  // What takes back an outline takes back what it was traced with.
  await pot.type("Pot or background", "0.5");
  await rings(pot);
  // So does a slider from which the system takes the finger away.
  const slider = pot.slider("Pot or background");
  const box = await slider.boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  await pot.page.mouse.move(box.x + 0.58 * box.width, box.y + box.height / 2);
  await pot.page.mouse.down();
  await pot.page.mouse.move(box.x + 0.7 * box.width, box.y + box.height / 2, { steps: 3 });
  await expect.poll(() => pot.field("Pot or background").first().inputValue()).not.toBe("0.5");
  await slider.dispatchEvent("pointercancel");
  await expect.poll(() => pot.field("Pot or background").first().inputValue()).toBe("0.5");
  await pot.page.mouse.up();
  await pot.type("Height", "28");
  await rings(pot);
  await pot.button("Take back").click();
  expect(await pot.field("Pot or background").first().inputValue()).toBe("0.5");
  await pot.button("Take back").click();
  await expect.poll(() => pot.field("Pot or background").first().inputValue()).toBe("0");
  await pot.type("Height", "29");
  await rings(pot);
  await pot.button("Use it").click();
  await pot.fingerprintOtherThan(before);
  const { radii, heights, sharp } = await document(pot);
  // On the picture it is 580 high, the foot is 160 wide and the rim 180; the neck is a corner.
  expect(heights.at(-1)).toBeCloseTo(29, 0);
  expect(radii[0]).toBeCloseTo(4, 0);
  expect(radii.at(-1)).toBeCloseTo(4.5, 0);
  expect(sharp).toBe(1);
});

test("what is wrong with a photograph is said as long as it is, and what is there is of this one", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: LINK });
  await open(pot);
  await pick(pot, "Photograph…", "vase.png", "image/png", await photograph(pot));
  await rings(pot);
  await pot.type("Pot or background", "-3");
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => trouble(pot).count()).toBe(1);
  await rings(pot);
  expect(await trouble(pot).textContent()).toMatch(/No pot can be told/);
  await pot.type("Pot or background", "0");
  await expect.poll(() => trouble(pot).count()).toBe(0);
  await rings(pot);
  // Of another photograph the outline of this one is none.
  await pick(pot, "Photograph…", "wall.png", "image/png", await photograph(pot, true));
  await expect.poll(() => trouble(pot).count()).toBe(1);
  expect(await knots(pot).count()).toBe(0);
  expect(await pot.button("Use it").isDisabled()).toBe(true);
  await pot.button("Without the photograph").focus();
  await pot.page.keyboard.press("Enter");
  await expect
    .poll(() => pot.page.locator("pasu-draw").evaluate((dialog) => dialog.shadowRoot?.activeElement?.id))
    .toBe("photo");
  // A picture may be a drawing.
  await pick(pot, "Photograph…", "vase.svg", "image/svg+xml", Buffer.from(VASE_SVG));
  await rings(pot);
  // No pot is 0 high.
  await pot.type("Height", "0");
  await pot.page.getByText("Type a number above 0.").waitFor();
  expect(await pot.button("Use it").isDisabled()).toBe(false);
});

test("a finger draws on a phone, everything is within reach, and nothing is said that is not in the catalogue", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ ...PHONE, link: LINK });
  const before = await pot.fingerprint();
  await open(pot);
  await fingers(pot, [{ from: await at(pot, 0.66, 0.9), to: await at(pot, 0.78, 0.15) }]);
  await rings(pot);
  expect(await overhang(pot)).toBe(0);
  expect(await unreachable(pot, "footer, .acts")).toEqual([]);
  expect(await findings(pot)).toEqual([]);
  await pot.button("Use it").click();
  await pot.fingerprintOtherThan(before);
  for (const colorScheme of ["light", "dark"] as const) {
    const other = await here.enter({ link: PSEUDO + LINK, colorScheme } satisfies VisitOptions);
    await other.page.locator("pasu-panel #tab-profile").click();
    await other.page.locator("pasu-profile .button").click();
    await board(other).waitFor();
    await other.page.locator("pasu-draw .acts button").nth(2).click();
    await other.page.locator("pasu-draw .primary:enabled").waitFor();
    await other.page.locator("pasu-draw summary").click();
    expect(await unmarked(other)).toEqual([]);
    expect(await findings(other)).toEqual([]);
  }
});

test("what was drawn and not used is there when the dialogue is opened again", async () => {
  const pot = await here.enter({ link: LINK, viewport: { width: 1280, height: 800 } });
  const before = await pot.fingerprint();
  await open(pot);
  await stroke(pot, BELLY);
  await rings(pot);
  await pot.type("Height", "31");
  const drawn = await knots(pot).count();
  await pot.page.keyboard.press("Escape");
  await board(pot).waitFor({ state: "detached" });
  await open(pot);
  expect([await knots(pot).count(), await pot.field("Height").first().inputValue()]).toEqual([drawn, "31"]);
  await rings(pot);
  // The sheet is empty again by its own button, and stays so.
  await pot.button("Clear").click();
  await pot.page.keyboard.press("Escape");
  await board(pot).waitFor({ state: "detached" });
  await open(pot);
  expect(await knots(pot).count()).toBe(0);
  await stroke(pot, BELLY);
  await rings(pot);
  await pot.button("Use it").click();
  await pot.fingerprintOtherThan(before);
  await open(pot);
  expect(await knots(pot).count()).toBe(0);
});
