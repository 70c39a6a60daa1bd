// Networks of patches that are made of a vase, saved and opened.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { LEAF, openLeaf, told } from "../support/network.ts";
import { sheet } from "../support/sheet.ts";
import { stay } from "../support/stay.ts";

const here = stay();

test("a vase becomes patches, no further off than is said", { timeout: 120_000 }, async () => {
  const pot = await here.enter({ link: "#1/fourth-order?r0=3&r1=2&rm=4&h1=9" });
  const vase = await pot.fingerprint();
  await pot.button("Make it patches…").focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => pot.page.locator("pasu-patch-card section:focus").count()).toBe(1);
  const found = pot.page.locator("pasu-patch-card .found");
  await expect.poll(() => found.innerText(), { timeout: 30_000 }).toMatch(/^No further than [\d.]+ cm from the form/);
  const off = async () => Number(/[\d.]+/.exec(await found.innerText())?.[0]);
  const coarse = await off();
  // Digit by digit: fewer than 3 there cannot be.
  await pot.field("Patches round").click();
  await pot.page.keyboard.type("24");
  await pot.page.keyboard.press("Tab");
  expect(await pot.field("Patches round").inputValue()).toBe("24");
  await pot.type("Patches from end to end", "130");
  await pot.page.getByText("It has to be a whole number from 1 to 120.").waitFor();
  // What cannot be stands beside what is said of it.
  await pot.page.keyboard.press("Tab");
  expect(await pot.field("Patches from end to end").inputValue()).toBe("130");
  await pot.type("Patches from end to end", "12");
  expect(await pot.page.getByText("It has to be a whole number").count()).toBe(0);
  await expect.poll(off).toBeLessThan(coarse);
  expect(await findings(pot)).toEqual([]);
  await pot.button("Use it").focus();
  await pot.page.keyboard.press("Enter");
  await pot.fingerprintOtherThan(vase);
  await expect.poll(() => pot.page.locator("pasu-network-panel .intro button:focus").count()).toBe(1);
  expect(await told(pot)).toContain("288 patches");
  await pot.undo();
  await pot.shows(vase);
  // Where the part stands: ten times as large, it is ten times as far off.
  const large = await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { store: { design: { parts: object[] } } };
    };
    const { design } = designer.store;
    const parts = design.parts.map((part) => ({ ...part, place: { scale: [10, -10, 2] } }));
    return JSON.stringify({ ...design, parts });
  });
  await pot.dropFile("large.json", large);
  await pot.fingerprintOtherThan(vase);
  await pot.button("Make it patches…").click();
  await expect.poll(() => found.innerText(), { timeout: 30_000 }).toMatch(/^No further than [\d.]+ cm from the form/);
  // Each is rounded up to two digits.
  const times = (await off()) / coarse;
  expect(times).toBeGreaterThan(9);
  expect(times).toBeLessThan(11.5);
});

test("a network is saved as OBJ and opened again", async () => {
  const { pot } = await openLeaf(here);
  const { name, bytes } = await pot.download("Save as OBJ");
  expect(name).toMatch(/\.obj$/);
  expect(bytes.toString()).toContain("f 1 2 3 4 5 6 7 8");
  const before = await pot.fingerprint();
  const quads = "v 0 0 0\nv 4 0 0\nv 4 4 1\nv 0 4 0\nv 8 0 1\nv 8 4 2\nf 1 2 3 4\nf 2 5 6 3\n";
  const choosing = pot.page.waitForEvent("filechooser");
  await pot.button("Open OBJ quads…").click();
  await (await choosing).setFiles({ name: "roof.obj", mimeType: "model/obj", buffer: Buffer.from(quads) });
  await pot.fingerprintOtherThan(before);
  expect(await told(pot)).toContain("2 patches through 13 points");
  expect(await pot.page.title()).toBe("roof · Pasu");
  // What is none says where.
  for (const [text, said] of [
    [
      `${quads}f 1 2 3`,
      "The face in line 9 of this file has 3 corners. A network is of faces of four corners, or of eight points.",
    ],
    [`${quads}f 1 2 3 7`, "The face in line 9 of this file names the point 7, and there are 6."],
    ["v 0 0\n", "Line 1 of this file has not the three numbers of a point."],
  ] as const) {
    const again = pot.page.waitForEvent("filechooser");
    await pot.button("Open OBJ quads…").click();
    await (await again).setFiles({ name: "bad.obj", mimeType: "model/obj", buffer: Buffer.from(text) });
    await pot.page.getByText(said.slice(0, 40)).waitFor();
    // Nothing was done that a tick could stand for.
    expect(await pot.page.locator(".toast").locator("svg").count()).toBe(0);
  }
  const next = pot.page.waitForEvent("filechooser");
  await pot.button("Open OBJ quads…").click();
  await (await next).setFiles({ name: "again.obj", mimeType: "model/obj", buffer: Buffer.from(quads) });
  await expect.poll(() => pot.page.title()).toBe("again · Pasu");
  expect(await pot.page.getByText("Line 1 of this file").count()).toBe(0);
});

