/** Colours that are no names. */

import type { Triple } from "./triple";

/** A colour of sRGB as documents write it: `#rrggbb`. */
export type Colour = `#${string}`;

export function isColour(choice: string): choice is Colour {
  return choice.startsWith("#");
}

/** Its linear reflectances (IEC 61966-2-1). */
export function linearOf(colour: Colour): Triple {
  const channel = (at: number) => {
    const coded = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return coded <= 0.04045 ? coded / 12.92 : ((coded + 0.055) / 1.055) ** 2.4;
  };
  return [channel(1), channel(3), channel(5)];
}

/** The other way: a linear reflectance as sRGB, 0 to 1. */
export function codedOf(linear: number): number {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}
