/** Sliders of the scene: placement numbers by which parts can be moved, within limits. */

import { phrases } from "../../language";

export const joints = phrases("joints", {
  heading: "Sliders of the scene",
  about: "What can be lifted, pushed and turned. They travel in the link.",
  toggle: (number: string) => `Slider of the scene: ${number}`,
  along: (part: string, axis: string) => `${part} along ${axis}`,
  turns: (part: string) => `${part} turned`,
  /** Of two sliders with one label. */
  labelOf: (label: string, slider: string) => `${label} (${slider})`,
  outside: (from: string, to: string) => `It is outside its limits, ${from} to ${to}.`,
  locked: "It moves what is locked.",
  settings: (name: string) => `Settings of “${name}”`,
  label: "Label",
  from: "From",
  to: "To",
  axis: "Turns about",
  axes: { x: "x", y: "y", z: "z, upright", own: "its own axis" },
  glued: "Moves all that is glued to it",
  remove: "Take this slider away",
});
