// Many parts on the stage: what is on the graphics card stays there, a part that moves is a matrix, and a point of the picture belongs to a part. And
// several stages on a page, which draw with one context.

import { beforeEach, expect, test } from "vitest";
import { fineWall } from "../support/drag.ts";
import { contexts, countUploads, type PartBehind, type StageBehind, stageOf, uploads } from "../support/on-stage.ts";
import { difference } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { COARSE, type Visit } from "../support/visit.ts";

const here = stay({}, COARSE);
const PARTS = 20;
const LINK = "#1/second-order";

let pot: Visit;

beforeEach(async () => {
  pot = await here.enter({ link: LINK, before: countUploads });
  await pot.fingerprint();
  // Puts parts beside each other, on one level: copies of the pot that the page shows, an arm's length apart.
  await pot.page.evaluate(() => {
    const app = document.querySelector("pasu-app") as unknown as {
      designer: { surface: { shown: { solved: { parts: PartBehind[]; bounds: object } } } };
    };
    const { solved } = app.designer.surface.shown;
    const whole = {
      ...(solved.parts[0] as PartBehind).mesh,
      bounds: solved.bounds as { min: number[]; max: number[]; radius: number },
    };
    const num = (values: ArrayLike<number>, i: number) => values[i] as number;
    const width = num(whole.bounds.max, 0) - num(whole.bounds.min, 0);
    const made = {
      width,
      part: (id: string, place: number, revision = 1): PartBehind => ({
        id,
        revision,
        mesh: { ...whole, positions: whole.positions.slice(), normals: whole.normals.slice() },
        matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, place * 1.5 * width, 0, 0, 1],
        span: [num(whole.bounds.min, 2), num(whole.bounds.max, 2)],
        look: {
          glaze: place % 2 ? "cobalt" : "shino",
          inside: place % 2 ? "cobalt" : "shino",
          line: 0,
          clay: "stoneware",
        },
      }),
      bounds: (count: number) => {
        const [min, max] = [[...whole.bounds.min], [...whole.bounds.max]];
        max[0] = num(max, 0) + (count - 1) * 1.5 * width;
        const centre = min.map((low, i) => (low + num(max, i)) / 2);
        return { min, max, centre, radius: Math.hypot(...max.map((high, i) => high - num(centre, i))) };
      },
    };
    Object.assign(globalThis, { pasuParts: made });
  });
});

interface Parts {
  readonly width: number;
  part(id: string, place: number, revision?: number): PartBehind;
  bounds(count: number): object;
}

test("of twenty parts one that changes travels alone, and one that moves does not travel", async () => {
  const stage = await stageOf(pot);
  const sizes = await stage.evaluate(async (it: StageBehind, count) => {
    const { part, bounds } = (globalThis as unknown as { pasuParts: Parts }).pasuParts;
    const parts = Array.from({ length: count }, (_, i) => part(`part ${i}`, i));
    Object.assign(globalThis, { pasuShown: parts });
    it.show({ parts, bounds: bounds(count) });
    await it.whenIdle();
    const { positions, normals, uvs, indices, ware } = (parts[0] as PartBehind).mesh;
    return {
      own: positions.byteLength + normals.byteLength + ware.texels.byteLength,
      shared: uvs.byteLength + indices.byteLength,
    };
  }, PARTS);
  await uploads(pot);
  const change = async (index: number, by: { revision?: number; move?: number }) => {
    await stage.evaluate(
      async (it: StageBehind, [at, { revision, move }, count]) => {
        const { bounds } = (globalThis as unknown as { pasuParts: Parts }).pasuParts;
        const shown = (globalThis as unknown as { pasuShown: PartBehind[] }).pasuShown;
        const old = shown[at] as PartBehind;
        const matrix = [...old.matrix];
        matrix[14] = (matrix[14] ?? 0) + (move ?? 0);
        shown[at] = { ...old, revision: revision ?? old.revision, matrix };
        it.show({ parts: [...shown], bounds: bounds(count) });
        await it.whenIdle();
      },
      [index, by, PARTS] as const,
    );
    return await uploads(pot);
  };
  expect(await change(7, { move: 0.3 })).toEqual({ pieces: 0, bytes: 0 });
  expect(await change(3, { revision: 2 })).toEqual({ pieces: 3, bytes: sizes.own });
  expect(await change(3, {})).toEqual({ pieces: 0, bytes: 0 });
  // One that goes takes nothing with it, one that comes brings what is its own: the grid is there.
  await stage.evaluate(async (it: StageBehind, count) => {
    const { bounds, part } = (globalThis as unknown as { pasuParts: Parts }).pasuParts;
    const shown = (globalThis as unknown as { pasuShown: PartBehind[] }).pasuShown;
    shown.splice(5, 1, part("another", 5));
    it.show({ parts: [...shown], bounds: bounds(count) });
    await it.whenIdle();
  }, PARTS);
  expect(await uploads(pot)).toEqual({ pieces: 3, bytes: sizes.own });
});

