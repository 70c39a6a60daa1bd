/**
 * Switching an open design between second, mixed and fourth order, keeping what the next order can hold.
 *
 * The second order wall `s q'' = t k^2 q`, `k = 2 pi n`, also solves `q'''' = (t k^2 / s) q''`. A fourth order shape with
 * `s = 1`, that `t`, `w = 0` and the wall's own end slopes is therefore the same wall, not one like it.
 */

import { filled } from "./kinds";
import type { FourthOrder, Kind, MixedOrder, Pair, SecondOrder, Shape } from "./types";

export type OrderKind = "second-order" | "mixed-order" | "fourth-order";
export const ORDER_KINDS: readonly OrderKind[] = ["second-order", "mixed-order", "fourth-order"];

const TAU = 2 * Math.PI;

/** What an order can and cannot do, in a potter's words. */
export interface OrderNote {
  readonly title: string;
  readonly can: readonly string[];
  readonly cannot: readonly string[];
}

export const ORDER_NOTES: Readonly<Record<OrderKind, OrderNote>> = {
  "second-order": {
    title: "Second order",
    can: ["Set where the rim and the foot are", "Petals on the rim and the foot", "A waist, and a push along the wall"],
    cannot: ["Choose how the wall leaves the rim or the foot", "Swell into a belly without a push"],
  },
  "mixed-order": {
    title: "Mixed order",
    can: ["All of second order", "Choose how steeply the wall leaves the rim: a flat lip, or a drop"],
    cannot: ["Choose the slope at the foot", "Choose how far the wall leans out at either end"],
  },
  "fourth-order": {
    title: "Fourth order",
    can: ["Set where the rim and the foot are", "Choose the slope of the wall at both ends", "Bellies, necks and feet"],
    cannot: ["Petals (use free boundary data for those)", "A push along the wall"],
  },
};

/** A design in another order and what it had to leave behind, one sentence each. */
export interface Conversion {
  readonly shape: Shape;
  readonly lost: readonly string[];
}

/** The radii, height and end slopes that any two orders can share. Slopes are along `u` from the rim down. */
interface Outline {
  readonly rim: number;
  readonly foot: number;
  readonly height: number;
  readonly rimSlope: number;
  readonly footSlope: number;
  readonly middle: number;
  readonly rimRise: number;
  readonly footRise: number;
  /** `t k^2 / s` of a wall that second order can make. */
  readonly tension: Pair | null;
  readonly equation: { readonly s: Pair; readonly t: Pair; readonly w: Pair };
}

/** Whether the design's shape can be switched at all. */
export function convertible(kind: Kind): boolean {
  return kind !== "boundary-value";
}

/** The shape in another order; null for shapes that have no rim and foot radius to keep. */
export function convert(shape: Shape, to: OrderKind): Conversion | null {
  if (shape.kind === to) return { shape, lost: [] };
  const outline = outlineOf(shape);
  if (outline === null) return null;
  const lost: string[] = [];
  if (shape.kind === "bloor-wilson") {
    if (shape.h[1] !== 0 || shape.H[1] !== 0) lost.push("The dints of the rim are left out.");
    if (shape.r[1] + shape.r[2] !== 0 || shape.R[1] + shape.R[2] !== 0) lost.push("The skew of the rim is left out.");
  }
  if (to === "fourth-order") {
    if (shape.kind === "second-order" || shape.kind === "mixed-order") lost.push(...lostPlanar(filled(shape)));
    return { shape: fourthOrder(outline), lost };
  }
  const planar = planarOf(shape, outline, lost);
  if (to === "second-order") {
    if (shape.kind !== "fourth-order" || !straight(outline)) lost.push("The rise of the wall becomes even.");
    return { shape: { kind: "second-order", ...planar }, lost };
  }
  return {
    shape: { kind: "mixed-order", ...planar, rise: mixedRise(shape, outline) },
    lost,
  };
}

function lostPlanar(shape: SecondOrder | MixedOrder): readonly string[] {
  const lost: string[] = [];
  if (shape.r[1] !== 0 || shape.r[3] !== 0) lost.push("The petals are left out.");
  if (shape.force?.some((p) => p !== 0)) lost.push("The push along the wall is left out.");
  if (shape.n?.[0] !== 1) lost.push("The wall now goes round once.");
  return lost;
}

/** `z` of mixed order ends flat at the foot; `-1.5 h` is the cubic that bends least. */
function mixedRise(shape: Shape, outline: Outline): number {
  return shape.kind === "second-order" ? -1.5 * outline.height : outline.rimRise;
}

function straight(outline: Outline): boolean {
  return outline.rimRise === -outline.height && outline.footRise === -outline.height;
}

function planarOf(shape: Shape, outline: Outline, lost: string[]): Omit<SecondOrder, "kind"> {
  if (shape.kind === "second-order" || shape.kind === "mixed-order") {
    const { r, n, height, s, t, force } = filled<SecondOrder | MixedOrder>(shape);
    return {
      r,
      ...(n && { n }),
      ...(height !== undefined && { height }),
      ...(s && { s }),
      ...(t && { t }),
      ...(force && { force }),
    };
  }
  const tension = outline.tension;
  if (tension === null) lost.push("The slopes at rim and foot are left to the equation.");
  return {
    r: [outline.rim, 0, outline.foot, 0],
    height: outline.height,
    s: [1, 1],
    t: tension === null ? [0.1, 0.1] : [regained(tension[0] / TAU ** 2), regained(tension[1] / TAU ** 2)],
  };
}

