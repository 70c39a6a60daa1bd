// A scan of a pot becomes rings with waves, with how far it is off; what is no pot, and what rings cannot say, is told.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const LINK = "#1/rings";
const told = (pot: Visit) => pot.page.locator("pasu-scan .found");
const trouble = (pot: Visit) => pot.page.locator("pasu-scan .trouble");

type Corner = readonly [number, number, number];

/** A belly with five petals, 180 high, that stands at (20, 5); with a handle if it is to have one. */
function triangles(handle = false): readonly Corner[] {
  const at = (row: number, column: number): Corner => {
    const [height, angle] = [(180 * row) / 60, (2 * Math.PI * column) / 100];
    const out = handle && row > 20 && row < 42 && column > 20 && column < 25 ? 50 : 0;
    const radius = 40 + 20 * Math.sin(height / 40) + 3 * Math.cos(5 * angle) + out;
    return [20 + radius * Math.cos(angle), 5 + radius * Math.sin(angle), height];
  };
  return Array.from({ length: 60 }, (_, row) =>
    Array.from({ length: 100 }, (_, column) => {
      const [a, b, c, d] = [at(row, column), at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)];
      return [a, b, d, a, d, c];
    }),
  ).flat(2) as unknown as readonly Corner[];
}

function stl(corners: readonly Corner[]): Buffer {
  const bytes = Buffer.alloc(84 + (50 * corners.length) / 3);
  bytes.writeUInt32LE(corners.length / 3, 80);
  corners.forEach((corner, i) => {
    const begin = 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3);
    corner.forEach((value, axis) => void bytes.writeFloatLE(value, begin + 4 * axis));
  });
  return bytes;
}

/** As modellers have it: y is up; or as `turned` has it. */
function obj(corners: readonly Corner[], turned = ([x, y, z]: Corner): Corner => [x, z, -y]): Buffer {
  const points = corners.map((corner) => `v ${turned(corner).join(" ")}`);
  const faces = Array.from({ length: corners.length / 3 }, (_, i) => `f ${3 * i + 1} ${3 * i + 2} ${3 * i + 3}`);
  return Buffer.from(`mtllib https://example.org/scan.mtl\n${[...points, ...faces].join("\n")}\n`);
}

function ply(corners: readonly Corner[]): Buffer {
  const faces = Array.from({ length: corners.length / 3 }, (_, i) => `3 ${3 * i} ${3 * i + 1} ${3 * i + 2}`);
  const head = `ply\nformat ascii 1.0\nelement vertex ${corners.length}\nproperty float x\nproperty float y\nproperty float z\nelement face ${faces.length}\nproperty list uchar int vertex_indices\nend_header`;
  return Buffer.from(`${head}\n${corners.map((corner) => corner.join(" ")).join("\n")}\n${faces.join("\n")}\n`);
}

async function pick(pot: Visit, name: string, buffer: Buffer): Promise<void> {
  const chooser = pot.page.waitForEvent("filechooser");
  await pot.page.locator("pasu-scan button").filter({ hasText: /scan/i }).first().click();
  await (await chooser).setFiles({ name, mimeType: "application/octet-stream", buffer });
}

async function found(pot: Visit): Promise<RegExpExecArray> {
  const pattern = /(\d+) rings and (\d+) waves?: ([\d.]+)\scm off \(RMS\), ([\d.]+)\scm at most/;
  await expect.poll(() => told(pot).textContent(), { timeout: 60_000 }).toMatch(pattern);
  return pattern.exec((await told(pot).textContent()) ?? "") as RegExpExecArray;
}

async function open(pot: Visit): Promise<void> {
  await pot.command("New");
  await pot.button("From a scan…").click();
  await pot.page.locator("pasu-scan .lead").waitFor();
}

test("an STL, an OBJ and a PLY of one pot are the same rings, and become a pot in one step", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: LINK });
  const before = await pot.fingerprint();
  await open(pot);
  expect(await pot.button("Use it").isDisabled()).toBe(true);
  const corners = triangles();
  const texts: string[] = [];
  for (const [name, bytes, up] of [
    ["pot.stl", stl(corners), "z"],
    ["pot.OBJ", obj(corners), "y"],
    ["pot.ply", ply(corners), "z"],
  ] as const) {
    await pick(pot, name, bytes);
    const [, rings, waves, rms, most] = await found(pot);
    // 180 millimetres.
    expect(await pot.field("Height").first().inputValue()).toBe("18");
    expect(await pot.page.getByRole("combobox", { name: "Upwards is" }).inputValue()).toBe(up);
    expect(Number(most)).toBeLessThan(0.1);
    expect(Number(rms)).toBeLessThan(Number(most));
    texts.push(`${rings} ${waves}`);
  }
  expect(new Set(texts).size).toBe(1);
  expect(await findings(pot)).toEqual([]);
  await pot.type("Height", "9");
  await expect.poll(() => told(pot).textContent()).toMatch(/Finding/);
  await found(pot);
  await pot.button("Use it").click();
  const scanned = await pot.fingerprintOtherThan(before);
  const rings = await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: {
        store: {
          design: {
            parts: { shape: { rings: { r: { mean: number; waves?: { n: number }[] }; z: { mean: number } }[] } }[];
          };
        };
      };
    };
    return designer.store.design.parts[0]?.shape.rings ?? [];
  });
  expect(rings.at(-1)?.z.mean).toBeCloseTo(9, 0);
  expect(rings[0]?.r.mean).toBeCloseTo(2, 0);
  expect(rings.every(({ r }) => r.waves?.some(({ n }) => n === 5))).toBe(true);
  await pot.undo();
  await pot.shows(before);
  await pot.redo();
  await pot.shows(scanned);
});

