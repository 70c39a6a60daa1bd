import { describe, expect, it } from "vitest";
import { Camera } from "./camera";
import type { CameraPose } from "./pose";

const home: CameraPose = { azimuth: 0, polar: 1, distance: 10, target: [0, 0, 0] };

function at(pose: Partial<CameraPose> = {}): Camera {
  const camera = new Camera();
  camera.radius = 1;
  camera.travel({ ...home, ...pose }, true);
  return camera;
}

function rest(camera: Camera): void {
  for (let i = 0; camera.step(1 / 60); i++) if (i > 1000) throw new Error("the camera does not come to rest");
}

describe("Camera", () => {
  it("travels to a pose by the short way and arrives exactly", () => {
    const camera = at({ azimuth: 3 });
    camera.travel({ ...home, azimuth: -3, target: [1, 2, 3] });
    expect(camera.moving).toBe(true);
    rest(camera);
    expect(camera.pose.azimuth).toBeCloseTo(2 * Math.PI - 3, 12);
    expect(camera.pose.target).toEqual([1, 2, 3]);
    expect(camera.moving).toBe(false);
  });

  it("does not move when motion is reduced: it is there", () => {
    const camera = at();
    camera.reducedMotion = true;
    camera.orbit(1, 0.2);
    expect(camera.moving).toBe(false);
    expect(camera.pose.azimuth).toBe(1);
  });

  it("never tips over the poles nor leaves the range of the zoom", () => {
    const camera = at();
    camera.orbit(0, 9);
    expect(camera.goal.polar).toBe(Math.PI);
    camera.orbit(0, -20);
    expect(camera.goal.polar).toBe(0);
    for (const factor of [1e9, 1e-9, 0, -1, Number.NaN, Number.POSITIVE_INFINITY]) {
      camera.zoom(factor);
      expect(camera.goal.distance).toBeGreaterThan(0.04);
      expect(camera.goal.distance).toBeLessThan(61);
    }
  });

  it("moves the picture by as many pixels as the pointer", () => {
    const camera = at({ azimuth: -Math.PI / 2, polar: Math.PI / 2 });
    camera.reducedMotion = true;
    camera.pan(100, 50, 600);
    camera.aim([0, 0, 0], 1, 1, { centre: [0, 0, 0], radius: 2 });
    const seen = camera.view.see([0, 0, 0]);
    expect(seen.before).toBe(true);
    expect(600 * (seen.x - 0.5)).toBeCloseTo(100, 4);
    expect(600 * (seen.y - 0.5)).toBeCloseTo(50, 4);
  });

  it("looks the same at every size of the model", () => {
    const pictures = [1e-3, 1, 1e6].map((size) => {
      const camera = new Camera();
      camera.radius = size;
      camera.travel({ ...home, distance: 10 * size, target: [size, 0, 0] }, true);
      camera.aim([size, 0, 0], size, 1.5, { centre: [0, 0, 0], radius: 1 });
      const { viewMatrix, projectionMatrix } = camera.view.uniforms;
      return [...viewMatrix.value, ...projectionMatrix.value];
    });
    for (const picture of pictures)
      for (const [i, x] of picture.entries()) expect(x).toBeCloseTo(pictures[1]?.[i] as number, 6);
  });
});
