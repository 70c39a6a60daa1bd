import type { Drawable } from "../gl/drawable";
import { Material, type Uniform } from "../gl/material";
import { NEARER } from "../overlay/stroke";
import { PLACING_GLSL } from "../placing";
import type { Pot } from "../pot";
import type { Studio } from "../studio";

/** Over the glaze and the outline of a part, below all other lines. */
const ORDER = 9;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec2 uv;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
uniform float nearer;
out vec3 vScene;
out vec2 vAt;
void main() {
  vScene = inFrame(position) + shift;
  vAt = uv;
  vec4 p = viewMatrix * vec4(vScene, 1.0);
  p.xyz *= nearer;
  gl_Position = projectionMatrix * p;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
in vec2 vAt;
uniform vec4 cut;
uniform float ratio;
uniform vec2 at;
uniform float degree;
uniform float petals;
uniform float held;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  float swell = abs(cos(3.14159265359 * petals * (vAt.y - at.y)));
  float strength = degree > 0.0 ? pow(max(swell, 1e-6), 2.0 * degree) : 1.0;
  // The distance from the ring, in CSS pixels; the seam has no slope of its own.
  float off = abs(vAt.x - at.x) / max(fwidth(vAt.x), 1e-7) / ratio;
  float half_ = mix(0.9, 3.4, strength);
  float core = 1.0 - smoothstep(half_ - 0.5, half_ + 0.5, off);
  float all = 1.0 - smoothstep(half_ + 0.9, half_ + 1.9, off);
  // A glow where the clay will move.
  float glow = 0.34 * strength * exp(-pow(abs(vAt.x - at.x) / 0.06, 2.0));
  float line = all * mix(0.55, 1.0, strength);
  vec3 ink = mix(vec3(0.80, 0.27, 0.02), vec3(1.0, 0.55, 0.10), held);
  vec3 shade = mix(vec3(1.0), ink, core);
  float cover = line + glow * (1.0 - line);
  if (cover < 0.004) discard;
  colour = vec4(shade * line + vec3(1.0, 0.72, 0.36) * glow * (1.0 - line), cover);
}
`;

/** What a pull would move: the ring, and the bump round it, as strong as the pull is there. */
export interface Touch {
  /** The place of the part among the others. */
  readonly place: number;
  readonly u: number;
  /** The middle of the bump, from 0 to 1 round the axis. */
  readonly v: number;
  readonly degree: number;
  readonly petals: number;
  /** Whether the hand holds it. */
  readonly held: boolean;
}

const NAMES = ["place", "u", "v", "degree", "petals", "held"] as const;

/** Draws a touch on the part's own triangles once more: it follows every mesh and holds nothing on the GPU. */
export class Band {
  private touch: Touch | null = null;
  private readonly material: Material;
  private readonly at: Uniform<readonly number[]> = { value: [0, 0] };
  private readonly degree: Uniform<number> = { value: 0 };
  private readonly petals: Uniform<number> = { value: 1 };
  private readonly held: Uniform<number> = { value: 0 };
  private readonly cut: Uniform<readonly number[]> = { value: [0, 0, 0, 1] };

  constructor(studio: Studio, ratio: Uniform<number>) {
    const { at, degree, petals, held, cut } = this;
    this.material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: { frame: studio.frame, nearer: { value: NEARER }, ratio, at, degree, petals, held, cut },
      bothSides: true,
      depthWrite: false,
      blending: "premultiplied",
    });
  }

  /** Whether that is another one than before. */
  show(touch: Touch | null): boolean {
    const before = this.touch;
    this.touch = touch;
    if (before === null || touch === null) {
      if (before === touch) return false;
    } else if (NAMES.every((name) => before[name] === touch[name])) return false;
    if (!touch) return true;
    this.at.value = [touch.u, touch.v];
    this.degree.value = touch.degree;
    this.petals.value = touch.petals;
    this.held.value = touch.held ? 1 : 0;
    return true;
  }

  drawables(pot: Pot, cut: readonly number[]): readonly Drawable[] {
    const drawable = this.touch && pot.parts[this.touch.place]?.drawable;
    this.cut.value = cut;
    return drawable?.visible ? [{ ...drawable, material: this.material, order: ORDER }] : [];
  }
}
