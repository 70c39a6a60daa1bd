import { mat3, mat4, vec3 } from "gl-matrix";
import type { Uniform } from "./gl/material";
import { IDENTITY, type Matrix } from "./gl/view";
import type { Triple } from "./triple";

/** What shaders read of where a part stands. */
export interface Placing {
  /** From the mesh to the model. */
  readonly model: Uniform<readonly number[]>;
  /** The same for normals: the inverse, transposed. */
  readonly turned: Uniform<readonly number[]>;
  /** How far it is moved besides, in scene space: a pot beside another. */
  readonly shift: Uniform<Triple>;
}

export function newPlacing(shift: Uniform<Triple> = { value: [0, 0, 0] }): Placing {
  return { model: { value: IDENTITY }, turned: { value: [1, 0, 0, 0, 1, 0, 0, 0, 1] }, shift };
}

/** Puts a part where a matrix says. Whether it is turned inside out by that, as in a mirror. */
export function place(placing: Placing, matrix: Matrix): boolean {
  placing.model.value = matrix;
  // A part that is too small to have an inverse in numbers keeps the normals that it had.
  const turned = mat3.normalFromMat4([...placing.turned.value], matrix as number[]) as number[] | null;
  if (turned) placing.turned.value = turned;
  return mat4.determinant(matrix as number[]) < 0;
}

/** Where a point of the mesh stands. */
export function placed(matrix: Matrix, point: Triple): Triple {
  return vec3.transformMat4([0, 0, 0], point, matrix as number[]) as Triple;
}

/** A vertex of a mesh, and the same in scene space but for `shift`. */
export const PLACING_GLSL = /* glsl */ `
uniform vec4 frame;
uniform mat4 model;
uniform mat3 turned;
uniform vec3 shift;
vec3 inFrame(vec3 vertex) {
  // Where the part stands first: what is small and far away keeps its shape in single precision.
  return (mat3(model) * vertex + (model[3].xyz - frame.xyz)) * frame.w;
}
`;
