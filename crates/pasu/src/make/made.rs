//! From a design to meshes that pass every check.

use std::sync::Arc;

use glam::DVec3;

use super::making::Making;
use crate::check::Topology;
use crate::design::{Design, Part, Unit};
use crate::error::Result;
use crate::solid::{Pot, Product, Skin};
use crate::solution::{Newest, Solution};
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
            watch::share(index, parts.len(), || Ok(made_anew(self, *part, making, scale)?.mesh))
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

/// All that the mesh of a part depends on.
#[derive(Clone)]
struct Key {
    number: usize,
    part: Arc<Part>,
    unit: Unit,
    tolerance: Option<u64>,
    scale: u64,
    product: Product,
}

impl Key {
    /// Whether the part is still there as it was.
    fn stands(&self, design: &Design) -> bool {
        let is_it =
            |part: &Part| self.part.place == part.place && self.part.wall == part.wall && self.part.shape == part.shape;
        self.unit == design.unit() && design.parts().get(self.number).is_some_and(is_it)
    }
}

/// The meshes of a design that were made last.
type Known = Newest<Key, Arc<Finished>>;

/// The most triangles that are kept of all parts, some fifty bytes each.
const MOST_KEPT: usize = 1_000_000;

/// One part of [`solid`], which is made once for the check and for the files after it, and not again where another part is changed; `scale` is from model units to millimetres.
///
/// # Errors
/// As [`solid`].
pub(crate) fn make(solution: &Solution, number: usize, making: &Making, scale: f64) -> Result<Arc<Finished>> {
    let (design, (_, part)) = (solution.design(), solution.existing(number)?);
    let [kept, before] = solution.made_parts();
    if kept.is_empty() {
        let still = |before: &Known| before.of(|key| key.stands(design));
        kept.keep(before.get::<Known>().map_or_else(|| Known::new(MOST_KEPT), still));
    }
    let known = kept.get::<Known>();
    let (tolerance, scale_bits, product) = (making.tolerance.map(f64::to_bits), scale.to_bits(), making.product);
    let is_it = |of: &Key, _: &Arc<Finished>| {
        (of.number, of.tolerance, of.scale, of.product) == (number, tolerance, scale_bits, product)
    };
    if let Some(made) = known.and_then(|known| known.find(is_it)) {
        return Ok(made);
    }
    let made = Arc::new(made_anew(solution, number, making, scale)?);
    if let Some(known) = known {
        let key =
            Key { number, part: Arc::new(part.clone()), unit: design.unit(), tolerance, scale: scale_bits, product };
        known.keep(key, &made, made.mesh.n_triangles());
    }
    Ok(made)
}

/// As [`make`], whatever was made before.
fn made_anew(solution: &Solution, part: usize, making: &Making, scale: f64) -> Result<Finished> {
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

#[cfg(test)]
mod tests {
    use super::*;

    const CUP: &str = r#"{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 }, "wall": { "thickness": 0.5, "base": 1 } }"#;

    fn lid(angle: f64, more: &str) -> String {
        format!(
            r#"{{ "shape": {{ "kind": "octant", "exponents": [2, 2, 3] }}, "place": {{ "axis": [0, 0, 1], "angle": {angle}, "shift": [20, 0, 0] }}{more} }}"#
        )
    }

    fn design(parts: &[&str], more: &str) -> Design {
        Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}]{more} }}"#, parts.join(", "))).unwrap()
    }

    fn solid(tolerance: f64) -> Making {
        Making { product: Product::Solid, tolerance: Some(tolerance), ..Making::default() }
    }

    fn made(solution: &Solution, part: usize, making: &Making) -> Arc<Finished> {
        make(solution, part, making, making.scale_of(solution).unwrap().millimetres).unwrap()
    }

    #[test]
    fn a_part_is_made_once_for_the_check_and_the_files_after_it() {
        let solution = Solution::of(&design(&[CUP, &lid(0.5, "")], ""));
        let making = solid(0.1);
        assert!(solution.check(&making).unwrap().is_ok());
        let [one, other] = [0, 1].map(|part| made(&solution, part, &making));
        solution.write(crate::Format::Stl, &making).unwrap();
        solution.check(&making).unwrap();
        assert!(Arc::ptr_eq(&one, &made(&solution, 0, &making)) && Arc::ptr_eq(&other, &made(&solution, 1, &making)));
        let others = [
            solid(0.05),
            Making { product: Product::Pot, ..making },
            Making { shrinkage: 10.0, ..making },
            Making { tolerance: None, ..making },
        ];
        for other in others {
            let again = made(&solution, 0, &other);
            assert!(!Arc::ptr_eq(&one, &again) && one.mesh.positions != again.mesh.positions, "{other:?}");
            assert!(again.mesh == made(&Solution::of(solution.design()), 0, &other).mesh);
        }
        assert!(Arc::ptr_eq(&one, &made(&solution, 0, &making)));
    }

    #[test]
    fn a_part_that_is_as_it_was_in_a_design_before_is_not_made_again() {
        let making = solid(0.1);
        let before = Solution::of(&design(&[CUP, &lid(0.5, "")], ""));
        let [cup, _] = [0, 1].map(|part| made(&before, part, &making));
        // While a hand goes on nothing is made.
        let between = before.after(&design(&[CUP, &lid(0.6, "")], ""));
        let changed = design(&[CUP, &lid(0.7, "")], r#", "title": "cup and lid""#);
        let after = between.after(&changed);
        for solution in [&after, &after.after(&changed)] {
            assert!(Arc::ptr_eq(&cup, &made(solution, 0, &making)));
            for part in [0, 1] {
                assert!(made(solution, part, &making).mesh == made(&Solution::of(&changed), part, &making).mesh);
            }
        }
        // In other units, in another place of the list, with another wall, and where it was before once more.
        let thick = CUP.replace("0.5", "0.6");
        let others = [
            design(&[CUP, &lid(0.7, "")], r#", "unit": "in""#),
            design(&[&lid(0.7, ""), CUP], ""),
            design(&[&thick, &lid(0.7, "")], ""),
            design(&[CUP, &lid(0.5, "")], ""),
        ];
        for other in &others {
            let solution = after.after(other);
            let pot = Making { tolerance: None, product: Product::Pot, ..making };
            for (part, making) in [(0, making), (1, making), (0, pot)] {
                if making.product == Product::Solid || other.parts()[part].wall.is_some() {
                    let again = made(&solution, part, &making);
                    assert!(again.mesh == made(&Solution::of(other), part, &making).mesh, "{}", other.to_json());
                }
            }
        }
    }
}
