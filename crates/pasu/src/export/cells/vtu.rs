//! VTK's XML of an unstructured grid.

use core::fmt::Write;

use super::listed::{corners, points};
use crate::design::plain;
use crate::interior::{CellShape, Cells};

pub(super) fn write(cells: &Cells) -> String {
    // The numbers that VTK has for them.
    let kind = match cells.shape {
        CellShape::Hexahedron => 12,
        CellShape::Tetrahedron => 10,
    };
    let mut text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        cells.n_points(),
        cells.n_cells()
    );
    let mut array = |name: &str, kind: &str, more: &str, lines: &mut dyn Iterator<Item = String>| {
        // A String takes whatever is written to it.
        let _ = writeln!(text, "<DataArray type=\"{kind}\" Name=\"{name}\"{more} format=\"ascii\">");
        lines.for_each(|line| {
            let _ = writeln!(text, "{line}");
        });
        text.push_str("</DataArray>\n");
        if name == "points" {
            text.push_str("</Points>\n<Cells>\n");
        } else if name == "types" {
            text.push_str("</Cells>\n<CellData Scalars=\"scaled_jacobian\">\n");
        }
    };
    let joined = |numbers: &mut dyn Iterator<Item = String>| numbers.collect::<Vec<String>>().join(" ");
    let n = cells.shape.n_corners();
    let lines = &mut points(cells).map(|point| joined(&mut point.iter().map(|x| plain(*x))));
    array("points", "Float64", " NumberOfComponents=\"3\"", lines);
    let lines = &mut corners(cells).map(|cell| joined(&mut cell.iter().map(u32::to_string)));
    array("connectivity", "Int64", "", lines);
    array("offsets", "Int64", "", &mut (1..=cells.n_cells()).map(|cell| (n * cell).to_string()));
    array("types", "UInt8", "", &mut (0..cells.n_cells()).map(|_| kind.to_string()));
    array("scaled_jacobian", "Float64", "", &mut cells.quality.iter().map(|quality| plain(*quality)));
    text.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    text.replacen("<DataArray", "<Points>\n<DataArray", 1)
}
