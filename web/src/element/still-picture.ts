/** The pot without WebGL2: triangles painted from back to front into a plain 2D canvas, with one soft light. */

import type { Looked } from "../document/look";
import { placedNormals } from "../document/placed-normals";
import { type Matrix, placedAll } from "../document/placement";
import type { GlazeChoice } from "../document/types";
import { plainColour } from "../render/glaze";
import { codedOf } from "../render/own-colour";
import type { PartMesh } from "../solver/messages";

/** Turned a little and seen from above, like the stage's three-quarter view. */
const TURN = Math.PI / 5;
const TILT = 0.38;
const LIGHT = [-0.45, -0.55, 0.7] as const;
const MARGIN = 0.86;

type Rgb = readonly [number, number, number];

interface Face {
  readonly depth: number;
  readonly shade: number;
  readonly colour: Rgb;
  readonly corners: readonly number[];
}

/** A mesh and where it stands. */
export interface StillPart {
  readonly mesh: Pick<PartMesh, "positions" | "normals" | "indices">;
  readonly matrix: Matrix;
  readonly look: Looked;
  /** From which height to which it stands. */
  readonly span: readonly [low: number, high: number];
}

/** How much of it is paper, so that a black pot is seen on a dark page too. */
const LIFT = 0.1;
const MOST_PIXELS_PER_PIXEL = 2;

/** Draws parts to fill the canvas as large as it is on the page. */
export function paintStill(parts: readonly StillPart[], canvas: HTMLCanvasElement): void {
  const ratio = Math.min(MOST_PIXELS_PER_PIXEL, devicePixelRatio || 1);
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(canvas.clientHeight * ratio);
  drawStill(parts, canvas);
}

/** Draws parts to fill the canvas; the canvas keeps its size in pixels. */
export function drawStill(parts: readonly StillPart[], canvas: HTMLCanvasElement): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const { width, height } = canvas;
  context.clearRect(0, 0, width, height);
  const seen = parts.map(({ mesh, matrix, look, span }) => {
    const placed = placedAll(matrix, mesh.positions);
    return {
      points: project(placed),
      heights: placed,
      normals: placedNormals(matrix, mesh.normals),
      indices: mesh.indices,
      coats: coatsOf(look, span),
    };
  });
  const scale = frameOf(
    seen.map(({ points }) => points),
    width,
    height,
  );
  const faces = seen.flatMap((part) => facesOf(part));
  faces.sort((a, b) => a.depth - b.depth);
  for (const { corners, shade, colour } of faces) {
    context.beginPath();
    for (let i = 0; i < corners.length; i += 2) {
      const x = scale.x + scale.k * (corners[i] ?? 0);
      const y = scale.y - scale.k * (corners[i + 1] ?? 0);
      if (i === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
    context.closePath();
    const paint = `rgb(${colour.map((channel) => Math.round(255 * Math.min(1, channel * shade))).join(" ")})`;
    context.fillStyle = paint;
    // A hairline in the same paint closes the gaps that antialiasing leaves between neighbours.
    context.strokeStyle = paint;
    context.lineWidth = 0.7;
    context.fill();
    context.stroke();
  }
}

/** Right, up and towards the eye, for every vertex. */
function project(positions: Float64Array): Float32Array {
  const out = new Float32Array(positions.length);
  const [ct, st, cp, sp] = [Math.cos(TURN), Math.sin(TURN), Math.cos(TILT), Math.sin(TILT)];
  for (let i = 0; i < positions.length; i += 3) {
    const x = (positions[i] ?? 0) * ct - (positions[i + 1] ?? 0) * st;
    const y = (positions[i] ?? 0) * st + (positions[i + 1] ?? 0) * ct;
    const z = positions[i + 2] ?? 0;
    out[i] = x;
    out[i + 1] = z * cp + y * sp;
    out[i + 2] = z * sp - y * cp;
  }
  return out;
}

function frameOf(parts: readonly Float32Array[], width: number, height: number): { x: number; y: number; k: number } {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const points of parts) {
    for (let i = 0; i < points.length; i += 3) {
      left = Math.min(left, points[i] ?? 0);
      right = Math.max(right, points[i] ?? 0);
      low = Math.min(low, points[i + 1] ?? 0);
      high = Math.max(high, points[i + 1] ?? 0);
    }
  }
  const k = MARGIN * Math.min(width / Math.max(right - left, 1e-9), height / Math.max(high - low, 1e-9));
  return { k, x: width / 2 - (k * (left + right)) / 2, y: height / 2 + (k * (low + high)) / 2 };
}

/** What a part is covered with, and below which height it is bare outside. */
interface Coats {
  readonly outside: Rgb;
  readonly inside: Rgb;
  readonly clay: Rgb;
  readonly line: number;
}

function coatsOf({ glaze, inside, line, clay }: Looked, [low, high]: StillPart["span"]): Coats {
  const shown = (own: GlazeChoice): Rgb => {
    const [red, green, blue] = plainColour(own, clay);
    return [lifted(red), lifted(green), lifted(blue)];
  };
  return {
    outside: shown(glaze),
    inside: shown(inside),
    clay: shown("bare"),
    line: line > 0 ? low + line * (high - low) : Number.NEGATIVE_INFINITY,
  };
}

function lifted(linear: number): number {
  return LIFT + (1 - LIFT) * codedOf(linear);
}

/** The triangles with their mean depth, their colour and the light that falls on them. */
function facesOf({
  points,
  heights,
  normals,
  indices,
  coats,
}: {
  readonly points: Float32Array;
  /** xyz, of which the last is the height. */
  readonly heights: Float64Array;
  readonly normals: Float64Array;
  readonly indices: Uint32Array;
  readonly coats: Coats;
}): Face[] {
  const faces: Face[] = [];
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const [a, b, c] = [indices[i] ?? 0, indices[i + 1] ?? 0, indices[i + 2] ?? 0];
    const corners: number[] = [];
    let depth = 0;
    for (const corner of [a, b, c]) {
      corners.push(points[3 * corner] ?? 0, points[3 * corner + 1] ?? 0);
      depth += points[3 * corner + 2] ?? 0;
    }
    const height = ((heights[3 * a + 2] ?? 0) + (heights[3 * b + 2] ?? 0) + (heights[3 * c + 2] ?? 0)) / 3;
    const colour = !facesEye(normals, a) ? coats.inside : height < coats.line ? coats.clay : coats.outside;
    faces.push({ depth, corners, colour, shade: shadeOf(normals, a) });
  }
  return faces;
}

/** Whether the outside is seen: normals point out of the pot. */
function facesEye(normals: Float64Array, vertex: number): boolean {
  const [x, y, z] = [normals[3 * vertex] ?? 0, normals[3 * vertex + 1] ?? 0, normals[3 * vertex + 2] ?? 0];
  const [ct, st, cp, sp] = [Math.cos(TURN), Math.sin(TURN), Math.cos(TILT), Math.sin(TILT)];
  return z * sp - (x * st + y * ct) * cp >= 0;
}

function shadeOf(normals: Float64Array, vertex: number): number {
  const x = normals[3 * vertex] ?? 0;
  const y = normals[3 * vertex + 1] ?? 0;
  const z = normals[3 * vertex + 2] ?? 0;
  const size = Math.hypot(...LIGHT);
  const towards = (x * LIGHT[0] + y * LIGHT[1] + z * LIGHT[2]) / size;
  // The inside is lit too: by its own back, a little less.
  return 0.42 + 0.68 * (towards >= 0 ? towards : -0.35 * towards);
}
