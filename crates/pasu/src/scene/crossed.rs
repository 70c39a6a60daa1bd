//! Where the borders of two parts go through each other, and a place beside it that is deep.
//!
//! On one side of the curve in which two borders cross each of them is beneath the other. So little beside a place of that curve there is one that is deep in the other part, however thin that is: few are asked for what pairs of tiles find only once they are as small as a wall is thick.

use glam::{DMat3, DVec2, DVec3};

use super::bounds::Bounds;
use super::boxes::Within;
use super::budget::Budget;
use super::space::Space;
use super::tile::Tile;

/// The most pairs of boxes that are held against each other,
const MOST: u64 = 4096;

/// of which so many count for as much as a pair of tiles.
const BOXES: u64 = 96;

/// The most places of the curve that are tried,
const MOST_PLACES: usize = 6;

/// no nearer to each other than this part of the smaller part.
const APART: f64 = 1.0 / 16.0;

/// What one of them counts for, in pairs of tiles.
const PLACE: u64 = 4;

/// How deep a place beside the curve is to be, as parts of the smaller part: through a thin wall the first goes too far.
const BESIDE: [f64; 3] = [1.0 / 256.0, 1.0 / 1024.0, 1.0 / 4096.0];

/// Steps towards a place that both borders have.
const STEPS: usize = 12;

/// Both borders have a place where they are no further apart than this part of the smaller part.
const MET: f64 = 1e-9;

/// Borders that meet at an angle whose sine is less than this touch.
const TOUCHING: f64 = 1e-2;

