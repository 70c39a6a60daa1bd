/** A section of a blend as a person changes it: its form, how large and how far turned it is, where it stands and how the solid leaves it. */

import { setPath } from "../path";
import type { Blend, Pair, Section } from "../types";
import { type Figure, figureOf, outlineOf, PLAIN, withFigure } from "./figure";
import { SECTION } from "./tables.gen";

export type End = "start" | "end";
export const ENDS: readonly End[] = ["start", "end"];
export type Form = Section["form"];

/** In the order in which they are offered. */
export const FORMS: readonly Form[] = ["disc", "outline", "rectangle", "rectangle-reversed", "disc-in-square"];

/** Whether a form closes round: between two of these a blend can have a wall. */
export function isClosed(form: Form): boolean {
  return form === "disc" || form === "outline";
}

/** The size of a section; of an outline where the ellipse ends that it goes about. */
export function radiusOf(section: Section): Pair {
  return section.form === "outline" ? figureOf(section).radius : section.radius;
}

function withRadius(section: Section, index: 0 | 1, value: number): Section {
  const before = radiusOf(section);
  const radius: Pair = index === 0 ? [value, before[1]] : [before[0], value];
  if (before[index] === value) return section;
  return section.form === "outline"
    ? { ...section, ...withFigure(section, { radius }) }
    : setPath(section, ["radius"], radius);
}

/** The figure of a closed section: a disc is one without corners. */
export function closedFigure(section: Section): Figure | null {
  if (section.form === "outline") return figureOf(section);
  if (section.form !== "disc") return null;
  return { radius: section.radius, turn: 0, middle: [0, 0], ornament: PLAIN };
}

/** The closed section with something of its figure changed. A disc that is no more than one becomes an outline. */
export function refigured(section: Section, change: Partial<Figure>): Section {
  if (section.form === "outline") return { ...section, ...withFigure(section, change) };
  const figure = closedFigure(section);
  return figure ? { form: "outline", ...outlineOf({ ...figure, ...change }), ...levelOf(section) } : section;
}

/** The same section in another form, as large as it was. */
export function reformed(section: Section, form: Form): Section {
  if (section.form === form) return section;
  const level = levelOf(section);
  const radius = radiusOf(section);
  if (form !== "outline") return { form, radius, ...level };
  if (section.form === "disc")
    return { form, ...outlineOf({ radius, turn: 0, middle: [0, 0], ornament: PLAIN }), ...level };
  return { form, ...boxed(radius), ...level };
}

/** A rectangle as an outline, its sides where they were. */
export function boxed(radius: Pair) {
  const ornament = { count: 4, petals: 0, corners: 1, turn: 45 };
  const unit = {
    form: "outline",
    ...outlineOf({ radius: [1, 1], turn: 0, middle: [0, 0], ornament }),
    ...FLAT,
  } as const;
  const side = borderOf(unit)[0]?.[1] ?? 1;
  return outlineOf({ radius: [radius[0] / side, radius[1] / side], turn: 0, middle: [0, 0], ornament });
}

const FLAT = { z: 0, taper: 0, dz: 0 };

function levelOf({ z, taper, dz }: Section) {
  return { z, taper, dz };
}

/** Points of the border of a curve. */
const POINTS = 180;

/** The border of a section from above, its first point not repeated. */
export function borderOf(section: Section): readonly Pair[] {
  if (section.form === "rectangle" || section.form === "rectangle-reversed") {
    const [x, y] = section.radius;
    return [
      [x, y],
      [x, -y],
      [-x, -y],
      [-x, y],
    ];
  }
  return Array.from({ length: POINTS }, (_, at) => pointAt(section, at / POINTS));
}

/** A point of the border that is round, by the share of the way round from the axis of `y` on, clockwise. */
function pointAt(section: Section, v: number): Pair {
  const angle = 2 * Math.PI * v;
  if (section.form !== "outline") return [section.radius[0] * Math.sin(angle), section.radius[1] * Math.cos(angle)];
  const sum = (series: typeof section.x) =>
    series.reduce((all, { n, cos = 0, sin = 0 }) => all + cos * Math.cos(n * angle) + sin * Math.sin(n * angle), 0);
  return [sum(section.x), sum(section.y)];
}

/** How far a section reaches from the axis. */
export function reachOf(section: Section): number {
  return Math.max(0, ...borderOf(section).map(([x, y]) => Math.hypot(x, y)));
}

const NICE = [1, 2, 5, 10];

/** How much longer than the paper's examples this one is, as 1, 2, 5 times a power of ten: its sliders are as much longer. */
export function sizeFactor({ start, end }: Blend): number {
  const most = Math.max(
    ...SECTION.filter(({ min, dimension }) => dimension === "length" && min >= 0).flatMap(({ key, max }) =>
      [start, end].map((section) => Math.abs(numberOf(section, key)) / max),
    ),
  );
  if (!(most > 0) || !Number.isFinite(most)) return 1;
  const power = 10 ** Math.floor(Math.log10(most));
  const factor = Number(((NICE.find((step) => step * power >= most) ?? 10) * power).toPrecision(1));
  return factor >= 0.2 && factor <= 1 ? 1 : factor;
}

export type SectionKey = (typeof SECTION)[number]["key"];

export function numberOf(section: Section, key: SectionKey): number {
  switch (key) {
    case "radius-0":
      return radiusOf(section)[0];
    case "radius-1":
      return radiusOf(section)[1];
    default:
      return section[key];
  }
}

/** The section with one of its numbers changed; the same one when it had that already. */
export function withNumber(section: Section, key: SectionKey, value: number): Section {
  switch (key) {
    case "radius-0":
      return withRadius(section, 0, value);
    case "radius-1":
      return withRadius(section, 1, value);
    default:
      return setPath(section, [key], value);
  }
}
