/** What stands on the paper when the page is printed, besides what it has in common with the panels. */

import { grouped, phrases, plural } from "../../language";

export const printing = phrases("printing", {
  /** A part and what kind of shape it is. */
  part: (name: string, kind: string) => `${name}: ${kind}`,
  /** From the foot up. */
  ring: (number: number) => `Ring ${number}`,
  /** Means, where it has waves. */
  radiusAt: (radius: string, height: string) => `radius ${radius}, height ${height}`,
  wall: "Wall, thickness",
  floor: "Floor, thickness",
  /** Parts whose numbers are left out. */
  more: (count: number) => plural(count, { one: "And one more part.", other: `And ${grouped(count)} more parts.` }),
  link: "Link",
  /** Above the beginning of it. */
  longLink: (letters: number) =>
    `It has ${grouped(letters)} letters, too many to be typed: these are the first. Whoever has no copy of it needs the file of the design.`,
  linkUnknown: "The pot was still being changed when this was printed.",
  noLink: "This design is too large for a link. Whoever is to have it needs its file.",
});
