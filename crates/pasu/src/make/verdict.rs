//! The verdict on a design: made part by part, with whatever there is to say.

use std::sync::Arc;

use super::called::called;
use super::fitted;
#[cfg(feature = "patchwork")]
use super::folded;
#[cfg(feature = "patchwork")]
use super::joined::unions as joined;
use super::made::{Finished, make};
use super::makeable;
use super::making::Making;
use super::remedy::remedy;
#[cfg(not(feature = "patchwork"))]
use super::report::UnionReport;
use super::report::{Finding, MeshReport, Report, Severity};
use super::together;
use crate::design::Design;
use crate::error::{Args, Code, Result};
use crate::solid::{Pot, place, short};
use crate::solution::Solution;
use crate::watch;
use crate::weave::SolidMesh;

/// Makes every part as [`solid`](crate::solid()) does, and with [`Making::union`] of those of each object one solid as [`write()`](crate::write()) does, and says what was found: why a part cannot be made and what would help, or what differs from what was asked for, such as a ring that was fitted. A part without a wall is left out of the pots with a warning, where another part has one.
///
/// # Errors
/// `out-of-range` for a size, shrinkage or tolerance outside its range, and what scaling to a size refuses. What is wrong with a part is a finding, not an error.
///
/// ```
/// use pasu::{Code, Design, Making};
///
/// let vase = Design::parse("#1/bloor-wilson?n1=5")?;
/// let report = pasu::check(&vase, &Making::default())?;
/// // It has no wall, and so is no pot.
/// assert!(!report.is_ok());
/// assert_eq!(report.findings[0].code, Code::NoWall.as_str());
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn check(design: &Design, making: &Making) -> Result<Report> {
    Solution::of(design).check(making)
}

impl Solution {
    /// As [`check`].
    ///
    /// # Errors
    /// As [`check`].
    pub fn check(&self, making: &Making) -> Result<Report> {
        self.all_workable()?;
        let scale = making.scale_of(self)?.millimetres;
        let wanted = self.parts_of(making.product);
        let mut refused = Vec::new();
        let mut made = Vec::new();
        let mut n_remedies = 0;
        let making_share = if making.union { MAKING_APART } else { MAKING };
        for part in 0..self.n_parts() {
            watch::go_on()?;
            if !wanted.contains(&part) {
                refused.push(left_out(part));
                continue;
            }
            let one = || make(self, part, making, scale);
            match watch::between(0.0, making_share, || watch::share(part, self.n_parts(), one)) {
                Ok(one) => {
                    if one.pot.is_none() {
                        #[cfg(feature = "patchwork")]
                        refused.extend(folded::finding(self.part(part)?));
                    }
                    made.push(one);
                }
                Err(error) => {
                    n_remedies += 1;
                    let remedy = if n_remedies <= REMEDIES { remedy(self, part, making, scale, &error) } else { None };
                    let (code, path, args) = error.cause();
                    let (severity, message, at) = (Severity::Error, error.message().to_owned(), error.place());
                    refused.push(Finding { code, severity, part, path, message, args, at, remedy });
                }
            }
        }
        let mut unions = Vec::new();
        if making.union {
            let (joined, not) = watch::between(MAKING_APART, MAKING, || joined(self, &made, &refused, making, scale));
            watch::go_on()?;
            unions = joined;
            refused.extend(not);
        }
        Ok(Report { unions, ..verdict(self.design(), making, scale, refused, &made) })
    }
}

/// What joins bodies is left out of this build.
#[cfg(not(feature = "patchwork"))]
fn joined(_: &Solution, _: &[Arc<Finished>], _: &[Finding], _: &Making, _: f64) -> (Vec<UnionReport>, Vec<Finding>) {
    let message = "what joins parts is left out of this build: it takes the feature patchwork".to_owned();
    let (code, path, args) =
        (Code::UnsupportedShape.as_str(), Some("union".to_owned()), Args::from([("what", "left-out".into())]));
    (
        Vec::new(),
        vec![Finding { code, severity: Severity::Error, part: 0, path, message, args, at: None, remedy: None }],
    )
}

