/** What is looked for while a person goes on changing what is asked: not at every movement, and of many questions the last is answered. */

import type { ReactiveController, ReactiveControllerHost } from "lit";
import type { Outcome } from "../worker/port";

export class Seeking<T> implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  /** A question waits so long for a newer one, in milliseconds. */
  readonly #pause: number;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #asked: object | null = null;
  #found: Outcome<T> | null = null;

  constructor(host: ReactiveControllerHost, pause: number) {
    this.#host = host;
    this.#pause = pause;
    host.addController(this);
  }

  /** Whether something newer is being looked for. */
  get coming(): boolean {
    return this.#asked !== null;
  }

  /** What was found last, for whatever question. */
  get found(): Outcome<T> | null {
    return this.#found;
  }

  /** What was found, and is still what is asked for. */
  get ready(): T | null {
    return !this.coming && this.#found?.state === "done" ? this.#found.value : null;
  }

  /** Looks for something else. Null says that whoever finds it could not be fetched. */
  soon(seek: () => Promise<Outcome<T> | null>): void {
    clearTimeout(this.#timer);
    const asked = {};
    this.#asked = asked;
    this.#timer = setTimeout(() => void this.#seek(asked, seek), this.#pause);
    this.#host.requestUpdate();
  }

  /** There is nothing to be looked for. */
  forget(): void {
    clearTimeout(this.#timer);
    this.#asked = null;
    this.#found = null;
    this.#host.requestUpdate();
  }

  hostDisconnected(): void {
    clearTimeout(this.#timer);
    this.#asked = null;
  }

  async #seek(asked: object, seek: () => Promise<Outcome<T> | null>): Promise<void> {
    const found = await seek();
    if (this.#asked !== asked || found?.state === "superseded") return;
    this.#asked = null;
    this.#found = found;
    this.#host.requestUpdate();
  }
}
