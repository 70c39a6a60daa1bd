import { expect, test } from "vitest";
import { Camera } from "../camera";
import type { Bench } from "../stage";
import { newStudio } from "../studio";
import { Probe, rayAt } from "./probe";

const SCREEN = [800, 600] as const;
const POSE = { azimuth: 0.7, polar: 1.1, distance: 9, target: [1, -2, 3] as const };

test("through a spot goes the ray whose points are seen there", () => {
  const camera = new Camera();
  camera.radius = 3;
  const [x, y, z] = POSE.target;
  camera.travel({ ...POSE, target: [x, y, z] }, true);
  camera.aim([0, 0, 0], 1, SCREEN[0] / SCREEN[1], { centre: [0, 0, 0], radius: 20 });
  for (const [px, py] of [
    [400, 300],
    [10, 20],
    [733, 551],
  ] as const) {
    const { origin, direction } = rayAt(camera.pose, SCREEN, px, py);
    expect(Math.hypot(...direction)).toBeCloseTo(1, 12);
    for (const far of [2, 9, 30]) {
      const seen = camera.view.see([
        origin[0] + far * direction[0],
        origin[1] + far * direction[1],
        origin[2] + far * direction[2],
      ]);
      expect(seen.before).toBe(true);
      expect(seen.x * SCREEN[0]).toBeCloseTo(px, 6);
      expect(seen.y * SCREEN[1]).toBeCloseTo(py, 6);
    }
  }
});

test("what lies before the plane of the cut is cut, in units of the model", () => {
  const studio = newStudio("light");
  // The middle of the frame is at (0, 0, 10), and its radius 2.
  studio.frame.value = [0, 0, 10, 0.5];
  let plane: readonly number[] = [0, 0, 0, 1];
  const parts: { cut: { value: readonly number[] } }[] = [];
  const probe = new Probe({ studio, pot: { parts }, cut: () => plane, aim: () => null } as unknown as Bench);
  expect(probe.isCut(0, [0, 0, 1e6])).toBe(false);
  plane = [0, 0, 1, 0.5];
  expect(probe.isCut(0, [0, 0, 11.1])).toBe(true);
  expect(probe.isCut(0, [0, 0, 10.9])).toBe(false);
  // Of several objects each is cut through its own middle.
  parts.push({ cut: { value: plane } }, { cut: { value: [0, 0, 1, 1] } });
  expect([0, 1].map((part) => probe.isCut(part, [0, 0, 11.1]))).toEqual([true, false]);
  expect(probe.ray(1, 1)).toBeNull();
});
