/** What a person works with on a network: what is picked of it, and how a hand moves that. Fetched with the panel, and kept as long as the page is open. */

import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Doing, Touch, Way } from "../document/network/grasping";
import type { Axis } from "../document/network/moving";
import { type Network, sizeOf } from "../document/network/network";
import { NOTHING, type Picks, within } from "../document/network/selection";
import type { PartId } from "../state/part-ids";
import type { Designer } from "./designer";

export interface Settings {
  readonly motion: Doing;
  readonly way: Way;
  readonly touch: Touch;
  /** Whether what is picked is picked beside what is there, as with shift: a finger has none. */
  readonly several: boolean;
  readonly grid: boolean;
  /** In units of the document; null where nobody has said another one than the usual one of a network. */
  readonly step: number | null;
  /** Whether a point goes to another that it is dropped on. */
  readonly meet: boolean;
  readonly mirror: Axis | null;
  /** What 1 on a slider stands for, of parameters and of forces. */
  readonly magnification: number;
  readonly strength: number;
}

interface Picked {
  readonly of: Network;
  /** Another part may have the same patches. */
  readonly whose: PartId | undefined;
  readonly picks: Picks;
}

const USUAL: Settings = {
  motion: "move",
  way: "view",
  touch: "view",
  several: false,
  grid: false,
  step: null,
  meet: false,
  mirror: null,
  magnification: 2,
  strength: 100,
};

export class NetworkDesk {
  readonly #settings = signal(USUAL);
  readonly #picks = signal<Picked | null>(null);
  /** What was picked of networks that undo may bring back: a copy has the patches of what it was copied from. */
  readonly #kept = new WeakMap<Network["patches"], ReadonlyMap<PartId | undefined, Picks>>();
  readonly #whose: () => PartId | undefined;

  /** `whose` tells which part the networks are of. */
  constructor(whose: () => PartId | undefined) {
    this.#whose = whose;
  }

  get settings(): Settings {
    return this.#settings.value;
  }

  set(change: Partial<Settings>): void {
    this.#settings.value = { ...this.#settings.peek(), ...change };
  }

  /** What is picked of a network: the same as before where points were moved alone, and what was picked of it where undo brings back another. */
  picksOf(network: Network): Picks {
    const picked = this.#picks.value;
    const whose = this.#whose();
    if (picked && picked.whose === whose && (picked.of.patches === network.patches || alike(picked.of, network)))
      return within(network, picked.picks);
    return within(network, this.#kept.get(network.patches)?.get(whose) ?? NOTHING);
  }

  pick(network: Network, picks: Picks): void {
    const whose = this.#whose();
    this.#kept.set(network.patches, new Map([...(this.#kept.get(network.patches) ?? []), [whose, picks]]));
    this.#picks.value = { of: network, whose, picks };
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
  const known = desks.get(designer) ?? new NetworkDesk(() => designer.store.ids[designer.store.part]);
  desks.set(designer, known);
  return known;
}

/** The step of a grid of which some forty lie across a network, as large or as small as this is in its unit. */
export function stepOf({ step }: Settings, network: Network): number {
  return step ?? Number((sizeOf(network) / 20).toPrecision(1));
}

/** The selected network; null where the selected part is none. */
export function networkOf(designer: Designer): Network | null {
  const { design, part } = designer.store;
  const shape = design.parts[part]?.shape;
  return shape?.kind === "vertex-frame" ? shape : null;
}

const framed = new WeakMap<Designer, ReadonlySignal<Network | null>>();

/**
 * The selected network for whoever shows nothing of where its points are: while these alone are moved it is the one of before, so that nothing is drawn again that stays as it is.
 */
export function framedNetwork(designer: Designer): Network | null {
  const known = framed.get(designer) ?? keptWhileMoved(designer);
  framed.set(designer, known);
  return known.value;
}

function keptWhileMoved(designer: Designer): ReadonlySignal<Network | null> {
  let last: Network | null = null;
  return computed(() => {
    const now = networkOf(designer);
    const isSame =
      last &&
      now &&
      last.patches === now.patches &&
      last.vertices.length === now.vertices.length &&
      last.rule === now.rule &&
      last.crease === now.crease;
    if (!isSame) last = now;
    return last;
  });
}
