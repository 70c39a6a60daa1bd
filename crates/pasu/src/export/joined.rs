//! Bodies of one object as one solid.

use std::borrow::Cow;

use super::contents::Body;
use crate::design::Look;
use crate::error::Result;
use crate::face::FaceKind;
use crate::join::{Labelled, Union, union};
use crate::watch;

/// The longest name that is put together of those of all parts.
const LONGEST: usize = 120;

/// The bodies with those of one object joined into one, in the order of the first of each; `objects` has the object of each body, and `whole` each body as the checks have joined it: with no triangle divided along a glaze line.
/// That one is joined where the other cannot be.
///
/// # Errors
/// `crosses-itself` where no union passes the checks of a file, `too-large`.
pub(super) fn joined<'a>(
    bodies: Vec<Body<'a>>,
    objects: &[u32],
    whole: impl Fn(usize) -> Body<'a>,
) -> Result<Vec<Body<'a>>> {
    let mut groups: Vec<(u32, Vec<(usize, Body<'a>)>)> = Vec::new();
    for (index, (body, object)) in bodies.into_iter().zip(objects).enumerate() {
        match groups.iter_mut().find(|(number, _)| number == object) {
            Some((_, group)) => group.push((index, body)),
            None => groups.push((*object, vec![(index, body)])),
        }
    }
    let n_groups = groups.len();
    let one = |(index, (_, group)): (usize, (u32, Vec<(usize, Body<'a>)>))| {
        watch::share(index, n_groups, || {
            let (indices, mut bodies): (Vec<usize>, Vec<Body<'a>>) = group.into_iter().unzip();
            match bodies.len() {
                1 => Ok(bodies.remove(0)),
                _ => one_of(&bodies).or_else(|error| {
                    let wholes: Vec<Body<'a>> = indices.into_iter().map(&whole).collect();
                    let is_divided = bodies.iter().zip(&wholes).any(|(one, whole)| one.indices != whole.indices);
                    if is_divided { one_of(&wholes) } else { Err(error) }
                }),
            }
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

fn one_of(bodies: &[Body]) -> Result<Body<'static>> {
    let mut origins: Vec<Origin> = Vec::new();
    let labelled: Vec<Labelled> =
        bodies.iter().enumerate().map(|(index, body)| labelled(index, body, &mut origins)).collect();
    let Union { points, triangles, labels, .. } = union(&labelled.iter().collect::<Vec<_>>())?;
    let mut faces: Vec<(FaceKind, usize, usize)> = Vec::new();
    let mut last = None;
    for (place, label) in labels.iter().enumerate() {
        match faces.last_mut() {
            Some((_, _, count)) if last == Some(*label) => *count += 3,
            _ => faces.push((origins[*label as usize].kind, 3 * place, 3)),
        }
        last = Some(*label);
    }
    Ok(Body {
        name: name(bodies),
        look: bodies[0].look,
        positions: Cow::Owned(points.concat()),
        indices: Cow::Owned(triangles.concat()),
        faces,
        coats: Vec::new(),
        plain: labels.iter().map(|label| origins[*label as usize].look).collect(),
    })
}

/// A body, each triangle with the number of its origin.
fn labelled<'a>(index: usize, body: &'a Body, origins: &mut Vec<Origin>) -> Labelled<'a> {
    let looks = body.looks();
    let look_of = body.look_of();
    let mut labels = Vec::with_capacity(body.n_triangles());
    for (face, &(kind, first, count)) in body.faces.iter().enumerate() {
        for triangle in first / 3..(first + count) / 3 {
            let look = looks.get(look_of(triangle)).copied().unwrap_or(body.look);
            let is_this = |origin: &Origin| (origin.body, origin.face, origin.look) == (index, face, look);
            let label = origins.iter().rposition(is_this).unwrap_or_else(|| {
                origins.push(Origin { body: index, face, kind, look });
                origins.len() - 1
            });
            labels.push(label as u32);
        }
    }
    Labelled { name: &body.name, positions: &body.positions, indices: &body.indices, labels }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron of the first, the second and the third axis.
    fn tetrahedron(origin: [f32; 3], axes: [f32; 3]) -> Body<'static> {
        let at = |axis: usize| {
            let mut at = origin;
            at[axis] += axes[axis];
            at
        };
        let is_turned = axes.iter().product::<f32>() < 0.0;
        let indices = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        Body {
            name: "one".to_owned(),
            look: Look::default(),
            positions: Cow::Owned([origin, at(0), at(1), at(2)].concat()),
            indices: Cow::Owned(indices.map(|[a, b, c]| if is_turned { [a, c, b] } else { [a, b, c] }).concat()),
            faces: vec![(FaceKind::Outer, 0, 12)],
            coats: Vec::new(),
            plain: Vec::new(),
        }
    }

    /// Across from each other at an edge: no solid. Of the other two one reaches into the other.
    #[test]
    fn whole_bodies_are_joined_where_divided_ones_cannot_be() {
        let across = || tetrahedron([0.0; 3], [-4.0, -4.0, 4.0]);
        let bodies = || vec![tetrahedron([0.0; 3], [4.0, 4.0, 4.0]), across()];
        let same = |index: usize| bodies().remove(index);
        let error = joined(bodies(), &[7, 7], same).map(|bodies| bodies.len()).unwrap_err();
        assert_eq!(error.arg("what"), Some(&"pinched-joint".into()));
        assert_eq!(joined(bodies(), &[7, 8], same).map(|bodies| bodies.len()).ok(), Some(2));
        let whole = |index: usize| if index == 0 { tetrahedron([-1.0; 3], [6.0, 6.0, 6.0]) } else { across() };
        let found = joined(bodies(), &[7, 7], |index| {
            let mut body = whole(index);
            // Divided or not is told by the triangles.
            body.indices.to_mut().rotate_left(3);
            body
        });
        assert_eq!(found.map(|bodies| (bodies.len(), bodies[0].name.clone())).ok(), Some((1, "one + one".to_owned())));
    }
}