test("what a matrix places looks as if it had been computed there", async () => {
  const stage = await stageOf(pot);
  const pictures = await stage.evaluate(async (it: StageBehind) => {
    const { part, bounds } = (globalThis as unknown as { pasuParts: Parts }).pasuParts;
    const base64 = async () => {
      const blob = await it.picture(360, 300);
      const bytes = new Uint8Array(await blob.arrayBuffer());
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
    };
    const [c, s] = [Math.cos(0.4), Math.sin(0.4)];
    // Turned about y, stretched along x, mirrored in y.
    const matrices = [
      [1.3 * c, 0, -1.3 * s, 0, 0, 1, 0, 0, s, 0, c, 0, 0.2, 0.1, 0.3, 1],
      [c, 0, -s, 0, 0, -1, 0, 0, s, 0, c, 0, 0, 0, 0, 1],
    ];
    const out: string[] = [];
    for (const m of matrices) {
      const one = part("one", 0);
      it.show({ parts: [{ ...one, matrix: m }], bounds: bounds(1) });
      it.fit();
      await it.whenIdle();
      out.push(await base64());
      // The same by hand: points by the matrix, normals by its cofactors, triangles turned round where it mirrors.
      const at = (k: number) => m[k] as number;
      const cofactor = (i: number, j: number) => {
        const [a, b] = [(i + 1) % 3, (i + 2) % 3];
        const [d, e] = [(j + 1) % 3, (j + 2) % 3];
        return at(4 * d + a) * at(4 * e + b) - at(4 * e + a) * at(4 * d + b);
      };
      const determinant = [0, 1, 2].reduce((sum, i) => sum + at(i) * cofactor(i, 0), 0);
      const { positions, normals, indices } = one.mesh;
      const placed = { ...one.mesh, positions: positions.slice(), normals: normals.slice(), indices: indices.slice() };
      for (let v = 0; v < positions.length; v += 3) {
        const p = [...positions.subarray(v, v + 3)] as [number, number, number];
        const n = [...normals.subarray(v, v + 3)] as [number, number, number];
        const turned = [0, 1, 2].map(
          (i) => (cofactor(i, 0) * n[0] + cofactor(i, 1) * n[1] + cofactor(i, 2) * n[2]) / determinant,
        );
        const size = Math.hypot(...turned);
        for (const i of [0, 1, 2]) {
          placed.positions[v + i] = at(i) * p[0] + at(4 + i) * p[1] + at(8 + i) * p[2] + at(12 + i);
          placed.normals[v + i] = (turned[i] as number) / size;
        }
      }
      if (determinant < 0) {
        for (let t = 0; t < indices.length; t += 3) {
          placed.indices[t + 1] = indices[t + 2] as number;
          placed.indices[t + 2] = indices[t + 1] as number;
        }
      }
      it.show({ parts: [{ ...part("two", 0), mesh: placed }], bounds: bounds(1) });
      await it.whenIdle();
      out.push(await base64());
    }
    return out;
  });
  const [stretched, byHand, mirrored, mirroredByHand] = pictures.map((text) => Buffer.from(text, "base64")) as [
    Buffer,
    Buffer,
    Buffer,
    Buffer,
  ];
  expect(difference(stretched, byHand).mean).toBeLessThan(0.1);
  expect(difference(mirrored, mirroredByHand).mean).toBeLessThan(0.1);
  expect(difference(stretched, mirrored).mean).toBeGreaterThan(1);
});

test("a point of the picture belongs to the part that is seen there", async () => {
  const stage = await stageOf(pot);
  const found = await stage.evaluate(async (it: StageBehind) => {
    const { part, bounds, width } = (globalThis as unknown as { pasuParts: Parts }).pasuParts;
    const behind = part("behind", 1);
    const matrix = [...behind.matrix];
    // Farther from the eye, which is at negative y in the front view, and higher than the one before it.
    matrix[13] = 3 * width;
    matrix[14] = 0.2 * width;
    const row = [part("left", 0), part("right", 2), { ...behind, matrix }];
    it.show({ parts: [...row, part("middle", 1)], bounds: bounds(3) });
    it.view("front");
    await it.whenIdle();
    const { clientWidth, clientHeight } = it.root;
    const across = (y: number) => Array.from({ length: 41 }, (_, i) => it.pick(((i + 0.5) / 41) * clientWidth, y));
    const runs = (ids: readonly (string | number | null)[]) => ids.filter((id, i) => id !== ids[i - 1]);
    const middle = runs(across(clientHeight / 2));
    it.show({ parts: row, bounds: bounds(3) });
    return {
      middle,
      without: runs(across(clientHeight / 2)),
      corner: it.pick(1, 1),
      outside: [it.pick(-1, 5), it.pick(5, clientHeight), it.pick(Number.NaN, 5)],
    };
  });
  expect(found.middle.filter((id) => id !== null)).toEqual(["left", "middle", "right"]);
  expect(found.without.filter((id) => id !== null)).toEqual(["left", "behind", "right"]);
  expect(found.corner).toBeNull();
  expect(found.outside).toEqual([null, null, null]);
});

