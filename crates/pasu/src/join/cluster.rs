//! The union of bodies, two and two.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

use boolmesh::prelude::{Manifold, OpType, compute_boolean};
use glam::DVec3;

use super::boxes::{bounds, meet};
use super::labelled::Labelled;
use super::turn::Turn;
use crate::error::Result;
use crate::watch;

/// So many unions for each body are made in vain at most, because they have an edge twice.
const MOST_VAIN: usize = 3;

/// Bodies that are united already.
struct Cluster {
    number: usize,
    solid: Manifold,
    /// The box round each body, and round all.
    boxes: Vec<[DVec3; 2]>,
    whole: [DVec3; 2],
    /// How many corners are where another one is.
    n_double: usize,
}

impl Cluster {
    fn of(number: usize, body: &Labelled, positions: &[f64], near: f64) -> Option<Cluster> {
        let indices: Vec<usize> = body.indices.iter().map(|vertex| *vertex as usize).collect();
        let labels: Vec<f64> = body.labels.iter().flat_map(|label| [f64::from(*label); 3]).collect();
        let mut solid = Manifold::new_with_values(positions, &indices, &labels).ok()?;
        solid.eps = solid.eps.max(near * solid.bb.scale());
        let whole = bounds(body.positions);
        Some(Cluster { number, solid, boxes: vec![whole], whole, n_double: 0 })
    }

    fn with(&self, other: &Cluster, number: usize, turn: Turn) -> Option<Cluster> {
        // Whatever that crate meets that it did not expect is one pair fewer that can be joined, and no mistake of whoever asked.
        let unite = || compute_boolean(&self.solid, &other.solid, OpType::Add).ok();
        let solid = catch_unwind(AssertUnwindSafe(unite)).ok().flatten()?;
        let ([low, high], [other_low, other_high]) = (self.whole, other.whole);
        let (boxes, whole) = ([&self.boxes[..], &other.boxes].concat(), [low.min(other_low), high.max(other_high)]);
        let n_double = n_double(&solid, turn);
        Some(Cluster { number, solid, boxes, whole, n_double })
    }

    /// Whether the boxes of two of their bodies have a face or a volume in common.
    fn meets(&self, other: &Cluster) -> bool {
        let any = || self.boxes.iter().any(|one| other.boxes.iter().any(|other| meet(*one, *other)));
        meet(self.whole, other.whole) && any()
    }

    fn n_triangles(&self) -> usize {
        self.solid.hs.len() / 3
    }
}

/// How many corners are, in the numbers of a file, where another one is.
fn n_double(solid: &Manifold, turn: Turn) -> usize {
    let bits = |point: [f64; 3]| turn.back(point).map(|x| (x as f32 + 0.0).to_bits());
    let mut corners: Vec<[u32; 3]> = solid.ps.iter().map(|point| bits(point.to_array())).collect();
    corners.sort_unstable();
    corners.array_windows().filter(|[one, next]| one == next).count()
}

/// The union of all with their corners at these positions, made while they are turned, and how many corners of it are where another one is; `None` where there is none.
///
/// Bodies that touch along an edge alone have no union that is like a surface there: it has that edge twice, also when a third body fills the gap. So it goes from two that meet in more than that to two, the smallest first, and what has such an edge is made of others as long as there are any.
pub(super) fn united(
    bodies: &[&Labelled],
    positions: &[Vec<f64>],
    near: f64,
    turn: Turn,
) -> Result<Option<(Manifold, usize)>> {
    let all = bodies.iter().zip(positions).enumerate();
    let all = all.map(|(number, (body, positions))| Cluster::of(number, body, &turn.there(positions), near));
    let Some(mut clusters) = all.collect::<Option<Vec<_>>>() else { return Ok(None) };
    let mut vain: BTreeSet<[usize; 2]> = BTreeSet::new();
    for step in 1..bodies.len() {
        watch::go_on()?;
        clusters.sort_by_key(|cluster| (cluster.n_triangles(), cluster.number));
        let next = || smallest(&clusters, bodies.len() + step, turn, &mut vain, MOST_VAIN * bodies.len());
        let Some(union) = watch::share(step - 1, bodies.len() - 1, next) else { return Ok(None) };
        let ([one, other], union) = union;
        clusters.retain(|cluster| cluster.number != one && cluster.number != other);
        clusters.push(union);
    }
    Ok(clusters.pop().map(|mut all| {
        all.solid.ps.iter_mut().for_each(|point| *point = turn.back(point.to_array()).into());
        (all.solid, all.n_double)
    }))
}

/// The union of two, the smallest first, that meet and have no edge twice then; where there are no such, of two that have, or of two that do not meet. Which two, and what they are; those that were made in vain are remembered.
fn smallest(
    clusters: &[Cluster],
    number: usize,
    turn: Turn,
    vain: &mut BTreeSet<[usize; 2]>,
    most_vain: usize,
) -> Option<([usize; 2], Cluster)> {
    let mut doubled = None;
    for (at, one) in clusters.iter().enumerate() {
        for other in &clusters[at + 1..] {
            let pair = [one.number.min(other.number), one.number.max(other.number)];
            if watch::is_stopped() || vain.len() > most_vain {
                break;
            }
            if vain.contains(&pair) || !one.meets(other) {
                continue;
            }
            match one.with(other, number, turn) {
                Some(union) if union.n_double <= one.n_double + other.n_double => return Some((pair, union)),
                Some(union) => _ = doubled.get_or_insert((pair, union)),
                None => {}
            }
            vain.insert(pair);
        }
    }
    if watch::is_stopped() {
        return None;
    }
    doubled.or_else(|| {
        let pairs = (0..clusters.len()).flat_map(|one| (one + 1..clusters.len()).map(move |other| (one, other)));
        let (one, other) = pairs
            .map(|(one, other)| (&clusters[one], &clusters[other]))
            .min_by_key(|(one, other)| (!one.meets(other), one.n_triangles() + other.n_triangles()))?;
        Some(([one.number, other.number], one.with(other, number, turn)?))
    })
}
