// The designer in a page that others write too: it draws what changes and nothing else, and lives on where it is moved, or taken away and put back.

import { expect, test } from "vitest";
import { fineWall } from "../support/drag.ts";
import { sight, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, type Visit } from "../support/visit.ts";

const here = stay();
const VASE = "#1/second-order";

/** Counts from now on how often each kind of component is drawn, and how many of each kind are. */
async function countDrawings(pot: Visit): Promise<void> {
  await pot.page.evaluate(() => {
    const drawings: Record<string, number> = {};
    const drawn: Record<string, Set<object>> = {};
    const tags = ["app", "top-bar", "panel", "stage-tools", "stage", "parameters", "number"];
    for (const tag of tags.map((name) => `pasu-${name}`)) {
      const component = customElements.get(tag)?.prototype as { render(): unknown } | undefined;
      if (!component) throw new Error(`there is no ${tag}`);
      const render = component.render;
      component.render = function (this: object) {
        drawings[tag] = (drawings[tag] ?? 0) + 1;
        drawn[tag] = (drawn[tag] ?? new Set()).add(this);
        return render.call(this);
      };
    }
    Object.assign(globalThis, { drawings, drawn });
  });
}

interface Counted {
  readonly drawings: Readonly<Record<string, number>>;
  readonly drawn: Readonly<Record<string, ReadonlySet<object>>>;
}

test("a drag draws what it changes and nothing else", async ({ annotate }) => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  await pot.slider("Height").waitFor();
  await countDrawings(pot);
  let found: Record<string, readonly [number, number]> = {};
  await pot.drag("Height", 0.8, {
    steps: 12,
    held: async () => {
      found = await pot.page.evaluate(() => {
        const { drawings, drawn } = globalThis as unknown as Counted;
        return Object.fromEntries(
          Object.entries(drawings).map(([tag, times]) => [tag, [times, drawn[tag]?.size ?? 0]]),
        );
      });
    },
  });
  await annotate(JSON.stringify(found));
  await pot.fingerprintOtherThan(before);
  // The shell, the tabs and the tools have nothing to do with it; the bar says once that there is something to undo.
  for (const tag of ["pasu-app", "pasu-panel", "pasu-stage-tools"]) expect(found[tag], tag).toBeUndefined();
  expect(found["pasu-top-bar"]?.[0]).toBe(1);
  expect(found["pasu-parameters"]?.[0]).toBeGreaterThan(1);
  expect(found["pasu-number"]?.[1]).toBe(1);
});

test("moved to another place of the page, the designer goes on with the same picture", async () => {
  const pot = await here.enter({ ...CLEAR, link: VASE });
  const before = await pot.fingerprint();
  await pot.page.getByRole("application", { name: "The pot" }).focus();
  await pot.page.keyboard.press("4");
  await pot.command("Help");
  const heading = pot.dialog("Help");
  await heading.waitFor();
  const canvas = await pot.page.locator("pasu-stage .host canvas").elementHandle();
  await pot.page.evaluate(() => {
    const place = document.createElement("section");
    document.body.append(place);
    place.append(document.querySelector("pasu-app") ?? "");
  });
  await heading.waitFor();
  await pot.page.keyboard.press("Escape");
  await heading.waitFor({ state: "detached" });
  expect(await canvas?.evaluate((element) => element.isConnected)).toBe(true);
  const after = await stagePicture(pot);
  // Lower, so that the camera has nothing to follow.
  await pot.drag("Height", 0.1);
  await pot.fingerprintOtherThan(before);
  expect((await stagePicture(pot)).equals(after)).toBe(false);
  await pot.undo();
  await pot.shows(before);
  await expect.poll(async () => (await stagePicture(pot)).equals(after)).toBe(true);
});

test("taken off the page it lets the graphics card go, and put back it shows the pot of the moment, once", async () => {
  const pot = await here.enter({ ...CLEAR, link: "#1/fourth-order" });
  await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  await pot.page.getByRole("button", { name: "Fill it" }).click();
  const handle = pot.page.getByRole("slider", { name: "Water on the stage" });
  await handle.waitFor();
  await pot.tab("Shape");
  await fineWall(pot);
  const before = await pot.fingerprint();
  const tones = sight(await stagePicture(pot)).tones;
  const freed = await pot.page.evaluate(async () => {
    const app = document.querySelector("pasu-app");
    const stage = app?.shadowRoot?.querySelector("pasu-stage")?.shadowRoot;
    const gl = stage?.querySelector("canvas")?.getContext("webgl2");
    app?.remove();
    await new Promise((resolve) => setTimeout(resolve));
    const canvases = stage?.querySelectorAll("canvas").length;
    Object.assign(globalThis, { app });
    return { lost: gl?.isContextLost(), canvases };
  });
  expect(freed).toEqual({ lost: true, canvases: 0 });
  await pot.page.evaluate(() => {
    document.body.append((globalThis as unknown as { app: HTMLElement }).app);
  });
  await pot.shows(before);
  await fineWall(pot);
  await handle.waitFor();
  expect(await handle.count()).toBe(1);
  await expect.poll(async () => sight(await stagePicture(pot)).tones).toBeGreaterThan(0.8 * tones);
  // A key is heard once.
  await pot.type("Height", "21");
  const first = await pot.fingerprintOtherThan(before);
  await pot.type("Height", "22");
  await pot.fingerprintOtherThan(first);
  await pot.page.getByRole("application", { name: "The pot" }).focus();
  await pot.page.keyboard.press("Control+z");
  await pot.shows(first);
});
