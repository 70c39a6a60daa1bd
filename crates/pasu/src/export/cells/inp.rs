//! Abaqus: nodes and elements, counted from 1.

use core::fmt::Write;

use super::listed::{corners, points};
use crate::design::plain;
use crate::interior::Cells;

/// A line is no longer than a reader takes.
const LINE: usize = 70;

pub(super) fn write(cells: &Cells, title: &str) -> String {
    // A title must not begin as a keyword does.
    let title: String = title.chars().filter(char::is_ascii).filter(|c| !c.is_control()).take(LINE).collect();
    let mut text = format!("*HEADING\nPasu, millimetres: {title}\n*NODE\n");
    // A String takes whatever is written to it.
    for (index, point) in points(cells).enumerate() {
        let numbers: Vec<String> = point.iter().map(|x| plain(*x)).collect();
        let _ = writeln!(text, "{}, {}", index + 1, numbers.join(", "));
    }
    let _ = writeln!(text, "*ELEMENT, TYPE=C3D{}, ELSET=SOLID", cells.shape.n_corners());
    for (index, cell) in corners(cells).enumerate() {
        let numbers: Vec<String> = cell.iter().map(|corner| (corner + 1).to_string()).collect();
        let _ = writeln!(text, "{}, {}", index + 1, numbers.join(", "));
    }
    text
}