impl Space {
    /// A place of one of two parts that is deeper in the other than the slack, and how deep at least, where their borders are seen to go through each other. `None` where no such was found.
    pub(super) fn crossed(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<(DVec3, f64)> {
        let [one, another] = [self, other].map(Space::tiles);
        let mut open: Vec<[u32; 2]> =
            one.boxes.root().zip(another.boxes.root()).map(|(p, q)| [p, q]).into_iter().collect();
        let apart = APART * self.size().min(other.size());
        let mut places: Vec<DVec3> = Vec::new();
        let mut n_seen = 0;
        while let Some([p, q]) = open.pop() {
            n_seen += 1;
            let is_paid = n_seen % BOXES != 0 || budget.take(1);
            if n_seen > MOST || places.len() == MOST_PLACES || !is_paid {
                return None;
            }
            let [of_p, of_q] = [one.boxes.bounds(p), another.boxes.bounds(q)];
            if of_p.distance(&of_q) > 0.0 {
                continue;
            }
            let things = [one.boxes.within(p), another.boxes.within(q)];
            if let [Within::Thing(i), Within::Thing(j)] = things {
                let tiles = [&one.all[i], &another.all[j]];
                let is_new = |at: &DVec3| places.iter().all(|known| (*known - at).length() > apart);
                let Some(at) = pierced(tiles).filter(is_new) else { continue };
                places.push(at);
                if !budget.take(PLACE) {
                    return None;
                }
                if let Some(deep) = self.beside(other, tiles, slack, budget) {
                    return Some(deep);
                }
                continue;
            }
            // The larger one is taken apart; what has more in common with the other is last, and comes next.
            let is_first = of_p.size() >= of_q.size();
            let mut next = match things {
                [Within::Halves(halves), of] if is_first || matches!(of, Within::Thing(_)) => {
                    halves.map(|half| [half, q])
                }
                [_, Within::Halves(halves)] => halves.map(|half| [p, half]),
                _ => continue,
            };
            let common = |[p, q]: [u32; 2]| {
                let Bounds { low, high } = one.boxes.bounds(p).common(&another.boxes.bounds(q));
                (high - low).max(DVec3::ZERO).length()
            };
            if common(next[0]) > common(next[1]) {
                next.reverse();
            }
            open.extend(next);
        }
        None
    }

    /// A deep place beside one that two tiles have, which is sought.
    fn beside(&self, other: &Space, tiles: [&Tile; 2], slack: f64, budget: &mut Budget) -> Option<(DVec3, f64)> {
        let size = self.size().min(other.size());
        let at = self.met(other, tiles, MET * size)?;
        let borders = [&self.borders[tiles[0].border], &other.borders[tiles[1].border]];
        let normals = [0, 1].map(|k| borders[k].normal(at[k].x, at[k].y));
        let [one, another] = normals;
        let sine = one.cross(another).length();
        if !(sine > TOUCHING) {
            return None;
        }
        // What is no deeper than the slack tells nothing.
        for depth in BESIDE.map(|share| (share * size).max(2.0 * slack)) {
            for (k, outer) in [(0, other), (1, self)] {
                if !outer.is_solid {
                    continue;
                }
                // Along this border, away from where the other one faces.
                let (own, facing) = (normals[k], normals[1 - k]);
                let way = (own * own.dot(facing) - facing) / sine * (depth / sine);
                let beside = at[k] + borders[k].jet(at[k].x, at[k].y).towards(way);
                if !beside.is_finite() {
                    return None;
                }
                let beside = beside.clamp(DVec2::ZERO, DVec2::ONE);
                if !budget.take(outer.asked_for()) {
                    return None;
                }
                let place = borders[k].position(beside.x, beside.y);
                if let Some(depth) = outer.depth_beyond(place, slack, budget) {
                    return Some((place, depth));
                }
            }
        }
        None
    }

    /// The parameters of a place that both borders have, from the middles of two tiles on: by Newton's steps, each the shortest of those that would bring both together if they were flat.
    fn met(&self, other: &Space, tiles: [&Tile; 2], enough: f64) -> Option<[DVec2; 2]> {
        let borders = [&self.borders[tiles[0].border], &other.borders[tiles[1].border]];
        let lengths = tiles.map(|tile| DVec2::from_array(tile.cell.lengths()));
        let mut at = tiles.map(|tile| DVec2::from_array(tile.middle()));
        for _ in 0..STEPS {
            let jets = [0, 1].map(|k| borders[k].jet(at[k].x, at[k].y));
            let apart = jets[1].position - jets[0].position;
            if apart.length() <= enough {
                return Some(at);
            }
            let columns = [0, 1].map(|k| {
                let sign = if k == 0 { 1.0 } else { -1.0 };
                [jets[k].du * (sign * lengths[k].x), jets[k].dv * (sign * lengths[k].y)]
            });
            let squares = columns.iter().flatten().fold(DMat3::ZERO, |sum, column| {
                sum + DMat3::from_cols(*column * column.x, *column * column.y, *column * column.z)
            });
            let towards = squares.inverse() * apart;
            for k in [0, 1] {
                let step = DVec2::new(columns[k][0].dot(towards), columns[k][1].dot(towards));
                // No further than to a neighbour at once.
                let step = step / step.abs().max_element().max(1.0);
                at[k] = (at[k] + step * lengths[k]).clamp(DVec2::ZERO, DVec2::ONE);
            }
            if !at.iter().all(|at| at.is_finite()) {
                return None;
            }
        }
        None
    }
}

/// Where the triangles of two tiles go through each other.
fn pierced(tiles: [&Tile; 2]) -> Option<DVec3> {
    let [one, other] = tiles.map(Tile::triangles);
    one.iter().find_map(|p| other.iter().find_map(|q| p.pierced(q).or_else(|| q.pierced(p))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::solution::Solution;

    /// Two pots with thin walls, the second moved by so much and turned.
    fn two(shift: [f64; 3], angle: f64, thickness: f64) -> Solution {
        let [x, y, z] = shift;
        let pot = |place: &str| {
            format!(
                r#"{{ "shape": {{ "kind": "second-order", "r": [8, 0.5, 5, 0.3], "height": 14 }}, "wall": {{ "thickness": {thickness}, "base": 0.5 }}{place} }}"#
            )
        };
        let place = format!(r#", "place": {{ "axis": [1, 2, 5], "angle": {angle}, "shift": [{x}, {y}, {z}] }}"#);
        let text = format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, pot(""), pot(&place));
        Solution::of(&Design::parse(&text).unwrap())
    }

    #[test]
    fn thin_walls_that_go_through_each_other_are_told_by_few_places() {
        let slack = 1e-5;
        let mut n_found = 0;
        for i in 0..60u8 {
            let turn = f64::from(i) * 2.4;
            let away = 2.0 + f64::from(i % 6);
            let shift = [away * libm::cos(turn), away * libm::sin(turn), f64::from(i % 5)];
            let solution = two(shift, f64::from(i % 4) * 0.2, if i % 2 == 0 { 0.4 } else { 0.1 });
            let [one, other] = [0, 1].map(|part| solution.in_space(part).unwrap());
            let mut budget = Budget::new(1000);
            let Some((at, depth)) = one.crossed(&other, slack, &mut budget) else { continue };
            n_found += 1;
            // It is a place of one, and at least so deep in the other.
            let away = [&one, &other].map(|space| space.nearest(at).distance);
            let k = usize::from(away[1] < away[0]);
            assert!(away[k] < 1e-8 && depth > slack && away[1 - k] >= depth * (1.0 - 1e-9), "{i} {away:?} {depth}");
            assert_eq!([&one, &other][1 - k].holds(at), Some(true), "{i}");
        }
        // The others are left to pairs of tiles.
        assert!(n_found >= 52, "{n_found}");
    }

    #[test]
    fn what_stands_apart_or_within_has_no_such_place() {
        let mut budget = Budget::new(1000);
        let apart = two([30.0, 3.0, 1.0], 0.4, 0.4);
        let [one, other] = [0, 1].map(|part| apart.in_space(part).unwrap());
        assert_eq!(one.crossed(&other, 1e-5, &mut budget), None);
        let ball = |scale: f64| {
            format!(
                r#"{{ "shape": {{ "kind": "blend", "start": {{ "form": "disc", "radius": [{scale}, {scale}], "z": {}, "taper": 0, "dz": 3 }}, "end": {{ "form": "disc", "radius": [{scale}, {scale}], "z": {}, "taper": 0, "dz": 3 }}, "method": "modal" }} }}"#,
                -scale, scale
            )
        };
        let within = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, ball(1.0), ball(3.0))).unwrap();
        let within = Solution::of(&within);
        let [one, other] = [0, 1].map(|part| within.in_space(part).unwrap());
        assert!(one.is_solid && other.is_solid && one.crossed(&other, 1e-5, &mut budget).is_none());
    }
}
