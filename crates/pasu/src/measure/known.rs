//! What was measured before of parts that are the same but for where they were moved to: copies of one another, and those of a design of before.

use std::sync::Arc;

use glam::DVec3;

use super::measures::{MeasureOptions, PartMeasures};
use super::moved::Moved;
use super::outside::Outside;
use super::share::Share;
use super::taken::{Stood, Taken};
use crate::design::{Choice, Clay, Part, Placement, Shape, Unit, Wall};
use crate::error::{Error, Result};
use crate::face::Face;
use crate::solid::Product;
use crate::solution::{Newest, Solution};

/// The most bodies that are kept: those of a scene as pots, and as solids.
const MOST: usize = 1_000;

/// The most measures of one body that are kept: of clays, levels and densities.
const MOST_OF_ONE: usize = 16;

/// All that a body depends on that is measured.
#[derive(Clone, PartialEq)]
struct Key {
    /// Not moved, unless it would be another body then.
    place: Placement,
    product: Product,
    /// Of a pot whether it is the same body wherever it is moved to.
    is_movable: Option<bool>,
    /// As it is made, with its ring and drain as they are fitted.
    wall: Option<Wall>,
    /// Last, because it takes longest to compare.
    shape: Shape,
}

impl Key {
    fn of(part: &Part, place: Placement, stood: &Stood, product: Product) -> Key {
        let wall = stood.pot.as_ref().map_or(part.wall, |pot| pot.wall());
        let is_movable = stood.pot.as_ref().ok().map(|_| stood.is_movable());
        Key { place, product, is_movable, wall, shape: part.shape.clone() }
    }

    fn is_of(&self, part: &Part) -> bool {
        [part.place, part.place.unmoved()].contains(&self.place) && self.shape == part.shape
    }
}

/// What is asked of a body besides.
#[derive(Clone, Copy, PartialEq)]
struct Asked {
    clay: Choice<Clay>,
    fill: Option<u64>,
    density: Option<u64>,
}

/// A body that is measured, not moved unless it can only be where it was moved to.
pub(super) struct Subject {
    pub(super) taken: Taken,
    measured: Newest<Asked, (PartMeasures, Share)>,
}

impl Subject {
    fn new(stood: Stood) -> Subject {
        Subject { taken: Taken::of(stood), measured: Newest::new(MOST_OF_ONE) }
    }
}

/// Bodies of one design.
struct Known {
    unit: Unit,
    subjects: Newest<Key, Arc<Subject>>,
}

impl Known {
    /// What a solution keeps, with what that of the design before it knew of parts that are still as they were but for where they were moved to.
    fn of(solution: &Solution) -> Option<&Known> {
        let [kept, before] = solution.measured_parts();
        if kept.is_empty() {
            let (unit, parts) = (solution.design().unit(), solution.design().parts());
            let before = before.get::<Known>().filter(|before| before.unit == unit);
            let subjects = before.map(|before| before.subjects.of(|key| parts.iter().any(|part| key.is_of(part))));
            let subjects = subjects.unwrap_or_else(|| Newest::new(MOST));
            kept.keep(Known { unit, subjects });
        }
        kept.get()
    }
}

/// One part: a body, where that was moved to.
pub(super) struct Instance {
    pub(super) subject: Arc<Subject>,
    by: DVec3,
    /// Why it has no wall, with the place.
    refusal: Option<Error>,
}

impl Instance {
    /// # Errors
    /// As [`Stood::new`].
    pub(super) fn new(solution: &Solution, number: usize, product: Product) -> Result<Instance> {
        let mut stood = Stood::new(solution, number, product)?;
        let (part, refusal) = (solution.existing(number)?.1, stood.refusal().cloned());
        let (by, place) =
            if stood.is_movable() { (stood.shift(), part.place.unmoved()) } else { (DVec3::ZERO, part.place) };
        let key = Key::of(part, place, &stood, product);
        let known = Known::of(solution).map(|known| &known.subjects);
        if let Some(subject) = known.and_then(|known| known.find(|of, _| *of == key)) {
            return Ok(Instance { subject, by, refusal });
        }
        if by != DVec3::ZERO {
            let Ok(unmoved) = stood.unmoved() else {
                // What is rounded is rounded otherwise there: this one is itself alone.
                return Ok(Instance { subject: Arc::new(Subject::new(stood)), by: DVec3::ZERO, refusal });
            };
            stood = unmoved;
        }
        let subject = Arc::new(Subject::new(stood));
        if let Some(known) = known {
            known.keep(key, &subject, 1);
        }
        Ok(Instance { subject, by, refusal })
    }

