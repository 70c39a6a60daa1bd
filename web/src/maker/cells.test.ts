import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import { CELLS_FORMATS } from "../document/blend/cells";
import type { Design } from "../document/types";

const { maker } = realMaker({ free: true });

const shape = {
  kind: "blend",
  start: { form: "rectangle", radius: [1, 1], z: 0, taper: 0, dz: 3 },
  end: { form: "rectangle", radius: [1.5, 2], z: 3, taper: 0, dz: 3 },
} as const;
const SOLID: Design = { pasu: 1, parts: [{ shape }] };

test("the cells of a block are counted, judged, and written in every format", async () => {
  const ask = { kind: "cells", design: SOLID, part: 0, counts: [2, 3, 4], shape: "hexahedron", format: null } as const;
  const told = await maker.ask(ask);
  if (told.state !== "done") throw new Error(JSON.stringify(told));
  expect(told.value).toMatchObject({ count: 24, useless: 0, bytes: null });
  expect(told.value.least).toBeGreaterThan(0.5);
  expect(told.value.least).toBeLessThanOrEqual(1);
  const begin = { vtu: "<?xml", msh: "$MeshFormat", inp: "*" };
  for (const format of CELLS_FORMATS) {
    const made = await maker.ask({ ...ask, format });
    if (made.state !== "done") throw new Error(JSON.stringify(made));
    const text = new TextDecoder().decode(made.value.bytes ?? new Uint8Array());
    expect([format, text.trimStart().startsWith(begin[format])]).toEqual([format, true]);
  }
  const fine = await maker.ask({ ...ask, shape: "tetrahedron" });
  expect(fine.state === "done" && fine.value.count).toBeGreaterThan(24);
});

test("what has a wall has no inside, and says so", async () => {
  const walled: Design = { pasu: 1, parts: [{ shape, wall: { thickness: 0.1, base: 0.1 } }] };
  const ask = { kind: "cells", design: walled, part: 0, counts: [2, 2, 2], shape: "hexahedron", format: null } as const;
  expect((await maker.ask(ask)).state).toBe("refused");
});
