//! Bodies of one object as one solid: the union of their triangles.
//!
//! The union is that of the crate `boolmesh`, after E. Lalish's *Manifold*: decided by topology and not by coordinates, so that what comes of closed bodies is closed. Whether it is still so once its coordinates are rounded to those of a file is checked here, as of every body that is written.

use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};

use boolmesh::prelude::{Manifold, OpType, compute_boolean};

use super::contents::Body;
use crate::check;
use crate::design::Look;
use crate::error::{Code, Error, Result};
use crate::face::FaceKind;
use crate::watch;

/// The most triangles of all bodies that are joined.
const MOST_TRIANGLES: usize = 2_000_000;

/// Corners nearer to each other than this share of the size are drawn together, in turn, until what is left survives rounding to seven digits.
const NEAR: [f64; 3] = [1e-12, 2e-7, 2e-6];

/// How far the volume of a union may lie outside what those of its bodies allow, as a share of these.
const SLACK: f64 = 1e-5;

/// The longest name that is put together of those of all parts.
const LONGEST: usize = 120;

/// The bodies with those of one object joined into one, in the order of the first of each; `objects` has the object of each body.
///
/// # Errors
/// `crosses-itself` where no union passes the checks of a file, `too-large`.
pub(super) fn joined<'a>(bodies: Vec<Body<'a>>, objects: &[u32]) -> Result<Vec<Body<'a>>> {
    let mut groups: Vec<(u32, Vec<Body<'a>>)> = Vec::new();
    for (body, object) in bodies.into_iter().zip(objects) {
        match groups.iter_mut().find(|(number, _)| number == object) {
            Some((_, group)) => group.push(body),
            None => groups.push((*object, vec![body])),
        }
    }
    let n_groups = groups.len();
    let one = |(index, (_, group)): (usize, (u32, Vec<Body<'a>>))| {
        watch::share(index, n_groups, || match <[Body<'a>; 1]>::try_from(group) {
            Ok([single]) => Ok(single),
            Err(several) => union(&several),
        })
    };
    groups.into_iter().enumerate().map(one).collect()
}

/// What a triangle was before: a face of one of the bodies, and how that looks.
struct Origin {
    body: usize,
    face: usize,
    kind: FaceKind,
    look: Look,
}

/// The triangles of a body with the number of the origin of each.
struct Labelled {
    positions: Vec<f64>,
    indices: Vec<usize>,
    labels: Vec<f64>,
}

fn union(bodies: &[Body]) -> Result<Body<'static>> {
    let n_triangles = bodies.iter().map(Body::n_triangles).sum::<usize>();
    if n_triangles > MOST_TRIANGLES {
        let message = format!(
            "expected at most {MOST_TRIANGLES} triangles to be joined, found {n_triangles}; a larger tolerance takes fewer"
        );
        let error = Error::new(Code::TooLarge, "tolerance", message).with("greatest", MOST_TRIANGLES);
        return Err(error.with("found", n_triangles));
    }
    let mut origins: Vec<Origin> = Vec::new();
    let labelled: Vec<Labelled> =
        bodies.iter().enumerate().map(|(index, body)| labelled(index, body, &mut origins)).collect();
    for near in NEAR {
        watch::go_on()?;
        if let Some(solid) = united(&labelled, near)?.and_then(|union| sound(&union, &labelled, &origins)) {
            return Ok(Body { name: name(bodies), look: bodies[0].look, ..solid });
        }
    }
    let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).take(3).collect();
    let message = format!(
        "these parts cannot be joined into one solid, because numbers of seven digits do not tell their surfaces apart where they meet: {}; expected parts that run into each other, or to be written as they are",
        names.join(", ")
    );
    Err(Error::new(Code::CrossesItself, "union", message).with("what", "not-joined"))
}

fn labelled(index: usize, body: &Body, origins: &mut Vec<Origin>) -> Labelled {
    let looks = body.looks();
    let look_of = body.look_of();
    let mut labels = Vec::with_capacity(body.indices.len());
    for (face, &(kind, first, count)) in body.faces.iter().enumerate() {
        for triangle in first / 3..(first + count) / 3 {
            let look = looks.get(look_of(triangle)).copied().unwrap_or(body.look);
            let is_this = |origin: &Origin| (origin.body, origin.face, origin.look) == (index, face, look);
            let label = origins.iter().rposition(is_this).unwrap_or_else(|| {
                origins.push(Origin { body: index, face, kind, look });
                origins.len() - 1
            });
            labels.extend([label as f64; 3]);
        }
    }
    Labelled {
        positions: body.positions.iter().map(|x| f64::from(*x)).collect(),
        indices: body.indices.iter().map(|vertex| *vertex as usize).collect(),
        labels,
    }
}

