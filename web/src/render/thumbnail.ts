import { Camera } from "./camera";
import { GlContext } from "./context";
import type { StageLook } from "./glaze";
import type { StageMesh } from "./mesh";
import { drawPicture } from "./picture";
import { axesOf, fitDistance, VIEWS } from "./pose";
import { Tableau } from "./tableau";

/** Draws small pictures of pots into 2D canvases. */
export interface Thumbnails {
  /**
   * Draws a pot, fitted, on a transparent ground, at the canvas's own size in pixels.
   *
   * @throws {Error} when there is no graphics context to be had
   */
  draw(mesh: StageMesh, look: StageLook, canvas: HTMLCanvasElement): Promise<void>;
  dispose(): void;
}

/**
 * One maker of thumbnails for a whole gallery. It borrows the context of a stage when there is one, because browsers allow few, and opens
 * one of its own only otherwise.
 */
export function thumbnails(): Thumbnails {
  let own: GlContext | null = null;
  let tableau: Tableau | null = null;
  const camera = new Camera();
  let queue: Promise<unknown> = Promise.resolve();

  const drawNow = (mesh: StageMesh, look: StageLook, canvas: HTMLCanvasElement) => {
    let context = GlContext.any();
    if (!context) {
      own?.dispose();
      context = own = new GlContext(document.createElement("canvas"));
    }
    tableau ??= new Tableau("light");
    context.admit(tableau);
    tableau.cutOut = true;
    const parts = Math.max(1, mesh.groups.length / 3);
    tableau.show(mesh, new Array<StageLook>(parts).fill(look));
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
    tableau.prepare(context.renderer);
    tableau.light(camera, aspect);
    const picture = drawPicture(context.renderer, tableau.scene, camera.view, canvas.width, canvas.height, () => {});
    paper.drawImage(picture, 0, 0);
  };

  return {
    draw(mesh, look, canvas) {
      // One after the other, with a breath between two: a gallery must not hold up the page.
      const turn = queue.then(() => new Promise((resolve) => setTimeout(resolve, 0)));
      const done = turn.then(() => drawNow(mesh, look, canvas));
      queue = done.catch(() => {});
      return done;
    },
    dispose() {
      if (tableau) GlContext.dismiss(tableau);
      tableau = null;
      own?.dispose();
      own = null;
    },
  };
}
