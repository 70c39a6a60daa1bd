//! How high a part is and how wide its outside: of the faces, since a mesh has no vertex just where a rounded rim is highest.

use glam::DVec3;

use super::frame::Frame;
use crate::face::{Face, FaceKind};
use crate::numeric::grid::Grid;

/// Rows of the outside and of other faces, and columns of all, from which an extreme is sought.
const ROWS: [usize; 2] = [49, 9];
const COLUMNS: usize = 720;
/// Radii that differ by less, in millimetres, are one: where a wall is upright the lowest point counts, on every machine.
const SAME: f64 = 1e-6;

/// A point of the outside, by its distance from the axis and its height, in millimetres.
#[derive(Clone, Copy)]
pub(super) struct Farness {
    pub(super) radius: f64,
    pub(super) height: f64,
}

/// Heights are counted from the origin of the frame, in millimetres.
pub(super) struct Levels {
    /// The lowest and the highest point; 0 of a part without faces.
    pub(super) foot: f64,
    pub(super) top: f64,
    pub(super) farthest: Option<Farness>,
    pub(super) nearest: Option<Farness>,
}

impl Levels {
    pub(super) fn new(frame: &Frame, faces: &[&dyn Face], millimetres: f64) -> Levels {
        let mut levels = Levels { foot: f64::INFINITY, top: f64::NEG_INFINITY, farthest: None, nearest: None };
        // What is inside is neither higher nor lower than what is round it.
        for face in faces.iter().filter(|face| !matches!(face.kind(), FaceKind::Lining | FaceKind::Floor)) {
            let is_outside = face.kind() == FaceKind::Outer;
            let mut walk = face.walk();
            let mut at = |a: f64, v: f64| millimetres * walk.jet(a, v).position;
            let grid = Grid::new(ROWS[usize::from(!is_outside)], COLUMNS, &mut at);
            let mut most = |of: &dyn Fn(&DVec3) -> f64| {
                grid.greatest(of, &mut at).map(|place| (place.value, at(place.a, place.v)))
            };
            if let Some((low, _)) = most(&|p| -frame.height(*p)) {
                levels.foot = levels.foot.min(-low);
            }
            if let Some((high, _)) = most(&|p| frame.height(*p)) {
                levels.top = levels.top.max(high);
            }
            if !is_outside {
                continue;
            }
            for (sign, found) in [(1.0, &mut levels.farthest), (-1.0, &mut levels.nearest)] {
                let radius = |p: &DVec3| sign * frame.above(*p).length();
                let Some((value, point)) = most(&radius) else { continue };
                let height = grid.points().iter().filter(|p| radius(p) > value - SAME).map(|p| frame.height(*p));
                let height = height.fold(frame.height(point), f64::min);
                if found.is_none_or(|found| value > sign * found.radius) {
                    *found = Some(Farness { radius: sign * value, height });
                }
            }
        }
        if levels.top < levels.foot {
            (levels.foot, levels.top) = (0.0, 0.0);
        }
        levels
    }
}
