import { Damper } from "./damper";
import { View } from "./gl/view";
import type { Bounds } from "./mesh";
import { axesOf, type CameraPose, clipPlanes, eyeOf, FIELD_OF_VIEW, nearestTurn } from "./pose";
import { along, type Triple } from "./triple";

/** Time constants in seconds: a drag is followed closely, a change of view is seen as a movement. */
const FOLLOW_LAG = 0.045;
const TRAVEL_LAG = 0.11;

/** How far from the pot, in its radii, the camera may be. */
const NEAREST = 0.05;
const FARTHEST = 60;

/** What is left of a motion when it ends: a tenth of a pixel on a large screen. */
const SETTLED_ANGLE = 2e-4;
const SETTLED_SHARE = 2e-4;

/**
 * The camera of the stage: a pose that follows its goal, in model units, and the view from there in scene space, where the model is moved by `-centre` and
 * divided by `radius`.
 */
export class Camera {
  readonly view = new View();
  reducedMotion = false;
  private readonly azimuth = new Damper(0, SETTLED_ANGLE, FOLLOW_LAG);
  private readonly polar = new Damper(0, SETTLED_ANGLE, FOLLOW_LAG);
  /** The logarithm of the distance: zooming feels the same near and far. */
  private readonly reach = new Damper(0, SETTLED_SHARE, FOLLOW_LAG);
  private readonly target = [0, 1, 2].map(() => new Damper(0, SETTLED_SHARE, FOLLOW_LAG)) as [Damper, Damper, Damper];
  private home = 1;

  get pose(): CameraPose {
    return {
      azimuth: this.azimuth.value,
      polar: this.polar.value,
      distance: Math.exp(this.reach.value),
      target: this.read("value"),
    };
  }

  /** Where the motion ends. */
  get goal(): CameraPose {
    return {
      azimuth: this.azimuth.goal,
      polar: this.polar.goal,
      distance: Math.exp(this.reach.goal),
      target: this.read("goal"),
    };
  }

  get moving(): boolean {
    return this.dampers().some((damper) => damper.moving);
  }

  /** The size of what is looked at, in model units: it bounds the zoom and says what counts as settled. */
  set radius(radius: number) {
    this.home = radius;
    for (const damper of this.target) damper.settle = radius * SETTLED_SHARE;
  }

  /** Travels to a pose, by the short way round; at once when asked or when motion is reduced. */
  travel(pose: CameraPose, atOnce = false): void {
    this.lag = TRAVEL_LAG;
    this.azimuth.goal = nearestTurn(pose.azimuth, this.azimuth.value);
    this.polar.goal = Math.min(Math.max(pose.polar, 0), Math.PI);
    this.reach.goal = this.bounded(Math.log(pose.distance));
    this.target.forEach((damper, axis) => {
      damper.goal = pose.target[axis] as number;
    });
    this.finish(atOnce);
  }

  orbit(azimuth: number, polar: number): void {
    this.lag = FOLLOW_LAG;
    this.azimuth.goal += azimuth;
    this.polar.goal = Math.min(Math.max(this.polar.goal + polar, 0), Math.PI);
    this.finish(false);
  }

  /** Comes closer by a factor (2 shows things twice as large). */
  zoom(factor: number): void {
    if (!(factor > 0 && Number.isFinite(factor))) return;
    this.lag = FOLLOW_LAG;
    this.reach.goal = this.bounded(this.reach.goal - Math.log(factor));
    this.finish(false);
  }

  /** Moves the picture by CSS pixels, right and down, in a view that is `height` pixels high. */
  pan(dx: number, dy: number, height: number): void {
    if (!(height > 0)) return;
    this.lag = FOLLOW_LAG;
    const { right, up } = axesOf(this.azimuth.goal, this.polar.goal);
    const unit = (2 * Math.exp(this.reach.goal) * Math.tan(FIELD_OF_VIEW / 2)) / height;
    const to = along(along(this.read("goal"), right, -dx * unit), up, dy * unit);
    this.target.forEach((damper, axis) => {
      damper.goal = to[axis] as number;
    });
    this.finish(false);
  }

  step(seconds: number): boolean {
    let moving = false;
    for (const damper of this.dampers()) moving = damper.step(seconds) || moving;
    return moving;
  }

  /** Ends all motion where it was going. */
  settle(): void {
    for (const damper of this.dampers()) damper.jump(damper.goal);
  }

  /** Sets the view for a frame of reference (model to scene) and what it has to show (in scene space). */
  aim(centre: Triple, radius: number, aspect: number, contents: Pick<Bounds, "centre" | "radius">): void {
    const pose = this.pose;
    const { right, up, back } = axesOf(pose.azimuth, pose.polar);
    const eye = along([0, 0, 0], along(eyeOf(pose), centre, -1), 1 / radius);
    const { near, far } = clipPlanes(eye, contents);
    this.view.look(eye, right, up, back);
    this.view.focus(FIELD_OF_VIEW, aspect, near, far);
  }

  private set lag(seconds: number) {
    for (const damper of this.dampers()) damper.lag = seconds;
  }

  private finish(atOnce: boolean): void {
    if (atOnce || this.reducedMotion) this.settle();
  }

  private bounded(reach: number): number {
    return Math.min(Math.max(reach, Math.log(this.home * NEAREST)), Math.log(this.home * FARTHEST));
  }

  private read(which: "value" | "goal"): Triple {
    const [x, y, z] = this.target;
    return [x[which], y[which], z[which]];
  }

  private dampers(): Damper[] {
    return [this.azimuth, this.polar, this.reach, ...this.target];
  }
}