test("an OBJ file is in the unit of the design on the page", async () => {
  const { pot, plain } = await openLeaf(here);
  const inches = await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as { designer: { store: { design: object } } };
    return JSON.stringify({ ...designer.store.design, unit: "in" });
  });
  await pot.dropFile("inches.json", inches);
  const caption = () => pot.page.locator("pasu-stage #description").innerText();
  await expect.poll(caption).toMatch(/\d in /);
  const told = await caption();
  const { bytes } = await pot.download("Save as OBJ");
  await pot.openLink("#1/second-order?unit=in");
  await pot.fingerprintOtherThan(plain);
  await pot.dropFile("saved.obj", bytes);
  await pot.button("Open them as patches").click();
  await pot.shows(plain);
  await expect.poll(caption).toBe(told);
});

test("a network that was saved as OBJ and is dropped is opened as one, and not as a scan alone", async () => {
  const { pot, plain } = await openLeaf(here);
  const { bytes } = await pot.download("Save as OBJ");
  await pot.openLink("#1/second-order");
  const vase = await pot.fingerprintOtherThan(plain);
  const offer = pot.button("Open them as patches");
  await pot.dropFile("triangles.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  await pot.page.locator("pasu-scan .trouble").waitFor();
  expect(await offer.count()).toBe(0);
  const either = pot.page.getByText("It cannot be opened as a network of patches either.");
  expect(await either.count()).toBe(0);
  // Into the dialog that is open.
  await pot.dropFile("bad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 7\n");
  await either.waitFor();
  expect(await either.textContent()).toContain("The face in line 6 of this file names the point 7, and there are 4.");
  await pot.dropFile("saved.obj", bytes);
  await offer.click();
  await pot.fingerprintOtherThan(vase);
  await pot.shows(plain);
  expect(await pot.page.locator("pasu-scan").count()).toBe(0);
});

test("that a large file is being opened is said and shown, and can be stopped", { timeout: 120_000 }, async () => {
  const pot = await here.enter({});
  const first = await pot.fingerprint();
  // Held until the test lets it go.
  await pot.page.evaluate(() => {
    const { solver } = (document.querySelector("pasu-app") as unknown as { designer: { solver: Solver } }).designer;
    interface Solver {
      parse(text: string): Promise<unknown>;
    }
    const parse = solver.parse.bind(solver);
    solver.parse = async (text) => {
      await new Promise<void>((go) => Object.assign(globalThis, { pasuGo: go }));
      const parsed = parse(text);
      Object.assign(globalThis, { pasuParsed: parsed });
      return await parsed;
    };
  });
  const large = JSON.stringify(sheet(40, 50));
  const said = pot.page.locator("pasu-opening-note [role=status]");
  for (const stop of ["key", "button"]) {
    // Of two that are dropped together the second is not wanted either, and none is said to be open.
    await pot.dropFiles([
      ["sheet.json", large],
      ["leaf.json", LEAF],
    ]);
    await pot.button("Stop").waitFor();
    await expect.poll(async () => await said.textContent()).toMatch(/^Opening .*sheet\.json.* \(0\.\d+ MB\)…$/);
    expect(await findings(pot)).toEqual([]);
    if (stop === "key") await pot.page.keyboard.press("Escape");
    else await pot.button("Stop").click();
    await pot.button("Stop").waitFor({ state: "detached" });
    expect(await said.textContent()).toBe("");
    await pot.page.evaluate(async () => {
      const held = globalThis as unknown as { pasuGo(): void; pasuParsed: Promise<unknown> };
      held.pasuGo();
      await new Promise(requestAnimationFrame);
      await held.pasuParsed;
      for (let i = 0; i < 2; i += 1) await new Promise(requestAnimationFrame);
    });
    await pot.shows(first);
    expect(await pot.page.getByText(/^Opened/).count()).toBe(0);
  }
  await pot.dropFile("sheet.json", large);
  await pot.button("Stop").waitFor();
  expect(await pot.fingerprint()).toBe(first);
  await pot.page.evaluate(() => (globalThis as unknown as { pasuGo(): void }).pasuGo());
  await pot.fingerprintOtherThan(first);
  await pot.button("Stop").waitFor({ state: "detached" });
  await pot.leave();
});
