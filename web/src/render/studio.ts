import type { Uniform } from "./gl/material";
import type { Texture } from "./gl/texture";
import { NOISE } from "./noise";
import type { Triple } from "./triple";

/** The two appearances of the page. */
export type Theme = "light" | "dark";

interface Room {
  /** Backdrop: at the top, at the bottom, and in the glow behind the pot. These are of the screen (sRGB), all others linear. */
  top: Triple;
  bottom: Triple;
  glow: Triple;
  /** What the pot mirrors where there is no lamp: above, at the height of the eye, below. */
  ceiling: Triple;
  wall: Triple;
  floor: Triple;
  /** Darkness of the shadow on the table, 0 to 1. */
  shadow: number;
}

const ROOMS: Readonly<Record<Theme, Room>> = {
  light: {
    top: [0.838, 0.827, 0.807],
    bottom: [0.786, 0.77, 0.745],
    glow: [0.921, 0.914, 0.9],
    ceiling: [0.62, 0.64, 0.67],
    wall: [0.42, 0.41, 0.4],
    floor: [0.36, 0.34, 0.31],
    shadow: 0.72,
  },
  dark: {
    top: [0.021, 0.027, 0.052],
    bottom: [0.133, 0.128, 0.128],
    glow: [0.243, 0.237, 0.235],
    ceiling: [0.2, 0.215, 0.24],
    wall: [0.1, 0.1, 0.105],
    floor: [0.075, 0.07, 0.065],
    shadow: 0.85,
  },
};

/** The uniforms that everything in one picture shares. */
export interface Studio {
  /** Model to scene space: centre, and 1 / radius. */
  frame: Uniform<readonly [number, number, number, number]>;
  /** The eye in scene space. */
  eye: Uniform<Triple>;
  /** Cosine and sine of the turn from scene space to the studio, whose lamps stay with the camera as if the pot stood on a turntable. */
  turn: Uniform<number[]>;
  /** Cosine and sine of the lean of the studio, which follows a camera that looks from below. */
  lean: Uniform<number[]>;
  /** Height of the table in scene space. */
  table: Uniform<number>;
  ceiling: Uniform<Triple>;
  wall: Uniform<Triple>;
  floor: Uniform<Triple>;
  top: Uniform<Triple>;
  bottom: Uniform<Triple>;
  glow: Uniform<Triple>;
  shadow: Uniform<number>;
  noise: Uniform<Texture>;
}

export function newStudio(theme: Theme): Studio {
  const studio: Studio = {
    frame: { value: [0, 0, 0, 1] },
    eye: { value: [0, 0, 0] },
    turn: { value: [1, 0] },
    lean: { value: [1, 0] },
    table: { value: 0 },
    ceiling: { value: [0, 0, 0] },
    wall: { value: [0, 0, 0] },
    floor: { value: [0, 0, 0] },
    top: { value: [0, 0, 0] },
    bottom: { value: [0, 0, 0] },
    glow: { value: [0, 0, 0] },
    shadow: { value: 0 },
    noise: { value: NOISE },
  };
  furnish(studio, theme);
  return studio;
}

/** From this polar angle on the studio leans with the camera: nothing below the table would be lit otherwise. */
const LEAN_FROM = 1.72;

/** Turns the studio to a camera: the lamps stay where the photographer put them, and the pot turns before them. */
export function face(studio: Studio, azimuth: number, polar: number): void {
  const turn = -Math.PI / 2 - azimuth;
  studio.turn.value = [Math.cos(turn), Math.sin(turn)];
  const lean = Math.max(0, polar - LEAN_FROM);
  studio.lean.value = [Math.cos(lean), Math.sin(lean)];
}

/** Where a point of the model is in scene space. */
export function toScene({ frame }: Studio, point: Triple): Triple {
  const [x, y, z, w] = frame.value;
  return [(point[0] - x) * w, (point[1] - y) * w, (point[2] - z) * w];
}

/** Sets what the theme decides. */
export function furnish(studio: Studio, theme: Theme): void {
  const { shadow, ...colours } = ROOMS[theme];
  for (const [name, colour] of Object.entries(colours) as [Exclude<keyof Room, "shadow">, Triple][]) {
    studio[name].value = colour;
  }
  studio.shadow.value = shadow;
}

/**
 * The light of the studio in closed form, so that there is no environment map to make, filter, or lose with the context:
 * - `radiance(d, roughness)`: what comes from a direction, blurred as a surface of that roughness mirrors it. Lamps are rectangles on planes
 *   facing the pot; blurring a rectangle is a product of two blurred slits.
 * - `irradiance(n)`: what a matt surface receives, a cosine lobe per lamp, wrapped because the lamps are wide, and the room.
 * Directions are in the studio: x right, y away from the camera, z up.
 */
