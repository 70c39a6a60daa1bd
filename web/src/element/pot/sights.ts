/** Which elements are near the screen, and which are on it: asked of the browser for all elements at once. */

export interface Sight {
  /** Within half a screen of it. */
  readonly near: boolean;
  readonly seen: boolean;
}

const NEAR = "50%";

type Told = (sight: Sight) => void;

interface Watched {
  readonly told: Told;
  sight: Sight;
}

const watched = new Map<Element, Watched>();
const changed = new Set<Watched>();
let observers: readonly [near: IntersectionObserver, seen: IntersectionObserver] | null = null;

/** Tells where an element is whenever that changes, until what comes back is called. */
export function watchSight(element: Element, told: Told): () => void {
  observers ??= [observer("near", NEAR), observer("seen", "0px")];
  watched.set(element, { told, sight: { near: false, seen: false } });
  for (const each of observers) each.observe(element);
  return () => {
    watched.delete(element);
    for (const each of observers ?? []) each.unobserve(element);
    if (watched.size > 0) return;
    for (const each of observers ?? []) each.disconnect();
    observers = null;
  };
}

/** Those on the screen hear it before those that are only near it. */
function tell(): void {
  const all = [...changed].sort((one, other) => Number(other.sight.seen) - Number(one.sight.seen));
  changed.clear();
  const alive = new Set(watched.values());
  for (const one of all) if (alive.has(one)) one.told(one.sight);
}

function observer(what: keyof Sight, rootMargin: string): IntersectionObserver {
  return new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const one = watched.get(target);
        if (!one || one.sight[what] === isIntersecting) continue;
        one.sight = { ...one.sight, [what]: isIntersecting };
        // Which of the two observers is heard first is the browser's choice: both are, before anybody is told.
        if (changed.size === 0) setTimeout(tell);
        changed.add(one);
      }
    },
    { rootMargin },
  );
}
