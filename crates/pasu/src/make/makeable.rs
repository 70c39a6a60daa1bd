//! What a maker can make: walls that are too thin and walls that hang over, by the way in which the pot is made.

use glam::DVec3;

use super::craft::Craft;
use super::made::Made;
use super::report::{Finding, Severity};
use crate::face::FaceKind;
use crate::solid::{place, short};

/// The degrees that a wall may lean out over what is below it and be printed without support.
const SUPPORTED: f64 = 45.0;

/// What leans out further is told where it is at least this part of its face.
const SHARE: f64 = 1e-3;

/// What stands in the way of making one part by a craft; `millimetres` is how many a model unit has. Where no craft is asked for it is that of a printer, and nothing is worse than a warning: not everything that is written is to be
/// printed.
pub(super) fn findings(made: &Made, craft: Option<Craft>, millimetres: f64) -> Vec<Finding> {
    let by = craft.unwrap_or(Craft::Print);
    let mut found = Vec::new();
    found.extend(too_thin(made, by, craft.is_some(), millimetres));
    if by == Craft::Print {
        let faces = [(FaceKind::Outer, "outside"), (FaceKind::Lining, "inside")];
        found.extend(faces.into_iter().filter_map(|(kind, side)| overhang(made, kind, side, millimetres)));
    }
    found
}

fn too_thin(made: &Made, craft: Craft, is_asked: bool, millimetres: f64) -> Option<Finding> {
    if !made.pot.has_wall() {
        return None;
    }
    let thinnest = made.pot.thickness().0 * millimetres;
    let [least, safe] = craft.thinnest();
    if !(thinnest < safe) {
        return None;
    }
    let at = made.pot.thinned().map(|(_, at)| at);
    let somewhere = at.map_or(String::new(), |at| format!(" at {}", place(at)));
    let why = match (craft, thinnest < least) {
        (Craft::Print, true) => {
            format!("a line of the usual nozzle is {least} mm wide, and what is thinner is not printed")
        }
        (Craft::Print, false) => format!("two lines of the usual nozzle are {safe} mm wide, and one breaks"),
        (Craft::Clay, true) => format!("clay of less than {least} mm does not stand"),
        (Craft::Clay, false) => format!("clay of less than {safe} mm warps and breaks"),
    };
    let severity = if is_asked && thinnest < least { Severity::Error } else { Severity::Warning };
    let message = format!("the wall is only {} mm thick{somewhere}: {why}", short(thinnest));
    let part = made.pot.part();
    Some(Finding { code: "too-thin", severity, part, message, at: at.map(|at| at.to_array()) })
}

/// The steepest of the triangles of one kind of face that lean out further than can be printed.
fn overhang(made: &Made, kind: FaceKind, side: &str, millimetres: f64) -> Option<Finding> {
    let mesh = &made.mesh;
    let point = |vertex: u32| {
        let from = 3 * vertex as usize;
        DVec3::from_array([0, 1, 2].map(|axis| f64::from(mesh.positions[from + axis])))
    };
    let (mut area, mut hanging, mut steepest) = (0.0, 0.0, (SUPPORTED, DVec3::ZERO));
    for &(_, first, count) in mesh.faces.iter().filter(|(of, ..)| *of == kind) {
        let indices = &mesh.indices[first as usize..(first + count) as usize];
        for &[a, b, c] in indices.as_chunks::<3>().0 {
            let [a, b, c] = [a, b, c].map(point);
            let normal = (b - a).cross(c - a);
            area += normal.length();
            let degrees = libm::atan2(-normal.z, libm::hypot(normal.x, normal.y)).to_degrees();
            if degrees > SUPPORTED {
                hanging += normal.length();
                if degrees > steepest.0 {
                    steepest = (degrees, (a + b + c) / (3.0 * millimetres));
                }
            }
        }
    }
    if !(hanging > SHARE * area) {
        return None;
    }
    let (degrees, at) = steepest;
    let message = format!(
        "the {side} hangs over by {} degrees at {}: printers need support beyond {SUPPORTED} degrees",
        libm::round(degrees),
        place(at)
    );
    let part = made.pot.part();
    Some(Finding { code: "overhang", severity: Severity::Note, part, message, at: Some(at.to_array()) })
}
