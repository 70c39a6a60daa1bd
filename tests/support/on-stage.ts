// The stage behind the page, for tests of what it draws, and what travels to the graphics card meanwhile.

import type { JSHandle } from "playwright-core";
import type { Visit } from "./visit.ts";

/** What tests ask of a stage, as `web/src/render/stage.ts` has it. */
export interface StageBehind {
  readonly root: HTMLElement;
  show(model: { parts: readonly PartBehind[]; bounds: object | null }): readonly object[];
  pick(x: number, y: number): string | number | null;
  picture(width: number, height: number, options?: { transparent?: boolean }): Promise<Blob>;
  view(name: string): void;
  fit(): void;
  whenIdle(): Promise<void>;
  /** Curves that somebody points at. */
  readonly overlay: { readonly hinted: readonly Float32Array[] };
  dispose(): void;
}

export interface PartBehind {
  readonly id: string | number;
  readonly revision: number;
  readonly mesh: MeshBehind;
  readonly matrix: readonly number[];
  readonly look: { readonly glaze: string; readonly inside: string; readonly line: number; readonly clay: string };
  readonly span: readonly [low: number, high: number];
  readonly hidden?: boolean;
}

export interface MeshBehind {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
  readonly ware: { readonly texels: Float32Array; readonly rows: number; readonly columns: number };
}

export async function stageOf(pot: Visit): Promise<JSHandle<StageBehind>> {
  return await pot.page.evaluateHandle(() => {
    const view = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-stage");
    return (view as unknown as { stage: StageBehind }).stage;
  });
}

/** Counts from the first moment: bytes that travel to the GPU and in how many pieces, and WebGL contexts. To be called before the page opens. */
export async function countUploads(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const counted = { pieces: 0, bytes: 0, contexts: new Set<object>() };
    (globalThis as unknown as { pasuUploads: typeof counted }).pasuUploads = counted;
    type Method = (this: WebGL2RenderingContext, ...given: unknown[]) => unknown;
    const methods = WebGL2RenderingContext.prototype as unknown as Record<string, Method>;
    for (const name of ["bufferData", "bufferSubData", "texSubImage2D", "texSubImage3D", "texImage2D"]) {
      const real = methods[name] as Method;
      methods[name] = function (...given) {
        const data = given.find((each) => ArrayBuffer.isView(each)) as ArrayBufferView | undefined;
        counted.pieces += 1;
        counted.bytes += data?.byteLength ?? 0;
        return real.apply(this, given);
      };
    }
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
      const made = (getContext as (...given: unknown[]) => object | null).apply(this, given);
      if (made && given[0] === "webgl2") counted.contexts.add(made);
      return made;
    } as typeof getContext;
  });
}

/** What travelled since it was last asked. */
export async function uploads(pot: Visit): Promise<{ readonly pieces: number; readonly bytes: number }> {
  return await pot.page.evaluate(() => {
    const counted = (globalThis as unknown as { pasuUploads: { pieces: number; bytes: number } }).pasuUploads;
    const { pieces, bytes } = counted;
    counted.pieces = 0;
    counted.bytes = 0;
    return { pieces, bytes };
  });
}

/** How many contexts are in use: what was made and not lost. */
export async function contexts(pot: Visit): Promise<number> {
  return await pot.page.evaluate(() => {
    const { contexts: all } = (globalThis as unknown as { pasuUploads: { contexts: Set<WebGL2RenderingContext> } })
      .pasuUploads;
    return [...all].filter((gl) => !gl.isContextLost()).length;
  });
}
