//! What a part is before it is turned and moved, found once for all parts that differ in nothing else.

use std::sync::Arc;

use glam::DVec3;

use super::border::Border;
use super::bounds::Bounds;
use super::budget::Budget;
use super::isometry::Isometry;
use super::space::{Space, Tiles, tiled};
use super::tile::Tile;
use crate::design::{Part, Unit, Wall, written};
use crate::error::Result;
use crate::solid::Product;
use crate::solution::{Newest, Solution, Upright};
use crate::watch;

/// The most tiles by which a surface is enclosed where its body may not be wanted: a quarter of those that a body has.
const FEW_TILES: usize = 128;

/// The box is wider than the surface by no more than this part of its size along each axis, unless that takes too many steps.
const CLOSE: f64 = 1.0 / 64.0;

/// The most steps towards how far a surface reaches in one direction.
const MOST_STEPS: u64 = 200;

/// So many times what a wall measures it is taken to reach. No face goes further than once.
const MARGIN: f64 = 1.25;

/// Surfaces beyond this, and those smaller than its inverse, have their bodies found at once, so that what cannot be computed with is refused whatever is asked.
const LARGE: f64 = 1e50;

/// A part by itself, scaled, but neither turned nor moved.
#[derive(Debug)]
pub(super) struct Still {
    solution: Solution,
    /// The surface of a part with a wall.
    surface: Vec<Tile>,
    /// As [`Still::reach`].
    reach: Option<Bounds>,
}

/// Parts by themselves, by what they are, in a unit: whether a ring has room is judged in millimetres.
struct Stills {
    unit: Unit,
    /// As many as a scene has parts.
    known: Newest<Part, Arc<Still>>,
}

impl Still {
    fn new(solution: Solution) -> Result<Still> {
        let (placed, (_, part)) = (solution.part(0)?, solution.existing(0)?);
        let borders = Border::patches(placed);
        let surface = part.wall.map(|_| tiled(&borders, FEW_TILES)).unwrap_or_default();
        let reach = part.wall.and_then(|wall| reach(&solution, &wall, &borders, &surface));
        Ok(Still { surface, reach, solution })
    }

    /// A box round the surface of a part with a wall.
    pub(super) fn surface(&self, motion: &Isometry) -> Bounds {
        self.surface.iter().fold(Bounds::NOTHING, |all, tile| all.with(tile.moved(motion).bounds()))
    }

    /// A box round whatever body a part with a wall comes to, without finding that; `None` where the body has to be found: its reach is not known beforehand, as of one with a lining of its own.
    ///
    /// In the frame of the pot's own axis the clay is within the box round its surface, widened by what its wall measures. The other side of the wall is no further from the surface than it is thick; levels are off the lowest or highest point of the foot by the base
    /// and the height of the ring; what is led to a level stays where it is across the axis; the edge of a drain is half its width from the middle, and that of a ring its width from the foot; all else is straight between two of these. Round a sharp ring, though, the other side is mitred,
    /// and goes as far as its angle says.
    pub(super) fn reach(&self, motion: &Isometry) -> Option<Bounds> {
        let bounds = motion.bounds(&self.reach?);
        (bounds.far() < LARGE && bounds.size() > 1.0 / LARGE).then_some(bounds)
    }
}

/// As [`Still::reach`], of a part that stands upright.
fn reach(solution: &Solution, wall: &Wall, borders: &[Border], surface: &[Tile]) -> Option<Bounds> {
    if wall.lining.is_some() || solution.has_shell(0, Product::Pot).is_ok_and(|is_shell| is_shell) {
        return None;
    }
    let is_smooth = Upright::new(solution.part(0).ok()?).is_some_and(|upright| upright.stretches().len() == 1);
    if !is_smooth {
        return None;
    }
    let [width, height] = wall.foot.unwrap_or([0.0; 2]);
    let across = wall.thickness + width + 0.5 * wall.drain;
    let reach = MARGIN * DVec3::new(across, across, wall.thickness + wall.base + height);
    // Tiles are so few that boxes round them are far too wide for what stands close together.
    let tiles = Tiles::new(surface.to_vec());
    let enough = CLOSE * surface.iter().fold(Bounds::NOTHING, |all, tile| all.with(tile.bounds())).size();
    let furthest = |direction: DVec3| tiles.reach(borders, direction, enough, &mut Budget::new(MOST_STEPS)).0;
    let [low, high] = [-1.0, 1.0].map(|sign| sign * DVec3::from_array(DVec3::AXES.map(|axis| furthest(sign * axis))));
    Some(Bounds { low: low - reach, high: high + reach })
}

