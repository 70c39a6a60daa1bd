/** What the element says. */

export const WORDS = {
  pot: "A pot",
  view: "3D view",
  keys: "Arrow keys turn the pot, plus and minus zoom, F fits it to the view.",
  fingers: "Use two fingers to turn the pot",
  parameters: "Parameters",
  lost: "The graphics card was taken away for a moment. The picture comes back by itself.",
  /** What is shown where a design could not be: short, because the reader did not write it. */
  unshown: "This pot could not be shown.",
  unchanged: "The pot stays as it was.",
} as const;

/** Why there is no design, for whoever put the element into the page. */
export const REFUSALS = {
  address: (source: string) => `“${source}” is not an address`,
  unreachable: (address: string) => `${address} could not be fetched`,
  status: (address: string, status: number) => `${address} could not be fetched: the answer was ${status}`,
  size: (address: string, most: number) => `${address} has more than ${most} bytes, which no design needs`,
  orbit: (text: string) =>
    `camera-orbit is an angle round the pot, one from above and a distance, like “30deg 65deg 100%”, not “${text}”`,
  control: (name: string, names: readonly string[]) =>
    names.length === 0
      ? `this kind of shape has no parameter “${name}” to show`
      : `there is no parameter “${name}” here, but ${names.join(", ")}`,
} as const;
