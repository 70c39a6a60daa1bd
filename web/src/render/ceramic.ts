import { clayOf } from "./clay";
import { Material, type Uniforms } from "./gl/material";
import { type Glaze, glazeOf, type StageLook } from "./glaze";
import { PLACING_GLSL } from "./placing";
import { STUDIO_GLSL, type Studio, TONE_GLSL } from "./studio";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec3 normal;
#ifdef SOLID
in vec4 wares;
out float vLining;
#else
in vec2 uv;  // u, v / span
#endif
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
uniform highp sampler2D ware;
uniform vec2 span;        // from which height to which the part stands, in model units
uniform float line;       // where the glaze of the outside ends, as a share of that
out float vLine;          // how far above that this is
out vec3 vObject;
out vec3 vScene;
out vec3 vNormal;
out vec4 vWare;

#ifndef SOLID
// Between the samples by hand: not every GPU filters textures of floats.
vec4 wareAt(vec2 where) {
  ivec2 last = textureSize(ware, 0) - 1;
  vec2 p = where.yx * vec2(last);
  ivec2 a = min(ivec2(p), last);
  ivec2 b = min(a + 1, last);
  vec2 f = p - vec2(a);
  vec4 near = mix(texelFetch(ware, a, 0), texelFetch(ware, ivec2(b.x, a.y), 0), f.x);
  vec4 far = mix(texelFetch(ware, ivec2(a.x, b.y), 0), texelFetch(ware, b, 0), f.x);
  return mix(near, far, f.y);
}
#endif

