import { createProgramInfo, type ProgramInfo } from "twgl.js";

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

/** Something with resources in the context. */
export interface Tenant {
  /** Gives up what it has on the GPU; it comes back from memory when it is next drawn. */
  release(): void;
}

/** Whoever wants to know that the context went or came back. */
export interface Watcher {
  lost?(): void;
  restored?(): void;
}

/** Where every program finds its attributes: one vertex array then serves whatever draws it. */
export const LOCATIONS = { position: 0, normal: 1, uv: 2, wares: 3, value: 4, start: 5, end: 6, middle: 7 } as const;

/** Textures are filled on a unit that no program reaches, so that filling one never takes another's place. */
const FILLING_UNIT = 15;

/** The device that everything on the page draws with, while anything does. */
let shared: Device | null = null;

/**
 * The page's one WebGL2 context: browsers allow few. Stages and makers of thumbnails share it, each as long as it wants, and with the last of them
 * it is given back. Nothing else may be asked of the context while it is lost.
 */
export class Device {
  /** What the context draws into; {@link Pane} brings it to the page. */
  readonly canvas = document.createElement("canvas");
  readonly gl: WebGL2RenderingContext;
  lost = false;
  private users = 0;
  private readonly listeners = new AbortController();
  private readonly tenants = new Set<Tenant>();
  private readonly watchers = new Set<Watcher>();
  private readonly programs = new Map<string, ProgramInfo>();
  private readonly singles = new Map<unknown, Tenant>();

  private constructor() {
    const gl = this.canvas.getContext("webgl2", { antialias: false });
    if (!gl) throw new Error("the browser gives no WebGL2 context");
    this.gl = gl;
    const { signal } = this.listeners;
    this.canvas.addEventListener(
      "webglcontextlost",
      (event) => {
        // Without this the browser never gives the context back.
        event.preventDefault();
        this.lost = true;
        // Now, because objects of a context that is gone can be deleted without complaint, and not once it is back.
        this.evict();
        for (const watcher of this.watchers) watcher.lost?.();
      },
      { signal },
    );
    this.canvas.addEventListener(
      "webglcontextrestored",
      () => {
        this.lost = false;
        for (const watcher of [...this.watchers]) watcher.restored?.();
      },
      { signal },
    );
  }

  /** @throws {Error} when there is no WebGL2 or the browser refuses another context */
  static share(): Device {
    shared ??= new Device();
    shared.users += 1;
    return shared;
  }

  /** Ends what {@link share} began. */
  leave(): void {
    this.users -= 1;
    if (this.users > 0) return;
    this.evict();
    this.tenants.clear();
    this.listeners.abort();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    if (shared === this) shared = null;
  }

  /** Tells when the context goes and when it is back. */
  watch(watcher: Watcher): () => void {
    this.watchers.add(watcher);
    return () => this.watchers.delete(watcher);
  }

  /**
   * Resolves when there is something to draw with: at once, but while the context is lost.
   *
   * @throws {Error} when it has not come back after so many milliseconds: some never do
   */
  whenThere(patience: number): Promise<void> {
    if (!this.lost) return Promise.resolve();
    return new Promise((resolve, reject) => {
      const end = (how: () => void) => () => {
        clearTimeout(timer);
        forget();
        how();
      };
      const forget = this.watch({ restored: end(resolve) });
      const timer = setTimeout(
        end(() => reject(new Error("the graphics context is lost"))),
        patience,
      );
    });
  }

  /** Tells a tenant when the context goes. */
  admit(tenant: Tenant): void {
    this.tenants.add(tenant);
  }

  /** Lets a tenant go, which gives up what it has here. */
  dismiss(tenant: Tenant): void {
    if (this.tenants.delete(tenant)) tenant.release();
  }

  /** The one thing of a kind that everybody shares who draws here. */
  one<T extends Tenant>(Kind: new (device: Device) => T): T {
    const found = (this.singles.get(Kind) as T | undefined) ?? new Kind(this);
    this.singles.set(Kind, found);
    this.admit(found);
    return found;
  }

  /**
   * The program of a pair of shaders, compiled when it is first asked for and kept as long as the context: there are a dozen of them.
   *
   * @throws {Error} when it is not a program
   */
  program(vertex: string, fragment: string): ProgramInfo {
    const key = vertex + fragment;
    const found = this.programs.get(key);
    if (found) return found;
    const { gl } = this;
    const made = createProgramInfo(gl, [vertex, fragment], {
      attribLocations: { ...LOCATIONS },
      errorCallback: (why: string) => {
        // Of a context that is lost nothing can be compiled, and nobody is to blame.
        if (!gl.isContextLost()) throw new Error(why);
      },
    });
    if (!made) throw new Error("the graphics context is lost");
    // What is attached stays until the program goes.
    for (const shader of gl.getAttachedShaders(made.program) ?? []) gl.deleteShader(shader);
    this.programs.set(key, made);
    return made;
  }

  /** Makes room to fill a texture. */
  beginFilling(): void {
    this.gl.activeTexture(this.gl.TEXTURE0 + FILLING_UNIT);
  }

  private evict(): void {
    for (const tenant of this.tenants) tenant.release();
    for (const { program } of this.programs.values()) this.gl.deleteProgram(program);
    this.programs.clear();
  }
}
