import { Material, type Uniform } from "../gl/material";
import { PLACING_GLSL } from "../placing";
import type { Studio } from "../studio";

/** A map on the pot: values of its vertices, and the colours (sRGB, 0 to 255) that stand for the range from `low` to `high`. */
export interface StageMap {
  readonly values: Float32Array;
  /** The same of the vertices of the solid's faces, NaN where there is none; null while they are not known. */
  readonly lining: Float32Array | null;
  readonly low: number;
  readonly high: number;
  readonly ramp: readonly (readonly [number, number, number])[];
  /** Whether the values are how far faces lean, in degrees. Then every face has its own, by its normal: the inside and what the wall adds too. */
  readonly lean: boolean;
}

/** As many colours as every ramp has. */
const STOPS = 5;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec3 normal;
in float value;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
out vec3 vScene;
out vec3 vNormal;
out float vValue;
void main() {
  vScene = inFrame(position);
  vNormal = turned * normal;
  vValue = value;
  gl_Position = projectionMatrix * viewMatrix * vec4(vScene, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
in vec3 vNormal;
in float vValue;
uniform vec3 eye;
uniform vec3 ramp[${STOPS}];
uniform vec2 range;
uniform float known;
uniform vec4 cut;
uniform float core;
uniform float lean;
uniform float table;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  vec3 paint = vec3(0.72, 0.7, 0.67);
  if (core != 0.0 && gl_FrontFacing == (core > 0.0)) {
    colour = vec4(paint * 0.8, 1.0);
    return;
  }
  vec3 n = normalize(vNormal + vec3(0.0, 0.0, 1e-12));
  if (!gl_FrontFacing) n = -n;
  float value = lean > 0.5 ? degrees(asin(clamp(-n.z, -1.0, 1.0))) : vValue;
  // What lies on the table hangs over nothing.
  bool stands = lean > 0.5 && vScene.z < table + 1e-4 && n.z < -0.999;
  if (known > 0.5 && !isnan(value) && !stands) {
    float t = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) * ${STOPS - 1}.0;
    int i = int(min(t, ${STOPS - 2}.0));
    paint = mix(ramp[i], ramp[i + 1], t - float(i));
  }
  // Enough shade to see the shape by, little enough to tell the colours.
  vec3 toEye = normalize(eye - vScene);
  float facing = clamp(dot(n, toEye), 0.0, 1.0);
  float above = 0.5 + 0.5 * n.z;
  colour = vec4(paint * (0.66 + 0.26 * facing + 0.1 * above), 1.0);
}
`;

/** The material of a map; without values, plain grey. `core` is as in a glaze that is cut open. */
export function mapCoat(
  studio: Studio,
  map: Pick<StageMap, "low" | "high" | "ramp" | "lean"> | null,
  cut: Uniform,
  core: number,
): Material {
  const ramp = Array.from({ length: STOPS }, (_, i) => (map?.ramp[i] ?? [0, 0, 0]).map((channel) => channel / 255));
  return new Material({
    vertex: VERTEX,
    fragment: FRAGMENT,
    bothSides: true,
    uniforms: {
      frame: studio.frame,
      eye: studio.eye,
      ramp: { value: ramp.flat() },
      range: { value: [map?.low ?? 0, map?.high ?? 1] },
      known: { value: map ? 1 : 0 },
      cut,
      core: { value: core },
      lean: { value: map?.lean ? 1 : 0 },
      table: studio.table,
    },
  });
}
