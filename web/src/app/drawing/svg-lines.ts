/**
 * The lines of an SVG file, as points. The file is parsed apart from the page, where nothing of it runs and nothing is fetched; of its elements only shapes and their transforms are read, as numbers, and
 * nothing else of it comes into the page.
 */

import { evenly, lengthOf, type Spot } from "../../document/drawn/knot";

export interface SvgLine {
  readonly points: readonly Spot[];
  readonly closed: boolean;
}

export type SvgRefusal = "too-large" | "no-svg" | "entities" | "no-line";

const SVG = "http://www.w3.org/2000/svg";

/** A drawing of a profile is some kilobytes. */
const MOST_BYTES = 2_000_000;
/** All path data together. */
const MOST_LETTERS = 400_000;
/** Lines to choose from, and points of each. */
const MOST_LINES = 40;
const POINTS = 600;

/** What is there to be referred to, and is not seen itself. */
const UNSEEN = "defs, clipPath, mask, marker, pattern, symbol, linearGradient, radialGradient, filter";

/** The longest come first. */
export async function svgLines(file: Blob): Promise<readonly SvgLine[] | SvgRefusal> {
  if (file.size > MOST_BYTES) return "too-large";
  const text = await file.text();
  // Entities can make much of little, and no drawing needs them.
  if (/<!ENTITY/i.test(text)) return "entities";
  const parsed = new DOMParser().parseFromString(unstyled(text), "image/svg+xml");
  const root = parsed.documentElement;
  if (root.namespaceURI !== SVG || root.localName !== "svg" || parsed.querySelector("parsererror")) return "no-svg";
  let letters = 0;
  const lines: SvgLine[] = [];
  for (const element of root.querySelectorAll("path, polyline, polygon, line, rect, circle, ellipse")) {
    if (element.closest(UNSEEN)) continue;
    const data = pathData(element);
    letters += data.length;
    if (letters > MOST_LETTERS) return "too-large";
    if (data !== "") lines.push(...linesOf(data, matrixOf(element)));
  }
  if (lines.length === 0) return "no-line";
  return [...lines].sort((a, b) => lengthOf(b.points) - lengthOf(a.points)).slice(0, MOST_LINES);
}

/** Without styles, which say nothing of where a line is: the policy of the page would have the browser complain of each. */
function unstyled(text: string): string {
  let plain = "";
  let from = 0;
  for (let open = text.indexOf("<style"); open >= 0; open = text.indexOf("<style", from)) {
    const close = text.indexOf("</style", open);
    if (close < 0) break;
    plain += text.slice(from, open);
    from = text.indexOf(">", close) + 1 || text.length;
  }
  return `${plain}${text.slice(from)}`.replace(/\sstyle\s*=\s*(?:"[^"]*"|'[^']*')/g, "");
}

/** Letters, numbers and what stands between them: nothing else is path data. */
const PATH = /^[\sMmZzLlHhVvCcSsQqTtAa0-9eE.,+-]*$/;

function pathData(element: Element): string {
  const number = (name: string) => Number.parseFloat(element.getAttribute(name) ?? "") || 0;
  switch (element.localName) {
    case "path": {
      const data = element.getAttribute("d") ?? "";
      return PATH.test(data) ? data : "";
    }
    case "polyline":
    case "polygon": {
      const numbers = (element.getAttribute("points") ?? "").match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? [];
      if (numbers.length < 4) return "";
      const pairs = Array.from({ length: numbers.length >> 1 }, (_, i) => `${numbers[2 * i]} ${numbers[2 * i + 1]}`);
      return `M${pairs.join("L")}${element.localName === "polygon" ? "Z" : ""}`;
    }
    case "line":
      return `M${number("x1")} ${number("y1")}L${number("x2")} ${number("y2")}`;
    case "rect":
      return `M${number("x")} ${number("y")}h${number("width")}v${number("height")}h${-number("width")}Z`;
    default: {
      const [rx, ry] = element.localName === "circle" ? [number("r"), number("r")] : [number("rx"), number("ry")];
      const [cx, cy] = [number("cx"), number("cy")];
      return `M${cx - rx} ${cy}A${rx} ${ry} 0 1 0 ${cx + rx} ${cy}A${rx} ${ry} 0 1 0 ${cx - rx} ${cy}Z`;
    }
  }
}

/** What the element and all around it are moved, turned and stretched by. */
function matrixOf(element: Element): DOMMatrix {
  let matrix = new DOMMatrix();
  for (let each: Element | null = element; each; each = each.parentElement) {
    const own = each instanceof SVGGraphicsElement ? each.transform.baseVal.consolidate()?.matrix : null;
    if (own) matrix = new DOMMatrix([own.a, own.b, own.c, own.d, own.e, own.f]).multiply(matrix);
  }
  return matrix;
}

/** The pieces of a path, each run through by its length, as the browser measures it. */
function linesOf(data: string, matrix: DOMMatrix): readonly SvgLine[] {
  const path = document.createElementNS(SVG, "path") as SVGPathElement;
  path.setAttribute("d", data);
  const length = path.getTotalLength();
  if (!(length > 0) || !Number.isFinite(length)) return [];
  const pieces: Spot[][] = [];
  const step = length / POINTS;
  let last: DOMPoint | null = null;
  for (let i = 0; i <= POINTS; i += 1) {
    const point: DOMPoint = path.getPointAtLength(i * step);
    const moved = matrix.transformPoint({ x: point.x, y: point.y });
    if (!Number.isFinite(moved.x) || !Number.isFinite(moved.y)) return [];
    // No further than along the line, or the pen was lifted.
    const goesOn: boolean = last !== null && Math.hypot(point.x - last.x, point.y - last.y) <= 1.01 * step;
    if (goesOn) pieces.at(-1)?.push({ x: moved.x, y: moved.y });
    else pieces.push([{ x: moved.x, y: moved.y }]);
    last = point;
  }
  return pieces
    .filter((points) => points.length > 2)
    .map((points) => {
      const [first, end] = [points[0] as Spot, points.at(-1) as Spot];
      const whole = lengthOf(points);
      return { points, closed: Math.hypot(first.x - end.x, first.y - end.y) < (2 * whole) / points.length };
    });
}

/** Lines as large as a sheet allows, in its middle. */
export function onSheet(lines: readonly SvgLine[], size: number, margin: number): readonly SvgLine[] {
  const all = lines.flatMap(({ points }) => points);
  const [xs, ys] = [all.map(({ x }) => x), all.map(({ y }) => y)];
  const [least, most] = [
    (values: readonly number[]) => values.reduce((a, b) => Math.min(a, b)),
    (values: readonly number[]) => values.reduce((a, b) => Math.max(a, b)),
  ];
  const [left, right, top, bottom] = [least(xs), most(xs), least(ys), most(ys)];
  const scale = (size - 2 * margin) / Math.max(right - left, bottom - top, Number.MIN_VALUE);
  const [x0, y0] = [(size - scale * (left + right)) / 2, (size - scale * (top + bottom)) / 2];
  return lines.map(({ points, closed }) => ({
    closed,
    points: evenly(
      points.map(({ x, y }) => ({ x: x0 + scale * x, y: y0 + scale * y })),
      1,
    ),
  }));
}
