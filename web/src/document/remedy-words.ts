/** What is different of a wall that would make a pot, in words for a button. */

import { lengthWords } from "./quantities";
import type { Unit, Wall } from "./types";

/** "Make it with a ring 3 mm wide and 2 mm high" */
export function remedyWords(asked: Wall, wall: Wall, unit: Unit): string {
  const length = (value: number) => lengthWords(value, unit, 2);
  const changes: string[] = [];
  if ((wall.side ?? "inside") !== (asked.side ?? "inside")) {
    changes.push(wall.side === "outside" ? "the clay laid outwards" : "the clay laid inwards");
  }
  if (wall.thickness !== asked.thickness) changes.push(`a wall of ${length(wall.thickness)}`);
  if (wall.base !== asked.base) changes.push(`a base of ${length(wall.base)}`);
  if ((wall.rim ?? "flat") !== (asked.rim ?? "flat")) changes.push("a flat rim");
  if (wall.foot) {
    const [width, height] = wall.foot;
    if (width !== asked.foot?.[0] || height !== asked.foot[1]) {
      changes.push(`a ring ${length(width)} wide and ${length(height)} high`);
    }
  } else if (asked.foot) changes.push("no ring");
  if ((wall.drain ?? 0) !== (asked.drain ?? 0))
    changes.push(wall.drain ? `a drain of ${length(wall.drain)}` : "no drain");
  return `Make it with ${changes.join(" and ")}`;
}
