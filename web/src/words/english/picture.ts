/** Saving a picture. */

import { phrases } from "../../language";

export const picture = phrases("picture", {
  heading: "Save a picture",
  lead: "The pot as it stands on the stage, as a PNG file.",
  size: "Size",
  sizes: { square: "Square", wide: "Wide", tall: "Tall", large: "Large, for print" },
  pixels: (width: number, height: number) => `${width} × ${height}`,
  own: "My own",
  width: "Width in pixels",
  height: "Height in pixels",
  transparent: "Transparent background",
  cancel: "Cancel",
  save: "Save PNG",
  wrongSize: (least: number, most: number) => `Width and height are whole numbers from ${least} to ${most}.`,
});
