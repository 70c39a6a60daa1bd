// The gallery: every exhibit has a picture that was rendered, and opens as what it says.
//
// What its time buys: every exhibit's picture is drawn in software, and every exhibit is opened.

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { stay } from "../support/stay.ts";

const here = stay();
const goldens = JSON.parse(readFileSync(new URL("../goldens/fingerprints.json", import.meta.url), "utf8")) as Record<
  string,
  string
>;

test("every exhibit is rendered, and opens as the pot that it shows", { timeout: 240_000 }, async () => {
  const pot = await here.enter({ link: "#1/second-order?height=9" });
  let shown = await pot.fingerprint();
  await pot.command("Gallery");
  const exhibits = pot.page.locator("pasu-gallery button[data-exhibit]");
  await exhibits.first().waitFor();
  const ids = await exhibits.evaluateAll((all) => all.map((each) => each.getAttribute("data-exhibit") ?? ""));
  const papers = Object.keys(goldens).filter((name) => /^(zhang-you|ishak-ali)-/.test(name));
  const solids = ids.filter((id) => id.startsWith("zhang-you-2004-"));
  expect(solids.length).toBe(3);
  expect(ids.filter((id) => !id.startsWith("own-") && !solids.includes(id)).sort()).toEqual(papers.sort());
  expect(ids.filter((id) => id.startsWith("own-")).length).toBeGreaterThanOrEqual(35);

  const seen = new Set<string>();
  for (const id of ids) {
    const exhibit = pot.page.locator(`pasu-gallery button[data-exhibit="${id}"]`);
    if ((await exhibit.count()) === 0) await pot.command("Gallery");
    await exhibit.scrollIntoViewIfNeeded();
    const canvas = exhibit.locator("canvas");
    await expect.poll(() => canvas.getAttribute("data-drawn"), { timeout: 20_000 }).toBe("true");
    const { covered, tones } = await canvas.evaluate(pictureOf);
    expect(covered, `how much of its picture ${id} covers`).toBeGreaterThan(0.05);
    expect(covered, `how much of its picture ${id} covers`).toBeLessThan(0.98);
    expect(tones, `how many tones the picture of ${id} has`).toBeGreaterThan(30);

    // The goldens are of the numbers that the papers printed.
    await pot.page.getByLabel("As printed").check();
    const title = await exhibit.locator(".title").innerText();
    await exhibit.click();
    await expect.poll(() => pot.page.title()).toBe(`${title} · Pasu`);
    shown = await pot.fingerprintOtherThan(shown);
    seen.add(shown);
    if (goldens[id] !== undefined) expect(shown, id).toBe(goldens[id]);
    expect(await pot.page.getByRole("alert").count(), id).toBe(0);
  }
  // Figure 5 a = 6 is figure 4's n1 = 5 with another a: no two exhibits are the same pot.
  expect(seen.size).toBe(ids.length);
});

test("a gallery that was closed while it drew has every picture when it opens again", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  await pot.fingerprint();
  const pictures = pot.page.locator("pasu-gallery button[data-exhibit] canvas");
  for (let visit = 0; visit < 4; visit += 1) {
    await pot.command("Gallery");
    await pictures.first().waitFor();
    await pot.page.keyboard.press("Escape");
    await pictures.first().waitFor({ state: "detached" });
  }
  await pot.command("Gallery");
  for (let place = 0; place < 6; place += 1) {
    const picture = pictures.nth(place);
    await picture.scrollIntoViewIfNeeded();
    await expect.poll(() => picture.getAttribute("data-drawn"), { timeout: 20_000 }).toBe("true");
    expect((await picture.evaluate(pictureOf)).covered).toBeGreaterThan(0.05);
  }
});

/** How much of a canvas is painted, and in how many tones. */
function pictureOf(element: Element): { covered: number; tones: number } {
  const canvas = element as HTMLCanvasElement;
  const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? new Uint8ClampedArray();
  const tones = new Set<number>();
  let painted = 0;
  for (let i = 0; i < data.length; i += 4) {
    if ((data[i + 3] ?? 0) < 128) continue;
    painted += 1;
    tones.add((data[i] ?? 0) * 65536 + (data[i + 1] ?? 0) * 256 + (data[i + 2] ?? 0));
  }
  return { covered: painted / (canvas.width * canvas.height), tones: tones.size };
}
