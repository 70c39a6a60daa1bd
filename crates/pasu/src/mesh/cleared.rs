//! Grids of patches without lines that lie too near to each other for single precision.
//!
//! At the tip of an octant of other exponents in each direction a row is as long as the one before and a millionth as wide. Along the axes that is no harm, because zero is held exactly; of a turned one the triangles would be folded by rounding.

use glam::DVec3;

use super::sewn::sewn;
use crate::patch::Lines;
use crate::solution::Placed;
use crate::watch;

/// A triangle whose corners are moved by half a unit in the last place keeps its side if it is so many times as high: two corners against one, and as much for its neighbour.
const SAFE: f64 = 8.0;

/// No more lines are taken away than this.
const MOST: usize = 64;

/// The lines that are left, and the distance by which rounding moves a point at most; `None` where none is in the way, and where some are that have to stay.
///
/// One after the other goes the line between the most triangles that are too narrow.
pub(super) fn cleared(placed: &Placed, lines: &[Lines]) -> Option<(Vec<Lines>, f64)> {
    let patches = placed.solved().patches();
    let mut lines = lines.to_vec();
    for round in 0..=MOST {
        if watch::is_stopped() {
            return None;
        }
        let (positions, triangles) = sewn(placed, &lines);
        watch::work(triangles.len() as u64);
        let largest = positions.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
        let rounding = 0.5 * f64::from(f32::EPSILON) * libm::sqrt(3.0) * largest;
        let narrow = triangles.iter().filter(|(corners, _)| {
            let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
            !(height(a, b, c) >= SAFE * rounding)
        });
        // How many there are between each line and the next.
        let mut between: Vec<[Vec<usize>; 2]> =
            lines.iter().map(|lines| [vec![0; lines.u.len()], vec![0; lines.v.len()]]).collect();
        for (_, (patch, cell)) in narrow {
            let columns = lines[*patch].v.len() - 1;
            between[*patch][0][cell / columns] += 1;
            between[*patch][1][cell % columns] += 1;
        }
        let counted = between.iter().enumerate().flat_map(|(patch, directions)| {
            let of = move |(direction, counts): (usize, &Vec<usize>)| {
                // With two lines there is none to be taken away.
                let most =
                    if counts.len() > 2 { counts.iter().copied().enumerate().max_by_key(|(_, n)| *n) } else { None };
                most.map(|(interval, n)| (n, patch, direction, interval))
            };
            directions.iter().enumerate().filter_map(of).collect::<Vec<_>>()
        });
        match counted.max_by_key(|(n, ..)| *n) {
            Some((n, patch, direction, interval)) if n > 0 && round < MOST => {
                let of = if direction == 0 { &lines[patch].u } else { &lines[patch].v };
                // That of its two lines which is nearer to the one beyond; the ends stay.
                let gap = |from: usize| of.get(from + 1).map_or(f64::INFINITY, |next| next - of[from]);
                let before = if interval > 0 { gap(interval - 1) } else { f64::INFINITY };
                let line = if before < gap(interval + 1) || interval + 2 == of.len() { interval } else { interval + 1 };
                let place = of[line];
                Lines::without(&patches, &mut lines, patch, direction, place);
            }
            Some((0, ..)) | None if round > 0 => return Some((lines, 2.0 * rounding)),
            _ => return None,
        }
    }
    None
}

/// The least height of a triangle.
fn height(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    (b - a).cross(c - a).length() / libm::sqrt(longest)
}
