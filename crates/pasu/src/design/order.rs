//! The order of parts in what tells scenes from each other: a scene is a set of parts.
//!
//! A document keeps the order in which a person put its parts; in a link they have one of their own.

use core::cmp::Ordering;

use super::document::Design;
use super::joint::Joints;
use super::look::Look;
use super::part::Part;
use super::shape::KINDS;
use super::text;

impl Design {
    /// The same scene with its parts in the order of links, and its objects numbered 0, 1, 2 as they first appear there.
    ///
    /// Parts stand in the order of their kinds in the format, those of one kind in the order of their documents without name, object and joints, as texts, and those that are equal but for these in the order of their names, and then of their joints. However the parts of a scene were ordered and its objects numbered, this is the same design, which is what
    /// [`Design::link`] writes.
    ///
    /// ```
    /// use pasu::Design;
    ///
    /// let shelf = |parts: &str| Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{parts}] }}"#));
    /// let bowl = r#""shape": { "kind": "second-order", "r": [3, 0, 2, 0], "height": 2 }"#;
    /// let vase = r#""shape": { "kind": "second-order", "r": [1, 0, 2, 0], "height": 8 }"#;
    /// let one = shelf(&format!(r#"{{ "object": 1, {bowl} }}, {{ {vase} }}"#))?;
    /// let other = shelf(&format!(r#"{{ {vase} }}, {{ "object": 7, {bowl} }}"#))?;
    /// assert_ne!(one, other);
    /// assert_eq!(one.ordered(), other.ordered());
    /// assert_eq!(one.link(), other.link());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn ordered(&self) -> Design {
        let mut numbered = Vec::new();
        let parts = self.arranged(true).into_iter().map(|index| {
            let part = self.parts()[index].clone();
            let number = numbered.iter().position(|object| *object == part.object).unwrap_or_else(|| {
                numbered.push(part.object);
                numbered.len() - 1
            });
            Part { object: number as u32, ..part }
        });
        self.with_parts(parts.collect())
    }

    /// The numbers of the parts in the order of links, or in the order that there would be if no part had a name or joints.
    pub(crate) fn arranged(&self, with_names: bool) -> Vec<usize> {
        let parts = self.parts();
        let keys: Vec<Key> = parts.iter().map(|part| Key::of(part, true)).collect();
        let name = |index: usize| parts[index].name.as_ref().filter(|_| with_names);
        let joints = |index: usize| match parts[index].joints == Joints::default() || !with_names {
            true => String::new(),
            false => text::write(&Part { object: 0, ..parts[index].clone() }),
        };
        let named = |a: usize, b: usize| name(a).cmp(&name(b)).then_with(|| joints(a).cmp(&joints(b)));
        let compared = |a: usize, b: usize| keys[a].cmp(&keys[b]).then_with(|| named(a, b));
        // Equal parts of different objects are told apart by what else is in these. Objects of equal parts may stand for each other.
        let mut objects: Vec<(u32, Vec<usize>)> = Vec::new();
        for index in sorted(parts.len(), &compared) {
            let object = parts[index].object;
            match objects.iter_mut().find(|(number, _)| *number == object) {
                Some((_, members)) => members.push(index),
                None => objects.push((object, vec![index])),
            }
        }
        let ranked = sorted(objects.len(), &|a, b| {
            let (a, b) = (&objects[a].1, &objects[b].1);
            let pairs = a.iter().zip(b).map(|(a, b)| compared(*a, *b));
            pairs.fold(Ordering::Equal, Ordering::then).then(a.len().cmp(&b.len()))
        });
        let mut rank = vec![0; parts.len()];
        for (place, object) in ranked.into_iter().enumerate() {
            objects[object].1.iter().for_each(|index| rank[*index] = place);
        }
        sorted(parts.len(), &|a, b| compared(a, b).then(rank[a].cmp(&rank[b])))
    }

    /// The numbers of the parts in the order of what they are made of and where they stand alone.
    pub(crate) fn order(&self) -> Vec<usize> {
        let keys: Vec<Key> = self.parts().iter().map(|part| Key::of(part, false)).collect();
        sorted(keys.len(), &|a, b| keys[a].cmp(&keys[b]))
    }
}

/// The first `n` numbers in this order, equal ones as they were. One short function for whatever is put in order: each sort of the standard library's costs the first picture 4 kB.
fn sorted(n: usize, compared: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order = Vec::with_capacity(n);
    for next in 0..n {
        let place = order.partition_point(|earlier| compared(*earlier, next).is_le());
        order.insert(place, next);
    }
    order
}

/// What parts are put in order by: the place of their kind in the format, then the document without name, object and joints.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Key {
    kind: Option<usize>,
    document: String,
}

impl Key {
    /// Of a part with its look or without.
    pub(crate) fn of(part: &Part, with_look: bool) -> Key {
        let look = if with_look { part.look } else { Look::default() };
        let document = text::write(&Part { name: None, object: 0, look, joints: Joints::default(), ..part.clone() });
        Key { kind: KINDS.iter().position(|kind| kind.name == part.shape.kind()), document }
    }
}
