//! What is made of a design, and how large.

use super::craft::Craft;
use crate::design::{Design, plain};
use crate::error::{Code, Error, Result};
use crate::measure::{Gauge, gauge};
use crate::solid::Product;
use crate::solution::Solution;

/// What the finished pot is to measure, in the unit of the design.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Size {
    /// From the lowest to the highest point.
    Height(f64),
    /// The greatest level width.
    Width(f64),
    /// What it holds when full to the brim, in the unit cubed.
    Capacity(f64),
}

/// What is made of a design: the product, its size and how finely it is meshed.
///
/// Everything is scaled alike, the wall included. A clay that shrinks by `shrinkage` percent in drying and firing is made larger by `1 / (1 - shrinkage / 100)`, so that
/// [`Size`] is that of the finished pot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Making {
    /// What is made.
    pub product: Product,
    /// The size of the finished pot; as designed when left out.
    pub size: Option<Size>,
    /// By how many percent the clay shrinks, from 0 to less than 50.
    pub shrinkage: f64,
    /// The largest distance between triangles and the true faces, in model units, before scaling; one two-thousandth of each part's size when left out.
    pub tolerance: Option<f64>,
    /// By what craft it is made, which says how thin a wall may be and how far it may lean; by printing when left out, and then nothing that is found of it is an error.
    pub craft: Option<Craft>,
    /// Whether a file of triangles has the parts of each object as one solid, as they are glued; apart when left out. [`solid`](crate::solid()) has them apart either way.
    pub union: bool,
}

/// The factors between a design and what is made of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Scale {
    /// From the design to the finished pot.
    pub size: f64,
    /// From the finished pot to the raw one.
    pub shrinkage: f64,
    /// From model units to the millimetres of a file: the product of both and the unit.
    pub millimetres: f64,
}

/// The largest shrinkage in percent is below this.
const MOST_SHRINKAGE: f64 = 50.0;

impl Making {
    /// The factors that this asks for.
    ///
    /// # Errors
    /// `out-of-range` for a size, shrinkage or tolerance outside its range, or a size that the design has nothing of; `no-room` for the capacity of a design that holds nothing; what
    /// [`Surface::solve`](crate::Surface::solve) refuses.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// use pasu::{Making, Size};
    ///
    /// let making = Making { size: Some(Size::Height(8.0)), shrinkage: 20.0, ..Making::default() };
    /// let scale = making.scale(&cup)?;
    /// assert!((scale.size - 2.0).abs() < 1e-12 && (scale.shrinkage - 1.25).abs() < 1e-12);
    /// assert!((scale.millimetres - 25.0).abs() < 1e-10);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn scale(&self, design: &Design) -> Result<Scale> {
        self.scale_of(&Solution::of(design))
    }

    /// As [`Making::scale`].
    ///
    /// # Errors
    /// As [`Making::scale`].
    pub fn scale_of(&self, solution: &Solution) -> Result<Scale> {
        self.check()?;
        let found = |what| gauge(solution, self.product, what);
        let size = match self.size {
            None => 1.0,
            Some(Size::Height(height)) => factor("size.height", height, found(Gauge::Height)?)?,
            Some(Size::Width(width)) => factor("size.width", width, found(Gauge::Width)?)?,
            Some(Size::Capacity(capacity)) => libm::cbrt(factor("size.capacity", capacity, found(Gauge::Capacity)?)?),
        };
        let shrinkage = 1.0 / (1.0 - self.shrinkage / 100.0);
        let millimetres = solution.design().unit().millimetres() * size * shrinkage;
        Ok(Scale { size, shrinkage, millimetres })
    }

    /// Whether every number is within its range, whatever the design.
    pub(crate) fn is_in_range(&self) -> bool {
        self.check().is_ok()
    }

    /// Refuses what is outside its range.
    fn check(&self) -> Result<()> {
        let positive = |name: &str, value: f64| {
            if value > 0.0 && value.is_finite() {
                return Ok(());
            }
            let message = format!("expected a number greater than 0, found {}", plain(value));
            Err(Error::new(Code::OutOfRange, name, message).with("above", 0.0).with("found", value))
        };
        match self.size {
            Some(Size::Height(height)) => positive("size.height", height)?,
            Some(Size::Width(width)) => positive("size.width", width)?,
            Some(Size::Capacity(capacity)) => positive("size.capacity", capacity)?,
            None => {}
        }
        if let Some(tolerance) = self.tolerance {
            positive("tolerance", tolerance)?;
        }
        if !(0.0..MOST_SHRINKAGE).contains(&self.shrinkage) {
            let message =
                format!("expected a percentage from 0 to less than {MOST_SHRINKAGE}, found {}", plain(self.shrinkage));
            let error = Error::new(Code::OutOfRange, "shrinkage", message).with("least", 0.0);
            return Err(error.with("below", MOST_SHRINKAGE).with("found", self.shrinkage));
        }
        Ok(())
    }
}

/// By how much what was found has to grow.
fn factor(path: &str, wanted: f64, found: f64) -> Result<f64> {
    let factor = wanted / found;
    if factor > 0.0 && factor.is_finite() {
        return Ok(factor);
    }
    let message = format!("the design measures {}, which cannot be scaled to {}", plain(found), plain(wanted));
    Err(Error::new(Code::OutOfRange, path, message))
}
