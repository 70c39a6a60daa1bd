/** What the inside of a solid can be cut into for programs of analysis, and what they read. */

export const CELLS_FORMATS = ["vtu", "msh", "inp"] as const;
export type CellsFormat = (typeof CELLS_FORMATS)[number];

export const CELL_SHAPES = ["hexahedron", "tetrahedron"] as const;
export type CellShape = (typeof CELL_SHAPES)[number];
