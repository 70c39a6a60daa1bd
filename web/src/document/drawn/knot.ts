/** The points that a drawn line goes through. On the sheet x goes to the right and y down, as on a screen. */

export interface Spot {
  readonly x: number;
  readonly y: number;
}

export interface Knot extends Spot {
  /** Whether the line has a corner there. */
  readonly sharp: boolean;
}

export function between(a: Spot, b: Spot): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** How long a line is. */
export function lengthOf(line: readonly Spot[]): number {
  let length = 0;
  for (let i = 1; i < line.length; i += 1) length += between(line[i - 1] as Spot, line[i] as Spot);
  return length;
}

/** By how much a line turns at one of its points, in radians, seen over so many of them to either side. */
export function turnAt(line: readonly Spot[], i: number, over: number): number {
  const [a, b, c] = [line[i - over] as Spot, line[i] as Spot, line[i + over] as Spot];
  const [x1, y1, x2, y2] = [b.x - a.x, b.y - a.y, c.x - b.x, c.y - b.y];
  return Math.abs(Math.atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2));
}

/** The same line as points that are so far apart, about, both ends among them; none of a line without length. */
export function evenly(line: readonly Spot[], gap: number): readonly Spot[] {
  const length = lengthOf(line);
  const count = Math.max(1, Math.round(length / gap));
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last || !(length > 0)) return [];
  const even: Spot[] = [{ x: first.x, y: first.y }];
  let done = 0;
  for (let i = 1; i < line.length; i += 1) {
    const [a, b] = [line[i - 1] as Spot, line[i] as Spot];
    const step = between(a, b);
    while (even.length < count && even.length * (length / count) <= done + step) {
      const share = (even.length * (length / count) - done) / step;
      even.push({ x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) });
    }
    done += step;
  }
  even.push({ x: last.x, y: last.y });
  return even;
}
