// Work is kept: across a reload, in a file, and where the browser refuses to store anything.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import { COARSE } from "../support/visit.ts";

const here = stay({}, { ...COARSE, painted: false });

test("a reload brings everything back", async () => {
  const pot = await here.enter({ link: "#1/mixed-order" });
  const before = await pot.fingerprint();
  await pot.drag("Rise at the rim", 0.7);
  const after = await pot.fingerprintOtherThan(before);
  await pot.tab("Look");
  await pot.page.getByRole("radio", { name: "Copper red" }).check();
  await expect.poll(() => pot.address()).toContain("copper-red");
  await pot.page.reload();
  await pot.shows(after);
  expect(await pot.page.getByRole("tab", { name: "Look" }).getAttribute("aria-selected")).toBe("true");
  await expect.poll(() => pot.page.getByRole("radio", { name: "Copper red" }).isChecked()).toBe(true);
});

test("a visit without a link goes on where the last one ended", async () => {
  const pot = await here.enter({ link: "#1/mixed-order" });
  const before = await pot.fingerprint();
  await pot.type("Height", "5");
  const after = await pot.fingerprintOtherThan(before);
  await expect.poll(() => pot.address()).toContain("height=5");
  await pot.page.goto("about:blank");
  await pot.page.goto(pot.url);
  await pot.shows(after);
});

test("a saved file opens as the same pot, dropped or chosen", async () => {
  const mine = await here.enter({ link: "#1/bloor-wilson?n1=7" });
  const before = await mine.fingerprint();
  await mine.page.getByRole("textbox", { name: "Title" }).fill("Seven: dints?");
  await mine.page.keyboard.press("Enter");
  await mine.type("Smoothing", "2,5");
  const after = await mine.fingerprintOtherThan(before);
  const file = await mine.download("Save");
  expect(file.name).toBe("Seven dints.json");
  expect(JSON.parse(file.bytes.toString("utf8"))).toMatchObject({ pasu: 1, title: "Seven: dints?" });

  const theirs = await here.enter();
  const first = await theirs.fingerprint();
  await theirs.dropFile(file.name, file.bytes.toString("utf8"));
  await theirs.shows(after);
  await theirs.undo();
  await theirs.shows(first);
  await theirs.chooseFile(file.name, file.bytes.toString("utf8"));
  await theirs.shows(after);
});

test.each([
  ["no design", "holiday.json", '{ "beach": true }', /holiday\.json” cannot be opened: it holds no design/],
  ["no JSON", "notes.json", "milk, eggs", /milk/],
  [
    "a design with a fault",
    "vase.json",
    '{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [1, 0.1, 0.6, "wide"] } }] }',
    /wide/,
  ],
])("a file with %s is refused in words and the pot stays", async (_, name, text, words) => {
  const pot = await here.enter({ link: "#1/second-order?height=5" });
  const before = await pot.fingerprint();
  await pot.dropFile(name, text);
  const alert = pot.page.getByRole("alert");
  await alert.waitFor();
  expect(await alert.innerText()).toMatch(words);
  expect(await pot.fingerprint()).toBe(before);
});

test("a browser that stores nothing loses the comfort and nothing else", async () => {
  const pot = await here.enter();
  await pot.fingerprint();
  await pot.context.addInitScript(() => {
    Object.defineProperty(globalThis, "localStorage", {
      get() {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await pot.page.goto("about:blank");
  await pot.page.goto(`${pot.url}#1/second-order`);
  const before = await pot.fingerprint();
  await pot.drag("Height", 0.8);
  await pot.fingerprintOtherThan(before);
  await expect.poll(() => pot.address()).toContain("height=");
});
