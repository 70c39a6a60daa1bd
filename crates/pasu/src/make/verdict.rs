//! The verdict on a design: made part by part, with whatever there is to say.

use std::borrow::Borrow;

use super::made::{Made, make};
use super::making::Making;
use super::report::{Finding, MeshReport, Report, Severity};
use crate::design::Design;
use crate::error::Result;
use crate::solid::{place, short};
use crate::solution::Solution;

/// Makes every part as [`solid`](crate::solid()) does and says what was found: why a part cannot be made, or what differs from what was asked for.
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
        Ok(verdict(making, (0..self.n_parts()).map(|part| make(self, part, making, scale))))
    }
}

/// What there is to say of parts that were made, or refused, in their order.
pub(crate) fn verdict(making: &Making, parts: impl Iterator<Item = Result<impl Borrow<Made>>>) -> Report {
    let mut report = Report { product: making.product, findings: Vec::new(), meshes: Vec::new() };
    for (part, made) in parts.enumerate() {
        match made {
            Ok(made) => {
                report.findings.extend(findings(made.borrow()));
                report.meshes.push(counted(made.borrow()));
            }
            Err(error) => report.findings.push(Finding {
                code: error.code().as_str(),
                severity: Severity::Error,
                part,
                message: error.message().to_owned(),
                at: error.place(),
            }),
        }
    }
    report.findings.sort_by_key(|finding| finding.severity);
    report
}

fn counted(Made { mesh, pot, topology }: &Made) -> MeshReport {
    MeshReport {
        part: mesh.part,
        vertices: mesh.n_vertices(),
        triangles: mesh.n_triangles(),
        closed: true,
        genus: Some(topology.genus()),
        degenerate: 0,
        crossings: 0,
        bound: mesh.bound,
        thinned: pot.thinned().map_or(0.0, |(share, _)| share),
        thinnest: pot.has_wall().then(|| pot.thickness().0),
    }
}

fn findings(made: &Made) -> Option<Finding> {
    let pot = &made.pot;
    let (share, at) = pot.thinned()?;
    let message = format!(
        "the wall had to be thinned to {} at {}, where the surface bends more tightly or comes closer to itself than the wall is thick; {} % of it is thinner than asked for",
        short(pot.thickness().0),
        place(at),
        short(100.0 * share)
    );
    let severity = Severity::Warning;
    Some(Finding { code: "thinned", severity, part: pot.part(), message, at: Some(at.to_array()) })
}
