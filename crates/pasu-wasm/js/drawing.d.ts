// The interface of `pasu/drawing`: what it takes to draw a design, without what it takes to make it.

export type * from "./design.js";
export type {
  Derivatives,
  DesignSource,
  Mesh,
  MeshOptions,
  PasuErrorArgs,
  PasuErrorCode,
  Point,
  Remesh,
} from "./pasu.js";
export { bound, default, derivatives, evaluate, fingerprint, link, mesh, PasuError, parse } from "./pasu.js";
