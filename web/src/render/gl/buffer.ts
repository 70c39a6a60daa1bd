import type { Device } from "./device";

/** What a buffer holds. */
export type Numbers = Float32Array | Uint32Array;

export interface BufferOptions {
  /** Numbers of a vertex; 1 for an index. */
  readonly size: number;
  /** Whether it is written over again and again. */
  readonly dynamic?: boolean;
  /** Whether every instance has its own, in the place of every vertex. */
  readonly instanced?: boolean;
}

/**
 * An array and its copy on the GPU. It is the owner's very array that goes there, when the buffer is first used and when the array was exchanged; into the
 * memory that is there, while the length stays the same. It stays here too: from it the buffer comes back after the context was lost.
 */
export class Buffer {
  private made: { readonly gl: WebGL2RenderingContext; readonly handle: WebGLBuffer } | null = null;
  private length = -1;
  private stale = true;
  /** Of values that are otherwise there, those that were written over: pairs of the first and how many. */
  private written: Uint32Array[] = [];

  constructor(
    private values: Numbers,
    readonly options: BufferOptions,
  ) {}

  get array(): Numbers {
    return this.values;
  }

  set array(values: Numbers) {
    this.values = values;
    this.stale = true;
  }

  /** Values of these vertices were written over in the owner's array: pairs of the first and how many. */
  wrote(ranges: Uint32Array): void {
    if (this.stale) return;
    this.written.push(ranges);
    // What nobody looks at is not drawn meanwhile.
    if (this.written.length > MOST_WRITTEN) this.stale = true;
  }

  /** How many vertices, instances or indices it has. */
  get count(): number {
    return this.values.length / this.options.size;
  }

  /** The buffer, filled. Leaves no vertex array bound when something had to be done. */
  ready({ gl }: Device): WebGLBuffer {
    if (this.made && !this.stale && this.written.length === 0) return this.made.handle;
    const { values, written, options } = this;
    const target = values instanceof Uint32Array ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
    // Indices would be bound to whatever vertex array is.
    gl.bindVertexArray(null);
    this.made ??= { gl, handle: gl.createBuffer() };
    const { handle } = this.made;
    gl.bindBuffer(target, handle);
    if (this.made && !this.stale) {
      for (const ranges of written) {
        for (const [first, end] of together(ranges)) {
          const from = options.size * first;
          gl.bufferSubData(target, from * values.BYTES_PER_ELEMENT, values, from, options.size * end - from);
        }
      }
    } else if (this.length === values.byteLength) gl.bufferSubData(target, 0, values);
    else gl.bufferData(target, values, options.dynamic ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW);
    this.length = values.byteLength;
    this.stale = false;
    this.written = [];
    return handle;
  }

  release(): void {
    this.made?.gl.deleteBuffer(this.made.handle);
    this.made = null;
    this.length = -1;
    this.stale = true;
  }
}

/** Who was written over more often since it was drawn is sent as a whole. */
const MOST_WRITTEN = 64;

/** To send so many vertices takes no longer than another call. */
const GAP = 1500;

/** Ranges, of which those that lie close together are one: what is between them is there already, and the same. */
function together(ranges: Uint32Array): readonly (readonly [first: number, end: number])[] {
  const all: [number, number][] = [];
  for (let pair = 0; pair < ranges.length; pair += 2) {
    const [first, count] = [ranges[pair] ?? 0, ranges[pair + 1] ?? 0];
    const last = all.at(-1);
    if (last && first - last[1] <= GAP) last[1] = first + count;
    else all.push([first, first + count]);
  }
  return all;
}
