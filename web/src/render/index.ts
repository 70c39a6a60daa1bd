/** The 3D view, and the only part of the designer that knows three.js. */
export { CLAY_NAMES, type ClayName } from "./clay";
export { GLAZE_NAMES, type GlazeName, type StageLook } from "./glaze";
export { lengthText, type Unit } from "./length";
export type { StageMesh } from "./mesh";
export type { StageLines, StageOverlays } from "./overlay/overlays";
export type { CameraPose, ViewName } from "./pose";
export { Stage, type StageOptions } from "./stage";
export type { Theme } from "./studio";
export { type Thumbnails, thumbnails } from "./thumbnail";
