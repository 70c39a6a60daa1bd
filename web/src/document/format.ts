/** The files that a pot can be saved as. */

export type Format = "stl" | "3mf" | "glb" | "obj" | "ply" | "step" | "svg";

export const FORMAT_NAMES: readonly Format[] = ["3mf", "stl", "step", "svg", "glb", "obj", "ply"];
