/** The base of what is only read while a hand moves something on the stage: it draws itself again ten times a second at most then, between two pictures, and not with every movement. */

import { effect } from "@preact/signals-core";
import type { Store } from "../state/store";
import { DesignerElement } from "./designer-element";

/** Between two drawings under the hand, in milliseconds: digits that change faster are read by nobody. */
export const BETWEEN = 100;

/** So much longer at most while a slow page has nothing but the picture to draw. */
export const BUSY = 150;

export class Unhurried {
  #last = Number.NEGATIVE_INFINITY;
  #held = false;

  /** Comes when it is time to draw: at once at rest, under the hand a while after it began or after the drawing before, and there as soon as the hand has let go and the picture of that is drawn. */
  async turn(store: Pick<Store, "inGesture">): Promise<void> {
    // What a hand does first is seen before it is told.
    if (store.inGesture && !this.#held) this.#last = performance.now();
    this.#held = store.inGesture;
    const left = this.#last + BETWEEN - performance.now();
    if (left > 0 && store.inGesture) await restOr(store, left);
    if (store.inGesture) await idleOr(BUSY);
    this.#last = performance.now();
  }
}

async function restOr(store: Pick<Store, "inGesture">, most: number): Promise<void> {
  let leave = () => {};
  await new Promise<void>((resolve) => {
    const timer = setTimeout(resolve, most);
    leave = effect(() => {
      if (store.inGesture) return;
      clearTimeout(timer);
      // What the hand did last is seen before it is told, too.
      requestAnimationFrame(() => setTimeout(resolve));
    });
  });
  leave();
}

/** When the page has nothing else to do, or at once in a browser that does not say when that is. */
async function idleOr(timeout: number): Promise<void> {
  const { requestIdleCallback } = globalThis;
  if (requestIdleCallback) await new Promise<unknown>((resolve) => requestIdleCallback(resolve, { timeout }));
}

export abstract class UnhurriedElement extends DesignerElement {
  readonly #unhurried = new Unhurried();

  protected override async scheduleUpdate(): Promise<void> {
    // What somebody types into, or steps with keys, goes on from what it shows.
    // What is fetched late is given the designer with its first drawing.
    if (this.hasUpdated && !this.shadowRoot?.activeElement) await this.#unhurried.turn(this.designer.store);
    super.scheduleUpdate();
  }
}
