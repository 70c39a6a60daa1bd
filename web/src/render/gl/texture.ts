import type { Device } from "./device";

/** How a texture is made: once, when it is first used. */
export interface TextureKind {
  readonly target: "TEXTURE_2D" | "TEXTURE_3D";
  /** Reserves its memory and says how it is read; the texture is bound. */
  allocate(gl: WebGL2RenderingContext): void;
  /** Writes into that memory, now and whenever {@link Texture.changed} says so. */
  fill?(gl: WebGL2RenderingContext): void;
}

/** A texture that comes to the GPU when it is first used. twgl's own would read pictures too and weigh as much as all else of it that is used here. */
export class Texture {
  private made: { readonly gl: WebGL2RenderingContext; readonly handle: WebGLTexture } | null = null;
  private stale = true;

  constructor(private readonly kind: TextureKind) {}

  /** What it is filled with is different. */
  changed(): void {
    this.stale = true;
  }

  ready(device: Device): WebGLTexture {
    if (this.made && !this.stale) return this.made.handle;
    const { gl } = device;
    const { kind } = this;
    const target = gl[kind.target];
    device.beginFilling();
    const fresh = this.made === null;
    this.made ??= { gl, handle: gl.createTexture() };
    gl.bindTexture(target, this.made.handle);
    if (fresh) kind.allocate(gl);
    kind.fill?.(gl);
    gl.bindTexture(target, null);
    this.stale = false;
    return this.made.handle;
  }

  release(): void {
    this.made?.gl.deleteTexture(this.made.handle);
    this.made = null;
    this.stale = true;
  }
}
