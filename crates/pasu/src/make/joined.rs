//! Whether the parts of each object can be one solid, tried on the triangles that were made of them.

use glam::DVec3;

use super::called::called;
use super::made::Finished;
use super::report::{Finding, Severity, UnionReport};
use crate::design::Design;
use crate::error::Error;
use crate::join::{Labelled, union};
use crate::watch;

/// What comes of the parts of every object of which several were made, in the order in which a file has them; nothing of one of which a part is refused.
pub(super) fn unions(design: &Design, made: &[Finished], refused: &[Finding]) -> (Vec<UnionReport>, Vec<Finding>) {
    let object_of = |part: usize| design.parts().get(part).map(|part| part.object);
    let is_refused = |object: u32| {
        refused.iter().any(|found| found.severity == Severity::Error && object_of(found.part) == Some(object))
    };
    let mut groups: Vec<(u32, Vec<&Finished>)> = Vec::new();
    // A union goes by the order of its bodies, which in a file is that of links.
    for part in design.arranged(true) {
        let Some((one, object)) = made.iter().find(|one| one.mesh.part == part).zip(object_of(part)) else { continue };
        match groups.iter_mut().find(|(number, _)| *number == object) {
            Some((_, group)) => group.push(one),
            None => groups.push((object, vec![one])),
        }
    }
    groups.retain(|(object, group)| group.len() > 1 && !is_refused(*object));
    let (mut reports, mut findings) = (Vec::new(), Vec::new());
    let n_groups = groups.len();
    for (index, (_, group)) in groups.into_iter().enumerate() {
        match watch::share(index, n_groups, || one(design, &group)) {
            Ok(report) => reports.push(report),
            Err(finding) => findings.push(*finding),
        }
    }
    (reports, findings)
}

fn one(design: &Design, group: &[&Finished]) -> Result<UnionReport, Box<Finding>> {
    let names: Vec<String> = group.iter().map(|one| called(design, one.mesh.part)).collect();
    let bodies: Vec<Labelled> = group
        .iter()
        .zip(&names)
        .enumerate()
        .map(|(index, (one, name))| Labelled {
            name,
            positions: &one.mesh.positions,
            indices: &one.mesh.indices,
            labels: vec![index as u32; one.mesh.n_triangles()],
        })
        .collect();
    let bodies: Vec<&Labelled> = bodies.iter().collect();
    match union(&bodies) {
        Ok(union) => Ok(UnionReport {
            parts: group.iter().map(|one| one.mesh.part).collect(),
            vertices: union.points.len(),
            triangles: union.triangles.len(),
            bodies: union.topology.n_components,
            genus: union.topology.genus(),
        }),
        Err(error) => Err(Box::new(refused(group, &bodies, error))),
    }
}

/// Of so many pairs it is asked at most whether it is they that cannot be joined.
const MOST_PAIRS: usize = 24;

/// What is told of parts that cannot be joined: of the first two that cannot alone either, if there are such.
fn refused(group: &[&Finished], bodies: &[&Labelled], error: Error) -> Finding {
    let boxes: Vec<[DVec3; 2]> = bodies.iter().map(|body| bounds(body.positions)).collect();
    let meet = |[i, j]: &[usize; 2]| {
        let ([low, high], [other_low, other_high]) = (boxes[*i], boxes[*j]);
        low.cmple(other_high).all() && other_low.cmple(high).all()
    };
    let pairs = (0..bodies.len()).flat_map(|j| (0..j).map(move |i| [i, j])).filter(meet).take(MOST_PAIRS);
    // Two that are all there are have been asked.
    let mut pairs = pairs.filter(|_| bodies.len() > 2);
    let alone = pairs.find_map(|pair| union(&pair.map(|index| bodies[index])).err().map(|error| (pair, error)));
    let (told, error) = match alone {
        Some((pair, error)) => (Some(pair), error),
        None => ((bodies.len() == 2).then_some([0, 1]), error),
    };
    let (code, path, mut args) = error.cause();
    let parts = told.map(|pair| pair.map(|index| group[index].mesh.part));
    if let Some(parts) = parts {
        args.insert("other", parts[0].min(parts[1]).into());
    }
    let part =
        parts.map_or_else(|| group.iter().map(|one| one.mesh.part).min().unwrap_or(0), |[one, other]| one.max(other));
    let (severity, message, at) = (Severity::Error, error.message().to_owned(), error.place());
    Finding { code, severity, part, path, message, args, at, remedy: None }
}

fn bounds(positions: &[f32]) -> [DVec3; 2] {
    let points = positions.as_chunks::<3>().0.iter().map(|point| DVec3::from_array(point.map(f64::from)));
    points.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
}
