//! The union of several bodies, as a file has it.
//!
//! The union is that of the crate `boolmesh`, after E. Lalish's *Manifold*: decided by topology and not by coordinates, so that what comes of closed bodies is closed. Whether it is still so once its coordinates are rounded to those of a file is checked here, as of every body that is written.

use boolmesh::prelude::Manifold;

use super::cluster::united;
use super::labelled::Labelled;
use super::narrow::without_narrow;
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
    let mut is_pinched = false;
    for (index, near) in NEAR.into_iter().enumerate() {
        watch::go_on()?;
        let found = watch::share(index, NEAR.len(), || united(bodies, near))?;
        if let Some((solid, n_double)) = found {
            if let Some(union) = sound(&solid, bodies) {
                return Ok(union);
            }
            // Of more bodies nobody knows which of them that is.
            is_pinched |= bodies.len() == 2 && index == 0 && n_double > 0;
        }
    }
    let names: Vec<&str> = bodies.iter().map(|body| body.name).take(MOST_NAMES).collect();
    let names = names.join(", ");
    let refused = |message: String| Error::new(Code::CrossesItself, "union", message);
    if is_pinched {
        let message = format!(
            "these parts cannot be joined into one solid, which would be pinched where they touch along an edge or at a point alone: {names}; expected parts that meet in a face or run into each other, or to be written as they are"
        );
        return Err(refused(message).with("what", "pinched-joint"));
    }
    let message = format!(
        "these parts cannot be joined into one solid, because numbers of seven digits do not tell their surfaces apart where they meet: {names}; expected parts that run into each other, or to be written as they are"
    );
    Err(refused(message).with("what", "not-joined"))
}

/// What is written of a union, if it passes what every body has to as it is, or without triangles that are too narrow.
fn sound(union: &Manifold, bodies: &[&Labelled]) -> Option<Union> {
    let most = bodies.iter().flat_map(|body| &body.labels).copied().max()?;
    let corner = |half: usize| union.hs.get(half).map(|half| half.tail as u32);
    let (mut triangles, mut labels) = (Vec::new(), Vec::new());
    for triangle in 0..union.hs.len() / 3 {
        let [a, b, c] =
            [0, 1, 2].map(|k| corner(3 * triangle + k).filter(|vertex| (*vertex as usize) < union.ps.len()));
        let label = union.vals.get(3 * triangle).map(|label| libm::round(*label))?;
        if !(0.0..=f64::from(most)).contains(&label) {
            return None;
        }
        triangles.push([a?, b?, c?]);
        labels.push(label as u32);
    }
    let points: Vec<[f32; 3]> = union.ps.iter().map(|point| point.to_array().map(|x| x as f32)).collect();
    written(&points, &triangles, &labels, bodies).or_else(|| {
        let (triangles, labels) = without_narrow(&points, &triangles, &labels)?;
        written(&points, &triangles, &labels, bodies)
    })
}

/// Triangles in the order of their labels, and points in the order in which they come then, if they pass.
fn written(points: &[[f32; 3]], triangles: &[[u32; 3]], labels: &[u32], bodies: &[&Labelled]) -> Option<Union> {
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by_key(|number| labels[*number]);
    let mut number = vec![u32::MAX; points.len()];
    let (mut kept, mut renumbered): (Vec<[f32; 3]>, Vec<[u32; 3]>) = (Vec::new(), Vec::with_capacity(triangles.len()));
    for triangle in &order {
        renumbered.push(triangles[*triangle].map(|vertex| {
            let number = &mut number[vertex as usize];
            if *number == u32::MAX {
                *number = kept.len() as u32;
                kept.push(points[vertex as usize]);
            }
            *number
        }));
    }
    let topology = passes(&kept, &renumbered)?;
    let labels = order.into_iter().map(|triangle| labels[triangle]).collect();
    let is_sound = is_volume_of(&kept, &renumbered, bodies);
    is_sound.then_some(Union { points: kept, triangles: renumbered, labels, topology })
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
