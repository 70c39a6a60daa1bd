/** `<pasu-pot>`: a pot in any page. Importing the module defines the element. */

import type { Design } from "./design.js";

export type { Design } from "./design.js";

/** What came to the screen, or what a person made of it. */
export interface PotChange {
  readonly design: Design;
  /** The design's link, with its `#`: good as `src`. */
  readonly link: string;
}

/** Why something is not shown. `code` is stable, `path` names the attribute or the place in the design, `message` is a sentence. */
export interface PotProblem {
  readonly type: "loadfailure";
  readonly code: string;
  readonly path: string;
  readonly message: string;
}

/** Where the camera is: angles in radians as the stage counts them, and the distance as a share of that from which the pot just fits. */
export interface PotOrbit {
  readonly azimuth: number;
  readonly polar: number;
  readonly share: number;
  /** As `camera-orbit` is written. */
  toString(): string;
}

/** A picture's size in pixels; as large as it is on the screen where nothing is said. */
export interface PotPicture {
  readonly width?: number;
  readonly height?: number;
  readonly transparent?: boolean;
}

export interface PasuPotEventMap
  extends Omit<HTMLElementEventMap, "load" | "error" | "input" | "change" | "camera-change"> {
  load: CustomEvent<PotChange>;
  error: CustomEvent<PotProblem>;
  input: CustomEvent<{ readonly design: Design }>;
  change: CustomEvent<PotChange>;
  "camera-change": Event;
}

export declare class PasuPotElement extends HTMLElement {
  /** A link (`#1/…`), an address that ends in one, or the address of a design as JSON. */
  src: string;
  /** What is seen, for whoever does not see it. */
  alt: string;
  /** The address of a picture that is shown until the pot is there. */
  poster: string;
  /** `eager` loads at once, anything else near the screen. */
  loading: "auto" | "lazy" | "eager";
  /** Where the camera begins: `30deg 65deg 100%`. */
  cameraOrbit: string;
  /** Whether the pot turns by itself while it is seen. */
  autoRotate: boolean;
  /** The names of the parameters to show, in order. */
  controls: string;
  /** `view` shows no parameters, `sliders` those of `controls`, or all. */
  ui: "" | "view" | "sliders";
  theme: "auto" | "light" | "dark";
  /** The design that is shown, as a copy; to be set in the place of `src`. */
  design: Design | null;
  /** The link of the design that came to rest on the screen. */
  readonly link: string | null;
  /** Whether the design is on the screen. */
  readonly loaded: boolean;
  getCameraOrbit(): PotOrbit;
  /** The picture as it is seen, as a PNG. */
  toBlob(options?: PotPicture): Promise<Blob>;

  addEventListener<K extends keyof PasuPotEventMap>(
    type: K,
    listener: (this: PasuPotElement, event: PasuPotEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<K extends keyof PasuPotEventMap>(
    type: K,
    listener: (this: PasuPotElement, event: PasuPotEventMap[K]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-pot": PasuPotElement;
  }
}
