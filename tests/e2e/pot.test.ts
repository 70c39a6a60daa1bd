// `<pasu-pot>` in other people's pages: what it shows and says, and whose the gestures are.

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import type {} from "../../web/pot/pasu-pot.d.ts";
import { findings } from "../support/axe.ts";
import { counted, loaded, town } from "../support/guests.ts";
import { difference, sight } from "../support/sight.ts";

type Pot = HTMLElementTagNameMap["pasu-pot"];

const here = town();

const HEAD = `<!doctype html><html lang="en"><meta charset="utf-8"><title>A page</title>
  <script type="module" src="https://pasu.example/pot/0.1/pasu-pot.js"></script>`;

/** A page with these elements in its body. */
const page = (body: string, style = "") => ({
  html: `${HEAD}<style>${style}</style><body><main><h1>Pots</h1>${body}</main>`,
});

/** What a pot's events said since the page was asked to listen. */
async function listen(
  there: Page,
  ...types: string[]
): Promise<() => Promise<readonly { type: string; detail: never }[]>> {
  await there.evaluate((all) => {
    const heard: { type: string; detail: unknown }[] = [];
    (globalThis as unknown as { heard: unknown }).heard = heard;
    for (const type of all) {
      const note = (event: Event) => heard.push({ type, detail: (event as CustomEvent).detail });
      document.querySelector("pasu-pot")?.addEventListener(type, note);
    }
  }, types);
  return async () => await there.evaluate(() => (globalThis as unknown as { heard: never[] }).heard);
}

const orbit = (there: Page) => there.evaluate(() => String(document.querySelector("pasu-pot")?.getCameraOrbit()));
const linkOf = (there: Page) => there.evaluate(() => document.querySelector("pasu-pot")?.link);

test("one script tag and one element show a pot, from another origin", async () => {
  const guest = await here.open("plain.html");
  await loaded(guest);
  const pot = guest.page.locator("pasu-pot");
  expect(sight(await pot.screenshot()).tones).toBeGreaterThan(200);
  expect(await counted(guest)).toEqual({ contexts: 1, workers: 1, loads: 1 });
  expect(await linkOf(guest.page)).toBe("#1/bloor-wilson?n1=5");
  expect(await findings(guest)).toEqual([]);
});

test("a wall stands as soon as it is made, for all pots by one more worker, and goes with the last of them", async () => {
  const equation = { s: [1, 1], t: [2, 2], w: [1, 1] };
  const jar = { kind: "fourth-order", r0: 5.5, r1: 5.4, rm: 9.4, h1: 20, eta: [1.4, -1.9], dz: [34, 9], ...equation };
  const guest = await here.open(page('<pasu-pot camera-orbit="0deg 35deg 100%"></pasu-pot>'));
  const show = (wall: object | null) =>
    guest.page.evaluate(
      ([shape, given]) => {
        const pot = document.querySelector("pasu-pot");
        if (pot) pot.design = { pasu: 1, parts: [{ shape, ...(given && { wall: given }) }] } as never;
      },
      [jar, wall] as const,
    );
  const picture = () => guest.page.locator("pasu-pot").screenshot();
  await show(null);
  await loaded(guest);
  await expect.poll(async () => sight(await picture()).tones).toBeGreaterThan(100);
  const bare = await picture();
  expect((await counted(guest)).workers).toBe(1);
  await show({ thickness: 1.5, base: 1.5 });
  // The thickness of the rim is seen from above.
  await expect.poll(async () => difference(bare, await picture()).mean).toBeGreaterThan(1);
  expect((await counted(guest)).workers).toBe(2);
  const walled = await picture();
  await show(null);
  await expect.poll(async () => difference(walled, await picture()).mean).toBeGreaterThan(1);
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.remove());
  await expect.poll(() => counted(guest)).toMatchObject({ contexts: 0, workers: 0 });
});

test("shapes that the small module leaves out are drawn too", async () => {
  const guest = await here.open(page("<pasu-pot></pasu-pot>"));
  await guest.page.evaluate(() => {
    const section = { form: "rectangle", radius: [2, 2], z: 0, taper: 0, dz: 6 };
    const end = { form: "rectangle", radius: [3, 3], z: 6, taper: 0, dz: 6 };
    const pot = document.querySelector("pasu-pot");
    if (pot) pot.design = { pasu: 1, parts: [{ shape: { kind: "blend", start: section, end } }] } as never;
  });
  await loaded(guest);
  expect(sight(await guest.page.locator("pasu-pot").screenshot()).tones).toBeGreaterThan(60);
  expect((await counted(guest)).workers).toBe(1);
});