    /// The faces between which heights and widths are, moved.
    pub(super) fn faces(&self) -> Vec<Moved<'_>> {
        self.subject.taken.faces().into_iter().map(|face| Moved::new(face, self.by)).collect()
    }

    /// Every one from outside; `moved` are the faces of each. Of copies one is sampled.
    pub(super) fn outsides<'a>(all: &'a [Instance], moved: &'a [Vec<Moved>]) -> Vec<Outside<'a>> {
        let mut sampled: Vec<(&Arc<Subject>, Outside)> = Vec::new();
        let mut outside = |(instance, faces): (&'a Instance, &'a Vec<Moved>)| {
            let faces = faces.iter().map(|face| face as &dyn Face);
            if let Some((_, sampled)) = sampled.iter().find(|(subject, _)| Arc::ptr_eq(subject, &instance.subject)) {
                return sampled.moved(faces, instance.by);
            }
            let here = instance.subject.taken.outside();
            let moved = here.moved(faces, instance.by);
            sampled.push((&instance.subject, here));
            moved
        };
        all.iter().zip(moved).map(&mut outside).collect()
    }

    /// What the part measures: `measure` measures its body, with these options, where that is not known.
    ///
    /// # Errors
    /// As `measure`; no refusal is kept.
    pub(super) fn measures(
        &self,
        part: &Part,
        options: &MeasureOptions,
        measure: impl FnOnce(&MeasureOptions) -> Result<(PartMeasures, Share)>,
    ) -> Result<(PartMeasures, Share)> {
        let fill = options.fill.map(|level| level - self.by.z);
        let [level, density] = [fill, options.density].map(|number| number.map(f64::to_bits));
        let asked = Asked { clay: part.look.clay, fill: level, density };
        let measured = &self.subject.measured;
        let (measures, share) = match measured.find(|of, _| *of == asked) {
            Some(found) => found,
            None => {
                let found = measure(&MeasureOptions { fill, ..*options })?;
                measured.keep(asked, &found, 1);
                found
            }
        };
        let mut measures = measures.moved(self.by, options.fill);
        measures.name.clone_from(&part.name);
        if let Some(why) = &self.refusal {
            measures.is_refused(why, part.wall.is_some() && options.product == Product::Pot);
        }
        Ok((measures, share.moved(self.by)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::measure::{Measures, measure};

    /// A cup and a vase beside it, each with what is said of it.
    fn two(unit: &str, cup: &str, vase: &str) -> Design {
        Design::parse(&format!(
            r#"{{ "pasu": 1, "unit": "{unit}", "parts": [
                {{ "shape": {{ "kind": "second-order", "r": [3, 0.1, 3.5, 0.3], "t": [0.4, 0], "n": [1, 5], "height": 4 }}, "wall": {{ "thickness": 0.3, "base": 0.4 }}{cup} }},
                {{ "shape": {{ "kind": "second-order", "r": [2, 0.1, 1, 0.1], "height": 6 }}, "object": 1{vase} }}
            ] }}"#
        ))
        .unwrap()
    }

    fn at(x: f64) -> String {
        format!(r#", "place": {{ "shift": [{x}, 0, 0] }}"#)
    }

    /// How often something was measured.
    fn n_kept(solution: &Solution) -> usize {
        let subjects = Known::of(solution).unwrap().subjects.values();
        subjects.iter().map(|subject| subject.measured.n_kept()).sum()
    }

    #[test]
    fn a_part_is_measured_once_wherever_it_is_moved_and_every_number_is_that_of_a_fresh_design() {
        let options = MeasureOptions::default();
        let first = Solution::of(&two("cm", "", &at(9.0)));
        assert_eq!(first.measure(&options).unwrap(), first.measure(&options).unwrap());
        assert_eq!(n_kept(&first), 2);
        // The other is moved: both are known.
        let design = two("cm", r#", "name": "mug", "look": { "glaze": "cobalt" }"#, &at(9.5));
        let second = first.after(&design);
        assert_eq!(n_kept(&second), 2);
        let measures = second.measure(&options).unwrap();
        assert_eq!((n_kept(&second), measures.parts[0].name.as_deref()), (2, Some("mug")));
        assert_eq!(measures, measure(&design, &options).unwrap());
        // Through a design of which nothing was asked.
        let third = second.after(&two("cm", "", &at(8.0))).after(&design);
        assert_eq!(third.measure(&options).unwrap(), measures);
        // Turned, it stands otherwise.
        let turned = third.after(&two("cm", "", r#", "place": { "axis": [0, 1, 0], "angle": 0.5 }"#));
        assert_eq!(n_kept(&turned), 1);
        assert_eq!(turned.measure(&options).unwrap(), measure(turned.design(), &options).unwrap());
        assert_eq!(n_kept(&turned), 2);
    }

    #[test]
    fn what_measures_depend_on_makes_others() {
        let options = MeasureOptions::default();
        let first = Solution::of(&two("cm", "", &at(9.0)));
        let plain = first.measure(&options).unwrap();
        let others = [
            MeasureOptions { fill: Some(2.0), ..options },
            MeasureOptions { density: Some(2.0), ..options },
            MeasureOptions { product: Product::Solid, ..options },
        ];
        for other in others {
            let measures = first.measure(&other).unwrap();
            assert!(measures != plain && measures == measure(first.design(), &other).unwrap(), "{other:?}");
        }
        assert_eq!(n_kept(&first), 8);
        let clay = two("cm", r#", "look": { "clay": "porcelain" }"#, &at(9.0));
        for (design, n_known) in [(clay, 8), (two("in", "", &at(9.0)), 0)] {
            let next = first.after(&design);
            assert_eq!(n_kept(&next), n_known);
            let measures = next.measure(&options).unwrap();
            assert!(measures != plain && measures == measure(&design, &options).unwrap(), "{}", design.to_json());
        }
    }

    /// How often copies of a cup are measured that stand at three levels, each of which is as it is alone.
    fn measured_as_alone(cup: &str) -> usize {
        let shifts = [[0.0; 3], [9.0, 0.0, 0.0], [0.0, 9.0, 0.5], [-9.0, 2.0, -1.25]];
        let copy = |(shift, object): (&[f64; 3], usize)| {
            format!(
                r#"{{ "shape": {{ "kind": "second-order", {cup}, "height": 4 }}, "wall": {{ "thickness": 0.3, "base": 0.4 }},
                "object": {object}, "name": "{object}", "place": {{ "shift": {shift:?} }} }}"#
            )
        };
        let parts: Vec<String> = shifts.iter().zip(0..).map(copy).collect();
        let all = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}] }}"#, parts.join(", "))).unwrap();
        let solution = Solution::of(&all);
        let options = MeasureOptions { fill: Some(1.5), ..MeasureOptions::default() };
        let Measures { parts: measured, .. } = solution.measure(&options).unwrap();
        for (part, text) in measured.iter().zip(&parts) {
            let alone = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{text}] }}"#)).unwrap();
            let alone = measure(&alone, &options).unwrap().parts.remove(0);
            assert_eq!(*part, PartMeasures { part: part.part, ..alone });
            let shift = shifts[part.part];
            assert!((part.body.bottom - shift[2]).abs() <= part.body.height.error);
            assert_eq!(part.body.capacity.unwrap().fill.unwrap().level, 1.5);
            let at = part.body.centre.empty.unwrap();
            assert!((0..2).all(|i| (at.at[i] - shift[i]).abs() <= at.error), "{at:?} {shift:?}");
        }
        n_kept(&solution)
    }

    #[test]
    fn copies_are_measured_once_and_each_stands_where_it_stands() {
        assert_eq!(measured_as_alone(r#""r": [3, 0.05, 3.5, 0.1], "t": [0, 0], "n": [1, 3]"#), 3);
    }

    #[test]
    fn where_a_wall_had_to_be_thinned_each_copy_is_measured_where_it_stands() {
        assert_eq!(measured_as_alone(r#""r": [3, 0.1, 3.5, 0.3], "t": [0.4, 0], "n": [1, 5]"#), 4);
    }

    #[test]
    fn a_copy_that_is_refused_says_so_of_itself() {
        let copy = |x: f64, object: usize| {
            format!(
                r#"{{ "shape": {{ "kind": "second-order", "r": [3, 0.1, 3.5, 0.3], "t": [0.4, 0], "n": [1, 5], "height": 4 }}, "wall": {{ "thickness": 0.3, "base": 9 }},
                "object": {object}, "place": {{ "shift": [{x}, 0, 0] }} }}"#
            )
        };
        let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, copy(0.0, 0), copy(9.0, 1)));
        let solution = Solution::of(&design.unwrap());
        for part in solution.measure(&MeasureOptions::default()).unwrap().parts {
            let why = solution.sound_pot(part.part, Product::Pot).unwrap_err();
            assert_eq!(part.reason.as_deref(), Some(why.message()));
            assert_eq!(part.capacity_reason, part.reason);
            let path = Some(format!("parts[{}].wall.base", part.part));
            assert_eq!((part.cause.unwrap().path, part.capacity_cause.unwrap().path), (path.clone(), path));
        }
    }
}
