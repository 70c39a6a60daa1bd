// Networks of patches that tests open, and what a hand and a reader meet of them on the page.

import type { Stay } from "./stay.ts";
import type { Visit, VisitOptions } from "./visit.ts";

/** Eight points: a leaf of 12 by 12. */
export const LEAF = JSON.stringify({
  pasu: 1,
  parts: [
    {
      shape: {
        kind: "vertex-frame",
        vertices: [
          [-6, -6, 0],
          [0, -7, 3],
          [6, -6, 0],
          [7, 0, -2],
          [6, 6, 0],
          [0, 7, 3],
          [-6, 6, 0],
          [-7, 0, -2],
        ],
        patches: [{ frame: [0, 1, 2, 3, 4, 5, 6, 7] }],
      },
    },
  ],
});

/** The leaf in the designer; its fingerprint. */
export async function openLeaf(here: Stay, options: VisitOptions = {}) {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  const plain = await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-network-panel").waitFor();
  return { pot, plain };
}

/** A can of five rows of four patches, open at both ends: it has no handle. */
function can(): string {
  const [vertices, patches]: [number[][], object[]] = [[], []];
  const places = new Map<string, number>();
  const vertex = (place: number, level: number) => {
    const key = `${place % 8} ${level}`;
    const known = places.get(key);
    if (known !== undefined) return known;
    const angle = (Math.PI * (place - 1)) / 4;
    const point = [4 * Math.cos(angle), 4 * Math.sin(angle), level].map((value) => Number(value.toFixed(6)));
    places.set(key, vertices.push(point) - 1);
    return vertices.length - 1;
  };
  for (let row = 0; row < 5; row += 1) {
    for (let column = 0; column < 4; column += 1) {
      const at = (right: number, up: number) => vertex(2 * column + right, 2 * row + up);
      patches.push({ frame: [at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1)] });
    }
  }
  return JSON.stringify({ pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices, patches } }] });
}

/** The can in the designer with its points on the stage; its fingerprint. */
export async function openCan(here: Stay, options: VisitOptions = {}) {
  const pot = await here.enter(options);
  pot.page.setDefaultTimeout(20_000);
  const first = await pot.fingerprint();
  await pot.dropFile("can.json", can());
  const plain = await pot.fingerprintOtherThan(first);
  await points(pot);
  return { pot, plain };
}

export const item = (pot: Visit, name: string) => pot.page.locator(`pasu-network-handles [data-item="${name}"]`);

export async function middle(pot: Visit, name: string): Promise<readonly [number, number]> {
  const box = await item(pot, name).boundingBox();
  return [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
}

export async function drag(pot: Visit, name: string, dx: number, dy: number): Promise<void> {
  const [x, y] = await middle(pot, name);
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  await pot.page.mouse.move(x + dx, y + dy, { steps: 4 });
  await pot.page.mouse.up();
}

export async function points(pot: Visit): Promise<void> {
  await pot.button("Points on the stage").click();
  await item(pot, "vertex 0").waitFor();
}

export const number = async (pot: Visit, name: string) =>
  Number((await pot.page.getByRole("spinbutton", { name, exact: true }).inputValue()).replace("\u2212", "-"));

/** What a handle is when it is built: a ring on the stage for all that is picked, and more patches. */
export async function told(pot: Visit): Promise<string> {
  return (await pot.page.locator("pasu-network-panel .intro p").innerText()).trim();
}
