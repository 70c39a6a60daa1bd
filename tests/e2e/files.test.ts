// Files to make a pot from: chosen, told beforehand, saved, stopped, and dropped back on the page.
//
// What its time buys: files of every kind are written at the size at which people print, and read again.

import { expect, test } from "vitest";
import { designOf } from "../../web/src/document/gallery/exhibit.ts";
import { SHELVES } from "../../web/src/document/gallery.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";

const here = stay();

/** Opens the dialogue on a pot with a wall and waits for the verdict. */
async function exporting(link: string): Promise<{ readonly pot: Visit; readonly fingerprint: string }> {
  const pot = await here.enter({ link });
  await pot.fingerprint();
  await pot.makePot();
  const fingerprint = await pot.fingerprint();
  await pot.command("Export");
  await verdict(pot);
  return { pot, fingerprint };
}

async function verdict(pot: Visit): Promise<void> {
  await pot.page.locator("pasu-export").getByText("The mesh is closed").waitFor();
}

/** Asks for few triangles: these tests are not about how fine they are. */
async function coarse(pot: Visit): Promise<void> {
  await pot.page.getByLabel("Tolerance").fill("0.5");
  await verdict(pot);
}

/** Puts another pot in the place of this one. */
async function another(pot: Visit, fingerprint: string): Promise<void> {
  await pot.openLink("#1/second-order");
  const other = pot.button("Open the link");
  await Promise.race([other.waitFor(), pot.fingerprintOtherThan(fingerprint)]);
  if (await other.isVisible()) await other.click();
  await pot.fingerprintOtherThan(fingerprint);
}

const text = (bytes: Buffer, length: number) => bytes.toString("latin1", 0, length);

/** How each file begins, and whether it can hold its design: an STL is triangles and nothing else. */
const FILES: readonly (readonly [
  label: string,
  extension: string,
  begins: (bytes: Buffer) => boolean,
  opens: boolean,
])[] = [
  ["3MF", "3mf", (bytes) => text(bytes, 4) === "PK\u0003\u0004", true],
  ["STL", "stl", (bytes) => bytes.length === 84 + 50 * bytes.readUInt32LE(80), false],
  ["STEP", "step", (bytes) => text(bytes, 13) === "ISO-10303-21;", true],
  ["SVG", "svg", (bytes) => /^<\?xml|^<svg/.test(text(bytes, 8)), true],
  ["SVG A4", "a4.svg", (bytes) => text(bytes, bytes.length).includes("@page{size:210mm 297mm"), true],
  ["SVG Letter", "letter.svg", (bytes) => text(bytes, bytes.length).includes("@page{size:215.9mm 279.4mm"), true],
  ["GLB", "glb", (bytes) => text(bytes, 4) === "glTF", true],
  ["OBJ", "obj", (bytes) => text(bytes, 1) === "#", true],
  ["OBJ+MTL", "obj.zip", (bytes) => text(bytes, 4) === "PK\u0003\u0004", true],
  ["PLY", "ply", (bytes) => text(bytes, 4) === "ply\n", true],
];

test("every format is saved, and dropped on the page opens the pot again", { timeout: 400_000 }, async () => {
  const { pot, fingerprint } = await exporting("#1/fourth-order");
  await pot.button("Cancel").click();
  await pot.page.getByRole("textbox", { name: "Title" }).fill("Jar");
  const saved = new Map<string, Buffer>();
  for (const [label, extension, begins, opens] of FILES) {
    await pot.command("Export");
    await pot.page.getByRole("radio", { name: label, exact: true }).check();
    if (await pot.page.getByLabel("Tolerance").isVisible()) await coarse(pot);
    else await verdict(pot);
    const told = pot.page.getByText(opens ? "the file opens the design again" : "does not open the design again");
    expect(await told.isVisible(), label).toBe(true);
    const file = await pot.download(`Save ${label}`);
    expect(file.name).toBe(`Jar.${extension}`);
    expect(begins(file.bytes), label).toBe(true);
    saved.set(extension, file.bytes);
    await pot.page.getByRole("dialog").waitFor({ state: "detached" });
  }
  for (const [label, extension, , opens] of FILES) {
    if (!opens) {
      await pot.dropFile(`Jar.${extension}`, saved.get(extension) ?? Buffer.alloc(0));
      const scan = pot.page.locator("pasu-scan");
      await scan.getByText("“Jar.stl” holds no design.").waitFor();
      await pot.page.keyboard.press("Escape");
      await scan.waitFor({ state: "detached" });
      continue;
    }
    await another(pot, fingerprint);
    await pot.dropFile(`Jar.${extension}`, saved.get(extension) ?? Buffer.alloc(0));
    await pot.shows(fingerprint);
    expect(await pot.page.title(), label).toBe("Jar · Pasu");
  }
});

