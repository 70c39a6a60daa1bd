import type { Device, Tenant } from "./gl/device";
import { type Drawable, draw } from "./gl/drawable";
import type { Geometry } from "./gl/geometry";
import { Material, type Uniform, type Uniforms } from "./gl/material";
import { Target } from "./gl/target";
import type { View } from "./gl/view";
import { PLACING_GLSL } from "./placing";
import type { Studio } from "./studio";

/** Triangles of a part, by its place among the others. */
export interface Face {
  readonly geometry: Geometry;
  readonly uniforms: Uniforms;
  readonly range?: readonly [first: number, count: number];
  readonly part: number;
}

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
out vec3 vScene;
void main() {
  vScene = inFrame(position) + shift;
  gl_Position = projectionMatrix * viewMatrix * vec4(vScene, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
uniform vec4 cut;
uniform vec3 number;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  colour = vec4(number / 255.0, 1.0);
}
`;

/** Says which part is seen at a point: every part is drawn in a colour that is its number, into a picture of that one pixel. */
export class Picker implements Tenant {
  private readonly target = new Target(1, 1, { depth: true });
  private readonly pixel = new Uint8Array(4);
  private readonly cut: Uniform<readonly number[]> = { value: [0, 0, 0, 1] };

  constructor(private readonly studio: Studio) {}

  /** The place of the part that is seen there, in a picture of so many pixels; null where there is none. */
  pick(
    device: Device,
    faces: readonly Face[],
    cut: readonly number[] | null,
    view: View,
    { x, y, of }: { readonly x: number; readonly y: number; readonly of: readonly [number, number] },
  ): number | null {
    this.cut.value = cut ?? [0, 0, 0, 1];
    const material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: { frame: this.studio.frame, cut: this.cut },
      bothSides: true,
    });
    const numbered = faces.map(({ geometry, uniforms, range, part }): Drawable => {
      const number = part + 1;
      const colour = { value: [number & 255, (number >> 8) & 255, number >> 16] };
      const all = { ...uniforms, number: colour };
      return { geometry, material, uniforms: all, order: 0, visible: true, ...(range && { range }) };
    });
    view.tile({ x, y, width: 1, height: 1, of });
    this.target.begin(device);
    draw(device, numbered, view);
    view.tile(null);
    this.target.readPixels(device, this.pixel);
    const [red = 0, green = 0, blue = 0] = this.pixel;
    const number = red + 256 * green + 65536 * blue;
    return number === 0 ? null : number - 1;
  }

  release(): void {
    this.target.release();
  }
}
