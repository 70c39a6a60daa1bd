import type { Device } from "./device";
import { Texture } from "./texture";

export interface TargetOptions {
  /** Samples of a pixel, for smooth edges; 0 for plain ones. */
  readonly samples?: number;
  /** Whether nearer things hide others. */
  readonly depth?: boolean;
  /** Whether what is read between pixels is blended. */
  readonly linear?: boolean;
}

interface Made {
  readonly gl: WebGL2RenderingContext;
  /** What is drawn into, and what is read: the same where there are no samples. */
  readonly drawn: WebGLFramebuffer;
  readonly read: WebGLFramebuffer;
  readonly renderbuffers: readonly WebGLRenderbuffer[];
}

/** A picture that is drawn on the GPU and stays there. */
export class Target {
  readonly texture: Texture;
  private made: Made | null = null;

  constructor(
    readonly width: number,
    readonly height: number,
    private readonly options: TargetOptions = {},
  ) {
    this.texture = new Texture({
      target: "TEXTURE_2D",
      allocate: (gl) => {
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
        const filter = options.linear ? gl.LINEAR : gl.NEAREST;
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
      },
    });
  }

  /** Everything is drawn into it from now on; it begins empty. */
  begin(device: Device): void {
    const { gl } = device;
    this.made ??= this.make(device);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.made.drawn);
    gl.viewport(0, 0, this.width, this.height);
    clear(gl);
  }

  /** Brings what was drawn to where it is read. */
  end({ gl }: Device): void {
    const { made, width, height, options } = this;
    if (!made || !options.samples) return;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, made.drawn);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, made.read);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    const gone = [gl.COLOR_ATTACHMENT0, ...(options.depth ? [gl.DEPTH_ATTACHMENT] : [])];
    gl.invalidateFramebuffer(gl.READ_FRAMEBUFFER, gone);
  }

  /** Reads all of it, rows from below: four bytes a pixel. */
  readPixels({ gl }: Device, into: Uint8Array): void {
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.made?.read ?? null);
    gl.readPixels(0, 0, this.width, this.height, gl.RGBA, gl.UNSIGNED_BYTE, into);
  }

  release(): void {
    this.texture.release();
    if (!this.made) return;
    const { gl, drawn, read, renderbuffers } = this.made;
    for (const framebuffer of new Set([drawn, read])) gl.deleteFramebuffer(framebuffer);
    for (const renderbuffer of renderbuffers) gl.deleteRenderbuffer(renderbuffer);
    this.made = null;
  }

  private make(device: Device): Made {
    const { gl } = device;
    const { samples = 0, depth = false } = this.options;
    const read = gl.createFramebuffer();
    const texture = this.texture.ready(device);
    gl.bindFramebuffer(gl.FRAMEBUFFER, read);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const renderbuffers: WebGLRenderbuffer[] = [];
    const attach = (attachment: number, format: number) => {
      const renderbuffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, this.width, this.height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, renderbuffer);
      renderbuffers.push(renderbuffer);
    };
    let drawn = read;
    if (samples > 0) {
      drawn = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, drawn);
      attach(gl.COLOR_ATTACHMENT0, gl.RGBA8);
    }
    if (depth) attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24);
    gl.bindRenderbuffer(gl.RENDERBUFFER, null);
    return { gl, drawn, read, renderbuffers };
  }
}

/** Nothing, infinitely far away. */
export function clear(gl: WebGL2RenderingContext): void {
  gl.depthMask(true);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
}
