import { expect, test } from "vitest";
import type { Shape, VertexFrame } from "../document/types";
import { type Moved, Receiver, Sender } from "./moved";

function network(count: number): VertexFrame {
  const vertices = Array.from({ length: count }, (_, index) => [index, 2 * index, -index] as [number, number, number]);
  return { kind: "vertex-frame", vertices, patches: [{ frame: [0, 1, 2, 3, 4, 5, 6, 7] }] };
}

const movedTo = (from: VertexFrame, vertex: number, x: number): VertexFrame => ({
  ...from,
  vertices: from.vertices.map((point, index) => (index === vertex ? [x, 0, 0] : point)),
});

/** As a message between two threads has it. */
const sent = (shape: Shape | Moved) => structuredClone(shape);

test("of a large network the points alone are sent that were moved, and the same network arrives", () => {
  const [sender, receiver] = [new Sender(), new Receiver()];
  const first = network(1000);
  expect(sender.pack(first)).toBe(first);
  expect(receiver.unpack(sent(first))).toEqual(first);
  const second = movedTo(first, 700, 9);
  const third = movedTo(movedTo(second, 700, 10), 3, 4);
  const one = sender.pack(second);
  expect(one).toEqual({ kind: "moved", vertices: Uint32Array.of(700), points: Float64Array.of(9, 0, 0) });
  const message = sent(one);
  expect(receiver.unpack(message)).toEqual(second);
  // A message is read again where the whole module had to be fetched for it.
  expect(receiver.unpack(message)).toEqual(second);
  const two = sender.pack(third);
  expect(two.kind).toBe("moved");
  expect(receiver.unpack(sent(two))).toEqual(third);
  // Back to the first, as undo does.
  expect(receiver.unpack(sent(sender.pack(first)))).toEqual(first);
});

test("a network of which nothing was moved is the very one of before, so that what was made of it serves the next movement", () => {
  const [sender, receiver] = [new Sender(), new Receiver()];
  const first = network(1000);
  const known = receiver.unpack(sent(sender.pack(first)));
  // As the whole design is sent once a hand has let go, and its parts with it.
  expect(receiver.unpack(sent(sender.pack(first)))).toBe(known);
  expect(receiver.unpack(sent(sender.pack({ ...first })))).toBe(known);
  expect(receiver.last).toBe(known);
});

test("what differs otherwise, is small, or has moved as a whole is sent as it is", () => {
  const sender = new Sender();
  const first = network(1000);
  sender.pack(first);
  const crease: VertexFrame = { ...first, crease: 1 };
  const frames: VertexFrame = { ...crease, patches: [...crease.patches] };
  const all: VertexFrame = { ...frames, vertices: frames.vertices.map(([x, y, z]) => [x, y, z + 1]) };
  const more: VertexFrame = { ...all, vertices: [...all.vertices, [0, 0, 0]] };
  for (const shape of [crease, frames, all, more]) expect(sender.pack(shape)).toBe(shape);
  const small = network(20);
  expect(sender.pack(small)).toBe(small);
  expect(sender.pack(movedTo(small, 2, 1)).kind).toBe("vertex-frame");
  // Small ones leave what both sides keep as it is.
  expect(sender.pack(movedTo(more, 2, 1)).kind).toBe("moved");
  sender.forget();
  expect(sender.pack(more)).toBe(more);
  expect(() => new Receiver().unpack(sent(sender.pack(movedTo(more, 1, 1))))).toThrow("never sent");
});