test("src is a link, an address that ends in one, or that of a document; each says when it is there", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order"></pasu-pot>'), {});
  await loaded(guest);
  const heard = await listen(guest.page, "load", "error");
  const show = async (src: string, link: string) => {
    await guest.page.evaluate((next) => document.querySelector("pasu-pot")?.setAttribute("src", next), src);
    await expect.poll(async () => (await heard()).at(-1)).toMatchObject({ type: "load", detail: { link } });
    expect(await linkOf(guest.page)).toBe(link);
  };
  await show(`${here.site.url}#1/bloor-wilson?n1=3`, "#1/bloor-wilson?n1=3");
  await show("design.json", "#1/second-order?height=4.5");
  await guest.page.evaluate(() => {
    const pot = document.querySelector("pasu-pot") as Pot;
    const design = pot.design as NonNullable<Pot["design"]>;
    Object.assign(design.parts[0]?.shape ?? {}, { height: 5 });
    pot.design = design;
  });
  await expect.poll(() => linkOf(guest.page)).toBe("#1/second-order?height=5");
  expect(await counted(guest)).toMatchObject({ contexts: 1, workers: 1 });
});

test("what cannot be shown is told by its code, path and message, and the pot that was there stays", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order" alt="A vase"></pasu-pot>'), { expected: /404/ });
  await loaded(guest);
  const heard = await listen(guest.page, "load", "error");
  const refused = async (src: string, code: string, path: string) => {
    await guest.page.evaluate((next) => document.querySelector("pasu-pot")?.setAttribute("src", next), src);
    await expect.poll(async () => (await heard()).at(-1)).toMatchObject({ type: "error", detail: { code, path } });
    expect((await heard()).at(-1)?.detail).toHaveProperty("message");
    expect(await guest.page.getByText("This pot could not be shown. The pot stays as it was.").isVisible()).toBe(true);
    expect(await linkOf(guest.page)).toBe("#1/second-order");
  };
  await refused("#1/second-order?height=1e400", "not-finite", "parts[0].shape.height");
  await refused("nowhere.json", "unreachable", "src");
  await refused("http://[", "not-an-address", "src");
  await refused(`data:application/json,${"%20".repeat(2 ** 20 + 1)}`, "too-large", "src");
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.setAttribute("src", "#1/second-order?height=3"));
  await expect.poll(() => linkOf(guest.page)).toBe("#1/second-order?height=3");
  expect(await guest.page.getByText("could not be shown").count()).toBe(0);
});

test("a value that a slider cannot have leaves the design as it was, also for whoever asks for it", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order?height=5" controls="height"></pasu-pot>'));
  await loaded(guest);
  const heard = await listen(guest.page, "input", "change", "error");
  const field = guest.page.getByRole("spinbutton");
  await field.fill("1e300");
  await field.blur();
  await expect.poll(async () => (await heard()).at(-1)?.type).toBe("error");
  await guest.page.getByText("This pot could not be shown. The pot stays as it was.").waitFor();
  const heightOf = () =>
    guest.page.evaluate(() => {
      const shape = document.querySelector("pasu-pot")?.design?.parts[0]?.shape;
      return shape && "height" in shape ? shape.height : undefined;
    });
  expect([await heightOf(), await linkOf(guest.page)]).toEqual([5, "#1/second-order?height=5"]);
  expect((await heard()).map(({ type }) => type)).not.toContain("change");
  await field.fill("6");
  await field.blur();
  await expect.poll(async () => (await heard()).at(-1)?.type).toBe("change");
  expect([await heightOf(), await linkOf(guest.page)]).toEqual([6, "#1/second-order?height=6"]);
});

test("the camera begins where the page says, and what cannot be read is told", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order" camera-orbit="90deg 80deg 150%"></pasu-pot>'));
  await loaded(guest);
  expect(await orbit(guest.page)).toBe("90deg 80deg 150%");
  const heard = await listen(guest.page, "error");
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.setAttribute("camera-orbit", "left a bit"));
  await expect
    .poll(async () => (await heard()).map(({ detail }) => detail))
    .toMatchObject([{ code: "unreadable-orbit" }]);
  expect(await orbit(guest.page)).toBe("31.513deg 64.744deg 100%");
});