/// A part without a wall beside others that are pots.
fn left_out(part: usize) -> Finding {
    let message = "this part has no wall and is left out of the pots: with thickness and base it is one".to_owned();
    let (path, args) = (Some(format!("parts[{part}].wall")), Args::from([("what", "left-out".into())]));
    let (code, severity) = (Code::NoWall.as_str(), Severity::Warning);
    Finding { code, severity, part, path, message, args, at: None, remedy: None }
}

/// The share of the time that making takes, as against looking at what was made.
const MAKING: f64 = 0.9;
/// The share of making alone, where what was made is joined.
const MAKING_APART: f64 = 0.5;

/// For how many parts that are refused a remedy is sought: each takes as long as making the part a few times.
const REMEDIES: usize = 3;

/// What there is to say of the parts of a design that were made, besides what was said of those that were refused; `millimetres` is how many a model unit has.
pub(crate) fn verdict(
    design: &Design,
    making: &Making,
    millimetres: f64,
    refused: Vec<Finding>,
    made: &[Arc<Finished>],
) -> Report {
    let mut findings = refused;
    for one in made {
        findings.extend(fitted::findings(one, design));
        findings.extend(thinned(one));
        findings.extend(unkept(one));
        findings.extend(makeable::findings(one, making.craft, millimetres));
    }
    let meshes: Vec<&SolidMesh> = made.iter().map(|made| &made.mesh).collect();
    let name = |part: usize| called(design, part);
    let object = |part: usize| design.parts().get(part).map(|part| part.object);
    // What becomes one solid is not in its own way.
    let is_joined = |finding: &Finding| {
        let other =
            design.parts().iter().enumerate().find(|(index, _)| finding.args.get("other") == Some(&(*index).into()));
        making.union && other.is_some_and(|(index, _)| object(index) == object(finding.part))
    };
    findings.extend(together::findings(&meshes, name, millimetres).into_iter().filter(|finding| !is_joined(finding)));
    findings.sort_by_key(|finding| finding.severity);
    Report {
        product: making.product,
        findings,
        meshes: made.iter().map(|made| counted(made)).collect(),
        unions: Vec::new(),
    }
}

fn counted(Finished { mesh, pot, topology, .. }: &Finished) -> MeshReport {
    MeshReport {
        part: mesh.part,
        vertices: mesh.n_vertices(),
        triangles: mesh.n_triangles(),
        closed: true,
        genus: Some(topology.genus()),
        degenerate: 0,
        crossings: 0,
        bound: mesh.bound,
        thinned: pot.as_ref().and_then(Pot::thinned).map_or(0.0, |(share, _)| share),
        thinnest: pot.as_ref().filter(|pot| pot.has_wall()).map(|pot| pot.thickness().0),
    }
}

fn thinned(made: &Finished) -> Option<Finding> {
    let pot = made.pot.as_ref()?;
    let (share, at) = pot.thinned()?;
    let message = format!(
        "the wall had to be thinned to {} at {}, where the surface bends more tightly or comes closer to itself than the wall is thick; {} % of it is thinner than asked for",
        short(pot.thickness().0),
        place(at),
        short(100.0 * share)
    );
    let (severity, at) = (Severity::Warning, Some(at.to_array()));
    let path = Some(pot.skin().placed().path("wall.thickness"));
    let args = Args::from([("thickness", pot.thickness().0.into()), ("share", share.into())]);
    Some(Finding { code: "thinned", severity, part: pot.part(), path, message, args, at, remedy: None })
}

/// A tolerance that is not kept is told; what keeps it is the mesh of the surface, but the wall on it may bend more sharply than any mesh follows.
fn unkept(made: &Finished) -> Option<Finding> {
    let asked = made.unkept?;
    let message = format!(
        "the triangles come within {} of the wall, not within {} as asked for: its other side bends too sharply for that",
        short(made.mesh.bound),
        short(asked)
    );
    let (code, severity, path) = (Code::ToleranceTooFine.as_str(), Severity::Warning, Some("tolerance".to_owned()));
    let args = Args::from([("what", "unkept".into()), ("bound", made.mesh.bound.into()), ("asked", asked.into())]);
    Some(Finding { code, severity, part: made.mesh.part, path, message, args, at: None, remedy: None })
}
