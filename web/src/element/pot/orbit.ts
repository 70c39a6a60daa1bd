/**
 * Where the camera stands, written as in `<model-viewer>`: an angle round the pot, one from straight above, and a distance. 0deg 90deg looks from
 * the front at half height; 100% is the distance from which the pot just fits.
 */

import type { Refusal } from "../../document/types";
import { pot } from "../../words/english/pot";

export interface Orbit {
  /** Radians, as the stage counts them. */
  readonly azimuth: number;
  readonly polar: number;
  /** Of the distance from which the pot just fits. */
  readonly share: number;
}

/** The front of a pot, in the stage's angles. */
const FRONT = -Math.PI / 2;
const DEGREE = Math.PI / 180;

export const USUAL: Orbit = { azimuth: FRONT + 0.55, polar: 1.13, share: 1 };

const ANGLE = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(deg|rad)$/i;
const SHARE = /^((?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)%$/i;

/** @throws {Refusal} in words, when it is not written like that */
export function orbitOf(text: string): Orbit {
  const words = text.trim().split(/\s+/);
  if (words.length > 3 || text.trim() === "") throw refusal(text);
  const [azimuth = "auto", polar = "auto", share = "auto"] = words;
  const orbit = {
    azimuth: azimuth === "auto" ? USUAL.azimuth : FRONT + angleOf(azimuth, text),
    polar: polar === "auto" ? USUAL.polar : angleOf(polar, text),
    share: share === "auto" ? USUAL.share : shareOf(share, text),
  };
  return { ...orbit, polar: Math.min(Math.max(orbit.polar, 0), Math.PI) };
}

/** The same the other way. */
export function orbitText({ azimuth, polar, share }: Orbit): string {
  const short = (value: number) => String(Number(value.toFixed(3)));
  const round = (azimuth - FRONT) / DEGREE;
  return `${short(round - 360 * Math.floor((round + 180) / 360))}deg ${short(polar / DEGREE)}deg ${short(100 * share)}%`;
}

function angleOf(word: string, text: string): number {
  const [, number, unit] = ANGLE.exec(word) ?? [];
  const value = Number(number);
  if (number === undefined || !Number.isFinite(value)) throw refusal(text);
  return unit?.toLowerCase() === "deg" ? value * DEGREE : value;
}

function shareOf(word: string, text: string): number {
  const [, number] = SHARE.exec(word) ?? [];
  const value = Number(number) / 100;
  if (number === undefined || !(value > 0 && Number.isFinite(value))) throw refusal(text);
  return value;
}

function refusal(text: string): Refusal {
  return { code: "unreadable-orbit", path: "camera-orbit", message: pot.orbit(text) };
}
