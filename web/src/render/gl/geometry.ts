import type { Buffer } from "./buffer";
import { type Device, LOCATIONS } from "./device";

export type Attributes = { readonly [name in keyof typeof LOCATIONS]?: Buffer };

/** Buffers as a program reads them. The buffers belong to whoever made them, and several geometries may have the same. */
export class Geometry {
  private made: { readonly gl: WebGL2RenderingContext; readonly handle: WebGLVertexArrayObject } | null = null;
  /** The buffers that the vertex array was made of. */
  private of: WebGLBuffer[] = [];
  private readonly buffers: readonly Buffer[];

  constructor(
    readonly attributes: Attributes,
    readonly index: Buffer | null = null,
  ) {
    this.buffers = [...Object.values(attributes), ...(index ? [index] : [])];
  }

  /** How many indices or vertices one instance is drawn of. */
  get count(): number {
    return this.index?.count ?? this.attributes.position?.count ?? 0;
  }

  /** Binds everything, and brings to the GPU what is not there yet. */
  bind(device: Device): void {
    const { gl } = device;
    let same = this.made !== null;
    for (const [i, buffer] of this.buffers.entries()) {
      const handle = buffer.ready(device);
      same &&= this.of[i] === handle;
      this.of[i] = handle;
    }
    if (!same) this.assemble(device);
    gl.bindVertexArray(this.made?.handle ?? null);
  }

  release(): void {
    this.made?.gl.deleteVertexArray(this.made.handle);
    this.made = null;
    this.of = [];
  }

  private assemble(device: Device): void {
    const { gl } = device;
    this.made ??= { gl, handle: gl.createVertexArray() };
    gl.bindVertexArray(this.made.handle);
    for (const [name, buffer] of Object.entries(this.attributes)) {
      const location = LOCATIONS[name as keyof Attributes];
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer.ready(device));
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, buffer.options.size, gl.FLOAT, false, 0, 0);
      gl.vertexAttribDivisor(location, buffer.options.instanced ? 1 : 0);
    }
    if (this.index) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.index.ready(device));
  }
}
