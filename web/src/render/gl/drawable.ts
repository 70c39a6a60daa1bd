import type { ProgramInfo } from "twgl.js";
import type { Device } from "./device";
import type { Geometry } from "./geometry";
import type { Material, Uniforms } from "./material";
import { Texture } from "./texture";
import type { View } from "./view";

/** One draw call; whoever made it changes it. */
export interface Drawable {
  geometry: Geometry;
  material: Material;
  /** What the shaders read of this thing alone. */
  readonly uniforms?: Uniforms;
  /** Things of a lower order are drawn before. */
  readonly order: number;
  visible: boolean;
  /** The indices or vertices that are drawn; all of them when it is left out. */
  range?: readonly [first: number, count: number];
  /** How often it is drawn, where it is drawn by instances. */
  instances?: number;
  /** Whether its triangles are turned inside out, as in a mirror. */
  mirrored?: boolean;
}

/** Draws things in this order into what was begun. */
export function draw(device: Device, drawables: Iterable<Drawable>, view: View | null = null): void {
  const { gl } = device;
  let material: Material | null = null;
  let program: ProgramInfo | null = null;
  for (const thing of drawables) {
    if (!thing.visible || thing.instances === 0) continue;
    if (material !== thing.material || !program) {
      material = thing.material;
      const next = device.program(material.vertex, material.fragment);
      if (next !== program) gl.useProgram(next.program);
      program = next;
      if (view) set(device, program, view.uniforms);
      set(device, program, material.uniforms);
      behave(gl, material);
    }
    if (thing.uniforms) set(device, program, thing.uniforms);
    gl.frontFace(thing.mirrored ? gl.CW : gl.CCW);
    thing.geometry.bind(device);
    call(gl, thing);
  }
  gl.bindVertexArray(null);
}

function set(device: Device, { uniformSetters }: ProgramInfo, uniforms: Uniforms): void {
  for (const name in uniforms) {
    const value = uniforms[name]?.value;
    const setter = uniformSetters[name];
    if (setter && value !== undefined) setter(value instanceof Texture ? value.ready(device) : value);
  }
}

function behave(gl: WebGL2RenderingContext, material: Material): void {
  const toggle = (capability: number, on: boolean) => (on ? gl.enable(capability) : gl.disable(capability));
  toggle(gl.CULL_FACE, !material.bothSides);
  toggle(gl.DEPTH_TEST, material.depthTest);
  gl.depthFunc(gl.LEQUAL);
  gl.depthMask(material.depthWrite);
  toggle(gl.BLEND, material.blending !== "none");
  gl.blendEquation(material.blending === "largest" ? gl.MAX : gl.FUNC_ADD);
  if (material.blending === "alpha") {
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  } else gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
}

function call(gl: WebGL2RenderingContext, { geometry, range, instances }: Drawable): void {
  const [first, count] = range ?? [0, geometry.count];
  if (geometry.index) gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
  else if (instances !== undefined) gl.drawArraysInstanced(gl.TRIANGLES, first, count, instances);
  else gl.drawArrays(gl.TRIANGLES, first, count);
}
