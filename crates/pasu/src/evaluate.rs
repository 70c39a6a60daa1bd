//! Points of a design in double precision.

use crate::design::{Design, Part, plain};
use crate::error::{Code, Error, Result};
use crate::surface::{Surface, SurfaceJet};

/// Derivatives at the points asked for, three numbers each.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Derivatives {
    /// `X_u`.
    pub du: Vec<f64>,
    /// `X_v`.
    pub dv: Vec<f64>,
}

/// Positions, before placement, of part `part` at pairs `(u, v)`: `u` in [0, 1], `v` any number in the units of the shape's span.
///
/// # Errors
/// `no-such-point` for a part that does not exist, an odd number of coordinates, or a point outside the surface; what [`Surface::solve`] refuses; `overflow`.
///
/// ```
/// let vase = pasu::Design::parse("#1/second-order?height=9")?;
/// // The rim is at u = 0, the foot at u = 1.
/// let points = pasu::evaluate(&vase, 0, &[0.0, 0.0, 1.0, 0.5])?;
/// assert!((points[2] - 9.0).abs() < 1e-12 && points[5].abs() < 1e-12);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn evaluate(design: &Design, part: usize, at: &[f64]) -> Result<Vec<f64>> {
    let mut positions = Vec::with_capacity(at.len() / 2 * 3);
    for_each_point(design, part, at, |jet| positions.extend(jet.position.to_array()))?;
    finite(part, &positions)?;
    Ok(positions)
}

/// `X_u` and `X_v`, before placement, of part `part` at pairs `(u, v)`.
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
    let mut derivatives = Derivatives::default();
    for_each_point(design, part, at, |jet| {
        derivatives.du.extend(jet.du.to_array());
        derivatives.dv.extend(jet.dv.to_array());
    })?;
    finite(part, &derivatives.du)?;
    finite(part, &derivatives.dv)?;
    Ok(derivatives)
}

fn for_each_point(design: &Design, part: usize, at: &[f64], mut visit: impl FnMut(&SurfaceJet)) -> Result<()> {
    let parts = design.parts();
    let Some(chosen) = parts.get(part) else {
        let message = format!("expected a part from 0 to {}, found {part}", parts.len() - 1);
        let error = Error::new(Code::NoSuchPoint, "part", message).with("least", 0.0);
        return Err(error.with("greatest", parts.len() - 1).with("found", part));
    };
    if !at.len().is_multiple_of(2) {
        let message = format!("expected pairs (u, v), found {} numbers", at.len());
        return Err(Error::new(Code::NoSuchPoint, "at", message).with("found", at.len()));
    }
    let surface = Surface::of_part(chosen, part)?;
    for (i, point) in at.chunks_exact(2).enumerate() {
        let (u, v) = (point[0], point[1]);
        if !(0.0..=1.0).contains(&u) {
            let message = format!("expected u from 0 to 1, found {}", plain(u));
            let error = Error::new(Code::NoSuchPoint, format!("at[{}]", 2 * i), message);
            return Err(error.with("least", 0.0).with("greatest", 1.0).with("found", u));
        }
        if !v.is_finite() {
            let message = format!("expected a finite v, found {}", plain(v));
            return Err(Error::new(Code::NoSuchPoint, format!("at[{}]", 2 * i + 1), message).with("found", v));
        }
        visit(&surface.at(u, v));
    }
    Ok(())
}

fn finite(part: usize, numbers: &[f64]) -> Result<()> {
    if numbers.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(Error::new(Code::Overflow, format!("parts[{part}]"), "the surface leaves the range of numbers"))
    }
}

impl Surface {
    /// Solves the shape of part number `index` of a design.
    ///
    /// # Errors
    /// As [`Surface::solve`]; a named family has no modes in the document, so its path ends at the shape.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/second-order?height=9")?;
    /// let surface = pasu::Surface::of_part(&vase.parts()[0], 0)?;
    /// assert!((surface.at(0.5, 0.0).position.z - 4.5).abs() < 1e-12);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn of_part(part: &Part, index: usize) -> Result<Surface> {
        let path = format!("parts[{index}].shape");
        let shape = part.shape.problem();
        Surface::solve(&shape, &path).map_err(|error| {
            if !matches!(part.shape, crate::design::Shape::BoundaryValue(_)) { error.at(path) } else { error }
        })
    }
}
