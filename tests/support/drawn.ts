// Which components of the page draw themselves while something is done, and what canvases are made.

import type { Visit } from "./visit.ts";

interface Counting {
  pasuDrawn: Record<string, number>;
}

/** Counts from now on; to be called once the page has opened. */
export async function countDrawn(pot: Visit): Promise<void> {
  await pot.page.evaluate(() => {
    const counts: Record<string, number> = {};
    (globalThis as unknown as Counting).pasuDrawn = counts;
    const count = (name: string) => {
      counts[name] = (counts[name] ?? 0) + 1;
    };
    interface Drawing extends HTMLElement {
      update(changed: unknown): void;
    }
    // What Lit calls for each drawing, whoever schedules it.
    let base: Drawing = customElements.get("pasu-app")?.prototype;
    while (!Object.hasOwn(base, "render")) base = Object.getPrototypeOf(base);
    base = Object.getPrototypeOf(base);
    while (!Object.hasOwn(base, "update")) base = Object.getPrototypeOf(base);
    const { update } = base;
    base.update = function (changed) {
      count(this.localName);
      update.call(this, changed);
    };
    const { createElement } = document;
    document.createElement = ((name: string, options?: ElementCreationOptions) => {
      if (name === "canvas") count("a new canvas");
      return createElement.call(document, name, options);
    }) as typeof createElement;
  });
}

/** What was drawn since this was asked last, by the names of components. */
export async function drawn(pot: Visit): Promise<readonly string[]> {
  return await pot.page.evaluate(() => {
    const { pasuDrawn } = globalThis as unknown as Counting;
    const names = Object.keys(pasuDrawn);
    for (const name of names) delete pasuDrawn[name];
    return names;
  });
}