test("parameters show in the page's order, and a slider tells the link of what was made", async () => {
  const pot = '<pasu-pot src="#1/bloor-wilson?n1=5" controls="n1, a, teapot" alt="A vase"></pasu-pot>';
  const guest = await here.open(page(pot, "pasu-pot { width: 600px; height: 500px }"));
  const first = guest.page.getByRole("slider").first();
  await first.waitFor();
  await loaded(guest);
  expect(await guest.page.getByRole("slider").evaluateAll((all) => all.map((each) => each.ariaLabel))).toEqual([
    "Number of dints",
    "Smoothing",
  ]);
  const heard = await listen(guest.page, "input", "change", "error");
  const field = guest.page.getByRole("spinbutton", { name: "Number of dints" });
  await field.fill("7");
  await field.blur();
  await expect.poll(async () => (await heard()).map(({ type }) => type)).toEqual(["input", "change"]);
  expect((await heard())[1]?.detail).toMatchObject({ link: "#1/bloor-wilson?n1=7" });
  expect(await linkOf(guest.page)).toBe("#1/bloor-wilson?n1=7");
  expect(await findings(guest)).toEqual([]);
});

/** How many vertices the mesh on the screen has. */
const fineness = (there: Page) =>
  there.evaluate(() => {
    const { solved } = document.querySelector("pasu-pot") as unknown as {
      solved: { parts: readonly { mesh: { positions: Float32Array } }[] } | null;
    };
    return (solved?.parts[0]?.mesh.positions.length ?? 0) / 3;
  });

test("every name in controls that is none is told once, and again when controls says it again", async () => {
  const pot = '<pasu-pot src="#1/bloor-wilson" alt="A vase"></pasu-pot>';
  const guest = await here.open(page(pot));
  await loaded(guest);
  const heard = await listen(guest.page, "error");
  const set = (controls: string) =>
    guest.page.evaluate(async (next) => {
      const element = document.querySelector("pasu-pot") as Pot & {
        requestUpdate(): void;
        updateComplete: Promise<unknown>;
      };
      element.controls = next;
      await element.updateComplete;
      for (let i = 0; i < 3; i += 1) {
        element.requestUpdate();
        await element.updateComplete;
      }
    }, controls);
  const codes = async () => (await heard()).map(({ detail }) => (detail as { path: string }).path);
  await set("a teapot kettle");
  expect(await codes()).toEqual(["controls", "controls"]);
  await set("n1 teapot");
  expect(await codes()).toEqual(["controls", "controls", "controls"]);
});

test("what a hand takes back is drawn as finely as before", async () => {
  const pot = '<pasu-pot src="#1/bloor-wilson?n1=5" controls="a" alt="A vase"></pasu-pot>';
  const guest = await here.open(page(pot, "pasu-pot { width: 600px; height: 500px }"));
  const slider = guest.page.getByRole("slider").first();
  await slider.waitFor();
  await loaded(guest);
  const fine = await fineness(guest.page);
  const heard = await listen(guest.page, "input", "change", "load", "error");
  const box = await slider.boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  await guest.page.mouse.move(box.x + 0.3 * box.width, box.y + box.height / 2);
  await guest.page.mouse.down();
  await guest.page.mouse.move(box.x + 0.7 * box.width, box.y + box.height / 2, { steps: 4 });
  await expect.poll(() => fineness(guest.page)).toBeLessThan(fine);
  // As when the system takes the pointer away.
  await slider.dispatchEvent("pointercancel");
  await expect.poll(() => fineness(guest.page)).toBe(fine);
  expect(await linkOf(guest.page)).toBe("#1/bloor-wilson?n1=5");
  expect((await heard()).every(({ type }) => type === "input")).toBe(true);
});

