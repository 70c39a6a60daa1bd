import { Camera } from "./camera";
import { Device } from "./gl/device";
import type { StageModel } from "./mesh";
import { drawPicture } from "./picture";
import { axesOf, fitDistance, VIEWS } from "./pose";
import { Tableau } from "./tableau";

/** So many milliseconds a lost context is waited for. */
const PATIENCE = 3000;

/** Draws small pictures of pots into 2D canvases. */
export interface Thumbnails {
  /**
   * Draws a pot, fitted, on a transparent ground, at the canvas's own size in pixels.
   *
   * @throws {Error} when there is no graphics context to be had
   */
  draw(model: StageModel, canvas: HTMLCanvasElement): Promise<void>;
  dispose(): void;
}

/** One maker of thumbnails for a whole gallery. */
export function thumbnails(): Thumbnails {
  let device: Device | null = null;
  let tableau: Tableau | null = null;
  const camera = new Camera();
  let disposed = false;
  let queue: Promise<unknown> = Promise.resolve();

  const drawNow = async (model: StageModel, canvas: HTMLCanvasElement) => {
    if (disposed) return;
    device ??= Device.share();
    await device.whenThere(PATIENCE);
    if (disposed) return;
    tableau ??= new Tableau("light");
    device.admit(tableau);
    tableau.cutOut = true;
    tableau.show(model);
    const bounds = tableau.bounds;
    const paper = canvas.getContext("2d");
    if (!paper) throw new Error("the canvas of a thumbnail must have a 2D context");
    paper.clearRect(0, 0, canvas.width, canvas.height);
    if (!bounds) return;
    const radius = bounds.radius > 0 ? bounds.radius : 1;
    tableau.reframe({ centre: bounds.centre, radius });
    const aspect = canvas.width / canvas.height;
    const direction = VIEWS["three-quarter"];
    const distance = fitDistance(tableau.outline(), bounds.centre, axesOf(direction.azimuth, direction.polar), aspect);
    camera.radius = radius;
    camera.travel({ ...direction, distance: distance > 0 ? distance : radius, target: bounds.centre }, true);
    tableau.prepare(device);
    tableau.shade(device);
    tableau.light(camera, aspect);
    const picture = drawPicture(device, tableau.scene.drawables, camera.view, canvas.width, canvas.height, () => {});
    paper.drawImage(picture, 0, 0);
  };

  return {
    draw(model, canvas) {
      // One after the other, with a breath between two: a gallery must not hold up the page.
      const turn = queue.then(() => new Promise((resolve) => setTimeout(resolve, 0)));
      const done = turn.then(() => drawNow(model, canvas));
      queue = done.catch(() => {});
      return done;
    },
    dispose() {
      if (disposed) return;
      disposed = true;
      if (tableau) device?.dismiss(tableau);
      device?.leave();
    },
  };
}
