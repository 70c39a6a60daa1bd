import type { Device } from "./device";
import { Smooth } from "./smooth";
import { clear } from "./target";

/**
 * Where the frames of one stage are seen. While there is one pane, the canvas of the context is in it and is drawn straight into; of several, each has a plain
 * canvas that its frames are copied to. So one stage costs no copy, and any number of them one context.
 */
export class Pane {
  private static readonly all = new Set<Pane>();
  readonly element = document.createElement("div");
  private paper: CanvasRenderingContext2D | null = null;

  /** @param changed what was drawn is gone: a frame has to be drawn anew */
  constructor(
    private readonly device: Device,
    private readonly changed: () => void,
  ) {
    Object.assign(this.element.style, { width: "100%", height: "100%" });
    Pane.all.add(this);
    Pane.arrange();
  }

  /** Draws a frame of so many device pixels. */
  draw(width: number, height: number, samples: number, paint: () => void): void {
    const { paper } = this;
    const { gl, canvas } = this.device;
    // What several share only grows: every change of its size costs all of its memory anew.
    const columns = paper ? Math.max(width, canvas.width) : width;
    const rows = paper ? Math.max(height, canvas.height) : height;
    if (canvas.width !== columns) canvas.width = columns;
    if (canvas.height !== rows) canvas.height = rows;
    const smooth = this.device.one(Smooth);
    if (samples > 0) smooth.begin(width, height, samples);
    else {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.viewport(0, 0, width, height);
      clear(gl);
    }
    paint();
    if (samples > 0) smooth.end();
    if (!paper) return;
    if (paper.canvas.width !== width) paper.canvas.width = width;
    if (paper.canvas.height !== height) paper.canvas.height = height;
    paper.drawImage(canvas, 0, rows - height, width, height, 0, 0, width, height);
  }

  dispose(): void {
    Pane.all.delete(this);
    this.element.remove();
    Pane.arrange();
  }

  private static arrange(): void {
    const alone = Pane.all.size === 1;
    for (const pane of Pane.all) pane.settle(alone);
  }

  /** Takes the canvas of the context, or one of its own. */
  private settle(alone: boolean): void {
    const settled = alone ? this.device.canvas.parentNode === this.element : this.paper !== null;
    if (settled) return;
    const canvas = alone ? this.device.canvas : document.createElement("canvas");
    Object.assign(canvas.style, { display: "block", width: "100%", height: "100%", outline: "none" });
    this.paper = alone ? null : canvas.getContext("2d", { alpha: false });
    this.element.replaceChildren(canvas);
    this.changed();
  }
}
