import { expect, test } from "vitest";
import { realSolver } from "../../testing/real-solver";
import { MAPS } from "../document/maps";
import { NEW_SESSION, type Overlays } from "./session";
import { readView, type Viewed, withView } from "./viewed";

const ADDRESS = "https://pasu.example/designer/#1/second-order?height=5";
const NAMES = MAPS.map(({ name }) => name);
const OFF = NEW_SESSION.overlays;

const viewed = (change: Partial<Viewed> = {}): Viewed => ({
  camera: { azimuth: 0.5, polar: 1.2, share: 0.8 },
  overlays: OFF,
  map: null,
  ...change,
});
const searchOf = (address: string) => new URL(address).search;

test("every view comes back as it was, zero and nothing among them", () => {
  const cameras = [0, 0.5, Math.PI, 6.2].flatMap((azimuth) =>
    [0, 1.2, Math.PI].flatMap((polar) => [0.02, 1, 50].map((share) => ({ azimuth, polar, share }))),
  );
  const overlays: Overlays[] = Array.from({ length: 64 }, (_, bits) => ({
    isoU: (bits & 1) > 0,
    isoV: (bits & 2) > 0,
    wireframe: (bits & 4) > 0,
    boundary: (bits & 8) > 0,
    axes: (bits & 16) > 0,
    cut: (bits & 32) > 0,
  }));
  const all = [
    ...cameras.map((camera) => viewed({ camera })),
    ...overlays.map((each) => viewed({ overlays: each })),
    ...[null, ...NAMES].map((map) => viewed({ map })),
  ];
  for (const each of all) {
    const { viewed: read, damaged } = readView(searchOf(withView(ADDRESS, each)), NAMES);
    expect(damaged).toBe(false);
    expect([read.overlays, read.map]).toEqual([each.overlays, each.map]);
    expect(read.camera?.azimuth).toBeCloseTo(each.camera.azimuth, 2);
    expect(read.camera?.polar).toBeCloseTo(each.camera.polar, 2);
    expect((read.camera?.share ?? 0) / each.camera.share).toBeCloseTo(1, 2);
  }
});

test("the design stays what it was, for readers that know nothing of views too", async () => {
  const address = withView(ADDRESS, viewed({ map: "overhang" }));
  expect(address).toBe(
    "https://pasu.example/designer/?view=28.6,68.8,1.25&cut=0&show=none&map=overhang#1/second-order?height=5",
  );
  expect(withView("https://pasu.example/?a=1#1/second-order", viewed())).toContain("/?a=1&view=");
  const { solver } = realSolver({ free: true });
  const outcome = await solver.parse(address);
  expect(outcome.state === "done" && outcome.value.link).toBe("1/second-order?height=5");
});

test("what is not said is left as it is, and a whole turn is no turn", () => {
  expect(readView("?lang=en-XA", NAMES)).toEqual({ viewed: {}, damaged: false });
  expect(readView("?cut=1", NAMES).viewed).toEqual({ overlays: { ...OFF, cut: true } });
  expect(readView("?map=none", NAMES).viewed).toEqual({ map: null });
  expect(withView(ADDRESS, viewed({ camera: { azimuth: -Math.PI / 2, polar: 1, share: 1 } }))).toContain("view=270,");
  expect(withView(ADDRESS, viewed({ camera: { azimuth: 4 * Math.PI, polar: 1, share: 1 } }))).toContain("view=0,");
});

test.each([
  "view=",
  "view=1,2",
  "view=1,2,3,4",
  "view=1,2,0",
  "view=1,2,-1",
  "view=1,2,1e9",
  "view=1,2,101",
  "view=1,181,1",
  "view=1,-1,1",
  "view=361,1,1",
  "view=NaN,1,1",
  "view=Infinity,1,1",
  "view= 1,1,1",
  "view=,,",
  "cut=yes",
  "cut=",
  "show=",
  "show=isoU,teapot",
  "show=cut",
  "show=__proto__",
  "map=",
  "map=teapot",
])("%s is damaged and left out", (query) => {
  expect(readView(`?${query}`, NAMES)).toEqual({ viewed: {}, damaged: true });
});
