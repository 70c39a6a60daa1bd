// The designs that are measured; crates/bench/src/designs.rs reads the same files.

/** The vase with the first so many modes of each component. */
export function firstModes(vase, modes) {
  const design = structuredClone(vase);
  const { shape } = design.parts[0];
  for (const component of [shape.x, shape.y, shape.z]) component.modes.length = modes;
  return design;
}

/** The same with cosines and sines in every component: of each mode the other wave, half as high, with rim and foot exchanged. */
export function withEveryWave(vase) {
  const design = structuredClone(vase);
  const { shape } = design.parts[0];
  for (const mode of [shape.x, shape.y, shape.z].flatMap(({ modes }) => modes)) {
    if (mode.n === 0) continue;
    const { start, end, start_u, end_u } = mode.cos ?? mode.sin;
    mode[mode.cos ? "sin" : "cos"] = { start: end / 2, end: start / 2, start_u: end_u / 2, end_u: start_u / 2 };
  }
  return design;
}

/** The same with the equation of `x` in every component. */
export function withOneEquation(vase) {
  const design = structuredClone(vase);
  const { shape } = design.parts[0];
  for (const component of [shape.y, shape.z]) {
    const { s, t, w } = shape.x;
    Object.assign(component, { s, t, w });
  }
  return design;
}

/** How far rings are at most from where they would stand evenly, as a part of their distance: what is alike between two rings is solved once, and here nothing is. */
const ASIDE = 0.3;

/** The same through so many rings, no two gaps of one length unless `aside` is 0: between its ends, a little wider and narrower in turn. */
export function withRings(vase, count, aside = ASIDE) {
  const design = structuredClone(vase);
  const { shape } = design.parts[0];
  const place = (index) => index + 1 + aside * Math.sin(1.7 * index * index);
  const places = Array.from({ length: count }, (_, index) => place(index) / (count + 1));
  shape.rings = places.map((u) => ({ u }));
  for (const mode of [shape.x, shape.y, shape.z].flatMap(({ modes }) => modes)) {
    const datum = mode.cos ?? mode.sin;
    const { start = 0, end = 0 } = datum;
    datum.rings = places.map(
      (u, index) => start + (end - start) * u + (start - end) * (index % 2 === 0 ? 0.05 : -0.05),
    );
  }
  return design;
}

/** So many pots of four rings with walls, no two alike, none of which comes near another: rows of 25. */
export function pots(count) {
  const away = 12;
  const part = (_, index) => {
    // Between 0 and 1, and another for each.
    const number = (which) => Math.abs(Math.sin(43758.5453 * (7 * index + which + 1)));
    const rings = [0, 1 / 3, 2 / 3, 1].map((u, ring) => ({
      u,
      r: { mean: 2 + 2.5 * number(ring), waves: [{ n: 2 + (index % 5), cos: 0.2 * number(4) }] },
      z: { mean: (8 + 8 * number(5)) * u },
    }));
    return {
      shape: { kind: "rings", rings },
      wall: { thickness: 0.3 + 0.1 * number(6), base: 0.4 },
      place: { shift: [away * ((index % 25) + 1), away * Math.floor(index / 25), 0] },
    };
  };
  return { pasu: 1, parts: Array.from({ length: count }, part) };
}
