//! Whether the parts of each object can be one solid, tried on the triangles that were made of them.

use std::sync::Arc;

use super::called::called;
use super::made::Finished;
use super::making::Making;
use super::report::{Finding, Severity, UnionReport};
use crate::error::{Args, Code, Error};
use crate::face::FaceKind;
use crate::join::{Labelled, Unions};
use crate::solid::short;
use crate::solution::Solution;
use crate::watch;

/// What comes of the parts of every object of which several were made, in the order in which a file has them; nothing of one of which a part is refused.
///
/// `scale` is from model units to millimetres.
pub(super) fn unions(
    solution: &Solution,
    made: &[Arc<Finished>],
    refused: &[Finding],
    making: &Making,
    scale: f64,
) -> (Vec<UnionReport>, Vec<Finding>) {
    let design = solution.design();
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
        match watch::share(index, n_groups, || one(solution, &group, making, scale)) {
            Ok((report, unkept)) => {
                reports.push(report);
                findings.extend(unkept);
            }
            Err(finding) => findings.push(*finding),
        }
    }
    (reports, findings)
}

fn one(
    solution: &Solution,
    group: &[&Finished],
    making: &Making,
    scale: f64,
) -> Result<(UnionReport, Option<Finding>), Box<Finding>> {
    let design = solution.design();
    let names: Vec<String> = group.iter().map(|one| called(design, one.mesh.part)).collect();
    // The labels that a file without colours has.
    let mut n_faces = 0;
    let labels = |one: &Finished| -> Vec<u32> {
        let face = |(_, _, count): &(FaceKind, u32, u32)| {
            n_faces += 1;
            vec![n_faces - 1; *count as usize / 3]
        };
        one.mesh.faces.iter().flat_map(face).collect()
    };
    let labels: Vec<Vec<u32>> = group.iter().copied().map(labels).collect();
    let bodies = group.iter().zip(&names).zip(labels).map(|((one, name), labels)| Labelled {
        name,
        positions: &one.mesh.positions,
        indices: &one.mesh.indices,
        labels,
    });
    let bodies: Vec<Labelled> = bodies.collect();
    let bodies: Vec<&Labelled> = bodies.iter().collect();
    match Unions::of(solution).union(&bodies, making.tolerance.map(|tolerance| tolerance * scale)) {
        Ok(union) => {
            let of_parts = group.iter().map(|one| one.mesh.bound).fold(0.0, f64::max);
            let report = UnionReport {
                parts: group.iter().map(|one| one.mesh.part).collect(),
                vertices: union.points.len(),
                triangles: union.triangles.len(),
                bodies: union.topology.n_components,
                genus: union.topology.genus(),
                bound: of_parts + union.moved / scale,
            };
            let asked = making.tolerance.filter(|asked| of_parts <= *asked && report.bound > *asked);
            let unkept = asked.map(|asked| moved(&report, asked));
            Ok((report, unkept))
        }
        Err(error) => Err(Box::new(refused(group, &error))),
    }
}

/// A tolerance that only parts apart keep is told.
fn moved(union: &UnionReport, asked: f64) -> Finding {
    let message = format!(
        "joined, the triangles come within {} of these parts, not within {} as asked for: where their surfaces all but coincide, joining moves them a little",
        short(union.bound),
        short(asked)
    );
    let (code, severity, path) = (Code::ToleranceTooFine.as_str(), Severity::Warning, Some("tolerance".to_owned()));
    let args = Args::from([("what", "joined".into()), ("bound", union.bound.into()), ("asked", asked.into())]);
    let part = union.parts.iter().copied().min().unwrap_or(0);
    Finding { code, severity, part, path, message, args, at: None, remedy: None }
}

/// What is told of parts that cannot be joined; of two it is the later one that cannot be joined with the other.
fn refused(group: &[&Finished], error: &Error) -> Finding {
    let mut parts: Vec<usize> = group.iter().map(|one| one.mesh.part).collect();
    parts.sort_unstable();
    let (code, path, mut args) = error.cause();
    let part = match parts[..] {
        [one, other] => {
            args.insert("other", one.into());
            other
        }
        _ => parts[0],
    };
    let (severity, message, at) = (Severity::Error, error.message().to_owned(), error.place());
    Finding { code, severity, part, path, message, args, at, remedy: None }
}