test("what only a wall shows belongs to its part too, and what is cut away to none", async () => {
  pot = await here.enter({ link: "#1/fourth-order" });
  await pot.fingerprint();
  const stage = await stageOf(pot);
  /** What is seen from the middle of the picture downwards. */
  const column = (view: string) =>
    stage.evaluate(async (it: StageBehind, name) => {
      it.view(name);
      await it.whenIdle();
      const { clientWidth, clientHeight } = it.root;
      return Array.from({ length: 20 }, (_, i) => it.pick(clientWidth / 2, (0.5 + i / 40) * clientHeight));
    }, view);
  // From below one looks through the open foot and the mouth.
  expect((await column("below"))[0]).toBeNull();
  await pot.makePot();
  await fineWall(pot);
  expect((await column("below"))[0]).toBe(0);
  const whole = await column("top");
  expect(whole.filter((part) => part === 0).length).toBeGreaterThan(5);
  await pot.button("Overlays").click();
  await pot.page.getByRole("checkbox", { name: "Cut open" }).check();
  await pot.page.keyboard.press("Escape");
  // The half before the eye is the lower one of the picture from above.
  await expect.poll(async () => (await column("top")).slice(1).every((part) => part === null)).toBe(true);
});

test("two stages draw with one context, and one that is left alone has it to itself", async () => {
  const canvases = () =>
    pot.page.evaluate(() => {
      const stages = document.querySelector("pasu-app")?.shadowRoot?.querySelectorAll("pasu-stage") ?? [];
      return [...stages].map((each) => {
        const canvas = each.shadowRoot?.querySelector<HTMLCanvasElement>(".host canvas");
        // A canvas has one kind of context: asked for another, it has none.
        return canvas?.getContext("2d") ? "copy" : "own";
      });
    });
  expect(await contexts(pot)).toBe(1);
  expect(await canvases()).toEqual(["own"]);
  await pot.page.evaluate(async () => {
    const app = document.querySelector("pasu-app") as unknown as HTMLElement & { designer: object };
    const first = app.shadowRoot?.querySelector("pasu-stage") as HTMLElement;
    const second = document.createElement("pasu-stage") as HTMLElement & { designer: object };
    second.designer = app.designer;
    second.id = "second";
    Object.assign(second.style, { position: "fixed", width: "320px", height: "240px", inset: "80px auto auto 20px" });
    first.after(second);
  });
  const pictures = async () =>
    await pot.page.evaluate(async () => {
      const stages = [...(document.querySelector("pasu-app")?.shadowRoot?.querySelectorAll("pasu-stage") ?? [])];
      const out: { width: number; height: number; tones: number }[] = [];
      for (const each of stages as unknown as (HTMLElement & { stage: StageBehind })[]) {
        await each.stage.whenIdle();
        const canvas = each.shadowRoot?.querySelector<HTMLCanvasElement>(".host canvas");
        const paper = canvas?.getContext("2d");
        if (!canvas || !paper) continue;
        const { data } = paper.getImageData(0, 0, canvas.width, canvas.height);
        const tones = new Set(new Uint32Array(data.buffer)).size;
        out.push({ width: canvas.width, height: canvas.height, tones });
      }
      return out;
    });
  await expect.poll(canvases).toEqual(["copy", "copy"]);
  await expect.poll(async () => (await pictures()).filter(({ tones }) => tones > 400).length).toBe(2);
  const [, second] = await pictures();
  expect(second).toMatchObject({ width: 160, height: 120 });
  expect(await contexts(pot)).toBe(1);
  await pot.page.evaluate(() => document.querySelector("pasu-app")?.shadowRoot?.querySelector("#second")?.remove());
  await expect.poll(canvases).toEqual(["own"]);
  expect(await contexts(pot)).toBe(1);
  const before = await pot.fingerprint();
  await pot.type("Height", "5");
  await pot.fingerprintOtherThan(before);
  expect(pot.troubles).toEqual([]);
});

test("a gallery that opens while the context is lost shows its exhibits all the same", async () => {
  const card = await pot.page
    .locator("pasu-stage .host canvas")
    .evaluateHandle((element) =>
      (element as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context"),
    );
  await card.evaluate((extension) => extension?.loseContext());
  const note = pot.page.getByText("The graphics card was taken away");
  await note.waitFor();
  await pot.command("Gallery");
  const drawn = pot.page.locator('pasu-gallery canvas[data-drawn="true"]');
  await drawn.nth(2).waitFor();
  await pot.page.keyboard.press("Escape");
  await card.evaluate((extension) => extension?.restoreContext());
  await note.waitFor({ state: "detached" });
  expect(await contexts(pot)).toBe(1);
});
