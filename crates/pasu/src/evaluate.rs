//! Points of a design in double precision.

use crate::design::{Address, Design, numbers_of, plain};
use crate::error::{Code, Error, Result};
use crate::patch::SurfaceJet;
use crate::solution::{Placed, Solution};

/// Derivatives at the points asked for, three numbers each.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Derivatives {
    /// `X_u`.
    pub du: Vec<f64>,
    /// `X_v`.
    pub dv: Vec<f64>,
}

/// Positions, before placement, of part `part` at pairs `(u, v)`: `u` in [0, 1], `v` any number in the units of the shape's span; of a network of patches at triples `(patch, u, v)`, `u` and `v` in [0, 1].
///
/// # Errors
/// `no-such-point` for a part that does not exist, coordinates that are no whole pairs or triples, or a point outside the surface; what [`Surface::solve`](crate::Surface::solve) refuses; `overflow`.
///
/// ```
/// let vase = pasu::Design::parse("#1/second-order?height=9")?;
/// // The rim is at u = 0, the foot at u = 1.
/// let points = pasu::evaluate(&vase, 0, &[0.0, 0.0, 1.0, 0.5])?;
/// assert!((points[2] - 9.0).abs() < 1e-12 && points[5].abs() < 1e-12);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn evaluate(design: &Design, part: usize, at: &[f64]) -> Result<Vec<f64>> {
    Solution::of(design).evaluate(part, at)
}

/// `X_u` and `X_v`, before placement, of part `part` at pairs `(u, v)`, or triples `(patch, u, v)` of a network of patches.
///
/// # Errors
/// As [`evaluate`].
///
/// ```
/// let vase = pasu::Design::parse("#1/second-order?height=9")?;
/// let slopes = pasu::derivatives(&vase, 0, &[0.5, 0.25])?;
/// // The height falls evenly from the rim to the foot.
/// assert!((slopes.du[2] + 9.0).abs() < 1e-12 && slopes.dv[2] == 0.0);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn derivatives(design: &Design, part: usize, at: &[f64]) -> Result<Derivatives> {
    Solution::of(design).derivatives(part, at)
}

impl Solution {
    /// As [`evaluate`].
    ///
    /// # Errors
    /// As [`evaluate`].
    pub fn evaluate(&self, part: usize, at: &[f64]) -> Result<Vec<f64>> {
        let mut positions = Vec::with_capacity(at.len() / 2 * 3);
        self.for_each_point(part, at, |jet| positions.extend(jet.position.to_array()))?;
        finite(part, &positions)?;
        Ok(positions)
    }

    /// As [`derivatives`].
    ///
    /// # Errors
    /// As [`evaluate`].
    pub fn derivatives(&self, part: usize, at: &[f64]) -> Result<Derivatives> {
        let mut derivatives = Derivatives::default();
        self.for_each_point(part, at, |jet| {
            derivatives.du.extend(jet.du.to_array());
            derivatives.dv.extend(jet.dv.to_array());
        })?;
        finite(part, &derivatives.du)?;
        finite(part, &derivatives.dv)?;
        Ok(derivatives)
    }

    fn for_each_point(&self, part: usize, at: &[f64], mut visit: impl FnMut(&SurfaceJet)) -> Result<()> {
        self.check_points(part, at)?;
        let placed = self.part(part)?;
        let (_, of) = self.existing(part)?;
        match of.shape.address() {
            Address::Surface => at.chunks_exact(2).for_each(|point| visit(&jet(placed, point[0], point[1]))),
            Address::Patches(_) => at.chunks_exact(3).for_each(|point| {
                visit(&placed.solved().patch(point[0] as usize).jet(point[1], point[2]));
            }),
            #[cfg(not(feature = "patchwork"))]
            Address::Volume => {}
            #[cfg(feature = "patchwork")]
            Address::Volume => {
                let Some(volume) = placed.solved().volume() else { return Ok(()) };
                volume.visit(at, visit);
            }
        }
        Ok(())
    }

    /// Refuses a part and points that do not exist, without solving anything.
    ///
    /// # Errors
    /// `no-such-point`.
    pub(crate) fn check_points(&self, part: usize, at: &[f64]) -> Result<()> {
        let (_, of) = self.existing(part)?;
        let address = of.shape.address();
        let (n, words) = match address {
            Address::Surface => (2, "pairs (u, v)"),
            Address::Patches(_) => (3, "triples (patch, u, v)"),
            Address::Volume => (3, "triples (u, v, w)"),
        };
        if !at.len().is_multiple_of(n) {
            let message = format!("expected {words}, found {} numbers", at.len());
            return Err(Error::new(Code::NoSuchPoint, "at", message).with("found", at.len()));
        }
        for (i, point) in at.chunks_exact(n).enumerate() {
            match (address, point) {
                (Address::Surface, [u, v]) => {
                    within_one("u", *u, n * i)?;
                    if !v.is_finite() {
                        let message = format!("expected a finite v, found {}", plain(*v));
                        return Err(
                            Error::new(Code::NoSuchPoint, format!("at[{}]", n * i + 1), message).with("found", *v)
                        );
                    }
                }
                (Address::Patches(n_patches), [patch, u, v]) => {
                    let last = n_patches - 1;
                    if !(0.0..=last as f64).contains(patch) || *patch != libm::trunc(*patch) {
                        let message = format!(
                            "expected the number of a patch, {}, found {}",
                            numbers_of(n_patches),
                            plain(*patch)
                        );
                        let error = Error::new(Code::NoSuchPoint, format!("at[{}]", n * i), message);
                        return Err(error.with("least", 0.0).with("greatest", last).with("found", *patch));
                    }
                    within_one("u", *u, n * i + 1)?;
                    within_one("v", *v, n * i + 2)?;
                }
                (Address::Volume, [u, v, w]) => {
                    for (place, (name, found)) in [("u", *u), ("v", *v), ("w", *w)].into_iter().enumerate() {
                        within_one(name, found, n * i + place)?;
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// Refuses a coordinate beyond the unit interval.
fn within_one(name: &str, found: f64, place: usize) -> Result<()> {
    if (0.0..=1.0).contains(&found) {
        return Ok(());
    }
    let message = format!("expected {name} from 0 to 1, found {}", plain(found));
    let error = Error::new(Code::NoSuchPoint, format!("at[{place}]"), message);
    Err(error.with("least", 0.0).with("greatest", 1.0).with("found", found))
}

/// The jet in the parameters of the document: those of a Fourier series run over its span, those of a patch over the unit square.
fn jet(placed: &Placed, u: f64, v: f64) -> SurfaceJet {
    match placed.solved().fourier() {
        Some(surface) => surface.at(u, v),
        None => placed.solved().patch(0).jet(u, v),
    }
}

fn finite(part: usize, numbers: &[f64]) -> Result<()> {
    if numbers.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(Error::new(Code::Overflow, format!("parts[{part}]"), "the surface leaves the range of numbers"))
    }
}