test("why a format does not take a part is said where it was asked for, on a desk and on a phone", async () => {
  const mug = SHELVES.flatMap(({ exhibits }) => exhibits).find(({ id }) => id === "own-mug");
  if (!mug) throw new Error("there is no mug");
  for (const size of [{}, PHONE]) {
    const pot = await here.enter({ ...size, link: "#1/second-order" });
    const before = await pot.fingerprint();
    await pot.dropFile("mug.json", JSON.stringify(designOf(mug)));
    await pot.fingerprintOtherThan(before);
    await pot.command("Export");
    await pot.page.getByRole("radio", { name: "SVG A4", exact: true }).check();
    await verdict(pot);
    await pot.button("Save SVG A4").click();
    const said = pot.page.locator("pasu-export .problem");
    await expect.poll(() => said.textContent()).toMatch(/A template is of a pot with a foot and a rim/);
    const [place, button] = [await said.boundingBox(), await pot.button("Save SVG A4").boundingBox()];
    expect(place && button && place.y >= 0 && place.y < button.y + button.height).toBe(true);
    expect(await said.evaluate((element) => element.closest("[slot=actions]") !== null)).toBe(true);
    await pot.page.getByRole("radio", { name: "STL", exact: true }).check();
    await expect.poll(() => said.textContent()).toBe("");
  }
});

test("a verdict that comes while something else is typed saves nothing", async () => {
  const { pot } = await exporting("#1/fourth-order");
  await pot.page.evaluate(() => {
    type Maker = { ask(request: { readonly kind: string }, lane: string): Promise<unknown> };
    const app = document.querySelector("pasu-app") as unknown as { designer: { made: { maker: Maker } } };
    const { maker } = app.designer.made;
    const ask = maker.ask.bind(maker);
    const held: (() => void)[] = [];
    maker.ask = async (request, lane) => {
      const outcome = await ask(request, lane);
      if (request.kind === "check") await new Promise<void>((resolve) => held.push(resolve));
      return outcome;
    };
    Object.assign(globalThis, { held });
  });
  const tolerance = pot.page.getByLabel("Tolerance");
  await tolerance.fill("0.5");
  await pot.page.waitForFunction(() => (globalThis as unknown as { held: unknown[] }).held.length === 1);
  const isReady = await tolerance.evaluate(async (input: HTMLInputElement) => {
    input.value = "0.4";
    input.dispatchEvent(new Event("input"));
    (globalThis as unknown as { held: (() => void)[] }).held[0]?.();
    await new Promise((resolve) => setTimeout(resolve, 20));
    return (input.getRootNode() as ShadowRoot).querySelector("button.primary:enabled") !== null;
  });
  expect(isReady).toBe(false);
});

test("the size that is told is the size in the file", async () => {
  const { pot } = await exporting("#1/fourth-order");
  const outcome = pot.page.locator("pasu-export .outcome");
  expect(await outcome.innerText()).toContain("too thin for most clay");
  await pot.page.getByRole("radio", { name: "STL", exact: true }).check();
  await pot.page.getByRole("combobox", { name: "Size" }).selectOption("height");
  await pot.page.getByLabel("Finished height").fill("18");
  await pot.page.getByLabel("Shrinkage of the clay").fill("10");
  await coarse(pot);
  const told = await outcome.innerText();
  expect(told).not.toContain("too thin");
  expect(told).toMatch(/200\smm\shigh/);
  expect(told).toMatch(/180\smm\shigh/);
  expect(told).toMatch(/11\.1\s% larger/);
  const triangles = Number(told.match(/Triangles\s+([\d,]+)/)?.[1]?.replaceAll(",", ""));
  const { bytes } = await pot.download("Save STL");
  expect(bytes.readUInt32LE(80)).toBe(triangles);
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = 0; i < 3 * triangles; i += 1) {
    const z = bytes.readFloatLE(84 + 50 * Math.floor(i / 3) + 12 * (1 + (i % 3)) + 8);
    [low, high] = [Math.min(low, z), Math.max(high, z)];
  }
  expect(high - low).toBeCloseTo(200, 1);
});