/// Whether two parts differ in nothing but where they stand.
fn is_alike(one: &Part, other: &Part) -> bool {
    one.place.scale == other.place.scale && one.wall == other.wall && one.shape == other.shape
}

impl Solution {
    /// A part before it is turned and moved, found once for all that differ in nothing else.
    ///
    /// # Errors
    /// As [`Solution::part`]; `cancelled`.
    pub(super) fn still(&self, index: usize) -> Result<Arc<Still>> {
        let (_, part) = self.existing(index)?;
        let known = self.stills().map(|stills| &stills.known);
        if let Some(still) = known.and_then(|known| known.find(|of, _| is_alike(of, part))) {
            return Ok(still);
        }
        let still = Arc::new(Still::new(self.alone(index)?)?);
        watch::go_on()?;
        if let Some(known) = known {
            known.keep(part.clone(), &still, 1);
        }
        Ok(still)
    }

    /// What a part is in space before it is turned and moved: that of a part that is neither, if there is one. `None` of the first such itself; of an octant, of which formulas tell most; and of what is refused, which is told with the path of the part.
    ///
    /// # Errors
    /// As [`Solution::still`].
    pub(super) fn space_before(&self, index: usize) -> Result<Option<Arc<Space>>> {
        let (_, part) = self.existing(index)?;
        if self.part(index)?.solved().octant().is_some() {
            return Ok(None);
        }
        let first =
            self.design().parts().iter().position(|other| other.place == other.place.still() && is_alike(other, part));
        Ok(match first {
            Some(first) if first == index => None,
            Some(first) => self.in_space(first).ok(),
            None => self.still(index)?.solution.in_space(0).ok(),
        })
    }

    /// Where they are kept, with those of the design before that are in this one too.
    fn stills(&self) -> Option<&Stills> {
        let [kept, before] = self.still_parts();
        if kept.is_empty() {
            let (parts, unit) = (self.design().parts(), self.design().unit());
            let before = before.get::<Stills>().filter(|before| before.unit == unit);
            let known = before.map(|before| before.known.of(|of| parts.iter().any(|part| is_alike(of, part))));
            kept.keep(Stills { unit, known: known.unwrap_or_else(|| Newest::new(written::PARTS)) });
        }
        kept.get()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::scene::{Hit, Ray};

    const CUP: &str = r#""shape": { "kind": "second-order", "r": [3, 0.1, 3.5, 0.3], "t": [0.4, 0], "n": [1, 5], "height": 4 }, "wall": { "thickness": 0.3, "base": 0.4, "foot": [0.3, 0.2] }"#;
    const MOVED: &str = r#"{ "axis": [1, 2, 0.5], "angle": 1.1, "shift": [5, -3, 40] }"#;

    fn scene(places: &[&str]) -> Solution {
        let parts: Vec<String> = places.iter().map(|place| format!(r#"{{ {CUP}, "place": {place} }}"#)).collect();
        Solution::of(&Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}] }}"#, parts.join(", "))).unwrap())
    }

    /// What a part is in space before it is turned and moved.
    fn before(solution: &Solution, part: usize) -> Option<*const Space> {
        solution.in_space(part).unwrap().still().map(|(still, _)| core::ptr::from_ref(still))
    }