function fourthOrder(outline: Outline): FourthOrder {
  const { rim, foot, height, equation } = outline;
  const atFoot = -outline.footSlope;
  const atRim = -outline.rimSlope;
  const swell = 4 * outline.middle - rim - 3 * foot;
  const flat = Math.abs(swell) <= 1e-3 * Math.max(rim, foot, Math.abs(atFoot), Math.abs(atRim));
  const rm = flat ? neat((Math.max(Math.abs(atFoot), Math.abs(atRim), 1) + rim + 3 * foot) / 4) : neat(outline.middle);
  const factor = 4 * rm - rim - 3 * foot;
  return {
    kind: "fourth-order",
    r0: foot,
    r1: rim,
    rm,
    h1: height,
    eta: [neat(atFoot / factor), neat(atRim / factor)],
    dz: [neat(-outline.footRise), neat(-outline.rimRise)],
    ...equation,
  };
}

function outlineOf(shape: Shape): Outline | null {
  switch (shape.kind) {
    case "second-order":
    case "mixed-order":
      return outlineOfPlanar(filled<SecondOrder | MixedOrder>(shape));
    case "fourth-order":
      return outlineOfFourth(shape);
    case "bloor-wilson": {
      const { a, r, R, h, H } = shape;
      return {
        rim: r[0],
        foot: r[3],
        height: h[0],
        rimSlope: R[0],
        footSlope: R[3],
        middle: (r[0] + r[3]) / 2 + (R[0] - R[3]) / 8,
        rimRise: H[0],
        footRise: 0,
        tension: null,
        equation: { s: [1, 1], t: [2 * a * a, 2 * a * a], w: [a ** 4, a ** 4] },
      };
    }
    case "boundary-value":
      return null;
  }
}

function outlineOfPlanar(shape: SecondOrder | MixedOrder): Outline {
  const [rim, , foot] = shape.r;
  const height = shape.height ?? 0;
  const turns = shape.n?.[0] ?? 1;
  const s = shape.s ?? [1, 1];
  const t = shape.t ?? [0, 0];
  const tension: Pair = [(t[0] / s[0]) * (TAU * turns) ** 2, (t[1] / s[1]) * (TAU * turns) ** 2];
  const wall = secondOrderWall(rim, foot, tension[0]);
  const mixed = shape.kind === "mixed-order";
  return {
    rim,
    foot,
    height,
    ...wall,
    rimRise: mixed ? shape.rise : -height,
    footRise: mixed ? 0 : -height,
    tension,
    equation: { s: [1, 1], t: [neat(tension[0]), neat(tension[1])], w: [0, 0] },
  };
}

/** End slopes and middle of `q'' = tension q`, `q(0) = rim`, `q(1) = foot`. */
function secondOrderWall(
  rim: number,
  foot: number,
  tension: number,
): Pick<Outline, "rimSlope" | "footSlope" | "middle"> {
  const rate = Math.sqrt(Math.abs(tension));
  if (rate < 1e-6)
    return {
      rimSlope: foot - rim,
      footSlope: foot - rim,
      middle: (rim + foot) / 2,
    };
  const waves = tension < 0;
  // rate / sinh(rate) and rate / tanh(rate), which stay finite however strong the pull is.
  const across = waves ? rate / Math.sin(rate) : (2 * rate) / (Math.exp(rate) - Math.exp(-rate));
  const along = waves ? rate / Math.tan(rate) : rate / Math.tanh(rate);
  const half = waves ? Math.cos(rate / 2) : Math.cosh(rate / 2);
  return {
    rimSlope: foot * across - rim * along,
    footSlope: foot * along - rim * across,
    middle: (rim + foot) / 2 / half,
  };
}

function outlineOfFourth(shape: FourthOrder): Outline {
  const { r0, r1, rm, h1, eta, dz, s, t, w } = shape;
  const swell = 4 * rm - r1 - 3 * r0;
  const second = w[0] === 0 && w[1] === 0 && s[0] !== 0 && s[1] !== 0;
  return {
    rim: r1,
    foot: r0,
    height: h1,
    rimSlope: -eta[1] * swell,
    footSlope: -eta[0] * swell,
    middle: rm,
    rimRise: -dz[1],
    footRise: -dz[0],
    tension: second ? [t[0] / s[0], t[1] / s[1]] : null,
    equation: { s, t, w },
  };
}

/** Twelve digits, as canonical form keeps: the next edit then starts from a number that the link can hold. */
function neat(value: number): number {
  const short = Number(value.toPrecision(12));
  return short === 0 ? 0 : short;
}

/** A pull that went through fourth order at twelve digits and back: the last two are rounding. */
function regained(value: number): number {
  return Number(value.toPrecision(10));
}