test("without src there is no pot, and there is one again with the next", async () => {
  const poster = "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg'/%3E";
  const guest = await here.open(
    page(`<pasu-pot src="#1/second-order" controls="height" poster="${poster}"></pasu-pot>`),
  );
  await loaded(guest);
  const there = guest.page;
  for (const without of ["removed", "empty"]) {
    await there.evaluate((how) => {
      const pot = document.querySelector("pasu-pot") as Pot;
      if (how === "removed") pot.removeAttribute("src");
      else pot.setAttribute("src", "");
    }, without);
    await expect.poll(() => there.evaluate(() => (document.querySelector("pasu-pot") as Pot).loaded)).toBe(false);
    expect(await linkOf(there)).toBe(null);
    expect(await there.evaluate(() => (document.querySelector("pasu-pot") as Pot).design)).toBe(null);
    expect(await fineness(there)).toBe(0);
    expect(await there.getByRole("slider").count()).toBe(0);
    expect(await there.locator("pasu-pot .poster").isVisible()).toBe(true);
    expect(await there.locator("pasu-pot .wheel").count()).toBe(0);
    // There is nothing to turn, for nobody.
    expect(await there.getByRole("application").count()).toBe(0);
    await there.evaluate(() => document.querySelector("pasu-pot")?.setAttribute("src", "#1/second-order?height=3"));
    await expect.poll(() => linkOf(there)).toBe("#1/second-order?height=3");
    await expect.poll(() => there.evaluate(() => (document.querySelector("pasu-pot") as Pot).loaded)).toBe(true);
    await expect.poll(() => there.getByRole("application").count()).toBe(1);
  }
});

test("one that is taken out of the page and put back shows what it was to show last, and without a source nothing", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order"></pasu-pot>'));
  const there = guest.page;
  await loaded(guest);
  /** Takes it out once it has begun with what is set, and puts it back after it has given everything up. */
  const awayAfter = (src: string) =>
    there.evaluate(async (next) => {
      const pot = document.querySelector("pasu-pot") as Pot & { updateComplete: Promise<unknown> };
      const place = pot.parentElement;
      if (next === "") pot.removeAttribute("src");
      else pot.setAttribute("src", next);
      await pot.updateComplete;
      pot.remove();
      await new Promise((resolve) => setTimeout(resolve));
      place?.append(pot);
    }, src);
  const heard = await listen(there, "load", "error");
  await awayAfter("#1/second-order?height=5");
  await expect
    .poll(async () => (await heard()).map(({ detail }) => detail))
    .toMatchObject([{ link: "#1/second-order?height=5" }]);
  await awayAfter("");
  // Nothing is asked of a solver, and so not that of the page's own address.
  await expect.poll(() => counted(guest)).toMatchObject({ contexts: 1 });
  expect(await counted(guest)).toMatchObject({ workers: 0 });
  expect(await there.getByText("could not be shown").count()).toBe(0);
});

test("a design that is taken away leaves what src says, or no pot", async () => {
  const guest = await here.open(page("<pasu-pot></pasu-pot>"));
  const there = guest.page;
  const heard = await listen(there, "load", "error");
  const give = (design: unknown) =>
    there.evaluate((next) => {
      (document.querySelector("pasu-pot") as Pot).design = next as Pot["design"];
    }, design);
  const vase = { pasu: 1, parts: [{ shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 4 } }] };
  await give(vase);
  await loaded(guest);
  await give(null);
  expect(await linkOf(there)).toBe(null);
  await there.evaluate(() => document.querySelector("pasu-pot")?.setAttribute("src", "#1/second-order?height=5"));
  await expect.poll(() => linkOf(there)).toBe("#1/second-order?height=5");
  await give(vase);
  await expect.poll(() => linkOf(there)).toBe("#1/second-order?height=4");
  await give(null);
  await expect.poll(() => linkOf(there)).toBe("#1/second-order?height=5");
  expect((await heard()).filter(({ type }) => type === "error")).toEqual([]);
});

test("a source that comes while a hand holds a slider is loaded, and not what the hand has made", async () => {
  const pot = '<pasu-pot src="#1/second-order" controls="height" alt="A vase"></pasu-pot>';
  const guest = await here.open(page(pot, "pasu-pot { width: 600px; height: 500px }"));
  const { mouse } = guest.page;
  const slider = guest.page.getByRole("slider").first();
  await slider.waitFor();
  await loaded(guest);
  const heard = await listen(guest.page, "change", "load", "error");
  const box = await slider.boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  await mouse.move(box.x + 0.3 * box.width, box.y + box.height / 2);
  await mouse.down();
  await mouse.move(box.x + 0.7 * box.width, box.y + box.height / 2, { steps: 4 });
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.setAttribute("src", "#1/second-order?height=5"));
  await expect.poll(() => linkOf(guest.page)).toBe("#1/second-order?height=5");
  await expect.poll(async () => (await heard()).map(({ type }) => type)).toEqual(["load"]);
  await mouse.up();
  const field = guest.page.getByRole("spinbutton");
  await field.fill("6");
  await field.blur();
  await expect.poll(async () => (await heard()).map(({ type }) => type)).toEqual(["load", "change"]);
  expect(await linkOf(guest.page)).toBe("#1/second-order?height=6");
});

