import { Camera } from "./camera";
import { Gesture, type GestureTarget, type PageManners } from "./gesture";
import { Device, type Tenant, webgl2Supported } from "./gl/device";
import { draw } from "./gl/drawable";
import { Pane } from "./gl/pane";
import type { Source } from "./gl/scene";
import { WHOLE } from "./ground";
import { Loop } from "./loop";
import type { PartId, PartMesh, StageModel, StagePart } from "./mesh";
import type { Cover } from "./overlay/cover";
import type { Size } from "./overlay/dimensions";
import type { Box } from "./overlay/label";
import { Mark } from "./overlay/mark";
import { Overlays, type StageLines, type StageOverlays } from "./overlay/overlays";
import { type Face, Picker } from "./picker";
import { drawPicture, toPng } from "./picture";
import { axesOf, type CameraPose, type Direction, FIT_MARGIN_UPRIGHT, fitDistance, VIEWS, type ViewName } from "./pose";
import type { Pot } from "./pot";
import { Resolution } from "./resolution";
import { Rest } from "./rest";
import { LONGEST, Stopwatch } from "./stopwatch";
import type { Studio, Theme } from "./studio";
import { Tableau } from "./tableau";

/** How the stage begins; `theme`, `reducedMotion` and `lengths` may change later. */
export interface StageOptions {
  theme: Theme;
  reducedMotion: boolean;
  /** How a length is written beside its dimension line. */
  lengths: (length: number) => string;
  /** The stage stands in a page that scrolls. */
  page?: PageManners;
  /** The browser took the graphics context away; the picture stands still until it is back. */
  onContextLost?(): void;
  onContextRestored?(): void;
  /** A part was clicked on, without turning anything; with the shift or the control key `adds` is true. */
  onTap?(part: PartId, adds: boolean): void;
  /** What lies under a point of the stage is asked for, in CSS pixels from its upper left. */
  onUnder?(x: number, y: number): void;
  /** The camera came to rest somewhere else. */
  onCamera?(camera: CameraPose): void;
  /** A frame was drawn, as far as this thread is concerned. */
  onDrawn?(): void;
  /** What a frame with a new mesh cost, until the GPU was done with it, and whether it was drawn as coarsely as is ever done. */
  onCost?(milliseconds: number, coarsest: boolean): void;
}

/** Where something is drawn. */
export interface Place {
  readonly studio: Studio;
  readonly pot: Pot;
  readonly overlay: Overlays;
  /** Holds elements over the picture. */
  readonly root: HTMLElement;
  /** Something is different: frames are drawn. */
  readonly changed: () => void;
}

/** A tool that works on the pot, by code that is fetched when it is needed. Pictures have none of what it draws. */
export interface Tool extends Tenant, Source {
  visible: boolean;
  /** Before every frame, on a screen of so many CSS pixels. */
  prepare(camera: Camera, width: number, height: number): void;
}

/** What a tool works on. */
export interface Bench extends Place {
  readonly device: Device;
  readonly camera: Camera;
  /** The plane before which everything is cut away. */
  readonly cut: () => readonly number[];
  /** The faces of walls, by their parts. */
  readonly faces: () => readonly Face[];
  /** Brings all up to date for whoever asks what is seen at a point, on a screen of so many CSS pixels; null while nothing can be seen. */
  readonly aim: () => readonly [width: number, height: number] | null;
}

/** Something that is drawn besides the pot, by code that is fetched when it is needed. */
export interface Guest extends Tenant, Source {
  /** What of it belongs to parts, and the plane before which everything is cut away. */
  readonly faces: readonly Face[];
  readonly cutPlane: { readonly value: readonly number[] };
  /** Which side of a part, by its place, stands for its cut: -1 its back, 1 its front, 0 neither or no cut. */
  coreOf(place: number): number;
  /** Another mesh is on the stage. */
  forget(): void;
  /** Before every frame, on a screen of so many CSS pixels. */
  prepare(camera: Camera, width: number, height: number): void;
  dispose(): void;
}

