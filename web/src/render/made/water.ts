import { Buffer } from "../gl/buffer";
import type { Tenant } from "../gl/device";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import { Material, type Uniform } from "../gl/material";
import { STUDIO_GLSL, type Studio, TONE_GLSL } from "../studio";
import type { Triple } from "../triple";
import { ponds } from "./ponds";

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

/** The middle of an object, and the plane before which it is cut away. */
interface Opened {
  readonly middle: Triple;
  readonly cut: Uniform<readonly number[]>;
}

/** The surface of the water, on the GPU. */
export class Water implements Tenant {
  /** All of it, or that of each object. */
  drawables: readonly Drawable[];
  private readonly all: Drawable;
  /** Of which objects they are. */
  private parted = "";
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
    this.all = { geometry: this.geometry, material, order: 5, visible: false };
    this.drawables = [this.all];
  }

  set surface(water: StageWater | null) {
    this.all.visible = water !== null && water.indices.length > 0;
    this.drawables = [this.all];
    this.parted = "";
    if (!water) {
      this.release();
      return;
    }
    this.positions.array = water.positions;
    this.indices.array = water.indices;
  }

  /** What stands in an object is cut before the plane of that. */
  part(objects: readonly Opened[]): void {
    const parted = objects.map(({ middle }) => middle.join()).join(";");
    if (parted === this.parted || !this.all.visible) return;
    this.parted = parted;
    if (objects.length === 0) {
      this.drawables = [this.all];
      return;
    }
    const { ranges, indices } = ponds(this.positions.array, this.indices.array as Uint32Array);
    this.indices.array = indices;
    this.drawables = ranges.map(({ at, range }) => {
      const [first] = [...objects].sort((a, b) => apart(a.middle, at) - apart(b.middle, at));
      return { ...this.all, range, ...(first && { uniforms: { cut: first.cut } }) };
    });
  }

  release(): void {
    this.geometry.release();
    this.positions.release();
    this.indices.release();
  }
}

function apart([x, y]: Triple, [a, b]: readonly [number, number]): number {
  return Math.hypot(x - a, y - b);
}
