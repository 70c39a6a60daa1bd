/** How keys move a ring. */

import type { Move } from "../../maker/messages";
import { ARROWS } from "../../ui/arrows";

/** One press moves it by about so many pixels, and with shift by ten times as much. */
const PIXELS = 3;
const COARSE = 10;
/** With alt it goes round the axis, by so many degrees. */
const TURN = Math.PI / 180;

/** What an arrow asks for, where a pixel is so long: steps are round numbers. Null for any other key. */
export function ringStep(event: Pick<KeyboardEvent, "key" | "shiftKey" | "altKey">, pixel: number): Move | null {
  const arrow = ARROWS[event.key];
  if (!arrow) return null;
  const times = event.shiftKey ? COARSE : 1;
  if (event.altKey) return { out: 0, up: 0, round: arrow[0] * TURN * times };
  const step = 10 ** Math.floor(Math.log10(PIXELS * pixel)) * times;
  return { out: arrow[0] * step, up: arrow[1] * step, round: 0 };
}
