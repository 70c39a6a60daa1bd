/** What a person works with on a network: what is picked of it, and how a hand moves that. Fetched with the panel, and kept as long as the page is open. */

import { signal } from "@preact/signals-core";
import type { Doing, Touch, Way } from "../document/network/grasping";
import type { Axis } from "../document/network/moving";
import type { Network } from "../document/network/network";
import { NOTHING, type Picks, within } from "../document/network/selection";
import type { Designer } from "./designer";

export interface Settings {
  readonly motion: Doing;
  readonly way: Way;
  readonly touch: Touch;
  /** Whether what is picked is picked beside what is there, as with shift: a finger has none. */
  readonly several: boolean;
  readonly grid: boolean;
  /** In units of the document. */
  readonly step: number;
  /** Whether a point goes to another that it is dropped on. */
  readonly meet: boolean;
  readonly mirror: Axis | null;
  /** What 1 on a slider stands for, of parameters and of forces. */
  readonly magnification: number;
  readonly strength: number;
}

const USUAL: Settings = {
  motion: "move",
  way: "view",
  touch: "view",
  several: false,
  grid: false,
  step: 0.5,
  meet: false,
  mirror: null,
  magnification: 2,
  strength: 100,
};

export class NetworkDesk {
  readonly #settings = signal(USUAL);
  readonly #picks = signal<{ readonly of: Network | null; readonly picks: Picks }>({ of: null, picks: NOTHING });
  /** What was picked of networks that undo may bring back. */
  readonly #kept = new WeakMap<Network["patches"], Picks>();

  get settings(): Settings {
    return this.#settings.value;
  }

  set(change: Partial<Settings>): void {
    this.#settings.value = { ...this.#settings.peek(), ...change };
  }

  /** What is picked of a network: the same as before where points were moved alone, and what was picked of it where undo brings back another. */
  picksOf(network: Network): Picks {
    const { of, picks } = this.#picks.value;
    if (of && (of.patches === network.patches || alike(of, network))) return within(network, picks);
    return within(network, this.#kept.get(network.patches) ?? NOTHING);
  }

  pick(network: Network, picks: Picks): void {
    this.#kept.set(network.patches, picks);
    this.#picks.value = { of: network, picks };
  }
}

/** Whether both have the same patches between the same points, however these stand and whatever pushes them. */
function alike(one: Network, other: Network): boolean {
  return (
    one.vertices.length === other.vertices.length &&
    one.patches.length === other.patches.length &&
    one.patches.every(({ frame }, patch) =>
      frame.every((vertex, place) => other.patches[patch]?.frame[place] === vertex),
    )
  );
}

const desks = new WeakMap<Designer, NetworkDesk>();

export function networkDesk(designer: Designer): NetworkDesk {
  const known = desks.get(designer) ?? new NetworkDesk();
  desks.set(designer, known);
  return known;
}
