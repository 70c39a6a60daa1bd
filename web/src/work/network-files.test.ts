import { expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { realMaker } from "../../testing/real-maker";
import type { Designer } from "./designer";
import { readNetwork } from "./network-files";

const QUAD = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

const file = (text: string) => new File([text], "roof.obj");

function designer(options = { free: true }) {
  const { maker, worker } = realMaker(options);
  const opened = { maker } as unknown as Awaited<ReturnType<Designer["openMade"]>>;
  return { maker, worker, openMade: async () => opened };
}

test("faces of a file become a network", async () => {
  const read = await readNetwork(designer(), file(QUAD));
  if (!read || !("network" in read)) throw new Error("not read");
  // Four corners and the middles of four edges.
  expect([read.network.vertices.length, read.network.patches.length]).toEqual([8, 1]);
});

test.each([
  ["v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "line 4", false],
  [`${QUAD}f 1 2 3 7\n`, "line 6", true],
  ["", "no faces", false],
])("%j is told why it is none, and whether it was meant", async (text, told, isMeant) => {
  const read = await readNetwork(designer(), file(text));
  expect(read).toEqual({ trouble: expect.stringContaining(told), isMeant });
});

test("nothing is read where the maker cannot be fetched, or was asked for something newer", async () => {
  expect(await readNetwork({ openMade: async () => null }, file(QUAD))).toBeNull();
  const held = designer({ free: false });
  const reading = readNetwork(held, file(QUAD));
  await settled();
  held.maker.cancel("faces");
  expect(await reading).toBeNull();
});

test("what is wrong with a file is not told once it was stopped, and it is read no further", async () => {
  const held = designer({ free: false });
  const opening = new AbortController();
  const reading = readNetwork(held, file(""), opening.signal);
  await settled();
  expect(held.maker.busy).toBe(true);
  opening.abort();
  expect(await reading).toBeNull();
  expect(held.maker.busy).toBe(false);
  expect(await readNetwork(designer(), file(""), opening.signal)).toBeNull();
});
