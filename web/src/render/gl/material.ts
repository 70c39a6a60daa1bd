import type { Texture } from "./texture";

/** A value that shaders read; who holds the object changes what it holds. */
export interface Uniform<T extends UniformValue = UniformValue> {
  value: T;
}

export type UniformValue = number | readonly number[] | Texture;

export type Uniforms = Readonly<Record<string, Uniform>>;

/** How a colour comes over those that are there: in their place, by its alpha, by its alpha with which it is multiplied already, or the larger of the two. */
export type Blending = "none" | "alpha" | "premultiplied" | "largest";

export interface MaterialOptions {
  readonly vertex: string;
  readonly fragment: string;
  /** Names that the shaders are told are defined. */
  readonly defines?: readonly string[];
  readonly uniforms: Uniforms;
  readonly blending?: Blending;
  /** Whether triangles are seen from behind too. */
  readonly bothSides?: boolean;
  /** Whether nearer things hide it. */
  readonly depthTest?: boolean;
  /** Whether it hides farther things. */
  readonly depthWrite?: boolean;
}

/** What things are drawn with: a pair of shaders, what they read, and how the colours come together. It holds nothing on the GPU. */
export class Material {
  readonly vertex: string;
  readonly fragment: string;
  readonly uniforms: Uniforms;
  readonly blending: Blending;
  readonly bothSides: boolean;
  readonly depthTest: boolean;
  readonly depthWrite: boolean;

  constructor({ vertex, fragment, defines = [], uniforms, ...options }: MaterialOptions) {
    const head = `#version 300 es\n${defines.map((name) => `#define ${name}\n`).join("")}`;
    this.vertex = head + vertex;
    this.fragment = head + fragment;
    this.uniforms = uniforms;
    this.blending = options.blending ?? "none";
    this.bothSides = options.bothSides ?? false;
    this.depthTest = options.depthTest ?? true;
    this.depthWrite = options.depthWrite ?? true;
  }
}