const up = (pot: Visit) => pot.page.getByRole("combobox", { name: "Upwards is" });

test("a scan that lies, or has another way up than its kind of file, stands upright, and can be turned over", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: LINK });
  await open(pot);
  // Closed at both ends it is some pot from the side, too.
  const corners = triangles();
  const lids = corners.flatMap((corner, i): readonly Corner[] => {
    const next = i % 3 === 0 ? corners[i + 1] : undefined;
    const height = corner[2];
    if (next?.[2] !== height || (height !== 0 && height !== 180)) return [];
    return [corner, next, [20, 5, height]];
  });
  const closed = [...corners, ...lids];
  for (const [bytes, way] of [
    [obj(closed, (corner) => corner), "z"],
    [obj(closed, ([x, y, z]) => [z, y, -x]), "x"],
  ] as const) {
    await pick(pot, "pot.obj", bytes);
    const [, , , , most] = await found(pot);
    expect(await up(pot).inputValue()).toBe(way);
    expect(Number(most)).toBeLessThan(0.1);
    expect(await pot.field("Height").first().inputValue()).toBe("18");
  }
  const before = await colours(pot);
  await up(pot).selectOption("-x");
  await found(pot);
  expect((await colours(pot)).sum).not.toBe(before.sum);
  expect(await findings(pot)).toEqual([]);
});

/** How many colours the scan is seen in, and what they are, as one number. */
const colours = (pot: Visit) =>
  pot.page.locator("pasu-scan-picture canvas").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const { data } = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: [] };
    const all = new Set<number>();
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] !== 255) continue;
      const colour = ((data[i] ?? 0) << 16) | ((data[i + 1] ?? 0) << 8) | (data[i + 2] ?? 0);
      all.add(colour);
      sum = (sum * 31 + colour) % 1_000_003;
    }
    return { count: all.size, sum };
  });

test("the distance is a map on the scan, in the unit of the design, that is turned by keys", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: "#1/rings?unit=in" });
  await pot.dropFile("jug.stl", stl(triangles(true)));
  await expect
    .poll(() => told(pot).textContent(), { timeout: 60_000 })
    .toMatch(/[\d.]+\sin off \(RMS\), [\d.]+\sin at most/);
  // A handle is further off than the colours go.
  const ends = pot.page.locator("pasu-scan-picture .ends");
  expect(await ends.textContent()).toMatch(/^0\.0\d+\sin inside0≥ 0\.0\d+\sin outside$/);
  const before = await colours(pot);
  expect(before.count).toBeGreaterThan(30);
  const turn = pot.page.locator("pasu-scan-picture .slider");
  await turn.focus();
  await turn.press("PageUp");
  await expect.poll(async () => (await colours(pot)).sum).not.toBe(before.sum);
  expect(await findings(pot)).toEqual([]);
});

test.each([1e-5, 1e5])("a scan %f times as large is as good a scan", { timeout: 240_000 }, async (times) => {
  const pot = await here.enter({ link: LINK });
  const scaled = triangles().map(([x, y, z]): Corner => [times * x, times * y, times * z]);
  await pot.dropFile("pot.stl", stl(scaled));
  await pot.page.locator("pasu-scan .primary:enabled").waitFor();
  await pot.type("Height", "18");
  const [, , , , most] = await found(pot);
  expect(Number(most)).toBeLessThan(0.1);
  expect((await colours(pot)).count).toBeGreaterThan(10);
});

