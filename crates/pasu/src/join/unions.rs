//! The unions that were made last, for whoever makes the same again.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use xxhash_rust::xxh64::Xxh64;

use super::labelled::Labelled;
use super::union::{Union, union};
use crate::error::{Code, Result};
use crate::solution::Solution;
use crate::watch;

/// The most triangles that are kept, some 40 bytes each; the newest union whatever it has.
const MOST_TRIANGLES: usize = 500_000;
/// The most unions, made or refused.
const MOST_UNIONS: usize = 500;

/// Two sums of all that a union depends on, of which one alone would have a pair with the same one among some billions.
type Key = [u64; 2];

/// What came of some bodies.
struct Made {
    key: Key,
    /// A refusal names them: it is given again to whoever calls them the same.
    names: Vec<String>,
    union: Result<Arc<Union>>,
}

/// The unions of one design, which a check makes and the file after it once more, in the order in which they were made.
#[derive(Default)]
pub(crate) struct Unions(Mutex<Vec<Made>>);

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
        let key = key(bodies, tolerance);
        let names = || bodies.iter().map(|body| body.name);
        let is_known = |made: &&Made| made.key == key && (made.union.is_ok() || names().eq(&made.names));
        if let Some(known) = self.kept().iter().find(is_known) {
            return known.union.clone();
        }
        let union = union(bodies, tolerance).map(Arc::new);
        // What was ended early may be anything.
        if !watch::is_stopped() && union.as_ref().err().is_none_or(|error| error.code() == Code::CrossesItself) {
            let mut kept = self.kept();
            kept.push(Made { key, names: names().map(str::to_owned).collect(), union: union.clone() });
            while kept.len() > 1 && (kept.len() > MOST_UNIONS || n_triangles(&kept) > MOST_TRIANGLES) {
                kept.remove(0);
            }
        }
        union
    }

    fn kept(&self) -> MutexGuard<'_, Vec<Made>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// How many are kept.
    #[cfg(test)]
    pub(crate) fn n_kept(&self) -> usize {
        self.kept().len()
    }
}

fn n_triangles(kept: &[Made]) -> usize {
    kept.iter().filter_map(|made| made.union.as_ref().ok()).map(|union| union.triangles.len()).sum()
}

fn key(bodies: &[&Labelled], tolerance: Option<f64>) -> Key {
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

    /// What is ended has seen next to nothing of what it joins.
    #[test]
    fn what_was_ended_is_not_kept() {
        let unions = Arc::new(Unions::default());
        let (one, other) = (tetrahedron([0.0; 3], 4.0), tetrahedron([0.5; 3], 4.0));
        let asked = || unions.union(&[&body(&one, 0), &body(&other, 1)], None);
        let ended = watch::watched(|_| core::ops::ControlFlow::Break(()), || asked().map(drop));
        assert!(ended.is_err() && unions.n_kept() == 0);
        let counted = watch::within(0, asked);
        assert!(counted.is_none_or(|answer| answer.is_ok()));
        assert!(asked().is_ok());
    }

    #[test]
    fn no_more_is_kept_than_there_is_room_for() {
        let unions = Unions::default();
        let other = tetrahedron([0.5; 3], 4.0);
        for number in 0..=MOST_UNIONS {
            let one = tetrahedron([0.0; 3], 4.0);
            unions.union(&[&body(&one, number as u32), &body(&other, 1)], None).unwrap();
        }
        assert_eq!(unions.n_kept(), MOST_UNIONS);
    }
}