/// The union of all in turn; `None` where there is none.
fn united(bodies: &[Labelled], near: f64) -> Result<Option<Manifold>> {
    let mut union: Option<Manifold> = None;
    for (index, body) in bodies.iter().enumerate() {
        watch::go_on()?;
        let next = || {
            let mut solid = Manifold::new_with_values(&body.positions, &body.indices, &body.labels).ok()?;
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

/// The body that is written of a union, if it passes what every body has to.
fn sound(union: &Manifold, bodies: &[Labelled], origins: &[Origin]) -> Option<Body<'static>> {
    let corner = |half: usize| union.hs.get(half).map(|half| half.tail);
    let mut triangles: Vec<(usize, [usize; 3])> = Vec::with_capacity(union.hs.len() / 3);
    for triangle in 0..union.hs.len() / 3 {
        let [a, b, c] = [0, 1, 2].map(|k| corner(3 * triangle + k).filter(|vertex| *vertex < union.ps.len()));
        let label = union.vals.get(3 * triangle).map(|label| libm::round(*label))?;
        if !(0.0..origins.len() as f64).contains(&label) {
            return None;
        }
        triangles.push((label as usize, [a?, b?, c?]));
    }
    triangles.sort_by_key(|(label, _)| *label);
    let mut number = vec![u32::MAX; union.ps.len()];
    let mut points: Vec<[f32; 3]> = Vec::with_capacity(union.ps.len());
    let mut corners: Vec<[u32; 3]> = Vec::with_capacity(triangles.len());
    for (_, triangle) in &triangles {
        corners.push(triangle.map(|vertex| {
            if number[vertex] == u32::MAX {
                number[vertex] = points.len() as u32;
                points.push(union.ps[vertex].to_array().map(|x| x as f32));
            }
            number[vertex]
        }));
    }
    if !passes(&points, &corners) || !is_volume_of(&points, &corners, bodies) {
        return None;
    }
    let mut faces: Vec<(FaceKind, usize, usize)> = Vec::new();
    let mut last = None;
    for (place, (label, _)) in triangles.iter().enumerate() {
        match faces.last_mut() {
            Some((_, _, count)) if last == Some(*label) => *count += 3,
            _ => faces.push((origins[*label].kind, 3 * place, 3)),
        }
        last = Some(*label);
    }
    Some(Body {
        name: String::new(),
        look: Look::default(),
        positions: Cow::Owned(points.concat()),
        indices: Cow::Owned(corners.concat()),
        faces,
        coats: Vec::new(),
        plain: triangles.iter().map(|(label, _)| origins[*label].look).collect(),
    })
}

/// Closed, without triangles that cross or have no area, on the very numbers of the file.
fn passes(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> bool {
    let at = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
    !triangles.is_empty()
        && points.iter().flatten().all(|x| x.is_finite())
        && !triangles.iter().any(|triangle| check::is_degenerate(at(triangle)))
        && check::closed(triangles, points.len()).is_ok()
        && check::crossings_soon(points, triangles, |_| None, 1) == (Vec::new(), None)
}

/// Whether a union is no less than the largest of its bodies, and no more than all of them.
fn is_volume_of(points: &[[f32; 3]], triangles: &[[u32; 3]], bodies: &[Labelled]) -> bool {
    let origin = points.first().map_or([0.0; 3], |point| point.map(f64::from));
    let own = volume(triangles.iter().map(|t| t.map(|vertex| points[vertex as usize].map(f64::from))), origin);
    let volumes = bodies.iter().map(|body| {
        let point = |vertex: usize| [0, 1, 2].map(|axis| body.positions[3 * vertex + axis]);
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

/// `body + lid`.
fn name(bodies: &[Body]) -> String {
    let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
    let all = names.join(" + ");
    match all.chars().count() <= LONGEST {
        true => all,
        false => format!("{} and {} more", names[0], names.len() - 1),
    }
}
