// A link is the whole pot: the same to the bit wherever it is opened, and never half restored.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import init, { fingerprint, link, type Shape } from "pasu";
import { beforeAll, expect, test } from "vitest";
import { serve } from "../support/server.ts";
import { stay } from "../support/stay.ts";

interface Case {
  readonly name: string;
  readonly family?: Shape;
  readonly shape: Shape;
}

const read = (path: string): unknown => JSON.parse(readFileSync(new URL(path, import.meta.url), "utf8"));
const corpus = read("../reference/surfaces.json") as Case[];
const goldens = read("../goldens/fingerprints.json") as Record<string, string>;

const PACKAGE = fileURLToPath(new URL("../../crates/pasu-wasm/pkg", import.meta.url));

const here = stay();
beforeAll(() => init());

test("every surface of the corpus has the same fingerprint in Chromium, in Node and natively", async () => {
  const links = Object.fromEntries(
    corpus.map(({ name, family, shape }) => [name, link({ pasu: 1, parts: [{ shape: family ?? shape }] })]),
  );
  for (const [name, address] of Object.entries(links)) {
    expect(fingerprint(address), `${name} in Node`).toBe(goldens[name]);
  }
  const library = await serve(PACKAGE);
  const page = await here.browser.newPage();
  try {
    await page.goto(`${library.url}package.json`);
    // As text: vitest would turn the import into one of its own.
    const inChromium = await page.evaluate<Record<string, string>>(`import("./pasu.js").then(async (pasu) => {
      await pasu.default();
      const links = ${JSON.stringify(Object.entries(links))};
      return Object.fromEntries(links.map(([name, address]) => [name, pasu.fingerprint(address)]));
    })`);
    expect(inChromium).toEqual(goldens);
  } finally {
    await page.close();
    await library.close();
  }
});

test("the designer shows the fingerprint that every other platform finds", async () => {
  const pot = await here.enter();
  let before = await pot.fingerprint();
  for (const { name, family, shape } of corpus.filter((_, index) => index % 20 === 5)) {
    await pot.openLink(`#${link({ pasu: 1, parts: [{ shape: family ?? shape }] })}`);
    before = await pot.fingerprintOtherThan(before);
    expect(before, name).toBe(goldens[name]);
  }
});

test("a copied link shows the same pot to someone else", async () => {
  const mine = await here.enter({ link: "#1/bloor-wilson?n1=5" });
  const before = await mine.fingerprint();
  await mine.drag("Smoothing", 0.4);
  const after = await mine.fingerprintOtherThan(before);
  await mine.page.getByRole("textbox", { name: "Title" }).fill("Für Änne");
  await mine.page.keyboard.press("Enter");
  const address = await mine.copyLink();
  expect(address.startsWith(`${here.site.url}#1/bloor-wilson?`)).toBe(true);
  const theirs = await here.enter({ link: address.slice(here.site.url.length) });
  expect(await theirs.fingerprint()).toBe(after);
  expect(await theirs.page.getByRole("textbox", { name: "Title" }).inputValue()).toBe("Für Änne");
  expect(fingerprint(address)).toBe(after);
});

test("a pot that is no plain family travels in a packed link", async () => {
  const document = { pasu: 1, title: "A pot", parts: corpus.slice(60, 61).map(({ shape }) => ({ shape })) };
  const mine = await here.enter({ link: "#1/second-order" });
  const first = await mine.fingerprint();
  await mine.dropFile("pot.json", JSON.stringify(document));
  const shown = await mine.fingerprintOtherThan(first);
  const address = await mine.copyLink();
  expect(address).toContain("#1~");
  const theirs = await here.enter({ link: address.slice(here.site.url.length) });
  expect(await theirs.fingerprint()).toBe(shown);
});

test("a link that a mail program wrapped and encoded still opens", async () => {
  const plain = "#1/bloor-wilson?a=6&n1=5";
  const pot = await here.enter({ link: "#1%2Fbloor-wilson%3Fa%3D6%26amp%3Bn1%3D5%20" });
  expect(await pot.fingerprint()).toBe(fingerprint(plain));
});

