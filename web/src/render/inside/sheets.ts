import { Buffer } from "../gl/buffer";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import { Material, type Uniform } from "../gl/material";
import { PLACING_GLSL } from "../placing";
import type { Bench, Tool } from "../stage";

const STOPS = 5;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in float value;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
out vec3 vScene;
out float vValue;
void main() {
  vScene = inFrame(position);
  vValue = value;
  gl_Position = projectionMatrix * viewMatrix * vec4(vScene + shift, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
in float vValue;
uniform vec3 eye;
uniform vec3 ramp[${STOPS}];
uniform vec2 range;
uniform vec4 cut;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  vec3 paint = vec3(0.72, 0.7, 0.67);
  if (!isnan(vValue)) {
    float t = clamp((vValue - range.x) / (range.y - range.x), 0.0, 1.0) * ${STOPS - 1}.0;
    int i = int(min(t, ${STOPS - 2}.0));
    paint = mix(ramp[i], ramp[i + 1], t - float(i));
  }
  // Sheets have no side of their own: the one that is seen faces the eye. A bit that is seen on edge has no normal.
  vec3 across = cross(dFdx(vScene), dFdy(vScene));
  float size = length(across);
  vec3 n = size > 0.0 ? across / size : vec3(0.0, 0.0, 1.0);
  vec3 toEye = normalize(eye - vScene);
  if (dot(n, toEye) < 0.0) n = -n;
  float facing = clamp(dot(n, toEye), 0.0, 1.0);
  colour = vec4(paint * (0.6 + 0.3 * facing + 0.12 * (0.5 + 0.5 * n.z)), 1.0);
}
`;

/** What is seen within a part: triangles with a value at every vertex, and the colours (sRGB, 0 to 255) that stand for the range from `low` to `high`. */
export interface StageInside {
  /** The place of the part among the others. */
  readonly place: number;
  readonly positions: Float32Array;
  readonly values: Float32Array;
  readonly indices: Uint32Array;
  readonly low: number;
  readonly high: number;
  readonly ramp: readonly (readonly [number, number, number])[];
}

/** Draws what is seen within a part, where that part stands. It is in pictures too: it stands in the place of the part. */
export class InsideSheets implements Tool {
  private shown: StageInside | null = null;
  private readonly positions = new Buffer(new Float32Array(), { size: 3, dynamic: true });
  private readonly values = new Buffer(new Float32Array(), { size: 1, dynamic: true });
  private readonly indices = new Buffer(new Uint32Array(), { size: 1, dynamic: true });
  private readonly geometry = new Geometry({ position: this.positions, value: this.values }, this.indices);
  private readonly ramp: Uniform<readonly number[]> = { value: new Array<number>(3 * STOPS).fill(0) };
  private readonly range: Uniform<readonly number[]> = { value: [0, 1] };
  private readonly cut: Uniform<readonly number[]> = { value: [0, 0, 0, 1] };
  private readonly material: Material;

  constructor(private readonly bench: Bench) {
    const { ramp, range, cut } = this;
    const { frame, eye } = bench.studio;
    this.material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      bothSides: true,
      uniforms: { frame, eye, ramp, range, cut },
    });
  }

  get visible(): boolean {
    return true;
  }

  set visible(_: boolean) {
    // A picture of the stage shows what stands on it.
  }

  get drawables(): readonly Drawable[] {
    const { shown, geometry, material, bench } = this;
    const part = shown && bench.pot.parts[shown.place];
    if (!part) return [];
    this.cut.value = bench.cut();
    const { uniforms } = part.drawable;
    return [{ geometry, material, order: 0, visible: true, ...(uniforms && { uniforms }) }];
  }

  show(shown: StageInside | null): void {
    this.shown = shown;
    if (shown) {
      this.positions.array = shown.positions;
      this.values.array = shown.values;
      this.indices.array = shown.indices;
      this.range.value = [shown.low, shown.high];
      this.ramp.value = shown.ramp.flatMap((rgb) => rgb.map((channel) => channel / 255));
    }
    this.bench.changed();
  }

  prepare(): void {}

  release(): void {
    this.geometry.release();
    for (const buffer of [this.positions, this.values, this.indices]) buffer.release();
  }
}
