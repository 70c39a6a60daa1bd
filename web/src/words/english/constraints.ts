/** Whether the parts of a scene fit together, what is wrong where they do not, and what would mend it. */

import { phrases, plural } from "../../language";
import { formatNumber } from "../../number";

export const constraints = phrases("constraints", {
  heading: "How they fit together",
  /** Where there is nothing to tell: of several objects, of one, of both. */
  kept: {
    separate: "No two objects run into each other.",
    glued: "What is glued together touches.",
    both: "No two objects run into each other, and what is glued together touches.",
  },
  /** By what is proved, and by what was measured. */
  away: {
    proved: (length: string) => `${length} away from it at least`,
    measured: (length: string) => `about ${length} away from it`,
  },
  interference: (part: string, other: string) => `${part} runs into ${other}. Move them apart, or glue them together.`,
  within: (part: string, other: string) =>
    `All of ${part} lies inside ${other}, where nobody sees it. Take it away, or move it out.`,
  samePlace: (part: string, other: string) =>
    `${part} is the same body in the same place as ${other}. One of them is enough.`,
  notConnected: (part: string, other: string, away: string) =>
    `${part} is glued to ${other}, but ${away === "" ? "does not touch it" : `is ${away}`}. Move it there, or let it be an object of its own.`,
  /** Of several that hang together, one of which is the nearest. */
  groupNotConnected: (group: string, other: string, part: string, away: string) =>
    `${group} hang together and are glued to ${other}, but ${away === "" ? `${part} does not touch it` : `${part} is ${away}`}. Move them there, or let them be an object of their own.`,
  /** At the end of a list of names. */
  more: (count: number) => `${formatNumber(count)} more`,
  contact: (part: string, other: string) => `${part} touches ${other}. Leave a gap where they are to come apart again.`,
  undecidedInterference: (part: string, other: string) =>
    `Whether ${part} runs into ${other} could not be told, so close they are. Move them a little apart to be sure.`,
  undecidedConnection: (part: string, other: string) =>
    `Whether ${part} touches ${other}, to which it is glued, could not be told. Push it a little into it to be sure.`,
  undecidedGroup: (group: string, other: string) =>
    `Whether any of ${group} touches ${other}, to which they are glued, could not be told. Push them a little into it to be sure.`,
  undecidedWithin: (part: string, other: string) =>
    `Whether all of ${part} lies inside ${other} could not be told. Where nothing of it is seen, take it away.`,
  /** Of what is made. */
  gluedInFile: "Glued parts run into each other, as they are meant to: Export can join them into one solid.",
  mends: {
    glue: "Glue together",
    apart: "Move apart",
    together: (count: number) => (count === 1 ? "Bring it there" : "Bring them there"),
    separate: (count: number) =>
      count === 1 ? "Let it be an object of its own" : "Let them be an object of their own",
    remove: (part: string) => `Take ${part} away`,
  },
  /** What became of a press. */
  moved: (parts: readonly string[], by: string) =>
    parts.length === 1 ? `${parts[0]} was moved by ${by}.` : `${formatNumber(parts.length)} parts were moved by ${by}.`,
  notApart: "No place near by was found where they are apart. Nothing was moved.",
  notTogether: "No way was found on which they touch. Nothing was moved.",
  locked: "What would have to move is locked.",
  lockedPart: (part: string) => `${part} is locked. Unlock it first.`,
  /** Beside the place on the stage. */
  here: "Here",
  shows: "Shows where on the pot",
  all: (count: number) => `Show all ${formatNumber(count)}`,
  leftOut: (count: number) =>
    plural(count, {
      one: `${formatNumber(count)} more is not listed.`,
      other: `${formatNumber(count)} more are not listed.`,
    }),
});
