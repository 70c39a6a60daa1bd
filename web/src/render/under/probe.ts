import type { Camera } from "../camera";
import type { Drawable } from "../gl/drawable";
import { axesOf, type CameraPose, eyeOf, FIELD_OF_VIEW } from "../pose";
import type { Bench, Tool } from "../stage";
import { along, dot, type Triple } from "../triple";

/** From the eye through a point of the screen, in model units. */
export interface Ray {
  readonly origin: Triple;
  /** A unit vector. */
  readonly direction: Triple;
}

/** The ray that is seen at a point of a screen, in pixels from its upper left, from where a camera is: exact, not by the numbers of a graphics card. */
export function rayAt(pose: CameraPose, [width, height]: readonly [number, number], x: number, y: number): Ray {
  const { right, up, back } = axesOf(pose.azimuth, pose.polar);
  const unit = (2 * Math.tan(FIELD_OF_VIEW / 2)) / height;
  const aside = along(along([0, 0, 0], right, unit * (x - width / 2)), up, unit * (height / 2 - y));
  const towards = along(aside, back, -1);
  return { origin: eyeOf(pose), direction: along([0, 0, 0], towards, 1 / Math.hypot(...towards)) };
}

/** Says along which ray the eye looks, and what is cut away. It draws nothing. */
export class Probe implements Tool {
  visible = true;
  readonly drawables: readonly Drawable[] = [];

  constructor(private readonly bench: Bench) {}

  /** Null while nothing can be seen. */
  ray(x: number, y: number): Ray | null {
    const screen = this.bench.aim();
    return screen && rayAt(this.bench.camera.pose, screen, x, y);
  }

  /** Whether a point of a part is before the plane that cuts this open, where nothing is drawn. */
  isCut(part: number, point: Triple): boolean {
    const { pot, cut } = this.bench;
    const [nx = 0, ny = 0, nz = 0, w = 1] = pot.parts[part]?.cut.value ?? cut();
    const [cx = 0, cy = 0, cz = 0, scale = 1] = this.bench.studio.frame.value;
    return dot([scale * (point[0] - cx), scale * (point[1] - cy), scale * (point[2] - cz)], [nx, ny, nz]) > w;
  }

  prepare(_camera: Camera): void {}

  release(): void {}
}