test("the wheel scrolls the page, and zooms with the control key or once the pot has the focus", async () => {
  const style = "body { height: 3000px } pasu-pot { width: 500px; height: 400px }";
  const guest = await here.open(page('<pasu-pot src="#1/second-order"></pasu-pot>', style));
  await loaded(guest);
  const there = guest.page;
  const box = await there.locator("pasu-pot").boundingBox();
  if (!box) throw new Error("the pot cannot be seen");
  const before = await orbit(there);
  await there.mouse.move(box.x + 100, box.y + 100);
  await there.mouse.wheel(0, 60);
  await expect.poll(() => there.evaluate(() => scrollY)).toBe(60);
  expect(await orbit(there)).toBe(before);
  await there.keyboard.down("Control");
  await there.mouse.wheel(0, 100);
  await there.keyboard.up("Control");
  await expect.poll(() => orbit(there)).not.toBe(before);
  const small = await orbit(there);
  await there.keyboard.press("Tab");
  await there.mouse.wheel(0, -100);
  await expect.poll(() => orbit(there)).not.toBe(small);
  expect(await there.evaluate(() => scrollY)).toBe(60);
  const turned = await orbit(there);
  await there.keyboard.press("ArrowLeft");
  expect(await orbit(there)).not.toBe(turned);
});

test("one finger scrolls, two turn and pinch", async () => {
  const style = "body { height: 3000px; margin: 0 } pasu-pot { display: block; width: 100%; height: 500px }";
  const guest = await here.open(page('<pasu-pot src="#1/second-order"></pasu-pot>', style), {
    viewport: { width: 390, height: 700 },
    isMobile: true,
    hasTouch: true,
  });
  await loaded(guest);
  const there = guest.page;
  const session = await guest.context.newCDPSession(there);
  const touch = async (
    type: "touchStart" | "touchMove" | "touchEnd",
    ...points: readonly (readonly [number, number])[]
  ) =>
    await session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  const before = await orbit(there);
  await touch("touchStart", [200, 500]);
  for (let y = 490; y >= 300; y -= 10) await touch("touchMove", [200, y]);
  await touch("touchEnd");
  await expect.poll(() => there.evaluate(() => scrollY)).toBeGreaterThan(100);
  expect(await orbit(there)).toBe(before);
  // What was thrown goes on for a while.
  const rest = () =>
    there.evaluate(async () => {
      scrollTo(0, 0);
      for (let i = 0; i < 6; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
      return scrollY;
    });
  await expect.poll(rest).toBe(0);
  await touch("touchStart", [150, 300]);
  await touch("touchStart", [150, 300], [250, 300]);
  for (let by = 10; by <= 100; by += 10) await touch("touchMove", [150 + by, 300], [250 + by, 300]);
  await touch("touchEnd");
  await expect.poll(() => orbit(there)).not.toBe(before);
  const [azimuth, polar, share] = (await orbit(there)).split(" ");
  expect(azimuth).not.toBe(before.split(" ")[0]);
  expect(polar).toBe(before.split(" ")[1]);
  // What just fits is another distance from another side.
  expect(Number.parseFloat(share ?? "")).toBeCloseTo(100, -1);
  await touch("touchStart", [150, 300]);
  await touch("touchStart", [150, 300], [250, 300]);
  for (let by = 5; by <= 50; by += 5) await touch("touchMove", [150 - by, 300], [250 + by, 300]);
  await touch("touchEnd");
  await expect.poll(async () => Number.parseFloat((await orbit(there)).split(" ")[2] ?? "")).toBeLessThan(60);
  expect(await there.evaluate(() => scrollY)).toBe(0);
});

test("a pot turns by itself while it is seen and nobody holds it, and never where motion is reduced", async () => {
  const body = '<pasu-pot src="#1/second-order" auto-rotate></pasu-pot><div></div>';
  const style = "div { height: 3000px }";
  const guest = await here.open(page(body, style), { reducedMotion: "no-preference" });
  await loaded(guest);
  const start = await orbit(guest.page);
  await expect.poll(() => orbit(guest.page)).not.toBe(start);
  await guest.page.evaluate(() => scrollTo(0, 2500));
  const stands = async () => {
    const now = await orbit(guest.page);
    await guest.page.evaluate(async () => {
      for (let i = 0; i < 6; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
    });
    return now === (await orbit(guest.page));
  };
  await expect.poll(stands).toBe(true);
  await guest.page.evaluate(() => scrollTo(0, 0));
  await expect.poll(stands).toBe(false);
  await guest.page.emulateMedia({ reducedMotion: "reduce" });
  await expect.poll(stands).toBe(true);
});

/** How light a corner of the picture is, where the backdrop is. */
async function cornerOf(there: Page): Promise<number> {
  return await there.evaluate(async () => {
    const picture = await createImageBitmap(
      await (document.querySelector("pasu-pot") as Pot).toBlob({ width: 40, height: 40 }),
    );
    const paper = new OffscreenCanvas(40, 40).getContext("2d") as OffscreenCanvasRenderingContext2D;
    paper.drawImage(picture, 0, 0);
    return paper.getImageData(1, 1, 1, 1).data[0] ?? 0;
  });
}

test("colours that a person has forced are not those of the page, which has its backdrop", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order"></pasu-pot>'), {
    colorScheme: "light",
    forcedColors: "active",
  });
  await loaded(guest);
  expect(await cornerOf(guest.page)).toBeGreaterThan(150);
});