test.each([
  ["cut short", (whole: string) => whole.slice(0, -9)],
  ["altered in one letter", (whole: string) => whole.slice(0, 40) + (whole[40] === "A" ? "B" : "A") + whole.slice(41)],
  ["of a later version", (whole: string) => whole.replace("#1", "#2")],
  ["to something else", () => "#privacy"],
])("a link %s says so in words and leaves the pot alone", async (_, damage) => {
  const address = `#${link({ pasu: 1, title: "A pot", parts: corpus.slice(60, 61).map(({ shape }) => ({ shape })) })}`;
  expect(address).toContain("#1~");
  const pot = await here.enter({ link: "#1/second-order?height=5" });
  const before = await pot.fingerprint();
  await pot.openLink(damage(address));
  const alert = pot.page.getByRole("alert");
  await alert.waitFor();
  expect(await alert.innerText()).toMatch(/\b(link|design)\b.*\w/i);
  expect(await pot.fingerprint()).toBe(before);
  expect(await pot.field("Height").inputValue()).toBe("5");
  await pot.button("Dismiss").click();
  expect(await pot.page.getByRole("alert").count()).toBe(0);
  // Whoever copies the address from now on has the pot that is there.
  expect(await pot.address()).toBe("#1/second-order?height=5");
});

test("going on after a damaged link puts the message away and writes the address again", async () => {
  const pot = await here.enter({ link: "#1/second-order?height=5" });
  const before = await pot.fingerprint();
  await pot.openLink("#1~AAAA");
  await pot.page.getByRole("alert").waitFor();
  await pot.drag("Height", 0.8);
  await pot.fingerprintOtherThan(before);
  expect(await pot.page.getByRole("alert").count()).toBe(0);
  await expect.poll(() => pot.page.evaluate(() => location.hash)).toMatch(/^#1\/second-order\?height=/);
});

test("a first visit by a damaged link begins with a pot of the gallery and an explanation", async () => {
  const plain = await here.enter();
  const first = await plain.fingerprint();
  const pot = await here.enter({ link: "#1~AAAA" });
  await pot.page.getByRole("alert").waitFor();
  expect(await pot.fingerprint()).toBe(first);
});

test("a link that would replace unsaved work asks first, and every answer is kept", async () => {
  const link = "#1/fourth-order";
  const pot = await here.enter({ link: "#1/second-order" });
  const opened = await pot.fingerprint();
  await pot.type("Height", "5");
  const mine = await pot.fingerprintOtherThan(opened);
  const dialog = pot.dialog("Open this link?");

  await pot.openLink(link);
  await dialog.waitFor();
  expect(await pot.page.getByText("This link differs from your unsaved work").isVisible()).toBe(true);
  await pot.button("Keep mine").click();
  await dialog.waitFor({ state: "detached" });
  expect(await pot.fingerprint()).toBe(mine);
  await expect.poll(() => pot.address()).toBe("#1/second-order?height=5");

  await pot.openLink(link);
  await dialog.waitFor();
  await pot.page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
  expect(await pot.fingerprint()).toBe(mine);
  // An address that is still there would not change.
  await expect.poll(() => pot.address()).toBe("#1/second-order?height=5");

  await pot.openLink(link);
  await pot.button("Open the link").click();
  await pot.shows(fingerprint(link));
  expect(await pot.address()).toBe(link);
  await pot.undo();
  await pot.shows(mine);
});

test("unsaved work of the last visit is not lost to a link that is opened now", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const opened = await pot.fingerprint();
  await pot.type("Height", "5");
  const mine = await pot.fingerprintOtherThan(opened);
  await expect.poll(() => pot.address()).toBe("#1/second-order?height=5");
  await pot.page.goto("about:blank");
  await pot.page.goto(`${pot.url}#1/fourth-order`);
  await pot.dialog("Open this link?").waitFor();
  await pot.button("Keep mine").click();
  await pot.shows(mine);
  await pot.page.reload();
  await pot.shows(mine);
  expect(await pot.page.getByRole("dialog").count()).toBe(0);
});

test("a link to what is already on the stage asks nothing", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  const opened = await pot.fingerprint();
  await pot.type("Height", "5");
  const mine = await pot.fingerprintOtherThan(opened);
  await pot.openLink("#1/second-order?height=5.0");
  await pot.openLink("#1/second-order?height=5");
  await pot.tab("Look");
  await pot.shows(mine);
  expect(await pot.page.getByRole("dialog").count()).toBe(0);
});

