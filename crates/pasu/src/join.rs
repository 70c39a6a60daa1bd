//! Closed triangles of several bodies as those of one: their union.
//!
//! The union is that of the crate `boolmesh`, after E. Lalish's *Manifold*: decided by topology and not by coordinates, so that what comes of closed bodies is closed. Whether it is still so once its coordinates are rounded to those of a file is checked here, as of every body that is written.

use std::panic::{AssertUnwindSafe, catch_unwind};

use boolmesh::prelude::{Manifold, OpType, compute_boolean};

use crate::check::{self, Topology};
use crate::error::{Code, Error, Result};
use crate::watch;

/// The most triangles of all bodies that are joined.
const MOST_TRIANGLES: usize = 2_000_000;

/// Corners nearer to each other than this share of the size are drawn together, in turn, until what is left survives rounding to seven digits.
const NEAR: [f64; 3] = [1e-12, 2e-7, 2e-6];

/// How far the volume of a union may lie outside what those of its bodies allow, as a share of these.
const SLACK: f64 = 1e-5;

/// Of so many bodies that cannot be joined the names are told.
const MOST_NAMES: usize = 3;

/// One of the bodies that are joined: closed triangles in the numbers of a file, each with a number of whoever asks.
pub(crate) struct Labelled<'a> {
    pub(crate) name: &'a str,
    /// `x, y, z` per vertex, one vertex per point.
    pub(crate) positions: &'a [f32],
    /// Three vertex numbers per triangle, counter-clockwise from outside.
    pub(crate) indices: &'a [u32],
    /// One number per triangle, which goes along with all that is left of it.
    pub(crate) labels: Vec<u32>,
}

/// What several bodies are together, having passed the checks of a file.
pub(crate) struct Union {
    pub(crate) points: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// What each triangle was labelled, in rising order.
    pub(crate) labels: Vec<u32>,
    pub(crate) topology: Topology,
}

/// The union of bodies.
///
/// # Errors
/// `crosses-itself` at `union` where none passes the checks of a file, `too-large`.
pub(crate) fn union(bodies: &[&Labelled]) -> Result<Union> {
    let n_triangles = bodies.iter().map(|body| body.indices.len() / 3).sum::<usize>();
    if n_triangles > MOST_TRIANGLES {
        let message = format!(
            "expected at most {MOST_TRIANGLES} triangles to be joined, found {n_triangles}; a larger tolerance takes fewer"
        );
        let error = Error::new(Code::TooLarge, "tolerance", message).with("greatest", MOST_TRIANGLES);
        return Err(error.with("found", n_triangles));
    }
    for (index, near) in NEAR.into_iter().enumerate() {
        watch::go_on()?;
        let soon = watch::share(index, NEAR.len(), || united(bodies, near))?;
        if let Some(union) = soon.and_then(|union| sound(&union, bodies)) {
            return Ok(union);
        }
    }
    let names: Vec<&str> = bodies.iter().map(|body| body.name).take(MOST_NAMES).collect();
    let message = format!(
        "these parts cannot be joined into one solid, because numbers of seven digits do not tell their surfaces apart where they meet: {}; expected parts that run into each other, or to be written as they are",
        names.join(", ")
    );
    Err(Error::new(Code::CrossesItself, "union", message).with("what", "not-joined"))
}

/// The union of all in turn; `None` where there is none.
fn united(bodies: &[&Labelled], near: f64) -> Result<Option<Manifold>> {
    let mut union: Option<Manifold> = None;
    for (index, body) in bodies.iter().enumerate() {
        watch::go_on()?;
        let next = || {
            let mut solid = manifold(body)?;
            solid.eps = solid.eps.max(near * solid.bb.scale());
            match union.take() {
                None => Some(solid),
                Some(others) => compute_boolean(&others, &solid, OpType::Add).ok(),
            }
        };
        // Whatever that crate meets that it did not expect is one body fewer that can be joined, and no mistake of whoever asked.
        let found = watch::share(index, bodies.len(), || catch_unwind(AssertUnwindSafe(next)));
        match found {
            Ok(Some(solid)) => union = Some(solid),
            _ => return Ok(None),
        }
    }
    Ok(union)
}

