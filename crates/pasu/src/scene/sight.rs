//! Which parts a ray or another part may meet, or which may hold a point, before the bodies of all are known.
//!
//! A wall takes long to find, and of hundreds of pots a ray meets a few, and most stand apart. So a box is laid round what the clay of a part can reach at most, which follows from its surface and from what its wall is asked to be; the body itself is found when
//! something gets into that box.

use std::sync::{Arc, OnceLock};

use super::bounds::Bounds;
use super::boxes::Boxes;
use super::isometry::Isometry;
use super::space::Space;
use crate::design::Part;
use crate::error::Result;
use crate::solution::Solution;
use crate::watch;

/// All parts of a design, each in a box that may be wider than it has to be.
#[derive(Debug)]
pub(super) struct Sight {
    boxes: Boxes,
    parts: Vec<Seen>,
    /// What they are of.
    design: Vec<Part>,
}

#[derive(Debug, Clone)]
struct Seen {
    /// Round all that its body can reach.
    bounds: Bounds,
    /// Round its surface alone.
    surface: Bounds,
    /// What it is in space, once that was wanted.
    space: OnceLock<Arc<Space>>,
}

impl Solution {
    /// The boxes of all parts.
    ///
    /// # Errors
    /// As [`Solution::in_space`], of every part.
    pub(super) fn sight(&self) -> Result<Arc<Sight>> {
        if let Some(sight) = self.scene_seen().get::<Arc<Sight>>() {
            return Ok(Arc::clone(sight));
        }
        let before = self.scene_seen_before().get::<Arc<Sight>>();
        let design = self.design().parts();
        let seen = design.iter().enumerate().map(|(index, part)| {
            // What stands where it stood has the box that it had.
            if let Some(known) = before.and_then(|before| before.same(index, part)) {
                self.part(index)?;
                return Ok(known.clone());
            }
            self.seen(index)
        });
        let parts = seen.collect::<Result<Vec<Seen>>>()?;
        watch::go_on()?;
        let bounds: Vec<Bounds> = parts.iter().map(|seen| seen.bounds).collect();
        let sight = Arc::new(Sight { boxes: Boxes::new(&bounds), parts, design: design.to_vec() });
        self.scene_seen().keep(Arc::clone(&sight));
        Ok(sight)
    }

    /// The boxes of a part, and its body if that has to be found for them.
    ///
    /// # Errors
    /// As [`Solution::in_space`].
    fn seen(&self, index: usize) -> Result<Seen> {
        let (_, part) = self.existing(index)?;
        if part.wall.is_none() {
            let space = self.in_space(index)?;
            return Ok(Seen { bounds: space.bounds, surface: space.bounds, space: OnceLock::from(space) });
        }
        let (still, motion) = (self.still(index)?, Isometry::of(&part.place));
        let surface = still.surface(&motion);
        if let Some(bounds) = still.reach(&motion) {
            return Ok(Seen { bounds, surface, space: OnceLock::new() });
        }
        let space = self.in_space(index)?;
        Ok(Seen { bounds: space.bounds, surface, space: OnceLock::from(space) })
    }
}

impl Sight {
    /// The parts whose box something gets into, in the order of the document: of each the body, if it gets into the box of that too.
    ///
    /// # Errors
    /// As [`Solution::in_space`].
    pub(super) fn met(&self, solution: &Solution, is_met: impl Fn(&Bounds) -> bool) -> Result<Vec<&Arc<Space>>> {
        let mut near = Vec::new();
        self.boxes.each(&is_met, |part| near.push(part));
        near.sort_unstable();
        let spaces = near.into_iter().map(|part| self.space(solution, part));
        let met = spaces.filter(|space| space.as_ref().map_or(true, |space| is_met(&space.bounds)));
        met.collect()
    }

    /// A part in space.
    ///
    /// # Errors
    /// As [`Solution::in_space`].
    pub(super) fn space(&self, solution: &Solution, part: usize) -> Result<&Arc<Space>> {
        let seen = &self.parts[part];
        match seen.space.get() {
            Some(space) => Ok(space),
            None => {
                let space = solution.in_space(part)?;
                Ok(seen.space.get_or_init(|| space))
            }
        }
    }

