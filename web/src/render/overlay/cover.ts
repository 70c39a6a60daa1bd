/** What lies over a stage: handles stand beside it, where a hand can take hold of them. */

import type { Box, Spot } from "./label";

export interface Cover {
  /** Of the stage, in CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** Bars, tools and the caption. */
  readonly boxes: readonly Box[];
}

/** What a finger takes hold of reaches so far from its middle, in CSS pixels. */
const ROOM = 22;
/** It is moved by no more than this: what is farther off is not to be seen there. */
const FAR = 160;
/** At so many places of a way one is sought. */
const PLACES = 40;

/** Whether a handle with its middle at a spot is on the stage and under nothing. */
export function isClear({ x, y }: Spot, { width, height, boxes }: Cover): boolean {
  const within = x >= ROOM && y >= ROOM && x <= width - ROOM && y <= height - ROOM;
  const isOff = ({ left, top, right, bottom }: Box) =>
    x + ROOM <= left || x - ROOM >= right || y + ROOM <= top || y - ROOM >= bottom;
  return within && boxes.every(isOff);
}

/** A handle that belongs to a spot: there if it is clear, else at the first place that is on the way to one of others, the first of them before the next, and at the spot where that is nowhere near. */
export function besideCover(spot: Spot, towards: readonly Spot[], cover: Cover): Spot {
  if (isClear(spot, cover)) return spot;
  for (const { x, y } of towards) {
    const [dx, dy] = [x - spot.x, y - spot.y];
    const length = Math.hypot(dx, dy);
    if (!(length > 0)) continue;
    const way = Math.min(length, FAR) / length / PLACES;
    for (let place = 1; place <= PLACES; place++) {
      const here = { x: spot.x + place * way * dx, y: spot.y + place * way * dy };
      if (isClear(here, cover)) return here;
    }
  }
  return spot;
}
