// The interface of `pasu/drawing`: what it takes to draw a design, without what it takes to make it.

import type { DesignSource, Mesh, MeshOptions, Remesh } from "./pasu.js";

export type * from "./design.js";
export type {
  Derivatives,
  DesignSource,
  Followed,
  Mesh,
  MeshOptions,
  Moved,
  PasuErrorArgs,
  PasuErrorCode,
  Point,
  Remesh,
} from "./pasu.js";
export {
  bound,
  convert,
  default,
  derivatives,
  evaluate,
  fingerprint,
  follow,
  handles,
  link,
  PasuError,
  parse,
} from "./pasu.js";

/**
 * Loads the whole module in place of the small one, once; everything else stays as it is. The small one knows what has two ends and goes round an axis, and
 * refuses a network of frames, a blend or an octant with the code `unsupported-shape` and `args.what` `"left-out"`: then widen, and ask again.
 * `source` says where that module is, if not beside this file.
 */
export function widen(source?: string | URL): Promise<void>;

/** As that of `pasu`, but for `progress`, which this module does not tell. */
export function mesh(source: DesignSource, options?: MeshOptions & { into?: undefined }): Mesh;
export function mesh(source: DesignSource, options: MeshOptions & { into: Partial<Mesh> }): Remesh;
