//! What two scenes have in common, as sets of parts.

use std::collections::{BTreeMap, VecDeque};

use super::difference::{Counterpart, Difference};
use crate::design::{Design, Key, Part, Placement, Shape, to_json};

/// Whether two designs are one scene, and otherwise what became of each part.
///
/// ```
/// use pasu::{Design, compare};
///
/// let shelf = |parts: &str| Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{parts}] }}"#));
/// let bowl = r#"{ "shape": { "kind": "second-order", "r": [3, 0, 2, 0], "height": 2 } }"#;
/// let vase = |x: f64| {
///     let shape = r#"{ "kind": "second-order", "r": [1, 0, 2, 0], "height": 8 }"#;
///     format!(r#"{{ "shape": {shape}, "place": {{ "shift": [{x}, 0, 0] }} }}"#)
/// };
/// let before = shelf(&format!("{bowl}, {}", vase(5.0)))?;
/// assert!(compare(&before, &shelf(&format!("{}, {bowl}", vase(5.0)))?).is_same);
///
/// let difference = compare(&before, &shelf(&format!("{}, {bowl}", vase(7.0)))?);
/// assert_eq!((difference.kept[0].before, difference.kept[0].after), (0, 1));
/// assert_eq!((difference.moved[0].before, difference.moved[0].after), (1, 0));
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn compare(before: &Design, after: &Design) -> Difference {
    let orders = [before, after].map(|design| design.arranged(false));
    let is_glued_alike = objects(before, &orders[0]) == objects(after, &orders[1]);
    let mut matching = Matching { parts: [before.parts(), after.parts()], rest: orders };
    let mut kept = matching.take(|part| Some(Key::of(part, true)));
    let mut moved = matching.take(|part| part.name.clone().map(|name| (name, unplaced(part))));
    moved.extend(matching.take(|part| Some(unplaced(part))));
    let mut changed = matching.take(|part| part.name.clone());
    changed.extend(matching.take(|part| Some((part.shape.kind(), to_json(&part.place)))));
    let [mut gone, mut added] = matching.rest;
    for list in [&mut kept, &mut moved, &mut changed] {
        list.sort_unstable();
    }
    gone.sort_unstable();
    added.sort_unstable();
    let mut both: Vec<Counterpart> = [&kept, &moved, &changed].into_iter().flatten().copied().collect();
    both.sort_unstable();
    let has_other_parts = !(moved.is_empty() && changed.is_empty() && gone.is_empty() && added.is_empty());
    Difference {
        is_same: before.unit() == after.unit() && !has_other_parts && is_glued_alike,
        reglued: reglued(&both, [before, after]),
        kept,
        moved,
        changed,
        gone,
        added,
    }
}

/// The objects of the parts in this order, numbered as they first appear.
fn objects(design: &Design, order: &[usize]) -> Vec<usize> {
    let objects: Vec<u32> = order.iter().map(|index| design.parts()[*index].object).collect();
    objects.iter().map(|object| objects.iter().position(|first| first == object).unwrap_or_default()).collect()
}

/// What a part is, wherever it stands. The exponents of an octant change places with its axes when it is turned.
fn unplaced(part: &Part) -> Key {
    let mut shape = part.shape.clone();
    if let Shape::Octant(octant) = &mut shape {
        octant.exponents.sort_by(f64::total_cmp);
    }
    Key::of(&Part { shape, place: Placement::default(), ..part.clone() }, true)
}

/// The parts of both scenes, and those that have no counterpart yet, in the order of links.
struct Matching<'a> {
    parts: [&'a [Part]; 2],
    rest: [Vec<usize>; 2],
}

impl Matching<'_> {
    /// Takes out what is told by the same words in both scenes, the first by the first where several are.
    fn take<K: Ord>(&mut self, told: impl Fn(&Part) -> Option<K>) -> Vec<Counterpart> {
        let mut waiting: BTreeMap<K, VecDeque<usize>> = BTreeMap::new();
        for index in &self.rest[1] {
            if let Some(key) = told(&self.parts[1][*index]) {
                waiting.entry(key).or_default().push_back(*index);
            }
        }
        let mut found = Vec::new();
        for before in &self.rest[0] {
            let same = told(&self.parts[0][*before]).and_then(|key| waiting.get_mut(&key)?.pop_front());
            found.extend(same.map(|after| Counterpart { before: *before, after }));
        }
        self.rest[0].retain(|index| found.iter().all(|pair| pair.before != *index));
        self.rest[1].retain(|index| found.iter().all(|pair| pair.after != *index));
        found
    }
}

/// The parts of both scenes that have another neighbour of these glued to them, or one less.
fn reglued(both: &[Counterpart], [before, after]: [&Design; 2]) -> Vec<Counterpart> {
    let object = |pair: &Counterpart| (before.parts()[pair.before].object, after.parts()[pair.after].object);
    let objects: Vec<(u32, u32)> = both.iter().map(object).collect();
    let is_other = |(was, is): &(u32, u32)| objects.iter().any(|(first, second)| (first == was) != (second == is));
    both.iter().zip(&objects).filter(|(_, object)| is_other(object)).map(|(pair, _)| *pair).collect()
}
