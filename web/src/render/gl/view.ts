import { mat4, vec4 } from "gl-matrix";
import { dot, type Triple } from "../triple";

/** Sixteen numbers, column by column. In double precision: WebGL rounds them when they are handed over. */
export type Matrix = readonly number[];

export const IDENTITY: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Which part of a picture is drawn: x, y from the upper left, width, height, all in pixels of a picture of so many. */
export interface Tile {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly of: readonly [width: number, height: number];
}

/** Where something is seen: right and down from the upper left, as shares of the picture, and whether it is before the eye. */
export interface Seen {
  readonly x: number;
  readonly y: number;
  readonly before: boolean;
}

/** From scene space to the picture. */
export class View {
  /** What shaders read of it. */
  readonly uniforms = { viewMatrix: { value: [...IDENTITY] }, projectionMatrix: { value: [...IDENTITY] } };
  eye: Triple = [0, 0, 0];
  private lens = { fieldOfView: 1, aspect: 1, near: 0.1, far: 1 };

  /** Looks from a point along orthonormal axes, `back` being from what is looked at to the eye. */
  look(eye: Triple, right: Triple, up: Triple, back: Triple): void {
    const view = this.uniforms.viewMatrix.value;
    this.eye = eye;
    for (const [row, axis] of [right, up, back].entries()) {
      for (const k of [0, 1, 2] as const) view[4 * k + row] = axis[k];
      view[12 + row] = -dot(axis, eye);
    }
  }

  /** Sees so much, `fieldOfView` upwards, between two planes. */
  focus(fieldOfView: number, aspect: number, near: number, far: number): void {
    this.lens = { fieldOfView, aspect, near, far };
    this.tile(null);
  }

  /** Draws a part of the picture from now on; all of it at null. */
  tile(tile: Tile | null): void {
    const { fieldOfView, aspect, near, far } = this.lens;
    const top = near * Math.tan(0.5 * fieldOfView);
    const [height, width] = [2 * top, 2 * top * aspect];
    const [columns, rows] = tile?.of ?? [1, 1];
    const part = tile ?? { x: 0, y: 0, width: 1, height: 1 };
    const left = -0.5 * width + (part.x * width) / columns;
    const upper = top - (part.y * height) / rows;
    const right = left + (part.width * width) / columns;
    const lower = upper - (part.height * height) / rows;
    mat4.frustum(this.uniforms.projectionMatrix.value, left, right, lower, upper, near, far);
  }

  /** Where a point of the scene is in the picture. */
  see(point: Triple): Seen {
    const { projectionMatrix, viewMatrix } = this.uniforms;
    const [x, y, , w] = vec4.transformMat4(
      [0, 0, 0, 0],
      vec4.transformMat4([0, 0, 0, 0], [...point, 1], viewMatrix.value),
      projectionMatrix.value,
    ) as [number, number, number, number];
    return { x: 0.5 + (0.5 * x) / w, y: 0.5 - (0.5 * y) / w, before: w > 0 };
  }
}