export const STUDIO_GLSL = /* glsl */ `
uniform vec2 turn;
uniform vec2 lean;
uniform vec3 ceiling;
uniform vec3 wall;
uniform vec3 floor_;

vec3 studioDirection(vec3 d) {
  float away = turn.y * d.x + turn.x * d.y;
  return vec3(turn.x * d.x - turn.y * d.y, lean.x * away + lean.y * d.z, lean.x * d.z - lean.y * away);
}

float slit(float x, float halfWidth, float blur) {
  vec2 s = clamp(vec2(x + halfWidth, x - halfWidth) / blur + 0.5, 0.0, 1.0);
  s = s * s * (3.0 - 2.0 * s);
  return s.x - s.y;
}

float lamp(vec3 d, vec3 centre, vec3 side, vec2 halfSize, float blur) {
  float away = dot(d, centre);
  if (away < 0.05) return 0.0;
  vec2 p = vec2(dot(d, side), dot(d, cross(centre, side))) / away;
  return slit(p.x, halfSize.x, blur) * slit(p.y, halfSize.y, blur);
}

vec3 room(float z, float blur) {
  float up = smoothstep(-0.12 - blur, 0.12 + blur, z);
  return mix(floor_, mix(wall, ceiling, smoothstep(0.0, 1.0, z)), up);
}

vec3 radiance(vec3 d, float roughness) {
  float blur = 0.03 + 1.9 * roughness;
  vec3 light = room(d.z, roughness);
  light += vec3(6.6, 6.35, 6.0) * (0.75 + 0.45 * d.z) * lamp(d, vec3(-0.6804, -0.4949, 0.5404), vec3(-0.5882, 0.8087, 0.0), vec2(0.40, 0.58), blur);
  light += vec3(2.3, 2.45, 2.7) * lamp(d, vec3(0.9129, -0.3043, 0.2722), vec3(0.3162, 0.9487, 0.0), vec2(0.13, 0.95), blur + 0.05);
  light += vec3(1.7, 1.8, 2.0) * lamp(d, vec3(0.3939, 0.7878, 0.4735), vec3(-0.8944, 0.4472, 0.0), vec2(0.8, 0.5), blur + 0.15);
  light += vec3(0.9) * smoothstep(0.55 - roughness, 1.0, d.z);
  return light;
}

float lobe(vec3 n, vec3 centre, float wrap) {
  float x = max(0.0, (dot(n, centre) + wrap) / (1.0 + wrap));
  return x * x * wrap + x * (1.0 - wrap);
}

vec3 irradiance(vec3 n) {
  vec3 light = mix(floor_, mix(wall, ceiling, 0.6), 0.5 + 0.5 * n.z) * 0.62;
  light += vec3(1.02, 0.98, 0.92) * lobe(n, vec3(-0.6804, -0.4949, 0.5404), 0.3);
  light += vec3(0.13, 0.14, 0.155) * lobe(n, vec3(0.9129, -0.3043, 0.2722), 0.5);
  light += vec3(0.14, 0.145, 0.155) * lobe(n, vec3(0.3939, 0.7878, 0.4735), 0.4);
  light += vec3(0.26) * lobe(n, vec3(0.0, 0.0, 1.0), 0.4);
  return light;
}
`;

/** Half a level of ordered noise, so that soft gradients have no bands. */
export const GRAIN_GLSL = /* glsl */ `
float grain() {
  return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}
`;

/**
 * From light to the screen: the Khronos neutral tone mapping, which leaves the colour of a glaze alone and only rolls off its highlights,
 * and the sRGB curve. It is part of the shaders, not of the
 * renderer, because pictures drawn into a texture must look the same as the screen.
 */
export const TONE_GLSL = /* glsl */ `
${GRAIN_GLSL}
vec3 toScreen(vec3 light) {
  float dark = min(light.r, min(light.g, light.b));
  float offset = dark < 0.08 ? dark - 6.25 * dark * dark : 0.04;
  vec3 c = light - offset;
  float peak = max(c.r, max(c.g, c.b));
  const float start = 0.76;
  if (peak > start) {
    float d = 1.0 - start;
    float rolled = 1.0 - d * d / (peak + d - start);
    c *= rolled / peak;
    c = mix(c, vec3(rolled), 1.0 - 1.0 / (0.15 * (peak - rolled) + 1.0));
  }
  c = max(c, vec3(0.0));
  vec3 screen = mix(1.055 * pow(c, vec3(0.41666)) - 0.055, 12.92 * c, vec3(lessThan(c, vec3(0.0031308))));
  return screen + grain();
}
`;
