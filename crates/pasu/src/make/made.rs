//! From a design to meshes that pass every check.

use std::sync::Arc;

use glam::DVec3;

use super::making::Making;
use crate::check::Topology;
use crate::design::Design;
use crate::error::Result;
use crate::solid::{Pot, Product, Skin};
use crate::solution::Solution;
use crate::watch;
use crate::weave::{Made, SolidMesh, closed_patches, grid, refuse_crossing};

/// The closed mesh of each part that the product is made of, in millimetres, after size and shrinkage.
///
/// What is returned has passed every check of [`SolidMesh`]; what does not is refused, never written. A foot ring or a drain for which there is no room gives way to the nearest for which there is, in whatever is asked of a design;
/// [`check`](crate::check()) warns of it.
///
/// # Errors
/// What [`Making::scale`] and [`Pot::new`](crate::Pot::new) refuse; `crosses-itself` where the surface runs through itself and `no-room` where the clay on it does, with the place; `tolerance-too-fine`, `too-large`;
/// `overflow` for millimetres beyond single precision.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// use pasu::{Making, Size};
///
/// let making = Making { size: Some(Size::Height(8.0)), ..Making::default() };
/// let pots = pasu::solid(&cup, &making)?;
/// let top = pots[0].positions.chunks_exact(3).map(|p| p[2]).fold(f32::NEG_INFINITY, f32::max);
/// // In millimetres, as files are.
/// assert_eq!(top, 80.0);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn solid(design: &Design, making: &Making) -> Result<Vec<SolidMesh>> {
    Solution::of(design).solid(making)
}

impl Solution {
    /// As [`solid`].
    ///
    /// # Errors
    /// As [`solid`].
    pub fn solid(&self, making: &Making) -> Result<Vec<SolidMesh>> {
        self.all_workable()?;
        let scale = making.scale_of(self)?.millimetres;
        let parts = self.parts_of(making.product);
        let made = |(index, part): (usize, &usize)| {
            watch::share(index, parts.len(), || Ok(make(self, *part, making, scale)?.mesh))
        };
        parts.iter().enumerate().map(made).collect()
    }

    /// The parts that a product is made of: all, but for pots those with a wall if any has one, and what closes without one.
    pub(crate) fn parts_of(&self, product: Product) -> Vec<usize> {
        let all = 0..self.n_parts();
        let is_solid = |part: usize| self.part(part).is_ok_and(|placed| placed.solved().is_closed());
        let has_wall =
            |part: &usize| self.design().parts().get(*part).is_some_and(|part| part.wall.is_some()) || is_solid(*part);
        if product == Product::Pot && all.clone().any(|part| has_wall(&part)) {
            all.filter(has_wall).collect()
        } else {
            all.collect()
        }
    }
}

/// One part as it is made.
pub(crate) struct Finished {
    pub(crate) mesh: SolidMesh,
    pub(crate) topology: Topology,
    /// The tolerance that was asked for, where the mesh does not keep it.
    pub(crate) unkept: Option<f64>,
    /// The faces of a pot; `None` of patches that go round a body as they are.
    pub(crate) pot: Option<Pot>,
    /// Of patches with a thickness the least of it, by samples, and where it is.
    pub(crate) thinnest: Option<(f64, DVec3)>,
}

impl Finished {
    /// Where something of the part is in the design.
    pub(crate) fn path(&self, field: &str) -> String {
        format!("parts[{}].{field}", self.mesh.part)
    }
}

impl From<Made> for Finished {
    fn from(Made { mesh, pot, topology, unkept }: Made) -> Self {
        Finished { mesh, topology, unkept, pot: Some(pot), thinnest: None }
    }
}

/// One part of [`solid`]; `scale` is from model units to millimetres.
///
/// # Errors
/// As [`solid`].
pub(crate) fn make(solution: &Solution, part: usize, making: &Making, scale: f64) -> Result<Finished> {
    if solution.has_shell(part, making.product)? {
        let shell = solution.patched(part, making.product)?;
        let (topology, mesh) = closed_patches(&shell, making.tolerance, scale)?;
        let thinnest = shell.solved().thinnest().map(|(thick, at)| (thick, shell.point(at)));
        return Ok(Finished { mesh, topology, unkept: None, pot: None, thinnest });
    }
    let placed = if making.product == Product::Pot { solution.walled(part)? } else { solution.workable(part)? };
    if placed.solved().wall().is_none() {
        let (topology, mesh) = closed_patches(placed, making.tolerance, scale)?;
        return Ok(Finished { mesh, topology, unkept: None, pot: None, thinnest: None });
    }
    let skin = Arc::new(Skin::new(placed)?);
    let usual = grid(&skin, None, None)?.bound;
    if making.tolerance.is_some_and(|asked| asked > usual) {
        refuse_crossing(&skin, None, scale)?;
    }
    refuse_crossing(&skin, making.tolerance, scale)?;
    solution.made(part, making.product, making.tolerance, scale).map(Finished::from)
}
