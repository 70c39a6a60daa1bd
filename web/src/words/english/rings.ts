/** A pot of rings, from the rim to the foot. `u` is that of the equation. */

import { phrases, plural } from "../../language";

export const rings = phrases("rings", {
  lead: "A pot of rings.",
  about: "The wall passes through every ring, and bends as little as its equation lets it in between.",
  smoothing: "Smoothing",
  rim: "Rim",
  foot: "Foot",
  ring: (number: number) => `Ring ${number}`,
  place: "Place u",
  radius: "Radius",
  height: "Height",
  of: (what: string, ring: string) => `${what}, ${ring}`,
  sharp: "Sharp",
  waves: (count: number) => plural(count, { one: "with 1 wave round it", other: `with ${count} waves round it` }),
});