fn manifold(body: &Labelled) -> Option<Manifold> {
    let positions: Vec<f64> = body.positions.iter().map(|x| f64::from(*x)).collect();
    let indices: Vec<usize> = body.indices.iter().map(|vertex| *vertex as usize).collect();
    let labels: Vec<f64> = body.labels.iter().flat_map(|label| [f64::from(*label); 3]).collect();
    Manifold::new_with_values(&positions, &indices, &labels).ok()
}

/// What is written of a union, if it passes what every body has to.
fn sound(union: &Manifold, bodies: &[&Labelled]) -> Option<Union> {
    let most = bodies.iter().flat_map(|body| &body.labels).copied().max()?;
    let corner = |half: usize| union.hs.get(half).map(|half| half.tail);
    let mut whole: Vec<(u32, [usize; 3])> = Vec::with_capacity(union.hs.len() / 3);
    for triangle in 0..union.hs.len() / 3 {
        let [a, b, c] = [0, 1, 2].map(|k| corner(3 * triangle + k).filter(|vertex| *vertex < union.ps.len()));
        let label = union.vals.get(3 * triangle).map(|label| libm::round(*label))?;
        if !(0.0..=f64::from(most)).contains(&label) {
            return None;
        }
        whole.push((label as u32, [a?, b?, c?]));
    }
    whole.sort_by_key(|(label, _)| *label);
    let mut number = vec![u32::MAX; union.ps.len()];
    let mut points: Vec<[f32; 3]> = Vec::with_capacity(union.ps.len());
    let mut triangles: Vec<[u32; 3]> = Vec::with_capacity(whole.len());
    for (_, triangle) in &whole {
        triangles.push(triangle.map(|vertex| {
            if number[vertex] == u32::MAX {
                number[vertex] = points.len() as u32;
                points.push(union.ps[vertex].to_array().map(|x| x as f32));
            }
            number[vertex]
        }));
    }
    let topology = passes(&points, &triangles)?;
    let labels = whole.into_iter().map(|(label, _)| label).collect();
    is_volume_of(&points, &triangles, bodies).then_some(Union { points, triangles, labels, topology })
}

/// Closed, without triangles that cross or have no area, on the very numbers of the file.
fn passes(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> Option<Topology> {
    let at = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
    let is_plain = !triangles.is_empty()
        && points.iter().flatten().all(|x| x.is_finite())
        && !triangles.iter().any(|triangle| check::is_degenerate(at(triangle)));
    let topology = is_plain.then(|| check::closed(triangles, points.len()).ok()).flatten()?;
    (check::crossings_soon(points, triangles, |_| None, 1) == (Vec::new(), None)).then_some(topology)
}

/// Whether a union is no less than the largest of its bodies, and no more than all of them.
fn is_volume_of(points: &[[f32; 3]], triangles: &[[u32; 3]], bodies: &[&Labelled]) -> bool {
    let origin = points.first().map_or([0.0; 3], |point| point.map(f64::from));
    let own = volume(triangles.iter().map(|t| t.map(|vertex| points[vertex as usize].map(f64::from))), origin);
    let volumes = bodies.iter().map(|body| {
        let point = |vertex: u32| [0, 1, 2].map(|axis| f64::from(body.positions[3 * vertex as usize + axis]));
        volume(body.indices.chunks_exact(3).map(|t| [point(t[0]), point(t[1]), point(t[2])]), origin)
    });
    let (most, all) = volumes.fold((0.0f64, 0.0), |(most, all), volume| (most.max(volume), all + volume));
    (most - SLACK * all..=all + SLACK * all).contains(&own)
}

/// Six times the volume within triangles.
fn volume(triangles: impl Iterator<Item = [[f64; 3]; 3]>, origin: [f64; 3]) -> f64 {
    let six = triangles.map(|triangle| {
        let [a, b, c] = triangle.map(|p| [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]]);
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    });
    six.sum()
}
