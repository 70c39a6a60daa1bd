/** The keys that move the water, in the panel and on the stage. */

const STEP = 0.01;
const COARSE_STEP = 0.1;

const STEPS: Readonly<Record<string, number>> = {
  ArrowUp: STEP,
  ArrowRight: STEP,
  ArrowDown: -STEP,
  ArrowLeft: -STEP,
  PageUp: COARSE_STEP,
  PageDown: -COARSE_STEP,
};

/** How full the pot is after a key; null where the key means nothing. */
export function fillAfter(event: KeyboardEvent, fill: number | null): number | null {
  if (fill === null || event.ctrlKey || event.metaKey || event.altKey) return null;
  if (event.key === "Home") return 0;
  if (event.key === "End") return 1;
  const step = STEPS[event.key];
  if (step === undefined) return null;
  const next = Math.round((fill + step * (event.shiftKey && Math.abs(step) === STEP ? 10 : 1)) / STEP) * STEP;
  return Math.min(1, Math.max(0, next));
}