test("a scan that is dropped on the stage, or opened, is read at once; what is a design of ours is opened as that", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: LINK });
  const before = await pot.fingerprint();
  await pot.dropFile("pot.ply", ply(triangles()));
  await pot.page.getByText("“pot.ply” holds no design. It is read as a scan.").waitFor();
  await found(pot);
  await pot.shows(before);
  expect(await pot.page.locator(".banners [role=alert]").count()).toBe(0);
  await pot.button("Use it").click();
  const scanned = await pot.fingerprintOtherThan(before);
  // Beside other files, of which none is a design.
  await pot.dropFiles([
    ["notes.txt", "bowls for the market"],
    ["Pot.STL", stl(triangles())],
    ["other.ply", ply(triangles())],
  ]);
  await pot.page
    .getByText("“notes.txt” could not be opened. Not opened: “other.ply”, because one design is shown at a time.")
    .waitFor();
  await found(pot);
  await pot.page.keyboard.press("Escape");
  await pot.page.locator("pasu-scan").waitFor({ state: "detached" });
  // A design is opened, whatever lies beside it.
  await pot.dropFiles([
    ["pot.stl", stl(triangles())],
    ["vase.txt", "#1/second-order"],
  ]);
  await pot.fingerprintOtherThan(scanned);
  expect(await pot.page.locator("pasu-scan").count()).toBe(0);
  // What was dropped before is not opened again with the dialogue, and what is damaged is refused in it.
  await open(pot);
  expect(await told(pot).textContent()).toContain("Nothing is open yet.");
  await pot.page.keyboard.press("Escape");
  await pot.chooseFile("broken.obj", "v 0 0 0\nf 1 2 3\n");
  await expect.poll(() => trouble(pot).textContent(), { timeout: 30_000 }).toMatch(/no triangles/);
});

test("a handle is told of, and what is no scan of a pot is refused in words", { timeout: 240_000 }, async () => {
  const pot = await here.enter({ link: LINK });
  await open(pot);
  for (const [name, bytes, words] of [
    ["pot.txt", Buffer.from("solid"), /no STL, OBJ or PLY/],
    ["pot.stl", Buffer.from("this is no scan"), /no triangles/],
    [
      "pot.ply",
      Buffer.from("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
      /no triangles/,
    ],
    ["pot.obj", Buffer.from("v 0 0 0\nv 1 0 0\n"), /no triangles/],
    [
      "pot.stl",
      stl([
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 5],
      ]),
      /no pot that stands upright/,
    ],
    [
      "pot.stl",
      stl([
        [0, 0, 0],
        [Number.NaN, 0, 0],
        [0, 1, 5],
      ]),
      /no triangles/,
    ],
  ] as const) {
    await pick(pot, name, bytes);
    await expect
      .poll(
        () =>
          trouble(pot)
            .textContent()
            .catch(() => ""),
        { timeout: 30_000 },
      )
      .toMatch(words);
    expect(await pot.button("Use it").isDisabled()).toBe(true);
  }
  await pick(pot, "jug.stl", stl(triangles(true)));
  await found(pot);
  await pot.page
    .getByText(/Something stands out at one side, .* the rest is 0\.0\d+\scm off \(RMS\), 0\.\d+\scm at most/)
    .waitFor({ timeout: 30_000 });
  expect(await findings(pot)).toEqual([]);
});

test("holes are bridged and told, and so is how much of a broken scan is left", { timeout: 240_000 }, async () => {
  const pot = await here.enter({ link: LINK });
  await open(pot);
  const all = triangles();
  // Some triangles half-way up are missing, and of one a number is none.
  const middle = 3 * (2 * 100 * 30);
  const holed = [...all.slice(0, middle), ...all.slice(middle + 12)].map(
    ([x, y, z], i): Corner => [i === 9000 ? Number.NaN : x, y, z],
  );
  await pick(pot, "pot.stl", stl(holed));
  const [, , , , distance] = await found(pot);
  expect(Number(distance)).toBeLessThan(0.2);
  expect(await told(pot).textContent()).not.toMatch(/Only/);
  await pot.page.getByText(/The scan has holes, 0\.\d+\s?% of what is looked at/).waitFor();
  // Half of it from two thirds of the height on.
  const broken = all.filter((_, i) => {
    const number = Math.floor(i / 3);
    return Math.floor(number / 200) < 40 || number % 200 < 100;
  });
  await pick(pot, "pot.stl", stl(broken));
  await found(pot);
  await expect.poll(() => told(pot).textContent()).toMatch(/Only 1[12](\.\d+)?\scm of 18\scm in height are closed/);
  expect(await findings(pot)).toEqual([]);
});

test("on a phone all of it is within reach, and nothing is said that is not in the catalogue", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ ...PHONE, link: LINK });
  await open(pot);
  await pick(pot, "pot.stl", stl(triangles()));
  await found(pot);
  expect(await overhang(pot)).toBe(0);
  expect(await unreachable(pot, "footer")).toEqual([]);
  expect(await findings(pot)).toEqual([]);
  const other = await here.enter({ link: PSEUDO + LINK, colorScheme: "dark" });
  await other.page.locator("pasu-top-bar .files button").nth(1).click();
  await other.page.locator("pasu-new .lead button").nth(2).click();
  await other.page.locator("pasu-scan .lead").waitFor();
  const chooser = other.page.waitForEvent("filechooser");
  await other.page.locator("pasu-scan button.outlined").click();
  await (await chooser).setFiles({ name: "jug.stl", mimeType: "model/stl", buffer: stl(triangles(true)) });
  await other.page.locator("pasu-scan .primary:enabled").waitFor();
  expect(await unmarked(other)).toEqual([]);
  expect(await findings(other)).toEqual([]);
});
