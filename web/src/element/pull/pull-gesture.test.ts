import { expect, test } from "vitest";
import { PullGesture } from "./pull-gesture";

/** Events of a pointer as far as they are looked at, and what was heard of them. */
function bench(onPot = true, between = false) {
  const heard: unknown[][] = [];
  const hear =
    (name: string) =>
    (...given: unknown[]) =>
      void heard.push([name, ...given]);
  const gesture = new PullGesture({
    take: (at, adds) => {
      heard.push(["take", at, ...(adds ? ["adds"] : [])]);
      return onPot;
    },
    pull: (by, modifier, otherwise) => heard.push(["pull", by, modifier, ...(otherwise ? ["otherwise"] : [])]),
    pinch: (one, other) => {
      heard.push(["pinch", one, other]);
      return between;
    },
    squeeze: hear("squeeze"),
    release: hear("release"),
    cancel: hear("cancel"),
    hover: hear("hover"),
    turn: hear("turn"),
    pan: hear("pan"),
    zoom: hear("zoom"),
    widen: hear("widen"),
  });
  const event = (x: number, y: number, more: object = {}) =>
    ({
      clientX: x,
      clientY: y,
      pointerId: 1,
      button: 0,
      pointerType: "mouse",
      type: "pointerup",
      ...more,
    }) as PointerEvent;
  const wheel = (deltaY: number, more: object = {}) =>
    gesture.wheel({ deltaY, deltaX: 0, deltaMode: 0, preventDefault: () => {}, ...more } as WheelEvent);
  const names = () => heard.map(([name]) => name);
  return { gesture, heard, event, wheel, names };
}

test("the first button on the pot pulls from where it took hold, by the way of the keys that are held", () => {
  const { gesture, heard, event } = bench();
  gesture.down(event(10, 10));
  gesture.move(event(12, 10));
  gesture.move(event(30, 5));
  gesture.move(event(30, 5, { shiftKey: true }));
  gesture.move(event(30, 5, { altKey: true }));
  gesture.move(event(30, 5, { ctrlKey: true }));
  expect(gesture.pulling).toBe(true);
  gesture.up(event(30, 5));
  expect(heard).toEqual([
    ["take", { x: 10, y: 10 }],
    ["pull", { x: 20, y: -5 }, null],
    ["pull", { x: 20, y: -5 }, "up"],
    ["pull", { x: 20, y: -5 }, "round"],
    ["pull", { x: 20, y: -5 }, null, "otherwise"],
    ["release"],
  ]);
});

test("a hand that hardly moves pulls nothing, and one that moved may come back", () => {
  const { gesture, names, event } = bench();
  gesture.down(event(10, 10));
  gesture.move(event(12, 11));
  gesture.up(event(12, 11));
  expect(names()).toEqual(["take", "release"]);
  gesture.down(event(10, 10));
  gesture.move(event(20, 10));
  gesture.move(event(10, 10));
  expect(names().slice(2)).toEqual(["take", "pull", "pull"]);
});

test("beside the pot it turns, with shift it moves; so do the other buttons on the pot", () => {
  const beside = bench(false);
  beside.gesture.down(beside.event(10, 10));
  beside.gesture.move(beside.event(15, 12));
  beside.gesture.up(beside.event(15, 12));
  beside.gesture.down(beside.event(10, 10, { shiftKey: true }));
  beside.gesture.move(beside.event(15, 12));
  expect(beside.heard.filter(([name]) => name !== "take")).toEqual([
    ["turn", 5, 2],
    ["pan", 5, 2],
  ]);
  const on = bench();
  on.gesture.down(on.event(10, 10, { button: 2 }));
  on.gesture.move(on.event(15, 12));
  on.gesture.up(on.event(15, 12));
  on.gesture.down(on.event(10, 10, { button: 1 }));
  on.gesture.move(on.event(15, 12));
  expect(on.heard).toEqual([
    ["turn", 5, 2],
    ["pan", 5, 2],
  ]);
});

test("a second finger takes back the pull, and both turn and pinch until they are gone", () => {
  const { gesture, names, heard, event } = bench();
  const finger = (id: number, x: number, y: number) => event(x, y, { pointerId: id, pointerType: "touch" });
  gesture.down(finger(1, 100, 100));
  gesture.move(finger(1, 110, 100));
  gesture.down(finger(2, 210, 100));
  expect(names()).toEqual(["take", "pull", "cancel", "pinch"]);
  gesture.move(finger(2, 310, 100));
  expect(heard.slice(4)).toEqual([
    ["turn", 50, 0],
    ["zoom", 2],
  ]);
  gesture.up(finger(1, 110, 100));
  gesture.move(finger(2, 300, 100));
  expect(heard.at(-1)).toEqual(["turn", -10, 0]);
  gesture.up(finger(2, 300, 100));
  expect(gesture.pulling).toBe(false);
  expect(names()).not.toContain("release");
});

test("two fingers that hold the pot squeeze it by half of what they come nearer, and whichever goes first lets go", () => {
  const { gesture, heard, names, event } = bench(true, true);
  const finger = (id: number, x: number, y: number, more = {}) =>
    event(x, y, { pointerId: id, pointerType: "touch", ...more });
  gesture.down(finger(1, 100, 100));
  gesture.down(finger(2, 200, 110));
  expect(heard.slice(1)).toEqual([["cancel"], ["pinch", { x: 100, y: 100 }, { x: 200, y: 110 }]]);
  expect(gesture.pulling).toBe(true);
  // One that hardly moves squeezes nothing, and up or down does not.
  gesture.move(finger(2, 198, 150));
  expect(names()).toHaveLength(3);
  gesture.move(finger(2, 180, 110));
  gesture.move(finger(1, 90, 100));
  gesture.up(finger(1, 90, 100));
  gesture.move(finger(2, 150, 110));
  gesture.up(finger(2, 150, 110));
  expect(heard.slice(3)).toEqual([["squeeze", -10], ["squeeze", -5], ["release"]]);
  gesture.down(finger(1, 100, 100));
  gesture.down(finger(2, 200, 100));
  gesture.up(finger(2, 200, 100, { type: "pointercancel" }));
  expect(names().at(-1)).toBe("cancel");
});

test("only what holds nothing hovers, and no finger does", () => {
  const { gesture, heard, event } = bench();
  gesture.move(event(5, 6));
  gesture.move(event(5, 6, { pointerType: "touch" }));
  gesture.leave();
  expect(heard).toEqual([
    ["hover", { x: 5, y: 6 }],
    ["hover", null],
  ]);
});

test("the wheel zooms, with shift or alt or under the hand it widens", () => {
  const { gesture, heard, event, wheel } = bench();
  wheel(-100);
  wheel(-100, { shiftKey: true });
  wheel(0, { deltaX: 100, shiftKey: true });
  wheel(3, { deltaMode: 1, altKey: true });
  gesture.down(event(1, 1));
  wheel(-50);
  expect(heard[0]?.[0]).toBe("zoom");
  expect(heard[0]?.[1]).toBeGreaterThan(1);
  expect(heard.slice(1).filter(([name]) => name === "widen")).toEqual([
    ["widen", 1],
    ["widen", -1],
    ["widen", -0.48],
    ["widen", 0.5],
  ]);
});

test("a pointer that the browser takes away was not meant", () => {
  const { gesture, names, event } = bench();
  gesture.down(event(1, 1));
  gesture.move(event(20, 1));
  gesture.up(event(20, 1, { type: "pointercancel" }));
  expect(names().at(-1)).toBe("cancel");
});
