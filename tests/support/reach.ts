// What can be reached on the page: nothing hangs over an edge, and everything can be pressed where it is.

import type { Visit } from "./visit.ts";

/** The largest width or height that anything on the page needs beyond the window's. */
export async function overhang(pot: Visit): Promise<number> {
  return await pot.page.evaluate(() => {
    const { scrollWidth = 0, scrollHeight = 0 } = document.scrollingElement ?? {};
    return Math.max(scrollWidth - innerWidth, scrollHeight - innerHeight);
  });
}

/** Controls, or those inside what a selector says alone, that cannot be pressed: hidden behind something, outside the window or smaller than 24 pixels (WCAG 2.5.8). */
export async function unreachable(pot: Visit, inside?: string): Promise<string[]> {
  return await pot.page.evaluate(async (only) => {
    const controls: HTMLElement[] = [];
    const collect = (root: Document | ShadowRoot) => {
      for (const element of root.querySelectorAll<HTMLElement>("*")) {
        if (element.matches("button, input, select, summary, a[href], [role=tab], g[role=button]"))
          controls.push(element);
        if (element.shadowRoot) collect(element.shadowRoot);
      }
    };
    collect(document);
    const deepest = (x: number, y: number) => {
      let hit = document.elementFromPoint(x, y);
      for (let inner = hit; inner?.shadowRoot; hit = inner) {
        const next: Element | null = inner.shadowRoot.elementFromPoint(x, y);
        if (!next || next === inner) break;
        inner = next;
        hit = next;
      }
      return hit;
    };
    // What is behind an open dialogue is nobody's to press.
    const modal = controls.map((control) => control.closest("dialog[open]")).find((dialog) => dialog !== null) ?? null;
    const within = (outer: Element, inner: Element) => {
      for (let node: Node | null = inner; node; node = node instanceof ShadowRoot ? node.host : node.parentNode)
        if (node === outer) return true;
      return false;
    };
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    /** Where it is once it is in the middle and nothing moves it any more: what is measured comes when it is there, and pushes down what stands beneath. */
    const settled = async (pressed: Element) => {
      const moved = () => {
        pressed.scrollIntoView({ block: "center", inline: "nearest" });
        return pressed.getBoundingClientRect();
      };
      let [before, box] = [moved(), null as DOMRect | null];
      for (let n = 0; n < 60; n += 1) {
        await frame();
        box = moved();
        if (box.x === before.x && box.y === before.y && box.width === before.width && box.height === before.height)
          break;
        before = box;
      }
      return box ?? before;
    };
    /** What keeps a control from being pressed where it is. */
    const obstacles = (control: HTMLElement, pressed: Element, box: DOMRect) => {
      if (box.width === 0 || box.height === 0) return [];
      const found: string[] = [];
      const name = control.getAttribute("aria-label") ?? control.textContent?.trim() ?? control.tagName;
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      if (box.width < 24 || box.height < 24) found.push(`${name}: ${box.width} × ${box.height}`);
      const outside =
        box.left < -0.5 || box.right > innerWidth + 0.5 || box.top < -0.5 || box.bottom > innerHeight + 0.5;
      if (outside) found.push(`${name}: outside the window`);
      const hit = deepest(x, y);
      if (!hit || !(pressed.contains(hit) || hit.contains(pressed))) {
        found.push(`${name}: covered by ${hit?.tagName.toLowerCase() ?? "nothing"}.${hit?.className ?? ""}`);
      }
      return found;
    };
    const problems: string[] = [];
    const panel = document
      .querySelector("pasu-app")
      ?.shadowRoot?.querySelector("pasu-panel")
      ?.shadowRoot?.querySelector(".body");
    const aside = (panel?.scrollWidth ?? 0) - (panel?.clientWidth ?? 0);
    if (aside > 1) problems.push(`the panel is ${aside} pixels wider than there is room`);
    for (const control of controls) {
      const pressed = control.closest("label") ?? control;
      if (!pressed.checkVisibility({ visibilityProperty: true }) || control.matches(":disabled, .skip")) continue;
      if (modal && !within(modal, pressed)) continue;
      if (only && !control.closest(only)) continue;
      pressed.scrollIntoView({ block: "center", inline: "nearest" });
      // Most can be pressed at once; who cannot is looked at again when it rests.
      if (obstacles(control, pressed, pressed.getBoundingClientRect()).length === 0) continue;
      problems.push(...obstacles(control, pressed, await settled(pressed)));
    }
    if (!modal && !only && controls.length < 10) problems.push("there are hardly any controls");
    return problems;
  }, inside);
}
