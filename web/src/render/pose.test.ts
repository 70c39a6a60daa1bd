import { describe, expect, it } from "vitest";
import { axesOf, clipPlanes, eyeOf, FIELD_OF_VIEW, FIT_MARGIN_UPRIGHT, fitDistance, nearestTurn, VIEWS } from "./pose";
import { dot, type Triple } from "./triple";

const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

describe("the axes of the camera", () => {
  it("are orthonormal and right-handed for every direction, the poles included", () => {
    for (let azimuth = -7; azimuth < 7; azimuth += 0.61) {
      for (const polar of [0, 1e-9, 0.4, Math.PI / 2, 3, Math.PI]) {
        const { right, up, back } = axesOf(azimuth, polar);
        for (const axis of [right, up, back]) expect(dot(axis, axis)).toBeCloseTo(1, 12);
        for (const [i, x] of cross(right, up).entries()) expect(x).toBeCloseTo(back[i] as number, 12);
      }
    }
  });

  it("look from the front with x to the right and z up", () => {
    const { azimuth, polar } = VIEWS.front;
    const { right, up, back } = axesOf(azimuth, polar);
    for (const [axis, wanted] of [
      [right, [1, 0, 0]],
      [up, [0, 0, 1]],
      [back, [0, -1, 0]],
    ] as const) {
      for (const [i, x] of axis.entries()) expect(x).toBeCloseTo(wanted[i] as number, 12);
    }
  });

  it("put the eye at its distance", () => {
    const eye = eyeOf({ azimuth: 0, polar: Math.PI / 2, distance: 5, target: [1, 2, 3] });
    expect(eye[0]).toBeCloseTo(6);
    expect(eye[1]).toBeCloseTo(2);
    expect(eye[2]).toBeCloseTo(3);
  });
});

describe("the short way round", () => {
  it("is at most half a turn", () => {
    for (let angle = -20; angle < 20; angle += 0.7) {
      const near = nearestTurn(angle, 3);
      expect(Math.abs(near - 3)).toBeLessThanOrEqual(Math.PI + 1e-9);
      expect(Math.cos(near)).toBeCloseTo(Math.cos(angle), 9);
    }
  });
});

describe("the fitted distance", () => {
  const corners: number[] = [];
  for (const x of [-1, 1]) for (const y of [-1, 1]) for (const z of [0, 4]) corners.push(x, y, z);

  it("brings every point into the picture, and one near its edge", () => {
    for (const { azimuth, polar } of Object.values(VIEWS)) {
      for (const aspect of [0.4, 1, 2.5]) {
        const axes = axesOf(azimuth, polar);
        const target: Triple = [0, 0, 2];
        const distance = fitDistance(corners, target, axes, aspect);
        let widest = 0;
        for (let i = 0; i < corners.length; i += 3) {
          const p: Triple = [corners[i] as number, corners[i + 1] as number, (corners[i + 2] as number) - 2];
          const away = distance - dot(p, axes.back);
          expect(away).toBeGreaterThan(0);
          const y = Math.abs(dot(p, axes.up)) / away / Math.tan(FIELD_OF_VIEW / 2);
          const x = Math.abs(dot(p, axes.right)) / away / Math.tan(FIELD_OF_VIEW / 2) / aspect;
          widest = Math.max(widest, x, y);
        }
        expect(widest).toBeLessThan(1);
        expect(widest).toBeGreaterThan(0.76);
      }
    }
  });

  it("grows with the model and is 0 for nothing", () => {
    const axes = axesOf(0, 1);
    const small = fitDistance(corners, [0, 0, 2], axes, 1.5);
    const large = fitDistance(
      corners.map((x) => x * 1e6),
      [0, 0, 2e6],
      axes,
      1.5,
    );
    expect(large / small).toBeCloseTo(1e6, 3);
    expect(fitDistance([], [0, 0, 0], axes, 1.5)).toBe(0);
    const bare = fitDistance(corners, [0, 0, 2], axes, 1.5, false);
    expect(bare).toBeLessThan(small);
    expect(bare).toBeGreaterThan(0.7 * small);
  });
});

it("leaves as much free above and below as it is told", () => {
  const axes = axesOf(VIEWS.front.azimuth, VIEWS.front.polar);
  const upright = [0, 0, -1, 0, 0, 1];
  const near = fitDistance(upright, [0, 0, 0], axes, 1);
  expect(fitDistance(upright, [0, 0, 0], axes, 1, true, 2 * FIT_MARGIN_UPRIGHT)).toBeCloseTo(2 * near, 9);
  const across = [-1, 0, 0, 1, 0, 0];
  const wide = fitDistance(across, [0, 0, 0], axes, 1);
  expect(fitDistance(across, [0, 0, 0], axes, 1, true, 2 * FIT_MARGIN_UPRIGHT)).toBeCloseTo(wide, 9);
});

describe("the clip planes", () => {
  it("enclose the sphere and never reach the eye", () => {
    const far = clipPlanes([0, -10, 0], { centre: [0, 0, 0], radius: 2 });
    expect(far).toEqual({ near: 8, far: 12 });
    const inside = clipPlanes([0, 0, 0.1], { centre: [0, 0, 0], radius: 2 });
    expect(inside.near).toBeGreaterThan(0);
    expect(inside.far).toBeCloseTo(2.1);
  });
});
