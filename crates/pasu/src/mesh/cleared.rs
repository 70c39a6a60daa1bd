//! Grids of patches without lines that lie too near to each other for single precision.
//!
//! At the tip of an octant of other exponents in each direction a row is as long as the one before and a millionth as wide. Along the axes that is no harm, because zero is held exactly; of a turned one the triangles would be folded by rounding.

use glam::DVec3;

use super::sewn::sewn;
use crate::patch::{Lines, SAME_LINE};
use crate::solution::Placed;
use crate::watch;

/// A triangle whose corners are moved by half a unit in the last place keeps its side if it is so many times as high: two corners against one, and as much for its neighbour.
const SAFE: f64 = 8.0;

/// No more lines are taken away than this.
const MOST: usize = 64;

/// Of a mesh of more vertices none is: all of it is looked at again for each line, and nobody waits for that.
const MOST_VERTICES: usize = 1 << 16;

/// The lines that are left, and the distance by which rounding moves a point at most; `None` where none is in the way, and where some are that have to stay.
///
/// One after the other goes the line between the most triangles that are too narrow.
pub(super) fn cleared(placed: &Placed, lines: &[Lines]) -> Option<(Vec<Lines>, f64)> {
    let patches = placed.solved().patches();
    if lines.iter().map(Lines::n_vertices).sum::<usize>() > MOST_VERTICES {
        return None;
    }
    // What is smooth between two of these is not across one, where no bound of a cell would hold.
    let knots = Lines::pieces_of(&patches, 1);
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
        // Of the two lines on both sides of an interval that which is nearer to the one beyond; the ends and the knots stay.
        let removable = |patch: usize, direction: usize, interval: usize| {
            let of = |lines: &Lines| if direction == 0 { lines.u.clone() } else { lines.v.clone() };
            let (own, knots) = (of(&lines[patch]), of(&knots[patch]));
            let stays = |place: f64| knots.iter().any(|knot| (knot - place).abs() <= SAME_LINE);
            let gap = |from: usize, to: usize| own.get(to).map_or(f64::INFINITY, |next| next - own[from]);
            let before = (interval > 0).then(|| (gap(interval - 1, interval), own[interval]));
            let after = own.get(interval + 1).map(|place| (gap(interval + 1, interval + 2), *place));
            let both = [after, before].into_iter().flatten().filter(|(_, place)| !stays(*place));
            both.min_by(|one, other| one.0.total_cmp(&other.0)).map(|(_, place)| place)
        };
        let mut most: Option<(usize, usize, usize, f64)> = None;
        let mut is_clear = true;
        for (patch, directions) in between.iter().enumerate() {
            for (direction, counts) in directions.iter().enumerate() {
                for (interval, n) in counts.iter().copied().enumerate().filter(|(_, n)| *n > 0) {
                    is_clear = false;
                    if most.is_none_or(|(most, ..)| n > most)
                        && let Some(place) = removable(patch, direction, interval)
                    {
                        most = Some((n, patch, direction, place));
                    }
                }
            }
        }
        match most {
            Some((_, patch, direction, place)) if round < MOST => {
                Lines::without(&patches, &mut lines, patch, direction, place);
            }
            None if is_clear && round > 0 => return Some((lines, 2.0 * rounding)),
            _ => return None,
        }
    }
    None
}

/// The least height of a triangle.
pub(crate) fn height(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    (b - a).cross(c - a).length() / libm::sqrt(longest)
}