void main() {
#ifdef SOLID
  vLining = wares.x;
  vWare = vec4(0.0, wares.yz * frame.w, wares.w);
#else
  vec4 wares = wareAt(uv);
  vWare = vec4(wares.x / frame.w, wares.yz * frame.w, wares.w);
#endif
  vObject = inFrame(position);
  vScene = vObject + shift;
  vNormal = turned * normal;
  float ends = (mix(span.x, span.y, line) - frame.z) * frame.w;
  // Glazed to the foot, bare to the rim and over it, or something between.
  vLine = line <= 0.0 ? 1e9 : line >= 1.0 ? -1e9 : vObject.z - ends;
  gl_Position = projectionMatrix * viewMatrix * vec4(vScene, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
precision highp sampler3D;
in vec3 vObject;
in vec3 vScene;
in vec3 vNormal;
in vec4 vWare;
in float vLine;
uniform vec3 eye;
uniform float table;
uniform sampler3D noise;
uniform vec3 clayColour;
uniform vec3 grainColour;
uniform vec2 clay;        // grog, roughness
// Of the outside and of the inside.
uniform vec3 tintLogs[2]; // log2 of what a layer lets through
uniform vec3 bodies[2];
uniform vec3 edgeColours[2];
uniform vec4 layers[2];   // opacity, breaking, mottle, streak
uniform vec3 surfaces[2]; // speckle, roughness, coat
#ifdef SOLID
in float vLining;
uniform float level;      // of the water, in scene space
#endif
#ifdef CUT
uniform vec4 cut;         // the plane before which everything is taken away
uniform float core;       // which side of the surface is within the clay: -1 its back, 1 its front, 0 neither
#endif
out vec4 colour;
${STUDIO_GLSL}
${TONE_GLSL}

// Smooth between cells: without it the creases of linear interpolation show in reflections.
vec4 cells(vec3 p) {
  vec3 i = floor(p);
  vec3 f = p - i;
  return texture(noise, (i + f * f * (3.0 - 2.0 * f) + 0.5) / 32.0);
}

// Turned, so that no plane of a pot lies along the block's own: on the level underside its cells would show as a maze.
const mat3 TURNED = mat3(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);

void main() {
#ifdef CUT
  if (dot(vScene, cut.xyz) > cut.w) discard;
  // What is seen through the cut of the inner side of a closed surface stands for the cut itself.
  if (core != 0.0 && gl_FrontFacing == (core > 0.0)) {
    colour = vec4(toScreen(mix(clayColour, vec3(0.5), 0.25)), 1.0);
    return;
  }
#endif
  vec3 toEye = normalize(eye - vScene);
  vec3 n = normalize(vNormal + vec3(0.0, 0.0, 1e-12));
  if (!gl_FrontFacing) n = -n;
#ifdef SOLID
  bool inside = vLining > 0.5;
#else
  bool inside = !gl_FrontFacing;
#endif
  int side = inside ? 1 : 0;
  vec3 tintLog = tintLogs[side];
  vec3 body = bodies[side];
  vec3 edgeColour = edgeColours[side];
  vec4 layer = layers[side];
  vec3 surface = surfaces[side];
  // A sliver of the far wall shows along a silhouette: it must not look like the depth of the pot.
  float within = inside ? smoothstep(0.02, 0.2, dot(n, toEye)) : 0.0;

  vec4 broad = cells(vObject * 4.3) - 0.5;
  vec4 fine = cells(vObject * vec3(17.0, 17.0, mix(17.0, 2.2, layer.w))) - 0.5;
  vec4 grit = cells(TURNED * vObject * 71.0) - 0.5;

  // Thickness of the glaze: 1 on a plain wall, less over edges, more in hollows, bare at the foot.
  float bulge = inside ? -vWare.x : vWare.x;
  float bend = clamp(0.06 * (bulge - 0.6), -0.7, 0.75);
  float rim = exp(-max(0.0, vWare.y) / 0.02);
  float wander = 0.5 * broad.x + 0.25 * fine.y;
  float footLine = vWare.z - 0.034 - 0.016 * wander;
  // It ends at a line, which is as level as the hand that dips the pot.
  if (!inside) footLine = min(footLine, vLine - 0.012 * wander);
  float bead = exp(-max(0.0, footLine) / 0.03);
  float thick = 1.0 - bend - 0.8 * rim + 0.3 * bead + layer.z * (1.0 * broad.y + 0.8 * fine.x);
  // It runs down while it melts.
  thick += 0.22 * layer.w * clamp(0.4 - vObject.z, -1.0, 1.0);
  thick = clamp(thick, 0.05, 1.9);
  float coat = surface.z * (inside ? 1.0 : smoothstep(-0.004, 0.004, footLine));

  // The clay, with its grains.
  float grains = clay.x * (smoothstep(0.2, 0.4, grit.x) * 0.8 + 0.25 * fine.z + 0.25 * grit.y);
  vec3 clayAlbedo = mix(clayColour, grainColour, clamp(grains, 0.0, 1.0));

  // The glaze over it: what the glass lets through of the clay, and what it scatters itself; spots of iron.
  float cover = 1.0 - exp2(log2(1.0 - 0.995 * layer.x) * thick);
  vec3 glazed = mix(clayAlbedo * exp2(tintLog * thick), body * (1.45 - 0.45 * thick + 0.25 * layer.z * broad.z), cover);
  float breaks = layer.y * (1.0 - smoothstep(0.28, 0.85, thick));
  glazed = mix(glazed, edgeColour, breaks);
  float spot = surface.x * smoothstep(0.3, 0.42, grit.z);
  glazed = mix(glazed, glazed * vec3(0.36, 0.27, 0.2), spot);
  vec3 albedo = mix(clayAlbedo, glazed, coat);

  // A fired surface is never flat.
  vec3 waves = 0.020 * broad.yzw + 0.010 * fine.yzw;
  vec3 rough = (0.16 + 0.1 * clay.x) * grit.yzw + 0.06 * fine.xyz;
  n = normalize(n + mix(rough, waves, coat));

  // Light that reaches this place: the inside by its opening, the underside by the table, hollows by their walls.
  float depth = min(vWare.w, 100.0);
#ifdef CUT
  depth *= 0.25;  // the light comes in by the cut
#endif
  float fromFoot = 2.2 * min(vWare.z, 100.0);
  float open = max(1.0 / (1.0 + 1.15 * depth * depth + 0.35 * depth), lean.y / (1.0 + fromFoot * fromFoot));
  open = mix(1.0, open, within);
  float height = max(0.0, vScene.z - table);
  float ground = 1.0 - 0.75 * lean.x * lean.x * exp(-height / 0.16) * (0.55 - 0.45 * n.z);
  float hollow = 1.0 / (1.0 + 0.045 * max(0.0, -bulge));
  float access = open * ground * hollow;
  vec3 matt = vec3(access) / (1.0 - 0.8 * albedo * (1.0 - access));

  // Interpolated normals turn away from the eye at the silhouette; mirrored there they would see through the pot.
  n = normalize(n + toEye * max(0.0, 0.03 - dot(n, toEye)));
  vec3 ns = studioDirection(n);
  float facing = clamp(dot(n, toEye), 0.0, 1.0);
  float roughness = mix(clay.y, clamp(surface.y + 0.05 * fine.w + 0.25 * rim * surface.y, 0.03, 1.0), coat);
  float f0 = mix(0.028, 0.05, coat);
  float grazing = 1.0 - facing;
  float fresnel = f0 + (max(1.0 - roughness, f0) - f0) * grazing * grazing * grazing * grazing * grazing;
  vec3 mirrored = radiance(studioDirection(reflect(-toEye, n)), roughness);
  float mirrorAccess = min(1.0, access * access * 1.2) ;

  vec3 light = albedo * irradiance(ns) * matt * (1.0 - fresnel) + mirrored * fresnel * mirrorAccess;
#ifdef SOLID
  // Under water: what the way down and back lets through, and what the water scatters.
  if (inside && vScene.z < level) {
    vec3 through = exp2(-vec3(1.5, 0.5, 0.32) * min(level - vScene.z + 0.25, 2.0));
    light = light * through + vec3(0.02, 0.13, 0.19) * (1.0 - through.r);
  }
#endif
  colour = vec4(toScreen(light), 1.0);
}
`;

/**
 * What a material is besides: `SOLID`, of faces that bring what the glaze goes by with their vertices; `CUT`, of a pot that is cut open.
 */
export interface CeramicVariant {
  readonly defines?: readonly ("SOLID" | "CUT")[];
  readonly uniforms?: Uniforms;
}

/**
 * The material of its glazes on one clay: a layered shader of our own rather than a general physical one, because it follows how glaze lies
 * on a pot and needs no environment map to be made before the first picture.
 */
export function ceramic(look: StageLook, studio: Studio, variant: CeramicVariant = {}): Material {
  const clay = clayOf(look.clay);
  const glazes = [glazeOf(look.glaze), glazeOf(look.inside)];
  const both = (of: (glaze: Glaze) => readonly number[]) => ({ value: glazes.flatMap(of) });
  const log2 = (x: number) => Math.log2(Math.max(x, 1e-4));
  return new Material({
    vertex: VERTEX,
    fragment: FRAGMENT,
    bothSides: true,
    defines: variant.defines ?? [],
    uniforms: {
      frame: studio.frame,
      eye: studio.eye,
      turn: studio.turn,
      lean: studio.lean,
      table: studio.table,
      ceiling: studio.ceiling,
      wall: studio.wall,
      floor_: studio.floor,
      noise: studio.noise,
      ...variant.uniforms,
      clayColour: { value: clay.colour },
      grainColour: { value: clay.grain },
      clay: { value: [clay.grog, clay.roughness] },
      line: { value: look.line },
      tintLogs: both(({ tint }) => tint.map(log2)),
      bodies: both(({ body }) => body),
      edgeColours: both(({ edge }) => edge),
      layers: both(({ opacity, breaking, mottle, streak }) => [opacity, breaking, mottle, streak]),
      surfaces: both(({ speckle, roughness, coat }) => [speckle, roughness, coat]),
    },
  });
}
