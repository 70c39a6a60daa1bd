import { describe, expect, it } from "vitest";
import { besideCover, type Cover, isClear } from "./cover";

const BAR = { left: 100, top: 12, right: 500, bottom: 52 };
const COVER: Cover = { width: 600, height: 400, boxes: [BAR] };

describe("what lies over a stage", () => {
  it("leaves clear what is on the stage and beside every box, by the room that a finger takes", () => {
    expect(isClear({ x: 300, y: 200 }, COVER)).toBe(true);
    expect(isClear({ x: 300, y: 73 }, COVER)).toBe(false);
    expect(isClear({ x: 300, y: 74 }, COVER)).toBe(true);
    expect(isClear({ x: 50, y: 30 }, COVER)).toBe(true);
    for (const [x, y] of [
      [21, 200],
      [579, 200],
      [300, -10],
      [300, 379],
    ] as const) {
      expect(isClear({ x, y }, COVER)).toBe(false);
    }
  });

  it("moves a handle no farther than it takes", () => {
    expect(besideCover({ x: 300, y: 200 }, [{ x: 0, y: 0 }], COVER)).toEqual({ x: 300, y: 200 });
    const moved = besideCover({ x: 300, y: -20 }, [{ x: 300, y: 300 }], COVER);
    expect(moved.x).toBe(300);
    expect(moved.y).toBeGreaterThanOrEqual(74);
    expect(moved.y).toBeLessThanOrEqual(78);
  });

  it("goes another way where all of the first is covered", () => {
    const moved = besideCover(
      { x: 300, y: 40 },
      [
        { x: 400, y: 40 },
        { x: 300, y: 300 },
      ],
      COVER,
    );
    expect(moved).toEqual({ x: 300, y: expect.closeTo(76, 0) });
  });

  it("leaves a handle where it belongs if no clear place is near", () => {
    const covered = { x: 200, y: 30 };
    expect(besideCover(covered, [{ x: 400, y: 30 }], COVER)).toBe(covered);
    expect(besideCover(covered, [covered], COVER)).toBe(covered);
    const off = { x: 300, y: -900 };
    expect(besideCover(off, [{ x: 300, y: 300 }], COVER)).toBe(off);
    expect(besideCover(covered, [{ x: 300, y: 300 }], { width: 10, height: 10, boxes: [] })).toBe(covered);
  });
});
