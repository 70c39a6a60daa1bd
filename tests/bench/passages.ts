// A change on its way from the hand to the screen, seen from inside the page: where its milliseconds go.

import type { Visit } from "../support/visit.ts";

/** One change; times in milliseconds. */
export interface Passage {
  /** From the event to the question put to the worker: controls, document. */
  readonly input: number;
  /** From the page to the worker. */
  readonly there: number;
  /** The mesh, in the worker: what it takes, and the same for the coarse mesh of the glaze. */
  readonly mesh: number;
  readonly coarse: number;
  readonly coarseVertices: number;
  /** What the picture needs besides: glaze, bounds, words. */
  readonly glaze: number;
  /** The page's thread is not done with the controls when the answer is. */
  readonly busy: number;
  /** From the worker to the page, or from when its thread is free. */
  readonly back: number;
  /** From the answer to the stage: page, panels. */
  readonly page: number;
  /** Until the browser began the frame. */
  readonly frame: number;
  /** Vertices and glaze into the buffers of the GPU, until they are there. */
  readonly upload: number;
  /** The rest of the frame, until the GPU has drawn it. */
  readonly draw: number;
  /** From the event until the GPU has drawn the frame. */
  readonly whole: number;
}

/** What is put into the page to measure there. */
export interface Measuring {
  pasuTrace(
    moment: string,
    change: number,
    times?: { begun: number; meshed: number; glazed: number; done: number },
  ): void;
  /** The next change that is drawn. */
  pasuPassage(): Promise<Passage>;
}

/** Follows changes through the page; to be called before it opens. */
export async function watchPassages(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const now = () => performance.timeOrigin + performance.now();
    const moments = new Map<string, number>();
    let times = { begun: 0, meshed: 0, glazed: 0, done: 0 };
    let changed = 0;
    let event = 0;
    let upload = 0;
    let uploading = false;
    const after = new MessageChannel();
    after.port2.onmessage = ({ data }) => {
      if (data === changed) moments.set("free", now());
    };
    let resolve: ((passage: Passage) => void) | null = null;
    addEventListener(
      "pointermove",
      ({ timeStamp }) => {
        event = performance.timeOrigin + timeStamp;
      },
      { capture: true },
    );
    // Reading back waits until everything asked before is done.
    const finish = (gl: WebGL2RenderingContext) => {
      const before = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before);
    };
    const methods = WebGL2RenderingContext.prototype as unknown as Record<
      string,
      (this: WebGL2RenderingContext, ...parameters: unknown[]) => unknown
    >;
    for (const name of ["bufferSubData", "texSubImage2D"]) {
      const real = methods[name];
      methods[name] = function (...given) {
        if (!uploading || !real) return real?.apply(this, given);
        finish(this);
        const idle = now();
        finish(this);
        const began = now();
        real.apply(this, given);
        finish(this);
        // The trip to the GPU's process and back is not part of it.
        upload += Math.max(0, now() - began - (began - idle));
        if (!moments.has("frame")) moments.set("frame", idle);
        return undefined;
      };
    }
    const measuring = globalThis as unknown as Measuring;
    measuring.pasuTrace = (moment, change, given) => {
      if (moment === "asked") {
        changed = change;
        moments.clear();
        upload = 0;
        // The browser lays out and paints the controls in the task that told of the event: this comes after it.
        after.port1.postMessage(change);
      }
      if (change !== changed || moments.has(moment)) return;
      moments.set(moment, now());
      if (given) times = given;
      if (moment === "shown") uploading = true;
      if (moment !== "drawn") return;
      uploading = false;
      const stage = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-stage");
      const gl = stage?.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
      if (gl) finish(gl);
      const drawn = now();
      const { designer } = document.querySelector("pasu-app") as unknown as {
        designer: {
          surface: { shown: { solved: { parts: { mesh: { ware: { rows: number; columns: number } } }[] } } };
        };
      };
      const { rows, columns } = designer.surface.shown.solved.parts[0]?.mesh.ware ?? { rows: 0, columns: 0 };
      const at = (name: string) => moments.get(name) ?? Number.NaN;
      resolve?.({
        input: at("asked") - event,
        there: times.begun - at("asked"),
        mesh: times.meshed - times.begun,
        coarse: times.glazed - times.meshed,
        coarseVertices: rows * columns,
        glaze: times.done - times.glazed,
        busy: Math.max(0, (moments.get("free") ?? 0) - times.done),
        back: at("solved") - Math.max(times.done, moments.get("free") ?? 0),
        page: at("shown") - at("solved"),
        frame: at("frame") - at("shown"),
        upload,
        draw: drawn - at("frame") - upload,
        whole: drawn - event,
      });
      resolve = null;
    };
    measuring.pasuPassage = () =>
      new Promise((settle) => {
        resolve = settle;
      });
  });
}

/** The stage is drawn with this many vertices either way. */
export async function gridOf(pot: Visit, size: number): Promise<void> {
  await pot.page.evaluate((side) => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { surface: { grid: () => object } };
    };
    designer.surface.grid = () => ({ rows: side, columns: side });
  }, size);
}
