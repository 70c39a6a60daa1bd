/** A pot from a scan of one. */

import { listed, phrases, plural } from "../../language";

export const scan = phrases("scan", {
  heading: "From a scan",
  lead: "A scan of a pot that stands upright, as an STL, OBJ or PLY file. Its outside becomes rings with waves; nothing of it leaves this page.",
  file: "Choose a scan…",
  /** A file that was opened, and is no design. */
  undesigned: (name: string) => `${name} holds no design. It is read as a scan.`,
  patches: "Its faces have four corners or eight points: they can be the patches of a network as well.",
  unpatched: (trouble: string) => `It cannot be opened as a network of patches either. ${trouble}`,
  usePatches: "Open them as patches",
  picture: "The outside of the scan from the side, and the rings",
  pictureOff: "The scan from the side, coloured by how far it is from the rings, and the rings",
  turn: "Turn it",
  colours: (inside: string, outside: string) =>
    `Distance of the scan from the rings: colours from ${inside} inside of them to ${outside} outside`,
  coloursAbout: "Blue: the scan is inside of the rings. Red: outside.",
  inside: (length: string) => `${length} inside`,
  outside: (length: string) => `${length} outside`,
  up: "Upwards is",
  ups: {
    z: "z, as printers have it",
    y: "y, as modellers have it",
    x: "x, it lies",
    "-z": "−z, upside down",
    "-y": "−y, upside down",
    "-x": "−x, it lies the other way round",
  },
  height: "Height",
  heightHelp:
    "How high the pot is to be, from the foot to the rim; rounding that adds a little. A scan does not say its unit.",
  tolerance: "No further off than",
  toleranceHelp: "How far the rings may be from the scan. Less takes more of them.",
  reading: "Reading the scan…",
  coming: "Finding rings…",
  nothing: "Nothing is open yet.",
  found: (rings: number, waves: number, rms: string, most: string) =>
    listed([
      plural(rings, { one: "1 ring", other: `${rings} rings` }),
      plural(waves, { one: "1 wave", other: `${waves} waves` }),
    ]).concat(`: ${rms} off (RMS), ${most} at most.`),
  further: "Rings cannot follow it any closer; these come nearest.",
  standsOut: (rms: string, most: string) =>
    `Something stands out at one side, like a handle or a spout. A ring goes round the pot once, so that is left away; the rest is ${rms} off (RMS), ${most} at most.`,
  cut: (kept: string, height: string) =>
    `The scan is not closed all round at its foot or its rim, at a slanting or a broken edge, or at a large hole. The pot ends where it is closed: it is ${kept} of ${height} high.`,
  cutShort: (kept: string, height: string) => ` Only ${kept} of ${height} in height are closed all round.`,
  holes: (share: string) =>
    `The scan has holes, ${share} of what is looked at. There the pot goes on as it does to either side.`,
  use: "Use it",
  done: (rings: number, rms: string, most: string) =>
    plural(rings, {
      one: `The pot has 1 ring, ${rms} off on the whole, ${most} at most.`,
      other: `The pot has ${rings} rings, ${rms} off on the whole, ${most} at most.`,
    }),
  refused: {
    "too-large": "This scan is too large: three million triangles and 150 MB are the most.",
    "no-mesh": "There are no triangles in this file that could be read.",
    other: "This is no STL, OBJ or PLY file.",
    "no-pot": "This is no pot that stands upright: too little of it goes all round an axis. Perhaps another way is up.",
  },
});
