/**
 * How a pot is looked at, as a link may carry it: in the query of the address, because what follows the `#` is the design and nothing else, and an older page leaves a query alone. The
 * words in it are the same in every language: `view=30,75,1&cut=0&show=isoU,axes&map=overhang`, degrees round the pot and from straight above, and how many times closer than where it just fits.
 */

import type { MapName } from "../document/types";
import { NEW_SESSION, type Overlays } from "./session";
import type { VIEW_KEYS } from "./view-keys";

export interface Camera {
  /** In radians. */
  readonly azimuth: number;
  readonly polar: number;
  /** The distance, in those from which the pot just fits. */
  readonly share: number;
}

export interface Viewed {
  readonly camera: Camera;
  readonly overlays: Overlays;
  readonly map: MapName | null;
}

/** What could be read of it, and whether anything could not. */
export interface ReadView {
  readonly viewed: Partial<Viewed>;
  readonly damaged: boolean;
}

const LINES = (Object.keys(NEW_SESSION.overlays) as (keyof Overlays)[]).filter((name) => name !== "cut");
const CLOSEST = 100;
const NOTHING = "none";
const DEGREE = Math.PI / 180;

/** The address of a design with the view in it. */
export function withView(address: string, { camera, overlays, map }: Viewed): string {
  const round = (value: number, digits: number) => String(Number(value.toFixed(digits)) + 0);
  const turn = (((camera.azimuth / DEGREE) % 360) + 360) % 360;
  const view = [round(turn, 1), round(camera.polar / DEGREE, 1), round(1 / camera.share, 3)];
  const lines = LINES.filter((name) => overlays[name]);
  const query = [
    `view=${view.join(",")}`,
    `cut=${overlays.cut ? 1 : 0}`,
    `show=${lines.length > 0 ? lines.join(",") : NOTHING}`,
    `map=${map ?? NOTHING}`,
  ].join("&");
  const [before = "", design = ""] = address.split("#", 2);
  return `${before}${before.includes("?") ? "&" : "?"}${query}#${design}`;
}

/** Reads the query of an address; `maps` are those that there are. What is not said is left as it is. */
export function readView(search: string, maps: readonly MapName[]): ReadView {
  const said = new URLSearchParams(search);
  let damaged = false;
  const read = <T>(key: (typeof VIEW_KEYS)[number], take: (text: string) => T | undefined): T | undefined => {
    const text = said.get(key);
    if (text === null) return undefined;
    const taken = take(text);
    if (taken === undefined) damaged = true;
    return taken;
  };
  const camera = read("view", cameraFrom);
  const cut = read("cut", (text) => (text === "1" ? true : text === "0" ? false : undefined));
  const lines = read("show", linesFrom);
  const map = read("map", (text) => (text === NOTHING ? null : maps.find((name) => name === text)));
  const shown = Object.fromEntries(LINES.map((name) => [name, lines?.includes(name) ?? false]));
  const overlays = { ...NEW_SESSION.overlays, ...shown, cut: cut ?? false };
  return {
    damaged,
    viewed: {
      ...(camera && { camera }),
      ...((cut !== undefined || lines) && { overlays }),
      ...(map !== undefined && { map }),
    },
  };
}

function cameraFrom(text: string): Camera | undefined {
  const numbers = text.split(",").map((each) => (/^-?\d+(\.\d+)?$/.test(each) ? Number(each) : Number.NaN));
  const [azimuth = Number.NaN, polar = Number.NaN, closer = Number.NaN] = numbers;
  const good = numbers.length === 3 && Math.abs(azimuth) <= 360 && polar >= 0 && polar <= 180;
  if (!good || !(closer >= 1 / CLOSEST && closer <= CLOSEST)) return undefined;
  return { azimuth: azimuth * DEGREE, polar: polar * DEGREE, share: 1 / closer };
}

function linesFrom(text: string): readonly string[] | undefined {
  if (text === NOTHING) return [];
  const names = text.split(",");
  return names.every((name) => LINES.some((line) => line === name)) ? names : undefined;
}
