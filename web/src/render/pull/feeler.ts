import type { Device, Tenant } from "../gl/device";
import { type Drawable, draw } from "../gl/drawable";
import { Material, type Uniform } from "../gl/material";
import { Target } from "../gl/target";
import type { View } from "../gl/view";
import { PLACING_GLSL } from "../placing";
import type { PotPart } from "../pot-part";
import type { Studio } from "../studio";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec2 uv;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
out vec3 vScene;
out vec2 vAt;
void main() {
  vScene = inFrame(position) + shift;
  vAt = uv;
  gl_Position = projectionMatrix * viewMatrix * vec4(vScene, 1.0);
}
`;

/** Two bytes for each: what is drawn is never nothing, because `u` begins at 1. */
const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
in vec2 vAt;
uniform vec4 cut;
out vec4 colour;
vec2 bytes(float whole) {
  float high = floor(whole / 256.0);
  return vec2(high, whole - 256.0 * high);
}
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  vec2 share = clamp(vAt, 0.0, 1.0);
  colour = vec4(bytes(1.0 + floor(65534.0 * share.x + 0.5)), bytes(floor(65535.0 * share.y + 0.5))) / 255.0;
}
`;

/** Says which point of a part's surface is under the hand: a picture of one pixel is drawn, whose colour is the point. */
export class Feeler implements Tenant {
  private readonly target = new Target(1, 1, { depth: true });
  private readonly pixel = new Uint8Array(4);
  private readonly cut: Uniform<readonly number[]> = { value: [0, 0, 0, 1] };
  private readonly material: Material;

  constructor(studio: Studio) {
    this.material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: { frame: studio.frame, cut: this.cut },
      bothSides: true,
    });
  }

  /** The point of the part there, `u` and `v` from 0 to 1, in a picture of so many pixels; null where it is not seen. */
  feel(
    device: Device,
    { drawable }: PotPart,
    cut: readonly number[],
    view: View,
    { x, y, of }: { readonly x: number; readonly y: number; readonly of: readonly [number, number] },
  ): readonly [u: number, v: number] | null {
    this.cut.value = cut;
    const { geometry, uniforms } = drawable;
    const alone: Drawable = {
      geometry,
      material: this.material,
      order: 0,
      visible: true,
      ...(uniforms && { uniforms }),
    };
    view.tile({ x, y, width: 1, height: 1, of });
    this.target.begin(device);
    draw(device, [alone], view);
    view.tile(null);
    this.target.readPixels(device, this.pixel);
    const [a = 0, b = 0, c = 0, d = 0] = this.pixel;
    const u = 256 * a + b;
    return u === 0 ? null : [(u - 1) / 65534, (256 * c + d) / 65535];
  }

  release(): void {
    this.target.release();
  }
}
