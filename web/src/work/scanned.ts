/** Rings for a scan, as large as the pot is to be. */

import type { Levels } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { ScannedShape } from "../maker/messages";
import type { Outcome } from "../worker/port";

/** A scan as large as the pot is to be, standing on 0 about the axis. */
export function scaled(levels: Levels, height: number): Levels {
  const times = height / levels.height;
  return {
    axis: [0, 0],
    bottom: 0,
    height,
    heights: levels.heights.map((each) => times * each),
    radii: levels.radii.map((section) => section.map((radius) => times * radius)),
  };
}

/** With as few rings as keep the scan within `tolerance` where that can be had; else those that come nearest to it. */
export function scannedOf(maker: MakerClient, levels: Levels, tolerance: number): Promise<Outcome<ScannedShape>> {
  return maker.ask({ kind: "scanned", levels, tolerance }, "scan");
}
