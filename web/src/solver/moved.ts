/**
 * Networks on their way to the worker. Of thousands of patches most stay as they are while a hand moves a point, and copying all of them would take the page's thread longer than a frame: of a network
 * that differs from the one before by where points are, these points alone are sent. Both sides keep the network that was sent last, and messages keep their order.
 */

import type { Shape, VertexFrame } from "../document/types";

/** The network that was sent last, with these points elsewhere. */
export interface Moved {
  readonly kind: "moved";
  readonly vertices: Uint32Array;
  /** Three numbers for each. */
  readonly points: Float64Array;
}

/** A network of fewer points is sent as it is. */
const FEW = 500;

/** Whether it is a network of which a hand moves only some. */
export function isLarge(shape: Shape): shape is VertexFrame {
  return shape.kind === "vertex-frame" && shape.vertices.length >= FEW;
}

/** So is one of which more than this share was moved. */
const MOST = 0.25;

export class Sender {
  #last: VertexFrame | null = null;

  /** What to send for a shape that is to be solved. */
  pack(shape: Shape): Shape | Moved {
    if (!isLarge(shape)) return shape;
    const last = this.#last;
    this.#last = shape;
    return (last && difference(last, shape)) ?? shape;
  }

  /** Another worker knows nothing yet. */
  forget(): void {
    this.#last = null;
  }
}

export class Receiver {
  #last: VertexFrame | null = null;

  /** The network that was sent last. */
  get last(): VertexFrame | null {
    return this.#last;
  }

  /** The shape that was meant. Reading a message once more changes nothing. */
  unpack(sent: Shape | Moved): Shape {
    if (sent.kind !== "moved") {
      if (isLarge(sent)) this.#last = sent;
      return sent;
    }
    const last = this.#last;
    if (!last) throw new Error("points were moved of a network that was never sent");
    // The very network: what was made of it still holds.
    if (sent.vertices.length === 0) return last;
    const vertices = [...last.vertices];
    for (const [index, vertex] of sent.vertices.entries()) {
      const [x = 0, y = 0, z = 0] = sent.points.subarray(3 * index, 3 * index + 3);
      vertices[vertex] = [x, y, z];
    }
    this.#last = { ...last, vertices };
    return this.#last;
  }
}

/** The points that are elsewhere; null where anything else differs, or too many do. */
function difference(from: VertexFrame, to: VertexFrame): Moved | null {
  const { vertices: before, ...others } = from;
  const { vertices: after, ...same } = to;
  if (before.length !== after.length || !alike(others, same)) return null;
  const moved: number[] = [];
  for (let vertex = 0; vertex < after.length; vertex += 1) if (before[vertex] !== after[vertex]) moved.push(vertex);
  if (moved.length > MOST * after.length) return null;
  const points = Float64Array.from(moved.flatMap((vertex) => after[vertex] ?? []));
  return { kind: "moved", vertices: Uint32Array.from(moved), points };
}

/** Whether all fields are the very same. */
function alike(one: object, other: object): boolean {
  const [a, b] = [one, other] as [Record<string, unknown>, Record<string, unknown>];
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name]);
}
