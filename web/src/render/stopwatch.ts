import type { Tenant } from "./gl/device";

/** How often a fence is looked at, in milliseconds; browsers hold timers to no less. */
const LOOK = 4;

/** What takes longer, in milliseconds, is given up: the page is hidden, or the GPU does something else. */
export const LONGEST = 1000;

/**
 * How long a frame takes until the GPU is done with it, which the thread that asks for it does not notice: a fence is put
 * behind the frame and looked at from time to time. One at a time; frames in between are not measured.
 */
export class Stopwatch implements Tenant {
  private fence: WebGLSync | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly gl: WebGL2RenderingContext) {}

  /** Measures what was given to the GPU up to now, from a time of `performance.now()`, if nothing is being measured; says whether it does. */
  measure(since: number, tell: (milliseconds: number) => void): boolean {
    const { gl } = this;
    if (this.fence) return false;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return false;
    this.fence = fence;
    gl.flush();
    const look = () => {
      const taken = performance.now() - since;
      const passed = gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
      if (!passed && taken < LONGEST) {
        this.timer = setTimeout(look, LOOK);
        return;
      }
      gl.deleteSync(fence);
      this.fence = null;
      if (passed) tell(taken);
    };
    this.timer = setTimeout(look, 0);
    return true;
  }

  /** Forgets the frame that is being measured. */
  release(): void {
    clearTimeout(this.timer);
    if (this.fence) this.gl.deleteSync(this.fence);
    this.fence = null;
  }
}
