/** The keys by which a stage is turned, moved and zoomed. */

import type { Stage } from "../render/stage";
import { VIEWS, ZOOM } from "./views";

/** One press of an arrow key, in radians and in pixels. */
const TURN = Math.PI / 18;
const PAN = 40;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Does what a key asks for, and keeps it from the page; false where it means nothing here. */
export function stageKey(event: KeyboardEvent, stage: Stage): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const view = VIEWS[Number(event.key) - 1];
  const arrow = ARROWS[event.key];
  if (arrow) {
    const [x, y] = arrow;
    if (event.shiftKey) stage.pan(-PAN * x, -PAN * y);
    else stage.orbit(TURN * x, TURN * y);
  } else if (view) stage.view(view);
  else if (event.key === "+" || event.key === "=") stage.zoom(ZOOM);
  else if (event.key === "-" || event.key === "_" || event.key === "−") stage.zoom(1 / ZOOM);
  else if (event.key === "f" || event.key === "F") stage.fit();
  else return false;
  event.preventDefault();
  return true;
}
