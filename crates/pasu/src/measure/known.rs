//! What parts measured before, for a design in which only others were changed.

use super::measures::{MeasureOptions, PartMeasures};
use super::share::Share;
use crate::design::{Choice, Clay, Part, Unit};
use crate::error::Result;
use crate::solid::Product;
use crate::solution::{Newest, Solution};

/// The most that are kept: those of a scene as a pot, and as a solid.
const MOST: usize = 1_000;

/// All that the measures of a part depend on that stands where it stood, but for its name.
#[derive(Clone, Copy, PartialEq)]
struct Key {
    number: usize,
    clay: Choice<Clay>,
    product: Product,
    fill: Option<u64>,
    density: Option<u64>,
}

impl Key {
    fn of(number: usize, part: &Part, options: &MeasureOptions) -> Key {
        let MeasureOptions { fill, product, density } = *options;
        let [fill, density] = [fill, density].map(|number| number.map(f64::to_bits));
        Key { number, clay: part.look.clay, product, fill, density }
    }
}

/// Measures of the parts of one design.
struct Known {
    unit: Unit,
    parts: Vec<Part>,
    measures: Newest<Key, (PartMeasures, Share)>,
}

impl Known {
    /// What a solution keeps, with what that of the design before it knew of parts that are still as they were.
    fn of(solution: &Solution) -> Option<&Known> {
        let [kept, before] = solution.measured_parts();
        if kept.is_empty() {
            let (unit, parts) = (solution.design().unit(), solution.design().parts());
            let before = before.get::<Known>().filter(|before| before.unit == unit);
            let measures = before.map(|before| {
                let pair = |number: usize| before.parts.get(number).zip(parts.get(number));
                before.measures.of(|key| pair(key.number).is_some_and(|(own, part)| own.stands_as(part)))
            });
            let measures = measures.unwrap_or_else(|| Newest::new(MOST));
            kept.keep(Known { unit, parts: parts.to_vec(), measures });
        }
        kept.get()
    }
}

/// What a part measures, which is asked once: `measure` measures it where that is not known.
///
/// # Errors
/// As `measure`; no refusal is kept.
pub(super) fn once(
    solution: &Solution,
    number: usize,
    options: &MeasureOptions,
    measure: impl FnOnce() -> Result<(PartMeasures, Share)>,
) -> Result<(PartMeasures, Share)> {
    let (_, part) = solution.existing(number)?;
    let key = Key::of(number, part, options);
    let known = Known::of(solution).map(|known| &known.measures);
    if let Some((measures, share)) = known.and_then(|known| known.find(|of, _| *of == key)) {
        return Ok((PartMeasures { name: part.name.clone(), ..measures }, share));
    }
    let measured = measure()?;
    if let Some(known) = known {
        known.keep(key, &measured, 1);
    }
    Ok(measured)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::measure::measure;

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

    fn n_kept(solution: &Solution) -> usize {
        Known::of(solution).unwrap().measures.n_kept()
    }

    #[test]
    fn a_part_is_measured_once_while_it_stands_and_every_number_is_that_of_a_fresh_design() {
        let options = MeasureOptions::default();
        let first = Solution::of(&two("cm", "", &at(9.0)));
        assert_eq!(first.measure(&options).unwrap(), first.measure(&options).unwrap());
        assert_eq!(n_kept(&first), 2);
        // The other is moved: of the two that are known one is taken over, and one is new.
        let design = two("cm", r#", "name": "mug", "look": { "glaze": "cobalt" }"#, &at(9.5));
        let second = first.after(&design);
        assert_eq!(n_kept(&second), 1);
        let measures = second.measure(&options).unwrap();
        assert_eq!((n_kept(&second), measures.parts[0].name.as_deref()), (2, Some("mug")));
        assert_eq!(measures, measure(&design, &options).unwrap());
        // Through a design of which nothing was asked.
        let third = second.after(&two("cm", "", &at(8.0))).after(&design);
        assert_eq!(third.measure(&options).unwrap(), measures);
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
}
