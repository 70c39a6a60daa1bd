/** A place on the stage in CSS pixels from the upper left. */
export interface Spot {
  x: number;
  y: number;
}

/** A rectangle on the stage, in the same pixels. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** A spot for a word of a size, moved off boxes at the edges of a stage that is so high: those in its lower half upwards, the others downwards. */
export function clearOf(
  spot: Spot,
  [width, height]: readonly [number, number],
  boxes: readonly Box[],
  high: number,
): Spot {
  let { x, y } = spot;
  for (const box of boxes) {
    const beside = x + width / 2 <= box.left || x - width / 2 >= box.right;
    if (beside || y + height / 2 <= box.top || y - height / 2 >= box.bottom) continue;
    y = box.top + box.bottom > high ? box.top - height / 2 : box.bottom + height / 2;
  }
  return { x, y };
}

const FONT = "600 13px/1.2 system-ui, sans-serif";
const CANVAS_FONT = (scale: number) => `600 ${13 * scale}px system-ui, sans-serif`;

/** Text and ground for both themes; the contrast is above 12 to 1. */
const INK = { light: ["#1d1b18", "rgba(255, 253, 248, 0.86)"], dark: ["#f6f3ee", "rgba(20, 21, 23, 0.84)"] } as const;

/** A word on the stage, held where a point of the scene is seen. */
export class Label {
  private readonly element = document.createElement("div");
  private text = "";

  constructor(host: HTMLElement) {
    // The same numbers are told in words by the page; here they would be read twice.
    this.element.setAttribute("aria-hidden", "true");
    Object.assign(this.element.style, {
      position: "absolute",
      left: "0",
      top: "0",
      padding: "2px 7px",
      borderRadius: "9px",
      font: FONT,
      fontVariantNumeric: "tabular-nums",
      whiteSpace: "nowrap",
      pointerEvents: "none",
      userSelect: "none",
    });
    this.element.hidden = true;
    host.append(this.element);
  }

  set theme(theme: "light" | "dark") {
    const [ink, ground] = INK[theme];
    Object.assign(this.element.style, { color: ink, background: ground });
  }

  /** Shows a text with its middle at a spot; nothing at null. */
  place(text: string, spot: Spot | null): void {
    this.element.hidden = spot === null;
    if (!spot) return;
    if (text !== this.text) this.element.textContent = text;
    this.text = text;
    this.element.style.transform = `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px) translate(-50%, -50%)`;
  }

  dispose(): void {
    this.element.remove();
  }
}

/** The same word on a picture; `scale` is pixels of the picture per CSS pixel. */
export function paint(
  context: CanvasRenderingContext2D,
  text: string,
  spot: Spot,
  theme: "light" | "dark",
  scale: number,
): void {
  const [ink, ground] = INK[theme];
  context.font = CANVAS_FONT(scale);
  context.textAlign = "center";
  context.textBaseline = "middle";
  const width = context.measureText(text).width + 14 * scale;
  const height = 20 * scale;
  context.fillStyle = ground;
  context.beginPath();
  context.roundRect(spot.x - width / 2, spot.y - height / 2, width, height, 9 * scale);
  context.fill();
  context.fillStyle = ink;
  context.fillText(text, spot.x, spot.y + 0.5 * scale);
}