test("a file that is opened is made again as it was", async () => {
  const { pot } = await exporting("#1/fourth-order");
  await pot.page.getByRole("radio", { name: "PLY", exact: true }).check();
  await pot.page.getByRole("combobox", { name: "Size" }).selectOption("width");
  await pot.page.getByLabel("Finished width").fill("12.5");
  await pot.page.getByLabel("Shrinkage of the clay").fill("8");
  await coarse(pot);
  const first = await pot.download("Save PLY");
  const made = await pot.fingerprint();
  await pot.command("Export");
  await pot.page.getByLabel("Shrinkage of the clay").fill("3");
  await coarse(pot);
  await pot.download("Save PLY");
  await pot.page.getByRole("dialog").waitFor({ state: "detached" });
  await another(pot, made);
  await pot.dropFile("pot.ply", first.bytes);
  await pot.shows(made);
  await pot.command("Export");
  await verdict(pot);
  expect(await pot.page.getByRole("combobox", { name: "Size" }).inputValue()).toBe("width");
  expect(await pot.page.getByLabel("Finished width").inputValue()).toBe("12.5");
  expect(await pot.page.getByLabel("Shrinkage of the clay").inputValue()).toBe("8");
  expect(await pot.page.getByLabel("Tolerance").inputValue()).toBe("0.5");
  const again = await pot.download("Save PLY");
  expect(again.bytes.equals(first.bytes)).toBe(true);
});

test("what makes no sense is said at its field, and nothing is saved", async () => {
  const { pot } = await exporting("#1/fourth-order");
  await pot.page.getByLabel("Shrinkage of the clay").fill("70");
  expect(await pot.page.getByText("A percentage from 0 to less than 50.").isVisible()).toBe(true);
  expect(await pot.page.getByLabel("Shrinkage of the clay").getAttribute("aria-invalid")).toBe("true");
  expect(await pot.button("Save 3MF").isDisabled()).toBe(true);
  await pot.page.getByLabel("Shrinkage of the clay").fill("7");
  await verdict(pot);
  expect(await pot.button("Save 3MF").isDisabled()).toBe(false);
});

test("a surface without a wall is made as a closed solid", async () => {
  const pot = await here.enter({ link: "#1/fourth-order" });
  await pot.fingerprint();
  await pot.command("Export");
  expect(await pot.page.getByRole("radio", { name: /^Hollow pot/ }).count()).toBe(0);
  await verdict(pot);
  const { bytes } = await pot.download("Save 3MF");
  expect(text(bytes, 2)).toBe("PK");
});

test("a file that takes long is stopped, and the page goes on", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const first = await pot.fingerprint();
  const teaSet = SHELVES.flatMap(({ exhibits }) => exhibits).find(({ id }) => id === "own-tea-set");
  if (!teaSet) throw new Error("there is no tea set in the gallery");
  await pot.dropFile("tea-set.json", JSON.stringify(designOf(teaSet)));
  await pot.fingerprintOtherThan(first);
  await pot.command("Export");
  await verdict(pot);
  // Its triangles are made by now, its B-splines are not.
  await pot.page.getByRole("radio", { name: "STEP", exact: true }).check();
  await pot.button("Save STEP").click();
  await pot.button("Stop").click();
  await pot.button("Cancel").waitFor();
  await pot.page.getByRole("radio", { name: "STL", exact: true }).check();
  await coarse(pot);
  const { bytes } = await pot.download("Save STL");
  expect(bytes.length).toBeGreaterThan(1000);
});

test.each([
  ["pot.url", (link: string) => `[InternetShortcut]\r\nURL=${link}\r\n`],
  [
    "pot.webloc",
    (link: string) =>
      `<?xml version="1.0" encoding="UTF-8"?>\n<plist version="1.0"><dict><key>URL</key><string>${link.replaceAll("&", "&amp;")}</string></dict></plist>`,
  ],
])("the shortcut %s opens the pot that it leads to", async (name, text) => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  await pot.dropFile(name, text(`${pot.url}#1/fourth-order?r0=.5&h1=2.5`));
  await pot.fingerprintOtherThan(before);
  expect(await pot.address()).toBe("#1/fourth-order?r0=.5&h1=2.5");
  expect(await pot.page.getByRole("alert").count()).toBe(0);
});

test.each([
  ["drawing.svg", Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"/>'), "Pasu did not save it"],
  ["archive.3mf", Buffer.from("PK\u0003\u0004 nothing"), "Pasu did not save it"],
])("%s holds no design: that is said and the pot stays", async (name, bytes, why) => {
  const pot = await here.enter({ link: "#1/second-order" });
  const before = await pot.fingerprint();
  await pot.dropFile(name, bytes);
  const alert = pot.page.getByRole("alert");
  await alert.waitFor();
  expect(await alert.innerText()).toContain(`“${name}” cannot be opened`);
  expect(await alert.innerText()).toContain(why);
  expect(await pot.fingerprint()).toBe(before);
});
