//! The unions that were made last, for whoever makes the same again.

use std::sync::Arc;

use xxhash_rust::xxh64::Xxh64;

use super::labelled::Labelled;
use super::union::{Union, union};
use crate::error::Result;
use crate::solution::{Newest, Solution};

/// The most triangles that are kept, some 40 bytes each; the newest union whatever it has.
const MOST_TRIANGLES: usize = 500_000;
/// What a union or a refusal counts for besides its triangles.
const EACH: usize = 1_000;

/// What a union depends on: two sums of it, of which one alone would have a pair with the same one among some billions; and the names of the bodies, which a refusal tells.
#[derive(Clone)]
struct Key([u64; 2], Vec<String>);

/// The unions of one design, which a check makes and the file after it once more.
pub(crate) struct Unions(Newest<Key, Result<Arc<Union>>>);

impl Default for Unions {
    fn default() -> Unions {
        Unions(Newest::new(MOST_TRIANGLES))
    }
}

impl Unions {
    /// Those that are kept beside a solution.
    pub(crate) fn of(solution: &Solution) -> Arc<Unions> {
        let kept = solution.joined();
        kept.keep(Arc::new(Unions::default()));
        kept.get().map_or_else(Arc::default, Arc::clone)
    }

    /// As [`union()`], which is not asked again for what it has answered.
    ///
    /// # Errors
    /// As [`union()`].
    pub(crate) fn union(&self, bodies: &[&Labelled], tolerance: Option<f64>) -> Result<Arc<Union>> {
        let sums = sums(bodies, tolerance);
        let names: Vec<String> = bodies.iter().map(|body| body.name.to_owned()).collect();
        let is_it = |Key(of, called): &Key, union: &Result<_>| *of == sums && (union.is_ok() || *called == names);
        if let Some(known) = self.0.find(is_it) {
            return known;
        }
        let union = union(bodies, tolerance).map(Arc::new);
        let n_triangles = union.as_ref().map_or(0, |union| union.triangles.len());
        self.0.keep(Key(sums, names), &union, EACH + n_triangles);
        union
    }

    /// How many are kept.
    #[cfg(test)]
    pub(crate) fn n_kept(&self) -> usize {
        self.0.n_kept()
    }
}

fn sums(bodies: &[&Labelled], tolerance: Option<f64>) -> [u64; 2] {
    [0, 1].map(|seed| {
        let mut sum = Xxh64::new(seed);
        sum.update(&tolerance.map_or([0xff; 8], f64::to_le_bytes));
        for Labelled { positions, indices, labels, .. } in bodies {
            for length in [positions.len(), indices.len()] {
                sum.update(&(length as u64).to_le_bytes());
            }
            positions.iter().for_each(|x| sum.update(&x.to_le_bytes()));
            indices.iter().chain(labels).for_each(|number| sum.update(&number.to_le_bytes()));
        }
        sum.digest()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron with right angles at a corner.
    fn tetrahedron(corner: [f32; 3], size: f32) -> Vec<f32> {
        let at = |axis: usize| {
            let mut at = corner;
            at[axis] += size;
            at
        };
        [corner, at(0), at(1), at(2)].concat()
    }

    const INDICES: [u32; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

    fn body(positions: &[f32], label: u32) -> Labelled<'_> {
        Labelled { name: "one", positions, indices: &INDICES, labels: vec![label; 4] }
    }

    #[test]
    fn the_same_bodies_are_joined_once_and_others_anew() {
        let unions = Unions::default();
        let (one, other) = (tetrahedron([0.0; 3], 4.0), tetrahedron([0.5; 3], 4.0));
        let made = |first: &[f32], label: u32, tolerance: Option<f64>| {
            unions.union(&[&body(first, label), &body(&other, 1)], tolerance).unwrap()
        };
        let first = made(&one, 0, None);
        assert!(Arc::ptr_eq(&first, &made(&one, 0, None)));
        assert!(!Arc::ptr_eq(&first, &made(&one, 2, None)));
        assert!(!Arc::ptr_eq(&first, &made(&one, 0, Some(0.01))));
        let moved = made(&tetrahedron([0.25; 3], 4.0), 0, None);
        assert_ne!(first.points, moved.points);
        assert!(Arc::ptr_eq(&first, &made(&one, 0, None)));
        let alone = union(&[&body(&one, 0), &body(&other, 1)], None).unwrap();
        assert_eq!((&alone.points, &alone.triangles), (&first.points, &first.triangles));
    }

    #[test]
    fn what_is_refused_is_refused_again_with_the_same_words() {
        let unions = Unions::default();
        // Across from each other at an edge.
        let (one, mut other) = (tetrahedron([0.0; 3], 4.0), tetrahedron([0.0; 3], 4.0));
        (other[3], other[7]) = (-4.0, -4.0);
        let refused = |name| {
            let union = unions.union(&[&Labelled { name, ..body(&one, 0) }, &body(&other, 1)], None);
            union.err().map(|error| error.to_string()).unwrap_or_default()
        };
        let first = refused("lid");
        assert!(first.contains("lid, one") && refused("lid") == first);
        assert_eq!(unions.n_kept(), 1);
        assert!(refused("knob").contains("knob, one"));
    }
}
