/** Rings for a scan: its mean outline by the maker, the waves of every ring from its sections, and how far the scan is off. */

import { withoutHandle } from "../document/scanned/handle";
import type { Levels } from "../document/scanned/levels";
import { type Off, offBy, placesRead } from "../document/scanned/off";
import { outlineOf, withWaves } from "../document/scanned/reading";
import type { Rings } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { SolverClient } from "../solver/client";
import type { Outcome } from "../worker/port";

export interface Scanned extends Off {
  readonly shape: Rings;
  /** How far the scan is off without what stands out of it like a handle, which rings leave away; null where nothing does. */
  readonly without: Off | null;
}

/** Each time the outline is followed twice as closely, which takes more rings: waves between rings are followed more closely by that, too. */
const ROUNDS = 5;

/** Waves of a ring that are left out, as a part of how far off it may be. */
const UNSEEN = 0.15;

/** A scan as large as the pot is to be, standing on 0. */
export function scaled(levels: Levels, height: number): Levels {
  const times = height / levels.height;
  return {
    axis: levels.axis,
    bottom: 0,
    height,
    heights: levels.heights.map((each) => times * each),
    radii: levels.radii.map((section) => section.map((radius) => times * radius)),
  };
}

/** With as few rings as keep the scan within `tolerance` where that can be had; else those that come nearest to it. */
export async function scannedOf(
  maker: MakerClient,
  solver: SolverClient,
  levels: Levels,
  tolerance: number,
): Promise<Outcome<Scanned>> {
  const radii = withoutHandle(levels.radii);
  const round = radii === levels.radii ? levels : { ...levels, radii };
  const profile = { right: outlineOf(round) };
  let best: Scanned | null = null;
  for (let time = 0; time < ROUNDS; time += 1) {
    const closely = tolerance / 2 ** time;
    const fitted = await maker.ask({ kind: "fit", profile, tolerance: closely }, "scan");
    if (fitted.state === "superseded" || (fitted.state === "refused" && !best)) return fitted;
    // Closer than rings can follow: what was found before is the best there is.
    if (fitted.state === "refused") break;
    const shape = withWaves(fitted.value.shape, round, UNSEEN * closely);
    const read = await solver.read("scan", shape, placesRead());
    if (read.state === "superseded" || (read.state === "refused" && !best)) return read;
    if (read.state === "refused") break;
    const off = offBy(round, read.value.points);
    if (!best || off.rms < (best.without ?? best).rms)
      best =
        round === levels
          ? { shape, ...off, without: null }
          : { shape, ...offBy(levels, read.value.points), without: off };
    if (off.most <= tolerance) break;
  }
  return best ? { state: "done", value: best } : { state: "superseded" };
}
