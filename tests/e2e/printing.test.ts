// What comes out of a printer: a sheet about the pot in the place of the page, whatever is open on it.

import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

/** As the browser does before it prints, and as it stands on paper. */
async function print({ page }: Visit): Promise<void> {
  // What prints is fetched when the picture stands.
  await page.waitForFunction(() => {
    dispatchEvent(new Event("beforeprint"));
    return document.querySelector("pasu-printed") !== null;
  });
  await page.emulateMedia({ media: "print" });
}

async function printed({ page }: Visit): Promise<void> {
  await page.emulateMedia({ media: null });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
}

/** How many pixels of the picture are something, and how many are paper. */
async function inked({ page }: Visit): Promise<{ readonly some: number; readonly none: number }> {
  return await page.locator("pasu-printed canvas").evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: [] };
    let some = 0;
    for (let i = 3; i < data.length; i += 4) if ((data[i] ?? 0) > 0) some += 1;
    return { some, none: data.length / 4 - some };
  });
}

test("the picture, the title, the numbers and the link are printed, and nothing of the page", async () => {
  const pot = await here.enter({ link: "#1/bloor-wilson?n1=5", colorScheme: "dark" });
  await pot.fingerprint();
  await pot.page.getByRole("textbox", { name: "Title" }).fill("Dint vase");
  await pot.page.keyboard.press("Tab");
  await pot.tab("Equation");
  await pot.command("Help");
  await pot.page.getByRole("dialog").waitFor();
  await print(pot);
  const sheet = pot.page.locator("pasu-printed article");
  expect(await sheet.locator("h1").innerText()).toBe("Dint vase");
  const text = await sheet.innerText();
  expect(text).toContain("A vase 3.3 cm high");
  expect(text.replace(/\s+/g, " ")).toMatch(/Rim radius r\s?1 1 cm/);
  const address = `${pot.url}${await pot.address()}`;
  expect(await sheet.getByRole("link").getAttribute("href")).toBe(address);
  expect(text).toContain(address);
  const { some, none } = await inked(pot);
  expect(Math.min(some, none)).toBeGreaterThan(10_000);
  expect(await pot.app.isVisible()).toBe(false);
  // Black on white, though the page is dark.
  expect(await sheet.evaluate((at) => getComputedStyle(at).color)).toBe("rgb(0, 0, 0)");
  expect(await pot.page.evaluate(() => getComputedStyle(document.body).overflow)).toBe("visible");
  await printed(pot);
  expect(await sheet.count()).toBe(0);
  expect(await pot.page.getByRole("dialog").isVisible()).toBe(true);
});

test("what is known of a pot is printed with it, and a design of many parts on few pages", async () => {
  const pot = await here.enter({ link: "#1/fourth-order" });
  await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  await pot.page.getByText("To the brim", { exact: true }).waitFor();
  await print(pot);
  const sheet = pot.page.locator("pasu-printed article");
  expect(await sheet.innerText()).toMatch(/To the brim\s+[\d.]+\sml/);
  await printed(pot);
  const made = await pot.fingerprint();
  await pot.dropFile(
    "rings.json",
    JSON.stringify({
      pasu: 1,
      parts: [
        {
          shape: {
            kind: "rings",
            rings: [
              { u: 0, r: { mean: 4 }, z: { mean: 0 } },
              { u: 1, r: { mean: 6 }, z: { mean: 9 } },
            ],
          },
        },
      ],
    }),
  );
  const before = await pot.fingerprintOtherThan(made);
  await print(pot);
  expect(await sheet.innerText()).toMatch(/Ring 2\s+radius 6\scm, height 9\scm/);
  await printed(pot);
  const part = (place: number) => ({
    shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06 + place / 1e7], height: 2 },
    place: { shift: [3 * place, 0, 0] },
  });
  const parts = Array.from({ length: 30 }, (_, place) => part(place));
  await pot.dropFile("many.json", JSON.stringify({ pasu: 1, title: "Many", parts }));
  await pot.fingerprintOtherThan(before);
  await print(pot);
  const text = await sheet.innerText();
  expect(text).toContain("And 18 more parts.");
  const whole = (await pot.page.evaluate(() => location.href)).length;
  // A link that nobody can type is not printed to its end.
  expect(whole < 600 || !text.includes(await pot.address())).toBe(true);
  await printed(pot);
});

test("what is printed is said in the language of the page", async () => {
  const pot = await here.enter({ link: `${PSEUDO}#1/bloor-wilson?n1=5` });
  await pot.fingerprint();
  await print(pot);
  const found = await unmarked(pot);
  expect(found.filter((each) => !each.startsWith("a. says: http"))).toEqual([]);
  await printed(pot);
});

test("a link is told when it is known, and not said to be missing before", async () => {
  const pot = await here.enter({ link: "#1/fourth-order" });
  await pot.fingerprint();
  await print(pot);
  await printed(pot);
  const links: string[] = [];
  const note = async () => {
    await print(pot);
    links.push(await pot.page.locator("pasu-printed article").innerText());
    await printed(pot);
  };
  await pot.drag("Rim radius", 0.8, { held: note });
  await pot.page.waitForFunction(() => location.hash.includes("?"));
  await note();
  expect(links[0]).toContain("still being changed");
  expect(links[1]).toContain(await pot.address());
});

test("a browser that prints says so beforehand", async () => {
  const pot = await here.enter({ link: "#1/fourth-order" });
  await pot.fingerprint();
  await print(pot);
  await printed(pot);
  await pot.page.evaluate(() => {
    const seen: string[] = [];
    addEventListener("beforeprint", () => seen.push(document.querySelector("pasu-printed")?.localName ?? ""));
    Object.assign(globalThis, { seen });
  });
  const file = (await pot.page.pdf({ format: "A4" })).toString("latin1");
  expect(await pot.page.evaluate(() => (globalThis as unknown as { seen: string[] }).seen)).toEqual(["pasu-printed"]);
  expect(file.match(/\/Type \/Page\b/g)).toHaveLength(1);
  expect(await pot.page.locator("pasu-printed").count()).toBe(0);
});