test("a link that is dropped or pasted is looked at as it says, like one that is opened", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  const link = (query: string, design: string) => `${here.site.url}?${query}#${design}`;
  const give = async (type: "drop" | "paste", text: string) =>
    await pot.page.evaluate(
      ([event, given]) => {
        const data = new DataTransfer();
        data.setData("text/plain", given);
        const app = document.querySelector("pasu-app");
        const options = { bubbles: true, cancelable: true, composed: true };
        if (event === "paste") app?.dispatchEvent(new ClipboardEvent("paste", { ...options, clipboardData: data }));
        else app?.dispatchEvent(new DragEvent("drop", { ...options, dataTransfer: data }));
      },
      [type, text] as const,
    );
  const shown = async () => {
    await pot.button("Overlays").click();
    const checked = await pot.page
      .getByRole("checkbox", { checked: true })
      .evaluateAll((all) => all.map((each) => (each as HTMLElement).closest("label")?.innerText.trim()));
    await pot.page.keyboard.press("Escape");
    return checked;
  };
  await give("drop", link("view=90,90,1&cut=0&show=wireframe&map=none", "1/second-order?height=4"));
  const second = await pot.fingerprintOtherThan(first);
  await expect.poll(shown).toEqual(["Wireframe"]);
  await give(
    "paste",
    `See ${link("view=10,80,2&cut=0&show=isoU,axes&map=overhang", "1/second-order?height=5")}, and tell me.`,
  );
  await pot.fingerprintOtherThan(second);
  await expect.poll(shown).toHaveLength(2);
  await pot.tab("Measures");
  expect(await pot.page.getByLabel("Colours show").inputValue()).toBe("overhang");
  // What is no link is left to whoever it was meant for.
  await give("paste", "milk, eggs");
  expect(await pot.page.getByRole("alert").count()).toBe(0);
});

test("a shortcut or a text that is dropped is looked at as the link in it says", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  const link = (design: string) => `${here.site.url}?view=90,90,1&cut=0&show=wireframe&map=none#${design}`;
  const wire = () => pot.page.getByRole("checkbox", { name: "Wireframe" });
  await pot.button("Overlays").click();
  await pot.dropFile("pot.url", `[InternetShortcut]\r\nURL=${link("1/second-order?height=4")}\r\n`);
  const second = await pot.fingerprintOtherThan(first);
  await expect.poll(() => wire().isChecked()).toBe(true);
  await wire().uncheck();
  await pot.dropFile("mail.txt", `Look at this (${link("1/second-order?height=5")}), and tell me.`);
  const third = await pot.fingerprintOtherThan(second);
  await expect.poll(() => wire().isChecked()).toBe(true);
  // As a mail program breaks it.
  const whole = link("1/bloor-wilson?n1=6&a=0.02");
  await pot.dropFile("wrapped.txt", `${whole.slice(0, -9)}\r\n${whole.slice(-9)}\r\n`);
  await pot.fingerprintOtherThan(third);
});

test("of two parts of one name in a file it is said which has to change, and which has it", async () => {
  const pot = await here.enter();
  await pot.fingerprint();
  const part = (name: string) => ({ name, shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06] } });
  await pot.dropFile("two.json", JSON.stringify({ pasu: 1, parts: [part("A"), part("B"), part("A")] }));
  await expect.poll(() => pot.page.getByRole("alert").innerText()).toContain("Part 3, Name: Part 1 has the same one.");
});

test("an address says what is on the stage, also where somebody goes back to one without a link", async () => {
  const pot = await here.enter();
  const jar = await pot.fingerprint();
  const follow = async (link: string, before: string) => {
    await pot.page.evaluate((next) => {
      location.hash = next;
    }, link);
    return await pot.fingerprintOtherThan(before);
  };
  const vase = await follow("#1/bloor-wilson?n1=5", jar);
  const bottle = await follow("#1/rings", vase);
  await pot.page.goBack();
  await pot.shows(vase);
  await pot.page.goBack();
  await expect.poll(() => pot.address()).toContain("#1/bloor-wilson?n1=5");
  await pot.shows(vase);
  await pot.undo();
  await pot.shows(bottle);
});