    /// Every two parts that may come as near to each other as this, the first of them first.
    pub(super) fn near(&self, slack: f64) -> Vec<[usize; 2]> {
        let mut pairs = Vec::new();
        for (part, seen) in self.parts.iter().enumerate() {
            let near = seen.bounds.wider(slack);
            let first = pairs.len();
            self.boxes.each(|bounds| bounds.distance(&near) == 0.0, |other| pairs.push([other, part]));
            let others = pairs.split_off(first);
            pairs.extend(others.into_iter().filter(|[other, part]| other < part));
            pairs[first..].sort_unstable();
        }
        pairs
    }

    /// From corner to corner of the box round all surfaces.
    pub(super) fn size(&self) -> f64 {
        let all = self.parts.iter().fold(Bounds::NOTHING, |all, seen| all.with(seen.surface));
        if self.parts.is_empty() { 1.0 } else { all.size() }
    }

    /// Whether a part is here just as it is there.
    pub(super) fn stands(&self, index: usize, part: &Part) -> bool {
        self.same(index, part).is_some()
    }

    /// What is known of a part that is here just as it is there.
    fn same(&self, index: usize, part: &Part) -> Option<&Seen> {
        let own = self.design.get(index)?;
        own.stands_as(part).then(|| self.parts.get(index)).flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::solid::Product;

    /// Of every pot of a scene the box that is laid round it beforehand, and how many have one; each holds all of the clay.
    fn held(parts: &str) -> usize {
        let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{parts}] }}"#)).unwrap();
        held_of(&Solution::of(&design))
    }

    fn held_of(solution: &Solution) -> usize {
        let design = solution.design();
        let reached = (0..design.parts().len()).filter(|index| {
            let seen = solution.seen(*index).unwrap();
            if seen.space.get().is_some() {
                return false;
            }
            let bounds = seen.bounds;
            let space = solution.in_space(*index).unwrap();
            assert!(space.is_solid, "{design:?} is to be made: {:?}", solution.pot(*index, Product::Pot).err());
            for tile in &space.tiles().all {
                for corner in tile.corners {
                    assert!(bounds.holds(corner), "{corner} of {design:?} is beyond {bounds:?}");
                }
            }
            // It is of use only where it is not much wider than it has to be: askew, a box round a box is up to 1.7 times as large.
            assert!(bounds.size() < 2.0 * space.size(), "{bounds:?} {:?}", space.bounds);
            true
        });
        reached.count()
    }

    /// Of each part whether its body was found.
    fn is_made(solution: &Solution) -> Vec<bool> {
        solution.sight().unwrap().parts.iter().map(|seen| seen.space.get().is_some()).collect()
    }

    const CUP: &str = r#""kind": "second-order", "r": [3, 0.1, 3.5, 0.3], "t": [0.4, 0], "n": [1, 5], "height": 4"#;
    const WALLS: [&str; 6] = [
        r#""thickness": 0.3, "base": 0.4"#,
        r#""thickness": 0.3, "base": 0.4, "side": "outside", "rim": "rounded""#,
        r#""thickness": 0.25, "base": 0, "rim": "rounded""#,
        r#""thickness": 0.2, "base": 0.3, "foot": [0.3, 0.4]"#,
        r#""thickness": 0.2, "base": 0.3, "drain": 1"#,
        r#""thickness": 0.2, "base": 0.6, "side": "outside", "drain": 1"#,
    ];
    const PLACES: [&str; 3] = [
        "{}",
        r#"{ "axis": [1, 2, 0.5], "angle": 1.1, "shift": [5, -3, 40] }"#,
        r#"{ "scale": [1.5, -0.8, 1.2], "axis": [1, 0, 0], "angle": 2.5, "shift": [-7, 0, 2] }"#,
    ];

    #[test]
    fn clay_stays_in_the_box_that_is_laid_round_it_before_it_is_known() {
        let mut n_boxes = 0;
        for wall in WALLS {
            for place in PLACES {
                n_boxes += held(&format!(r#"{{ "shape": {{ {CUP} }}, "wall": {{ {wall} }}, "place": {place} }}"#));
            }
        }
        assert_eq!(n_boxes, WALLS.len() * PLACES.len());
    }

    /// Flaring, leaning and wavy pots through three rings, with walls of every form up to a quarter of their radius, small and large, tilted and stretched.
    #[test]
    fn clay_of_pots_drawn_at_random_stays_in_its_box_too() {
        let mut state = 3u64;
        let mut between = |least: f64, most: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            least + (most - least) * (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let (mut n_held, mut n_made) = (0, 0);
        for round in 0..120 {
            let size = 10f64.powf(between(-3.0, 3.0));
            let rings: Vec<String> = (0..3)
                .map(|i| {
                    let (r, z) = (between(0.5, 2.5) * size, (f64::from(i) * between(0.2, 2.0)) * size);
                    let mut wave = |n: u32, most: f64| format!(r#"{{ "n": {n}, "cos": {}, "sin": {} }}"#, between(-most, most) * size, between(-most, most) * size);
                    let (of_r, of_z) = (wave(2 + round % 4, 0.12), wave(1, 0.1));
                    format!(r#"{{ "u": {}, "r": {{ "mean": {r}, "waves": [{of_r}] }}, "z": {{ "mean": {z}, "waves": [{of_z}] }} }}"#, f64::from(i) / 2.0)
                })
                .collect();
            let thickness = between(0.02, 0.25) * size;
            let form = match round % 6 {
                0 => format!(r#""base": {thickness}"#),
                1 => format!(r#""base": {}, "side": "outside", "rim": "rounded""#, 2.0 * thickness),
                2 => r#""base": 0, "rim": "rounded""#.to_owned(),
                3 => format!(
                    r#""base": {thickness}, "foot": [{}, {}]"#,
                    between(0.05, 0.2) * size,
                    between(0.05, 0.3) * size
                ),
                4 => format!(r#""base": {thickness}, "drain": {}"#, between(0.1, 0.3) * size),
                _ => format!(r#""base": {thickness}, "side": "outside""#),
            };
            let [x, y, z] = [between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)];
            let part = format!(
                r#"{{ "shape": {{ "kind": "rings", "rings": [{}] }}, "wall": {{ "thickness": {thickness}, {form} }}, "place": {{ "scale": [{}, {}, 1], "axis": [{x}, {y}, {z}], "angle": {}, "shift": [{size}, 0, {}] }} }}"#,
                rings.join(", "),
                between(0.7, 1.4),
                between(0.7, 1.4),
                between(-3.0, 3.0),
                between(-9.0, 9.0) * size,
            );
            let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{part}] }}"#)).unwrap();
            let solution = Solution::of(&design);
            if solution.pot(0, Product::Pot).is_ok() {
                n_made += 1;
                n_held += held_of(&solution);
            }
        }
        assert!(n_made > 60 && n_held == n_made, "{n_held} of {n_made}");
    }

    #[test]
    fn what_is_bare_sharp_or_no_pot_has_no_box_beforehand() {
        let sharp = r#""kind": "rings", "rings": [{ "u": 0, "r": { "mean": 2 }, "z": { "mean": 0 } }, { "u": 0.5, "r": { "mean": 3 }, "z": { "mean": 2 }, "sharp": true }, { "u": 1, "r": { "mean": 2 }, "z": { "mean": 4 } }]"#;
        let wall = r#""wall": { "thickness": 0.3, "base": 0.4 }"#;
        assert_eq!(held(&format!(r#"{{ "shape": {{ {sharp} }}, {wall} }}"#)), 0);
        assert_eq!(held(&format!(r#"{{ "shape": {{ {CUP} }} }}"#)), 0);
        assert_eq!(held(r#"{ "shape": { "kind": "octant", "exponents": [2, 2, 2] } }"#), 0);
    }

    #[test]
    fn walls_of_what_stands_apart_are_not_sought() {
        let pot = |x: f64, object: u32| {
            format!(
                r#"{{ "object": {object}, "shape": {{ {CUP} }}, "wall": {{ {} }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#,
                WALLS[0]
            )
        };
        let row =
            |parts: &[String]| Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}] }}"#, parts.join(", "))).unwrap();
        let solution = Solution::of(&row(&[pot(-4.0, 0), pot(10.0, 1), pot(16.0, 2), pot(30.0, 3)]));
        let report = solution.constraints(None).unwrap();
        let codes: Vec<_> = report.breaches.iter().map(|breach| (breach.code, breach.part, breach.other)).collect();
        assert_eq!(codes, [("interference", 2, 1)]);
        assert_eq!(is_made(&solution), [false, true, true, false]);
        // What is loose is held against the nearest of its object by its body.
        let solution = Solution::of(&row(&[pot(0.0, 0), pot(30.0, 0)]));
        let report = solution.constraints(None).unwrap();
        assert_eq!(report.breaches[0].code, "not-connected");
        assert!(is_made(&solution).iter().all(|is_made| *is_made));
    }

    #[test]
    fn walls_of_wavy_pots_are_not_sought_where_their_neighbours_are_a_tenth_of_their_size_away() {
        let pot = |object: u32, x: f64| {
            format!(
                r#"{{ "object": {object}, "shape": {{ "kind": "second-order", "r": [8.5, 0.25, 5.5, 0.3], "height": 16 }}, "wall": {{ "thickness": 0.4, "base": 0.5 }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#
            )
        };
        let made = |between: f64| {
            let [one, other] = [pot(0, 0.0), pot(1, between)];
            let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{one}, {other}] }}"#)).unwrap();
            let solution = Solution::of(&design);
            assert!(solution.constraints(None).unwrap().breaches.is_empty());
            is_made(&solution)
        };
        // They are 17.1 wide.
        assert_eq!(made(20.0), [false, false]);
        assert_eq!(made(17.5), [true, true]);
    }

    #[test]
    fn only_what_a_ray_comes_near_is_made_and_stays_made() {
        let pot = |x: f64| {
            format!(r#"{{ "shape": {{ {CUP} }}, "wall": {{ {} }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#, WALLS[0])
        };
        let scene =
            |x: f64| Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, pot(0.0), pot(x))).unwrap();
        let ray = crate::Ray { origin: [-12.0, 0.0, 2.0], direction: [0.0, 0.0, 1.0] };
        let along = crate::Ray { origin: [0.1, 0.2, -5.0], direction: [0.0, 0.0, 1.0] };
        let made = |solution: &Solution| {
            let sight = solution.sight().unwrap();
            sight.parts.iter().map(|seen| seen.space.get().cloned()).collect::<Vec<_>>()
        };
        let first = Solution::of(&scene(10.0));
        assert!(first.pick(ray).unwrap().is_empty());
        assert!(made(&first).iter().all(Option::is_none), "{:?}", first.seen(0));
        let hits = first.pick(along).unwrap();
        assert_eq!(hits.len(), 2, "{hits:?}");
        let once = made(&first);
        assert!(once[0].is_some() && once[1].is_none());
        // The other one is moved: the same body answers.
        let second = first.after(&scene(12.0));
        assert_eq!(second.pick(along).unwrap(), hits);
        let again = made(&second);
        assert!(again[0].as_ref().zip(once[0].as_ref()).is_some_and(|(one, other)| Arc::ptr_eq(one, other)));
        // It is taken over by whoever asks for all parts, and what is asked first makes no difference.
        let third = second.after(&scene(14.0));
        let (whole, alone) = (third.constraints(None).unwrap(), Solution::of(&scene(14.0)));
        assert_eq!(whole, alone.constraints(None).unwrap());
        assert_eq!(alone.pick(along).unwrap(), hits);
    }
}
