/** What is said of whole parts under a hand. */

import { unitOf } from "../document/look";
import type { Axis } from "../document/moving";
import type { Design, Triple } from "../document/types";
import { formatNumber } from "../number";
import { handling } from "./english/handling";
import { lengthWords, spokenLength } from "./quantities";

type Gripped =
  | { readonly kind: "free" }
  | { readonly kind: "move" | "turn"; readonly axis: Axis }
  | { readonly kind: "scale"; readonly axis: Axis | null };

type Moved =
  | { readonly kind: "move"; readonly by: Triple; readonly onTable: boolean }
  | { readonly kind: "turn"; readonly angle: number }
  | { readonly kind: "scale"; readonly factor: number };

/** A handle, and where it is. */
export function readingOf(grip: Gripped, at: { readonly pivot: Triple } | null, design: Design): string {
  const unit = unitOf(design);
  const { names } = handling;
  switch (grip.kind) {
    case "free": {
      if (!at) return names.free;
      const [x, y] = at.pivot;
      return handling.at(names.free, handling.both(spokenLength(x, unit), spokenLength(y, unit)));
    }
    case "move": {
      const name = names.move[grip.axis] ?? "";
      return at ? handling.at(name, spokenLength(at.pivot[grip.axis], unit)) : name;
    }
    case "turn":
      return names.turn[grip.axis] ?? "";
    case "scale":
      return (grip.axis === null ? names.all : names.scale[grip.axis]) ?? "";
  }
}

/** What a hand has done so far. */
export function motionWords(motion: Moved, design: Design): string {
  switch (motion.kind) {
    case "move": {
      const unit = unitOf(design);
      const parts = motion.by.flatMap((by, axis) =>
        by === 0 ? [] : [handling.along(handling.letters[axis] ?? "", lengthWords(by, unit))],
      );
      const by = parts.length === 0 ? handling.along("", lengthWords(0, unit)) : handling.joined(parts);
      return motion.onTable ? handling.onTable(by) : by;
    }
    case "turn":
      return handling.turnedBy(formatNumber(Number(((motion.angle / Math.PI) * 180).toFixed(2))));
    case "scale":
      return handling.times(formatNumber(motion.factor));
  }
}
