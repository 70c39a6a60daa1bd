/** What the element says that stands in other people's pages. */

import { phrases } from "../../language";

export const pot = phrases("pot", {
  aPot: "A pot",
  view: "3D view",
  keys: "Arrow keys turn the pot, plus and minus zoom, F fits it to the view.",
  fingers: "Use two fingers to turn the pot",
  parameters: "Parameters",
  lost: "The graphics card was taken away for a moment. The picture comes back by itself.",
  /** Where a design could not be shown: short, because the reader did not write it. */
  unshown: "This pot could not be shown.",
  unchanged: "This pot could not be shown. The pot stays as it was.",
  /** Of a frame by itself. */
  noLink: "No pot is shown: the address of this frame ends without the link of one.",

  /** Why there is no design, for whoever put the element into the page. */
  stopped: "the solver stopped, or could not be started",
  noAddress: (source: string) => `“${source}” is not an address`,
  unreachable: (address: string) => `${address} could not be fetched`,
  status: (address: string, status: number) => `${address} could not be fetched: the answer was ${status}`,
  tooLarge: (address: string, most: number) => `${address} has more than ${most} bytes, which no design needs`,
  orbit: (text: string) =>
    `camera-orbit is an angle round the pot, one from above and a distance, like “30deg 65deg 100%”, not “${text}”`,
  noControls: (name: string) => `this kind of shape has no parameter “${name}” to show`,
  noControl: (name: string, names: string) => `there is no parameter “${name}” here, but ${names}`,
});