    #[test]
    fn parts_that_differ_in_where_they_stand_alone_have_one_body() {
        let wide = r#"{ "scale": [2, 1, 1], "shift": [9, 0, 0] }"#;
        let solution = scene(&[MOVED, r#"{ "shift": [9, 0, 0] }"#, wide, r#"{ "angle": 2 }"#]);
        let [one, other, wide, turned] = [0, 1, 2, 3].map(|part| before(&solution, part));
        assert!(one.is_some() && one == other && one == turned && wide.is_some() && wide != one);
        // Of those that are neither turned nor moved the first is what the others are.
        let solution = scene(&[MOVED, "{}", r#"{ "shift": [9, 0, 0] }"#, "{}"]);
        let first = core::ptr::from_ref(&*solution.in_space(1).unwrap());
        assert_eq!([0, 1, 2, 3].map(|part| before(&solution, part)), [Some(first), None, Some(first), Some(first)]);
    }

    #[test]
    fn the_body_of_a_part_goes_along_with_it_into_the_next_design() {
        let first = scene(&[MOVED]);
        let known = first.still(0).unwrap();
        let next = |text: &str| first.after(&Design::parse(text).unwrap()).still(0).unwrap();
        let text = |unit: &str, height: u8, shift: u8| {
            let cup = CUP.replace(r#""height": 4"#, &format!(r#""height": {height}"#));
            format!(
                r#"{{ "pasu": 1, "unit": "{unit}", "parts": [{{ {cup}, "place": {{ "shift": [{shift}, 0, 0] }} }}] }}"#
            )
        };
        assert!(Arc::ptr_eq(&next(&text("cm", 4, 7)), &known));
        // Another shape is another body, and so is the same in millimetres, where a ring may have no room.
        assert!(!Arc::ptr_eq(&next(&text("cm", 5, 7)), &known));
        assert!(!Arc::ptr_eq(&next(&text("mm", 4, 7)), &known));
        let second = first.after(&Design::parse(&text("cm", 5, 7)).unwrap());
        second.still(0).unwrap();
        assert_eq!(second.stills().unwrap().known.n_kept(), 1);
    }

    /// Hits of a part by rays through and past it, and what holds points of these.
    fn answers(solution: &Solution, part: usize, of_own: impl Fn(DVec3) -> DVec3) -> Vec<Hit> {
        let mut all = Vec::new();
        for i in 0..60u8 {
            let (turn, level) = (f64::from(i) * 0.7, f64::from(i % 12) * 0.4);
            let (from, to) = (
                DVec3::new(9.0 * libm::cos(turn), 9.0 * libm::sin(turn), level),
                DVec3::new(f64::from(i % 7) - 3.0, f64::from(i % 5) - 2.0, 4.2 - level),
            );
            let (origin, end) = (of_own(from), of_own(to));
            let ray = Ray { origin: origin.to_array(), direction: (end - origin).to_array() };
            all.extend(solution.pick(ray).unwrap().into_iter().filter(|hit| hit.part == part));
            let wall = of_own(DVec3::new(3.15 * libm::cos(turn), 3.15 * libm::sin(turn), level));
            all.extend(solution.at(wall.to_array()).unwrap().into_iter().filter(|hit| hit.part == part));
        }
        all
    }

    #[test]
    fn what_is_moved_answers_as_it_does_where_it_was() {
        let place = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ {CUP}, "place": {MOVED} }}] }}"#)).unwrap();
        let motion = Isometry::of(&place.parts()[0].place);
        let still = answers(&scene(&["{}"]), 0, |at| at);
        let moved = answers(&scene(&[MOVED]), 0, |at| motion.point(at));
        assert!(still.len() > 150 && still.len() == moved.len(), "{} {}", still.len(), moved.len());
        for (one, other) in still.iter().zip(&moved) {
            let point = motion.point(DVec3::from_array(one.point));
            let normal = motion.vector(DVec3::from_array(one.normal));
            assert!((one.distance - other.distance).abs() < 1e-9 && one.face == other.face, "{one:?} {other:?}");
            assert!((point - DVec3::from_array(other.point)).length() < 1e-8, "{one:?} {other:?}");
            assert!((normal - DVec3::from_array(other.normal)).length() < 1e-6, "{one:?} {other:?}");
        }
        // To the bit, whichever part the body was found with.
        let beside = answers(&scene(&["{}", MOVED]), 1, |at| motion.point(at));
        assert_eq!(beside.iter().map(|hit| Hit { part: 0, ..hit.clone() }).collect::<Vec<_>>(), moved);
    }
}
