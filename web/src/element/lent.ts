/** What a component has at work on the stage: taken once there is a stage, and given back when the component leaves the page or gets another stage. */

import type { ReactiveController, ReactiveControllerHost } from "lit";
import type { Bench, Stage, Tool } from "../render/stage";

interface Host extends ReactiveControllerHost {
  readonly stage: Stage | null;
  readonly isConnected: boolean;
}

export class Lent<T extends Tool> implements ReactiveController {
  readonly #host: Host;
  readonly #take: (bench: Bench) => T;
  readonly #taken: (tool: T) => void;
  #tool: T | null = null;
  #stage: Stage | null = null;
  #giveBack: (() => void) | null = null;

  /** `taken` is called with each tool before it is first used. */
  constructor(host: Host, take: (bench: Bench) => T, taken: (tool: T) => void = () => {}) {
    this.#host = host;
    this.#take = take;
    this.#taken = taken;
    host.addController(this);
  }

  /** Null while the component has no stage, or is not on the page. */
  get tool(): T | null {
    return this.#tool;
  }

  hostUpdate(): void {
    const { stage, isConnected } = this.#host;
    if (stage !== this.#stage) this.#leave();
    if (!stage || this.#tool || !isConnected) return;
    const { tool, giveBack } = stage.lend(this.#take);
    this.#stage = stage;
    this.#tool = tool;
    this.#giveBack = giveBack;
    this.#taken(tool);
  }

  hostDisconnected(): void {
    this.#leave();
  }

  #leave(): void {
    this.#giveBack?.();
    this.#giveBack = null;
    this.#tool = null;
    this.#stage = null;
  }
}
