import { Buffer } from "../gl/buffer";
import type { Tenant } from "../gl/device";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import { Material, type Uniform } from "../gl/material";
import { STUDIO_GLSL, type Studio, TONE_GLSL } from "../studio";

/** The level surface of the water in a pot, model units. */
export interface StageWater {
  readonly level: number;
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
}

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec4 frame;
out vec3 vScene;
void main() {
  vScene = (position - frame.xyz) * frame.w;
  gl_Position = projectionMatrix * viewMatrix * vec4(vScene, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
uniform vec3 eye;
uniform vec4 cut;
out vec4 colour;
${STUDIO_GLSL}
${TONE_GLSL}
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  vec3 toEye = normalize(eye - vScene);
  vec3 n = vec3(0.0, 0.0, toEye.z < 0.0 ? -1.0 : 1.0);
  float grazing = 1.0 - abs(toEye.z);
  float fresnel = 0.02 + 0.98 * grazing * grazing * grazing * grazing * grazing;
  vec3 mirrored = radiance(studioDirection(reflect(-toEye, n)), 0.03);
  // Clear water shows by what it mirrors; a tint says that it is there where it mirrors nothing.
  float cover = 0.34 + 0.5 * fresnel;
  vec3 light = mix(vec3(0.06, 0.2, 0.26), mirrored, min(1.0, 0.08 + fresnel));
  colour = vec4(toScreen(light) * cover, cover);
}
`;

/** The surface of the water, on the GPU. */
export class Water implements Tenant {
  readonly drawable: Drawable;
  private readonly positions = new Buffer(new Float32Array(), { size: 3 });
  private readonly indices = new Buffer(new Uint32Array(), { size: 1 });
  private readonly geometry = new Geometry({ position: this.positions }, this.indices);

  constructor(studio: Studio, cut: Uniform) {
    const material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: {
        frame: studio.frame,
        eye: studio.eye,
        turn: studio.turn,
        lean: studio.lean,
        ceiling: studio.ceiling,
        wall: studio.wall,
        floor_: studio.floor,
        cut,
      },
      bothSides: true,
      depthWrite: false,
      blending: "premultiplied",
    });
    this.drawable = { geometry: this.geometry, material, order: 5, visible: false };
  }

  set surface(water: StageWater | null) {
    this.drawable.visible = water !== null && water.indices.length > 0;
    if (!water) {
      this.release();
      return;
    }
    this.positions.array = water.positions;
    this.indices.array = water.indices;
  }

  release(): void {
    this.geometry.release();
    this.positions.release();
    this.indices.release();
  }
}
