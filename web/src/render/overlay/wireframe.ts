import type { Tenant } from "../gl/device";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import { Material, type Uniform } from "../gl/material";
import { PLACING_GLSL } from "../placing";
import type { Pot } from "../pot";
import type { Studio } from "../studio";
import type { Triple } from "../triple";
import { NEARER } from "./stroke";

/** Lines of one direction are at least so many device pixels apart. */
const CLOSEST = 6;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
uniform float nearer;
uniform int columns;
out vec2 vCell;
out vec3 vScene;
void main() {
  vCell = vec2(gl_VertexID / columns, gl_VertexID % columns);
  vScene = inFrame(position) + shift;
  vec4 p = viewMatrix * vec4(vScene, 1.0);
  p.xyz *= nearer;
  gl_Position = projectionMatrix * p;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec2 vCell;
in vec3 vScene;
uniform vec3 ink;
uniform vec4 cut;
uniform float core;  // which side of the surface stands for the cut: -1 its back, 1 its front, 0 neither
out vec4 colour;

// How much of a pixel a line covers that is as wide as one, where x is whole; wide is how much x changes over a pixel.
float line(float x, float wide) {
  return clamp(1.0 - abs(fract(x - 0.5) - 0.5) / wide, 0.0, 1.0);
}

// How often the lines of a family have to be halved in number, to be no closer together than can be told apart.
float crowding(float wide) {
  return log2(${CLOSEST.toFixed(1)} * wide);
}

// Lines that are too close together for the screen: every second one goes, and of those that stay again.
float family(float x, float wide) {
  float level = max(0.0, crowding(wide));
  float each = exp2(floor(level));
  float lines = mix(line(x / each, wide / each), line(0.5 * x / each, 0.5 * wide / each), fract(level));
  // Where a row shrinks to a point nothing is left to see.
  return lines * (1.0 - smoothstep(6.0, 8.0, level));
}

void main() {
  if (dot(vScene, cut.xyz) > cut.w || (core != 0.0 && gl_FrontFacing == (core > 0.0))) discard;
  vec3 x = vec3(vCell, vCell.x - vCell.y);
  vec3 right = dFdx(x);
  vec3 up = dFdy(x);
  vec3 wide = max(sqrt(right * right + up * up), vec3(1e-6));
  float across = line(x.z, wide.z) * clamp(1.0 - crowding(wide.z), 0.0, 1.0);
  float lines = max(across, max(family(x.x, wide.x), family(x.y, wide.y)));
  colour = vec4(ink, 0.45 * lines);
}
`;

const DARK_INK: Triple = [0.05, 0.06, 0.09];
const LIGHT_INK: Triple = [0.86, 0.9, 0.94];

/**
 * The triangles of the pot as lines one device pixel wide, drawn by the parts' own triangles: which row and column a vertex belongs to follows from its
 * number, and the lines are where these are whole. Where they would run together on the screen fewer are drawn, as a map has fewer of its lines from afar.
 */
export class Wireframe implements Tenant {
  visible = false;
  private lines: Drawable[] = [];
  private readonly ink: Uniform<Triple> = { value: DARK_INK };
  private readonly material: Material;

  constructor(
    studio: Studio,
    cut: Uniform<readonly number[]>,
    private readonly order: number,
  ) {
    this.material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: { frame: studio.frame, nearer: { value: NEARER }, ink: this.ink, cut },
      bothSides: true,
      depthWrite: false,
      blending: "alpha",
    });
  }

  get drawables(): readonly Drawable[] {
    return this.visible ? this.lines : [];
  }

  /** Follows the pot; light lines on a dark glaze. `coreOf` says which side of a part stands for its cut, by its place: there are no lines on that. */
  update(pot: Pot, coreOf: (place: number) => number): void {
    this.ink.value = pot.dark ? LIGHT_INK : DARK_INK;
    for (const { geometry } of this.lines) geometry.release();
    const seen = [...pot.parts.entries()].filter(([, { drawable }]) => drawable.visible);
    this.lines = seen.map(([place, { positions, lattice, drawable }]) => ({
      geometry: new Geometry({ position: positions }, lattice.index),
      material: this.material,
      uniforms: { ...drawable.uniforms, columns: { value: lattice.columns }, core: { value: coreOf(place) } },
      order: this.order,
      visible: true,
      mirrored: drawable.mirrored ?? false,
    }));
  }

  /** Gives up everything on the GPU. */
  release(): void {
    for (const { geometry } of this.lines) geometry.release();
  }
}