test("the theme is the page's, unless the element says otherwise", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order"></pasu-pot>'), { colorScheme: "dark" });
  await loaded(guest);
  const corner = () => cornerOf(guest.page);
  // A page that says nothing of colour schemes is light, whatever the system is.
  expect(await corner()).toBeGreaterThan(150);
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.setAttribute("theme", "dark"));
  await expect.poll(corner).toBeLessThan(100);
  await guest.page.evaluate(() => document.querySelector("pasu-pot")?.removeAttribute("theme"));
  await guest.page.evaluate(() => document.documentElement.style.setProperty("color-scheme", "light dark"));
  await guest.page.emulateMedia({ colorScheme: "light" });
  await expect.poll(corner).toBeGreaterThan(150);
  // A switch of the page's own, of which no medium and no attribute tells.
  for (const reducedMotion of ["reduce", "no-preference"] as const) {
    await guest.page.emulateMedia({ colorScheme: "light", reducedMotion });
    await guest.page.evaluate(() => document.documentElement.style.setProperty("color-scheme", "dark"));
    await expect.poll(corner).toBeLessThan(100);
    await guest.page.evaluate(() => document.documentElement.style.setProperty("color-scheme", "light"));
    await expect.poll(corner).toBeGreaterThan(150);
  }
});

test("in print the picture keeps its form where the element has another on paper", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order" alt="A vase"></pasu-pot>'));
  await loaded(guest);
  await guest.page.locator("pasu-pot").evaluate((pot) => Object.assign(pot.style, { width: "90vw", height: "90vh" }));
  await guest.page.setViewportSize({ width: 1000, height: 400 });
  await guest.page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await guest.page.setViewportSize({ width: 400, height: 800 });
  await guest.page.emulateMedia({ media: "print" });
  const drawn = await guest.page.locator("pasu-pot .printed").evaluate((canvas: HTMLCanvasElement) => ({
    own: canvas.width / canvas.height,
    box: canvas.clientWidth / canvas.clientHeight,
    fit: getComputedStyle(canvas).objectFit,
  }));
  expect(drawn.own).toBeGreaterThan(2 * drawn.box);
  expect(drawn.fit).toBe("contain");
});

test("in print there is a still picture", async () => {
  const guest = await here.open(page('<pasu-pot src="#1/second-order" alt="A vase"></pasu-pot>'));
  await loaded(guest);
  await guest.page.evaluate(() => {
    const printed = () =>
      document.querySelector("pasu-pot")?.shadowRoot?.querySelector<HTMLCanvasElement>(".printed")?.width ?? -1;
    const seen: number[] = [];
    (globalThis as unknown as { seen: number[] }).seen = seen;
    addEventListener("beforeprint", () => seen.push(printed()));
    addEventListener("afterprint", () => seen.push(printed()));
  });
  await guest.page.pdf();
  expect(await guest.page.evaluate(() => (globalThis as unknown as { seen: number[] }).seen)).toEqual([600, 0]);
});
