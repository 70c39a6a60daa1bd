//! Bodies of one object as one solid.

use std::borrow::Cow;

use super::coats::Covering;
use super::contents::Body;
use crate::design::Look;
use crate::error::Result;
use crate::face::FaceKind;
use crate::join::{Labelled, Union, Unions};
use crate::watch;

/// The longest name that is put together of those of all parts.
const LONGEST: usize = 120;

/// The bodies with those of one object joined into one, in the order of the first of each; `objects` has the object of each body, `tolerance` what their triangles keep, in millimetres. `whole` has each body with no triangle divided along a glaze line, and what covers it:
/// the very triangles that the checks have joined, which are taken where the others cannot be joined.
///
/// # Errors
/// `crosses-itself` where no union passes the checks of a file, `too-large`.
pub(super) fn joined<'a>(
    unions: &Unions,
    bodies: Vec<Body<'a>>,
    objects: &[u32],
    tolerance: Option<f64>,
    whole: impl Fn(usize) -> (Body<'a>, Covering),
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
            if bodies.len() == 1 {
                return Ok(bodies.remove(0));
            }
            one_of(unions, &bodies, tolerance, |_, origin| origin.look).or_else(|error| {
                if bodies.iter().all(|body| body.coats.is_empty()) {
                    return Err(error);
                }
                let (wholes, coverings): (Vec<Body>, Vec<Covering>) = indices.into_iter().map(&whole).unzip();
                one_of(unions, &wholes, tolerance, |heights, origin| {
                    coverings[origin.body].at(origin.kind, heights).of(origin.look)
                })
            })
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

/// The union of bodies, made anew where it is not among those that are known; `look` says how a triangle looks whose corners are at these heights.
fn one_of(
    unions: &Unions,
    bodies: &[Body],
    tolerance: Option<f64>,
    look: impl Fn([f32; 3], &Origin) -> Look,
) -> Result<Body<'static>> {
    let mut origins: Vec<Origin> = Vec::new();
    let labelled: Vec<Labelled> =
        bodies.iter().enumerate().map(|(index, body)| labelled(index, body, &mut origins)).collect();
    let union = unions.union(&labelled.iter().collect::<Vec<_>>(), tolerance)?;
    let Union { points, triangles, labels, .. } = &*union;
    let mut faces: Vec<(FaceKind, usize, usize)> = Vec::new();
    let mut last = None;
    for (place, label) in labels.iter().enumerate() {
        match faces.last_mut() {
            Some((_, _, count)) if last == Some(*label) => *count += 3,
            _ => faces.push((origins[*label as usize].kind, 3 * place, 3)),
        }
        last = Some(*label);
    }
    let look = |(corners, label): (&[u32; 3], &u32)| {
        look(corners.map(|vertex| points[vertex as usize][2]), &origins[*label as usize])
    };
    let plain = triangles.iter().zip(labels).map(look).collect();
    Ok(Body {
        name: name(bodies),
        look: bodies[0].look,
        positions: Cow::Owned(points.concat()),
        indices: Cow::Owned(triangles.concat()),
        faces,
        coats: Vec::new(),
        plain,
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
    use super::super::Format;
    use super::super::coats::Coat;
    use super::*;
    use crate::design::Design;
    use crate::make::Making;
    use crate::solid::Product;
    use crate::solution::Solution;

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
        let bodies = |coats: &[Coat]| {
            [tetrahedron([0.0; 3], [4.0; 3]), across()]
                .map(|body| Body { coats: coats.to_vec(), ..body })
                .into_iter()
                .collect::<Vec<_>>()
        };
        let whole =
            |index: usize| (if index == 0 { tetrahedron([-1.0; 3], [6.0; 3]) } else { across() }, Covering::default());
        let found = |coats: &[Coat], objects: [u32; 2]| {
            joined(&Unions::default(), bodies(coats), &objects, None, whole)
                .map(|bodies| bodies.into_iter().map(|body| body.name).collect::<Vec<_>>())
        };
        assert_eq!(found(&[], [7, 7]).unwrap_err().arg("what"), Some(&"pinched-joint".into()));
        assert_eq!(found(&[], [7, 8]).unwrap(), ["one", "one"]);
        assert_eq!(found(&[Coat::Outside; 4], [7, 7]).unwrap(), ["one + one"]);
    }

    /// As a dialog asks: the check, files in one format after another, the check again.
    #[test]
    fn a_file_takes_the_union_of_its_check() {
        let octant = |shift: &str| {
            format!(r#"{{ "shape": {{ "kind": "octant", "exponents": [2, 2, 2] }}, "place": {{ "shift": {shift} }} }}"#)
        };
        let text = format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, octant("[0, 0, 0]"), octant("[0.3, 0.2, 0.1]"));
        let design = Design::parse(&text).unwrap();
        let solution = Solution::of(&design);
        let making = Making { product: Product::Solid, tolerance: Some(0.02), union: true, ..Making::default() };
        let finer = Making { tolerance: Some(0.01), ..making };
        for (making, n_kept) in [(making, 1), (making, 1), (finer, 2)] {
            let report = solution.check(&making).unwrap();
            assert!(report.is_ok() && report.unions.len() == 1, "{report:?}");
            for format in [Format::Stl, Format::Glb, Format::Ply] {
                assert!(solution.write(format, &making).unwrap() == crate::write(&design, format, &making).unwrap());
            }
            assert_eq!(Unions::of(&solution).n_kept(), n_kept);
        }
    }
}
