import type { Camera } from "../camera";
import type { Drawable } from "../gl/drawable";
import { Material, type Uniform } from "../gl/material";
import type { StageModel } from "../mesh";
import { NEARER } from "../overlay/stroke";
import { PLACING_GLSL } from "../placing";
import { axesOf, fitDistance } from "../pose";
import { Pot } from "../pot";
import type { Bench, Tool } from "../stage";
import { toScene } from "../studio";
import type { Triple } from "../triple";

/** Red, green and blue, from 0 to 1, in sRGB. */
export type Colour = readonly [number, number, number];

/** Over the glazes and below the outline of what is selected. */
const ORDER = 7;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec3 normal;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
uniform float nearer;
out vec3 vScene;
out vec3 vNormal;
void main() {
  vScene = inFrame(position) + shift;
  vNormal = turned * normal;
  vec4 p = viewMatrix * vec4(vScene, 1.0);
  p.xyz *= nearer;
  gl_Position = projectionMatrix * p;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
in vec3 vNormal;
uniform vec3 eye;
uniform vec4 cut;
uniform vec3 tint;
uniform float hatched;
uniform float ratio;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  float facing = abs(dot(normalize(vNormal + vec3(0.0, 0.0, 1e-12)), normalize(eye - vScene)));
  float light = 0.5 + 0.5 * facing;
  // Of what is no longer there: stripes, and its edge in full.
  float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * ratio)));
  float cover = hatched > 0.5 ? max(0.62 * stripe, smoothstep(0.42, 0.2, facing)) : 0.66;
  if (cover < 0.004) discard;
  colour = vec4(tint * light * cover, cover);
}
`;

/** Colours parts by what became of them: those on the stage all over, those of another scene hatched, in their own places. */
export class Tints implements Tool {
  visible = true;
  private readonly ghost: Pot;
  private own: ReadonlyMap<number, Colour> = new Map();
  private others: readonly Colour[] = [];
  private readonly cut: Uniform<readonly number[]> = { value: [0, 0, 0, 1] };
  private readonly plain: Material;
  private readonly hatched: Material;

  constructor(private readonly bench: Bench) {
    const { studio, overlay } = bench;
    this.ghost = new Pot(studio);
    const made = (hatched: number, nearer: number) =>
      new Material({
        vertex: VERTEX,
        fragment: FRAGMENT,
        uniforms: {
          frame: studio.frame,
          eye: studio.eye,
          ratio: overlay.pen.ratio,
          cut: this.cut,
          nearer: { value: nearer },
          hatched: { value: hatched },
        },
        bothSides: true,
        depthWrite: false,
        blending: "premultiplied",
      });
    this.plain = made(0, NEARER);
    this.hatched = made(1, 1);
  }

  /** Colours of parts by their places, and a colour for each part of a model that is shown besides. */
  show(own: ReadonlyMap<number, Colour>, model: StageModel, others: readonly Colour[]): void {
    this.own = own;
    this.others = others;
    this.ghost.update(model);
    this.bench.changed();
  }

  /** Has all of both scenes seen, from the present direction, where so many pixels of the width are taken. */
  frame(taken: number): void {
    const { pot, camera } = this.bench;
    const [width, height] = this.bench.aim() ?? [0, 0];
    const all = [pot.bounds, this.others.length > 0 ? this.ghost.bounds : null].filter((each) => each !== null);
    const [first] = all;
    if (!first || height === 0) return;
    const corners = all.flatMap(({ min, max }) =>
      [0, 1, 2, 3, 4, 5, 6, 7].flatMap((corner) =>
        [0, 1, 2].map((axis) => ((corner >> axis) & 1 ? max : min)[axis] as number),
      ),
    );
    const ends = (pick: (...values: number[]) => number) =>
      [0, 1, 2].map((axis) => pick(...corners.filter((_, at) => at % 3 === axis)));
    const [min, max] = [ends(Math.min), ends(Math.max)];
    const target = min.map((low, axis) => (low + (max[axis] as number)) / 2) as [number, number, number];
    const { azimuth, polar } = camera.goal;
    const distance = fitDistance(corners, target, axesOf(azimuth, polar), Math.max(width - taken, width / 3) / height);
    if (distance > 0) camera.travel({ azimuth, polar, target, distance });
    this.bench.changed();
  }

  get drawables(): readonly Drawable[] {
    if (!this.visible) return [];
    this.cut.value = this.bench.cut();
    const tinted = (drawable: Drawable | undefined, colour: Colour, material: Material): readonly Drawable[] =>
      drawable?.visible
        ? [{ ...drawable, material, order: ORDER, uniforms: { ...drawable.uniforms, tint: { value: colour } } }]
        : [];
    const { pot } = this.bench;
    for (const part of this.ghost.parts) part.cut.value = this.cutThrough(part.middle);
    return [
      ...[...this.own].flatMap(([place, colour]) => tinted(pot.parts[place]?.drawable, colour, this.plain)),
      // The inside, the rim and the underside of what has a wall.
      ...this.bench.faces().flatMap(({ part, ...face }) => {
        const colour = this.own.get(part);
        return colour ? tinted({ ...face, material: this.plain, order: ORDER, visible: true }, colour, this.plain) : [];
      }),
      ...this.others.flatMap((colour, at) => tinted(this.ghost.parts[at]?.drawable, colour, this.hatched)),
    ];
  }

  /** As all is cut, but through the middle of an object where there are several. */
  private cutThrough(middle: Triple | null): readonly number[] {
    const all = this.bench.cut();
    if (!middle) return all;
    const [x = 0, y = 0, z = 0] = all;
    const [a, b, c] = toScene(this.bench.studio, middle);
    return [x, y, z, x * a + y * b + z * c];
  }

  prepare(_camera: Camera): void {}

  release(): void {
    this.ghost.release();
  }
}
