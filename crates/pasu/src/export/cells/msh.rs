//! Gmsh's text, version 2.2, which every reader knows.

use core::fmt::Write;

use super::listed::{corners, points};
use crate::design::plain;
use crate::interior::{CellShape, Cells};

pub(super) fn write(cells: &Cells) -> String {
    // The numbers that Gmsh has for them.
    let kind = match cells.shape {
        CellShape::Hexahedron => 5,
        CellShape::Tetrahedron => 4,
    };
    let mut text = format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", cells.n_points());
    // A String takes whatever is written to it.
    for (index, point) in points(cells).enumerate() {
        let numbers: Vec<String> = point.iter().map(|x| plain(*x)).collect();
        let _ = writeln!(text, "{} {}", index + 1, numbers.join(" "));
    }
    let _ = write!(text, "$EndNodes\n$Elements\n{}\n", cells.n_cells());
    for (index, cell) in corners(cells).enumerate() {
        let numbers: Vec<String> = cell.iter().map(|corner| (corner + 1).to_string()).collect();
        let _ = writeln!(text, "{} {kind} 2 1 1 {}", index + 1, numbers.join(" "));
    }
    let _ = write!(text, "$EndElements\n$ElementData\n1\n\"scaled_jacobian\"\n1\n0\n3\n0\n1\n{}\n", cells.n_cells());
    for (index, quality) in cells.quality.iter().enumerate() {
        let _ = writeln!(text, "{} {}", index + 1, plain(*quality));
    }
    text.push_str("$EndElementData\n");
    text
}