/** Turning by the height of the stage turns the pot by half a turn. */
const TURN_PER_HEIGHT = Math.PI;

/** A frame later than this turns no further, in seconds. */
const LONGEST_STEP = 0.25;

/** So many points tell whether a pot is on the stage. */
const FEW = 2000;

/** Of a pot that grew the camera keeps its distance, unless what is there is smaller than this part of it. */
const SMALL = 0.2;
/** So many CSS pixels are left between a fitted pot and the caption. */
const CAPTION_GAP = 8;

/** However large the caption is, this factor is the most that a fitted pot leaves free for it. */
const MOST_ROOM = 2;

/** The 3D view: shows a mesh, turns it, and draws only when something changed. */
export class Stage {
  private readonly root: HTMLDivElement;
  private readonly device: Device;
  private readonly pane: Pane;
  private readonly picker: Picker;
  private readonly forgetDevice: () => void;
  private readonly tableau: Tableau;
  private readonly camera = new Camera();
  private readonly loop: Loop;
  private readonly gesture: Gesture;
  private readonly resolution = new Resolution();
  private readonly resizes: ResizeObserver;
  private readonly overlay: Overlays;
  private readonly mark: Mark;
  private readonly stopwatch: Stopwatch;
  private size = { width: 0, height: 0 };
  private model: StageModel = { parts: [], bounds: null };
  private drawn = 0;
  private placed = false;
  /** Whether the view was fitted and not touched since: then it stays fitted when the stage changes its shape. */
  private fitted = false;
  /** How large what grew was when the camera followed it last; 0 where the camera was placed or touched since. */
  private followed = 0;
  /** Where the caption is, which a fitted pot stays clear of. */
  private caption: Box | null = null;
  /** What the view that was fitted last left free above and below. */
  private left = FIT_MARGIN_UPRIGHT;
  /** How far away a fitted view is, as a share of the distance from which the pot just fits. */
  private share = 1;
  /** How fast the camera goes round by itself, in radians a second. */
  private rate = 0;
  private gesturing = false;
  private movedAt = -Infinity;
  private readonly rest = new Rest();
  /** Whether something has changed since the last frame, which may be long ago where many stages are drawn. */
  private hurried = false;
  /** The pose last told to the page. */
  private told = "";
  private disposed = false;
  private readonly listeners = new AbortController();
  private readonly settings = new Map<string, unknown>();
  private guest: Guest | null = null;
  private readonly tools = new Set<Tool>();
  private selected: readonly PartId[] = [];

  /** Whether the stage can work here: WebGL2 is present. */
  static supported(): boolean {
    return webgl2Supported();
  }

