// The designs that are measured; crates/bench/src/designs.rs reads the same files.

/** The vase with the first so many modes of each component. */
export function firstModes(vase, modes) {
  const design = structuredClone(vase);
  const { shape } = design.parts[0];
  for (const component of [shape.x, shape.y, shape.z]) component.modes.length = modes;
  return design;
}
