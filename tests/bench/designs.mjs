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
