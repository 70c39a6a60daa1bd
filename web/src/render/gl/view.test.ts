import { describe, expect, it } from "vitest";
import type { Triple } from "../triple";
import { View } from "./view";

/** From five before a scene, upright, as wide as two of its heights. */
function ahead(): View {
  const view = new View();
  view.look([0, -5, 0], [1, 0, 0], [0, 0, 1], [0, -1, 0]);
  view.focus(1, 2, 1, 10);
  return view;
}

describe("View", () => {
  it("sees what it looks at in the middle, and knows what is behind it", () => {
    const view = ahead();
    expect(view.see([0, 0, 0])).toEqual({ x: 0.5, y: 0.5, before: true });
    expect(view.see([0, -6, 0]).before).toBe(false);
    const edge = 5 * Math.tan(0.5);
    expect(view.see([0, 0, edge]).y).toBeCloseTo(0, 12);
    expect(view.see([2 * edge, 0, 0]).x).toBeCloseTo(1, 12);
  });

  it("draws tiles that fit together", () => {
    const whole = ahead();
    const tile = ahead();
    const of = [40, 20] as const;
    for (const point of [
      [1, 0, 0.5],
      [-2, 1, -1.5],
      [0.3, -2, 0],
    ] as const satisfies readonly Triple[]) {
      const { x, y } = whole.see(point);
      for (const [left, top] of [
        [0, 0],
        [10, 5],
        [30, 15],
      ] as const) {
        tile.tile({ x: left, y: top, width: 10, height: 5, of });
        const part = tile.see(point);
        expect((left + 10 * part.x) / of[0]).toBeCloseTo(x, 12);
        expect((top + 5 * part.y) / of[1]).toBeCloseTo(y, 12);
      }
    }
    tile.tile(null);
    expect(tile.uniforms.projectionMatrix.value).toEqual(whole.uniforms.projectionMatrix.value);
  });
});
