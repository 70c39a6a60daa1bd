/**
 * The stage of a component: fetched when it is wanted, given up when the component has left the page, and kept while it is only moved. Follows
 * what the browser says of motion.
 */

import type { ReactiveController, ReactiveControllerHost } from "lit";
import type { Stage, StageOptions } from "../render/stage";

/** Nothing to draw with yet, a stage, one whose context was taken away, one whose context did not come back in time, and a browser that has none. */
export type StageMode = "loading" | "live" | "lost" | "gone" | "still";

export interface StageNeeds {
  /** The element that the stage fills. */
  host(): HTMLElement;
  options(): Omit<StageOptions, "reducedMotion" | "onContextLost" | "onContextRestored">;
  /** How long a context that was taken away is waited for, in milliseconds; for ever when it is left out. */
  readonly patience?: number;
  /** The stage is there. */
  opened(): void;
  /** The stage is about to be given up. */
  closing(): void;
}

const REDUCED = "(prefers-reduced-motion: reduce)";
const DARK = "(prefers-color-scheme: dark)";

export class StageHolder implements ReactiveController {
  stage: Stage | null = null;
  mode: StageMode = "loading";
  readonly #element: ReactiveControllerHost & HTMLElement;
  readonly #needs: StageNeeds;
  readonly #reduced = matchMedia(REDUCED);
  readonly #dark = matchMedia(DARK);
  /** The stage that is being fetched: one that nobody waits for any more is not put up. */
  #opening: Promise<void> | null = null;
  #patience: ReturnType<typeof setTimeout> | undefined;
  /** Whether there was a stage before: then the browser is able to. */
  #again = false;

  constructor(element: ReactiveControllerHost & HTMLElement, needs: StageNeeds) {
    this.#element = element;
    this.#needs = needs;
    element.addController(this);
  }

  /** Whether the system is dark. */
  get dark(): boolean {
    return this.#dark.matches;
  }

  hostConnected(): void {
    this.#reduced.addEventListener("change", this.#mediaChanged);
    this.#dark.addEventListener("change", this.#mediaChanged);
  }

  hostDisconnected(): void {
    this.#reduced.removeEventListener("change", this.#mediaChanged);
    this.#dark.removeEventListener("change", this.#mediaChanged);
    // Whoever is only moved to another place is connected again by then, and the stage lives on.
    queueMicrotask(() => {
      if (!this.#element.isConnected) this.close();
    });
  }

  /** Fetches the stage and puts it up, unless it is there; then the mode is known. */
  open(): Promise<void> {
    if (this.stage || this.mode === "still") return Promise.resolve();
    this.#opening ??= this.#open();
    return this.#opening;
  }

  async #open(): Promise<void> {
    const fetched = await import("../render/stage").catch(() => null);
    const opening = this.#opening;
    if (!opening || this.stage) return;
    this.#opening = null;
    if (!fetched?.Stage.supported()) {
      this.#become("still");
      return;
    }
    try {
      this.stage = new fetched.Stage(this.#needs.host(), {
        ...this.#needs.options(),
        reducedMotion: this.#reduced.matches,
        onContextLost: () => this.#lose(),
        onContextRestored: () => {
          clearTimeout(this.#patience);
          this.#become("live");
        },
      });
    } catch {
      this.#become(this.#again ? "gone" : "still");
      return;
    }
    this.#become("live");
    this.#needs.opened();
  }

  /** Gives back what the stage holds of the graphics card. */
  close(): void {
    this.#opening = null;
    clearTimeout(this.#patience);
    this.#needs.closing();
    this.stage?.dispose();
    this.stage = null;
    this.#become("loading");
  }

  /** Gives up a context that does not come back, and asks for another one. */
  async retry(): Promise<void> {
    this.#again = true;
    this.close();
    await this.open();
  }

  #lose(): void {
    this.#become("lost");
    const { patience } = this.#needs;
    if (patience !== undefined) this.#patience = setTimeout(() => this.#become("gone"), patience);
  }

  #become(mode: StageMode): void {
    this.mode = mode;
    this.#element.requestUpdate();
  }

  readonly #mediaChanged = (): void => {
    this.stage?.reducedMotion(this.#reduced.matches);
    this.#element.requestUpdate();
  };
}
