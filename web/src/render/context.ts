import { WebGLRenderer } from "three";

let webgl2: boolean | undefined;

/** Whether this browser can make a WebGL2 context; asked once. */
export function webgl2Supported(): boolean {
  if (webgl2 === undefined) {
    webgl2 = false;
    try {
      const context = document.createElement("canvas").getContext("webgl2");
      webgl2 = context !== null;
      // Browsers allow few contexts at a time: this one is given back at once.
      context?.getExtension("WEBGL_lose_context")?.loseContext();
    } catch {
      // A browser that throws here has no WebGL.
    }
  }
  return webgl2;
}

/** Renderers that are on a page, newest last: whoever needs one for a moment borrows it instead of opening another context. */
const living: GlContext[] = [];

/** Something with resources in a context. */
export interface Tenant {
  /** Gives up what it has on the GPU; it comes back from memory when it is next drawn. */
  release(): void;
}

/** One WebGL context with its renderer, and what happens when the browser takes it away. */
export class GlContext {
  readonly renderer: WebGLRenderer;
  lost = false;
  private readonly listeners = new AbortController();
  private readonly tenants = new Set<Tenant>();

  /** @throws {Error} when there is no WebGL2 or the browser refuses another context */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly events: { lost?(): void; restored?(): void } = {},
  ) {
    const { signal } = this.listeners;
    canvas.addEventListener(
      "webglcontextlost",
      (event) => {
        // Without this the browser never gives the context back.
        event.preventDefault();
        this.lost = true;
        // Now, because objects of a context that is gone can be deleted without complaint, and not once it is back.
        this.evict();
        this.events.lost?.();
      },
      { signal },
    );
    this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false });
    // After the renderer's own listener, which makes its state anew: the callback may draw.
    canvas.addEventListener(
      "webglcontextrestored",
      () => {
        this.lost = false;
        this.events.restored?.();
      },
      { signal },
    );
    this.renderer.autoClear = false;
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    living.push(this);
  }

  /** A living context to borrow, or null. */
  static any(): GlContext | null {
    return living.findLast((context) => !context.lost) ?? null;
  }

  /** Tells a tenant when the context goes. */
  admit(tenant: Tenant): void {
    this.tenants.add(tenant);
  }

  /** Forgets a tenant that moves out of every context. */
  static dismiss(tenant: Tenant): void {
    for (const context of living) context.tenants.delete(tenant);
    tenant.release();
  }

  private evict(): void {
    for (const tenant of this.tenants) tenant.release();
  }

  dispose(): void {
    this.evict();
    this.tenants.clear();
    const index = living.indexOf(this);
    if (index >= 0) living.splice(index, 1);
    this.listeners.abort();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
