/** What stands out of a scan at one side. */

import { DIRECTIONS, middle } from "./section";

/** A handle stands out by this part of the radius, over less than this part of the turn, at so many of the levels at least. */
const OUT = 0.25;
const NARROW = 0.22;
const OFTEN = 0.06;
/** So many directions to either side of it, and levels above and below, are its root. */
const ROOT = 3;

/** Without what stands out at one side like a handle, round which no ring goes: the wall goes on there as it does to either side. The same sections where nothing does. */
export function withoutHandle(radii: readonly Float64Array[]): readonly Float64Array[] {
  const out = radii.map(handleIn);
  if (out.filter((each) => each !== null).length <= OFTEN * out.length) return radii;
  // Above and below it grows out of the wall as well.
  const near = (i: number) => out.slice(Math.max(0, i - ROOT), i + ROOT + 1).flatMap((each) => [...(each ?? [])]);
  return radii.map((section, i) => bridged(section, new Set(near(i))));
}

/** The directions in which a section has a handle; null where it has none. */
function handleIn(section: Float64Array): Set<number> | null {
  const radius = middle(section);
  const out = [...section.keys()].filter((k) => (section[k] as number) > (1 + OUT) * radius);
  if (out.length === 0 || out.length >= NARROW * DIRECTIONS) return null;
  // Where it grows out of the wall it belongs to it as well.
  return new Set(
    out.flatMap((k) => Array.from({ length: 2 * ROOT + 1 }, (_, i) => (k + i - ROOT + DIRECTIONS) % DIRECTIONS)),
  );
}

function bridged(section: Float64Array, out: ReadonlySet<number>): Float64Array {
  // Of a section that is all handle nothing is known.
  if (out.size === 0 || out.size > DIRECTIONS / 2) return section;
  /** The nearest direction without a handle, so many steps on or back. */
  const beyond = (k: number, step: 1 | -1) => {
    let away = 1;
    while (out.has((k + step * away + away * DIRECTIONS) % DIRECTIONS)) away += 1;
    return { away, radius: section[(k + step * away + away * DIRECTIONS) % DIRECTIONS] as number };
  };
  return section.map((radius, k) => {
    if (!out.has(k)) return radius;
    const [back, on] = [beyond(k, -1), beyond(k, 1)];
    return (back.radius * on.away + on.radius * back.away) / (back.away + on.away);
  });
}