  /** @throws {Error} when there is no WebGL2 */
  constructor(
    host: HTMLElement,
    private readonly options: StageOptions,
  ) {
    this.device = Device.share();
    this.loop = new Loop((seconds) => this.draw(seconds));
    this.forgetDevice = this.device.watch({
      lost: () => {
        this.loop.pause();
        options.onContextLost?.();
      },
      restored: () => {
        this.loop.resume();
        this.loop.invalidate();
        options.onContextRestored?.();
      },
    });
    this.root = document.createElement("div");
    Object.assign(this.root.style, { position: "absolute", inset: "0", overflow: "hidden" });
    this.pane = new Pane(this.device, () => this.loop.invalidate());
    this.root.append(this.pane.element);
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.append(this.root);
    this.stopwatch = new Stopwatch(this.device.gl);
    this.tableau = new Tableau(options.theme);
    this.picker = new Picker(this.tableau.studio);
    this.overlay = new Overlays(this.tableau.studio, this.root, options.theme, options.lengths);
    this.mark = new Mark(this.tableau.studio, this.overlay.cut, this.overlay.pen.ratio);
    this.tableau.scene.add(...this.overlay.sources, this.mark);
    for (const tenant of this.tenants()) this.device.admit(tenant);
    this.camera.reducedMotion = options.reducedMotion;
    const target: GestureTarget = {
      orbit: (dx, dy) => this.turnByPixels(dx, dy),
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor) => this.zoom(factor),
      tap: (x, y, adds) => this.tap(x, y, adds),
      under: (x, y) => {
        const { left, top } = this.root.getBoundingClientRect();
        options.onUnder?.(x - left, y - top);
      },
      gesture: (active) => {
        this.gesturing = active;
        this.loop.invalidate();
      },
    };
    this.gesture = new Gesture(this.pane.element, target, options.page);
    if (this.device.lost) {
      this.loop.pause();
      // Not before whoever made the stage has it.
      queueMicrotask(() => options.onContextLost?.());
    }
    this.resizes = new ResizeObserver(() => this.resize());
    this.resizes.observe(this.root);
    this.watchPixels();
    this.resize();
  }

  /** Frames drawn so far; it stands still when nothing changes. */
  get frames(): number {
    return this.drawn;
  }

  /** Where the camera is now. */
  get pose(): CameraPose {
    return this.camera.pose;
  }

  /**
   * Shows parts. Those that it shows already, by their identities and revisions, stay where they are on the GPU; what is different travels there. The arrays of
   * their meshes belong to the stage until it gives them back, which it does when it shows other ones. The camera stays, except that the first pot shown is fitted
   * into the view, and that one that was seen whole and grows beyond the stage is followed; and followed back, where nobody has looked otherwise, when it is a small part of that again.
   */
  show(model: StageModel): readonly PartMesh[] {
    // What fills the same room is seen as well as before: to look through its points takes longer than to draw a few that moved.
    const whole = this.placed && !fillsTheSame(this.model, model) && this.sees();
    const before = this.model.parts;
    this.model = model;
    this.tableau.show(model);
    this.overlay.forget();
    this.guest?.forget();
    if (!this.placed && this.tableau.bounds) {
      this.placed = true;
      this.place(VIEWS["three-quarter"], true);
    } else if ((whole && !this.sees()) || this.radius < this.followed * SMALL) {
      const { fitted } = this;
      const grows = this.radius > this.followed;
      this.place(null, false);
      this.fitted = fitted;
      this.followed = grows ? this.radius : 0;
    }
    this.changed();
    const kept = new Set(model.parts.map(({ mesh }) => mesh));
    return before.flatMap(({ mesh }) => (kept.has(mesh) ? [] : [mesh]));
  }

  /** The part that is seen at a point of the stage, in CSS pixels from its upper left; null where there is none, and while there is no context. */
  pick(x: number, y: number): PartId | null {
    const { width, height } = this.size;
    if (!(x >= 0 && y >= 0 && x < width && y < height) || !this.aim()) return null;
    const own = this.tableau.main.parts.flatMap(({ drawable }, part): readonly Face[] =>
      drawable.visible ? [{ geometry: drawable.geometry, uniforms: drawable.uniforms ?? {}, part }] : [],
    );
    const faces = [...own, ...(this.guest?.faces ?? [])];
    const cut = this.guest?.cutPlane.value ?? null;
    const part = this.picker.pick(this.device, faces, cut, this.camera.view, { x, y, of: [width, height] });
    return part === null ? null : (this.model.parts[part]?.id ?? null);
  }

  private aim(): readonly [number, number] | null {
    const { width, height } = this.size;
    if (this.device.lost || width === 0 || height === 0) return null;
    this.prepare(this.camera, width / height);
    this.guest?.prepare(this.camera, width, height);
    return [width, height];
  }

  /** Outlines parts among several, or none; not in pictures. */
  select(parts: readonly PartId[]): void {
    if (!this.differs("selected", parts.join())) return;
    this.selected = parts;
  }

  private tap(x: number, y: number, adds: boolean): void {
    const { left, top } = this.root.getBoundingClientRect();
    const part = this.options.onTap ? this.pick(x - left, y - top) : null;
    if (part !== null) this.options.onTap?.(part, adds);
  }

  /** Of the ball round all that is shown. */
  private get radius(): number {
    return this.tableau.seen?.radius ?? 0;
  }

  /** Whether all of the pot is on the stage, where the camera is going to be. */
  private sees(): boolean {
    const { goal } = this.camera;
    const aspect = this.size.height > 0 ? this.size.width / this.size.height : 1;
    const points = this.tableau.outline(FEW);
    return fitDistance(points, goal.target, axesOf(goal.azimuth, goal.polar), aspect, false) <= goal.distance;
  }

  /** Puts a second pot to the right of the first at the same scale, or takes it away, and fits the view when it comes or goes. */
  compare(other: StageModel | null): void {
    const before = this.tableau.comparing;
    this.tableau.compare(other);
    if (before !== this.tableau.comparing) this.fit();
    this.loop.invalidate();
  }

  /** The lines of every part of the present mesh, for the overlays. */
  lines(lines: readonly StageLines[]): void {
    this.overlay.lines = lines;
    this.changed();
  }

  /** Curves on a part that somebody points at, or none. */
  point(lines: readonly Float32Array[], part = 0): void {
    this.overlay.point(lines, part);
    this.changed();
  }

  /** Chooses what is drawn over the pot. */
  overlays(overlays: StageOverlays): void {
    if (!this.differs("overlays", JSON.stringify(overlays))) return;
    this.overlay.overlays = overlays;
    // Dimension lines stand off the pot: a fitted view has them in it.
    if (this.fitted) this.place(null, false);
  }

  /** Lets something else be drawn from now on. */
  invite<G extends Guest>(arrive: (place: Place) => G): G {
    const { tableau, overlay, root } = this;
    const guest = arrive({
      studio: tableau.studio,
      pot: tableau.main,
      overlay,
      root,
      changed: () => {
        overlay.forget();
        this.changed();
      },
    });
    tableau.scene.add(guest);
    this.device.admit(guest);
    this.guest = guest;
    overlay.coreOf = (place) => guest.coreOf(place);
    return guest;
  }

  /** Lets a tool work on the pot, until what comes back is called. */
  lend<T extends Tool>(take: (bench: Bench) => T): { readonly tool: T; readonly giveBack: () => void } {
    const { tableau, overlay, root, device, camera } = this;
    const tool = take({
      studio: tableau.studio,
      pot: tableau.main,
      overlay,
      root,
      device,
      camera,
      cut: () => this.guest?.cutPlane.value ?? WHOLE,
      faces: () => this.guest?.faces ?? [],
      aim: () => this.aim(),
      changed: () => this.changed(),
    });
    this.tools.add(tool);
    tableau.scene.add(tool);
    device.admit(tool);
    this.changed();
    const giveBack = () => {
      if (!this.tools.delete(tool)) return;
      tableau.scene.remove(tool);
      device.dismiss(tool);
      this.changed();
    };
    return { tool, giveBack };
  }

  /** What lies over the stage: a fitted pot stays clear of the caption, and labels of everything. */
  furnish(caption: Box | null, others: readonly Box[]): void {
    this.caption = caption;
    this.overlay.furniture = caption ? [caption, ...others] : others;
    if (this.fitted && this.room() > this.left) this.place(null, false);
    else this.loop.invalidate();
  }

  /** What lies over it, for what has to stand beside that. */
  get cover(): Cover {
    return { ...this.size, boxes: this.overlay.furniture };
  }

  /** Goes to a standard view, fitted. */
  view(name: ViewName): void {
    this.look(VIEWS[name], 1, false);
  }

  /** Moves the camera, in its present direction, so that everything is seen. */
  fit(): void {
    this.share = 1;
    this.place(null, false);
  }

  /** Looks from a direction, from a share of the distance from which the pot just fits. */
  look(direction: Direction, share: number, atOnce: boolean): void {
    this.share = share;
    this.place(direction, atOnce);
  }

  /** Where {@link look} would have to be told to look from, to see what is seen now. */
  get looking(): Direction & { readonly share: number } {
    const pose = this.camera.goal;
    const aspect = this.size.height > 0 ? this.size.width / this.size.height : 1;
    return { azimuth: pose.azimuth, polar: pose.polar, share: pose.distance / this.reach(pose, aspect, this.left) };
  }

  /** Goes round the pot by itself, so many radians a second, until it is told 0; never where motion is reduced. */
  spin(rate: number): void {
    if (this.rate === rate) return;
    this.rate = rate;
    this.changed();
  }

  /** Comes closer by a factor: 2 shows things twice as large. */
  zoom(factor: number): void {
    this.camera.zoom(factor);
    this.touched();
  }

  /** Turns the view by angles in radians; a positive polar angle goes downwards. */
  orbit(dAzimuth: number, dPolar: number): void {
    if (!Number.isFinite(dAzimuth + dPolar)) return;
    this.camera.orbit(dAzimuth, dPolar);
    this.touched();
  }

  /** Moves the picture right and down by CSS pixels. */
  pan(dx: number, dy: number): void {
    if (!Number.isFinite(dx + dy)) return;
    this.camera.pan(dx, dy, this.size.height);
    this.touched();
  }

  theme(theme: Theme): void {
    if (!this.differs("theme", theme)) return;
    this.tableau.theme = theme;
    this.overlay.appearance = theme;
  }

  /** What the dimension lines say. */
  measure(size: Size | null): void {
    if (this.differs("size", JSON.stringify(size))) this.overlay.measures = size;
  }

  /** Whether a hand changes what is on the stage: a fine frame that takes long is not drawn between two movements then, which it would hold up. */
  hold(held: boolean): void {
    if (this.rest.hold(held) && !held && this.loop.pending) this.loop.later(this.rest.delay);
  }

  /** How the dimension labels are written. */
  lengths(lengths: (length: number) => string): void {
    if (this.differs("lengths", lengths)) this.overlay.lengths = lengths;
  }

  reducedMotion(reduced: boolean): void {
    if (this.camera.reducedMotion === reduced) return;
    this.camera.reducedMotion = reduced;
    if (reduced) this.camera.settle();
    this.loop.invalidate();
  }

  /**
   * The picture as it is seen now, as a PNG of another size, without disturbing the screen. A fitted view is fitted to the picture; one that
   * was moved keeps its height.
   *
   * @throws {RangeError} for an impossible size
   * @throws {Error} while the graphics context is lost
   */
  async picture(width: number, height: number, options: { transparent?: boolean } = {}): Promise<Blob> {
    if (this.device.lost) throw new Error("the graphics context is lost; try again when it is back");
    return toPng(this.photograph(width, height, options.transparent ?? false));
  }

  /** The same at once, for what cannot wait (a page about to be printed); null while the graphics context is lost. */
  still(width: number, height: number, transparent = false): HTMLCanvasElement | null {
    return this.device.lost ? null : this.photograph(width, height, transparent);
  }

  /** Resolves when nothing more is to be drawn: at once at rest, and while the stage has no size. */
  whenIdle(): Promise<void> {
    if (this.size.width === 0 || this.size.height === 0) return Promise.resolve();
    return this.loop.whenIdle();
  }

  dispose(): void {
    if (this.disposed) return;
    this.disposed = true;
    this.resizes.disconnect();
    this.listeners.abort();
    this.gesture.dispose();
    this.loop.dispose();
    this.overlay.dispose();
    this.guest?.dispose();
    this.forgetDevice();
    for (const tenant of this.tenants()) this.device.dismiss(tenant);
    this.pane.dispose();
    this.device.leave();
    this.root.remove();
  }

  /** What has something on the GPU. */
  private tenants(): readonly Tenant[] {
    return [
      this.tableau,
      this.overlay,
      this.stopwatch,
      this.picker,
      ...this.tools,
      ...(this.guest ? [this.guest] : []),
    ];
  }

  /** Turns the pot by CSS pixels, right and down, as a drag does. */
  turnByPixels(dx: number, dy: number): void {
    const rate = TURN_PER_HEIGHT / Math.max(this.size.height, 200);
    this.orbit(-dx * rate, -dy * rate);
  }

  private touched(): void {
    this.fitted = false;
    this.followed = 0;
    this.changed();
  }

  /** All at once: between two frames of the screen, which share the scene. */
  private photograph(width: number, height: number, transparent: boolean): HTMLCanvasElement {
    const { tableau, overlay } = this;
    const aspect = width / height;
    const camera = new Camera();
    const pose = this.camera.pose;
    camera.radius = tableau.frame.radius;
    if (this.fitted && (this.spinning || !this.camera.moving)) pose.distance = this.share * this.reach(pose, aspect);
    camera.travel(pose, true);
    this.prepare(camera, aspect);
    tableau.shade(this.device, this.guest?.cutPlane.value);
    const scale = height / Math.max(this.size.height, 1);
    tableau.cutOut = transparent;
    const shown = [this.mark, ...this.tools];
    for (const each of shown) each.visible = false;
    try {
      const { drawables } = tableau.scene;
      const canvas = drawPicture(this.device, drawables, camera.view, width, height, (window) => {
        tableau.backdrop.window.value = [...window];
        overlay.scale(window[2] * width, window[3] * height, scale);
      });
      const paper = canvas.getContext("2d");
      if (paper) overlay.paint(paper, camera.view, width, height, scale);
      return canvas;
    } finally {
      tableau.cutOut = false;
      for (const each of shown) each.visible = true;
      tableau.backdrop.window.value = [0, 0, 1, 1];
    }
  }

  /** The distance from which everything is seen, looking at a point in a direction. */
  private reach(pose: Omit<CameraPose, "distance">, aspect: number, upright = FIT_MARGIN_UPRIGHT): number {
    const { frame, main } = this.tableau;
    const points = this.tableau.outline();
    if (main.bounds) points.push(...this.overlay.outline(main.bounds, pose.azimuth));
    const distance = fitDistance(points, pose.target, axesOf(pose.azimuth, pose.polar), aspect, true, upright);
    return distance > 0 ? distance : frame.radius;
  }

  /** What a fitted view leaves free above and below, as a factor: as much on both sides as the caption takes on one. */
  private room(): number {
    const { caption } = this;
    const { height } = this.size;
    if (!caption || height === 0) return FIT_MARGIN_UPRIGHT;
    const taken = CAPTION_GAP + (caption.top + caption.bottom > height ? height - caption.top : caption.bottom);
    return Math.max(FIT_MARGIN_UPRIGHT, height / Math.max(height - 2 * taken, height / MOST_ROOM));
  }

  /** Whether a setting is another one than before, which takes a new frame: pages set them again and again. */
  private differs(name: string, value: unknown): boolean {
    if (this.settings.get(name) === value) return false;
    this.settings.set(name, value);
    this.changed();
    return true;
  }

  /** Something is different: a quick frame now, a fine one when all is quiet. */
  private changed(): void {
    this.movedAt = performance.now();
    this.hurried = true;
    this.loop.invalidate();
  }

  private get spinning(): boolean {
    return this.rate !== 0 && !this.camera.reducedMotion;
  }

  /** Looks at everything from a direction, or from the present one. */
  private place(towards: Direction | null, atOnce: boolean): void {
    const bounds = this.tableau.seen;
    if (!bounds) return;
    const radius = bounds.radius > 0 ? bounds.radius : 1;
    this.tableau.reframe({ centre: bounds.centre, radius });
    this.camera.radius = radius;
    const { azimuth, polar } = towards ?? this.camera.goal;
    const aspect = this.size.height > 0 ? this.size.width / this.size.height : 1;
    const direction = { azimuth, polar, target: bounds.centre };
    this.left = this.room();
    this.camera.travel({ ...direction, distance: this.share * this.reach(direction, aspect, this.left) }, atOnce);
    this.fitted = true;
    this.followed = 0;
    this.loop.invalidate();
  }

  /** The pixels of the screen change when the window moves to another one, without a change of size. */
  private watchPixels(): void {
    if (this.disposed) return;
    const now = matchMedia(`(resolution: ${globalThis.devicePixelRatio || 1}dppx)`);
    now.addEventListener(
      "change",
      () => {
        this.loop.invalidate();
        this.watchPixels();
      },
      { once: true, signal: this.listeners.signal },
    );
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.root;
    if (width === this.size.width && height === this.size.height) return;
    this.size.width = width;
    this.size.height = height;
    if (width === 0 || height === 0) {
      this.loop.pause();
      return;
    }
    if (!this.device.lost) this.loop.resume();
    if (this.fitted && (this.spinning || !this.camera.moving)) this.place(null, true);
    this.loop.invalidate();
  }

  private prepare(camera: Camera, aspect: number): void {
    this.tableau.prepare(this.device);
    const { azimuth } = camera.pose;
    this.overlay.prepare(this.tableau.main, [Math.cos(azimuth), Math.sin(azimuth)]);
    this.mark.update(
      this.tableau.main,
      this.model.parts.flatMap(({ id }, place) => (this.selected.includes(id) ? [place] : [])),
    );
    this.tableau.light(camera, aspect);
    this.tableau.backdrop.aspect.value = aspect;
  }

  /** Tells where the camera came to rest, when that is somewhere else. */
  private tell(): void {
    const pose = this.camera.pose;
    const key = [pose.azimuth, pose.polar, pose.distance, ...pose.target].join();
    if (key === this.told) return;
    this.told = key;
    this.options.onCamera?.(pose);
  }

  private draw(seconds: number): boolean {
    const { width, height } = this.size;
    // The browser takes the context before it says so.
    if (width === 0 || height === 0 || this.device.gl.isContextLost()) return false;
    // After a rest no time has passed, and of a page that was hidden too much.
    if (this.spinning && !this.gesturing) this.camera.orbit(this.rate * Math.min(seconds, LONGEST_STEP), 0);
    const moving = this.camera.step(seconds) || this.spinning;
    const now = performance.now();
    if (moving || this.gesturing || this.hurried) this.movedAt = now;
    this.hurried = false;
    const busy = now - this.movedAt < this.rest.delay;
    if (busy && seconds > 0) this.resolution.learn(seconds * 1000);
    this.prepare(this.camera, width / height);
    const fineness = this.resolution.next(globalThis.devicePixelRatio || 1, busy);
    const [columns, rows] = [Math.floor(width * fineness.ratio), Math.floor(height * fineness.ratio)];
    this.overlay.scale(columns, rows, fineness.ratio);
    this.overlay.label(this.camera.view, width, height);
    this.guest?.prepare(this.camera, width, height);
    for (const tool of this.tools) tool.prepare(this.camera, width, height);
    this.overlay.cut.value = this.guest?.cutPlane.value ?? WHOLE;
    this.tableau.shade(this.device, this.guest?.cutPlane.value);
    this.pane.draw(columns, rows, fineness.samples, () =>
      draw(this.device, this.tableau.scene.drawables, this.camera.view),
    );
    this.drawn++;
    // A frame after a rest says nothing by its distance from the one before: its own cost is taken.
    if (busy && seconds === 0) {
      this.stopwatch.measure(now, (milliseconds) => {
        this.resolution.learn(milliseconds);
        this.options.onCost?.(milliseconds, this.resolution.coarsest);
      });
    }
    const timed = !busy && this.stopwatch.measure(now, (milliseconds) => this.rest.took(milliseconds));
    // Of one that takes too long nothing is told.
    if (timed) this.rest.took(LONGEST);
    this.options.onDrawn?.();
    if (!moving) this.tell();
    // What was drawn in haste is drawn again once all is quiet.
    if (busy && !this.gesturing) this.loop.later(this.rest.delay);
    return moving;
  }
}

/** Whether the same parts are seen, and fill the same box. */
function fillsTheSame(one: StageModel, other: StageModel): boolean {
  const [a, b] = [one.bounds, other.bounds];
  const alike = (axis: 0 | 1 | 2) => a?.min[axis] === b?.min[axis] && a?.max[axis] === b?.max[axis];
  const same = (part: StagePart, place: number) =>
    part.id === other.parts[place]?.id && part.hidden === other.parts[place]?.hidden;
  return (
    a?.radius === b?.radius &&
    alike(0) &&
    alike(1) &&
    alike(2) &&
    one.parts.length === other.parts.length &&
    one.parts.every(same)
  );
}
