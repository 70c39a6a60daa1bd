//! From a design to meshes that pass every check.

use std::sync::Arc;

use glam::DVec3;

use super::making::{Making, Scale};
use crate::check::Topology;
use crate::design::{Design, Part, Unit};
use crate::error::Result;
use crate::solid::{Pot, Product, Skin};
use crate::solution::{Newest, Solution};
use crate::watch;
use crate::weave::{Made, SolidMesh, closed_patches, is_coarse, refuse_crossing};

/// The closed mesh of each part that the product is made of, in millimetres, after size and shrinkage.
///
/// What is returned has passed every check of [`SolidMesh`]; what does not is refused, never written. A foot ring or a drain for which there is no room gives way to the nearest of those that are tried for which there is, in whatever is asked of a design;
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
        Ok(self.all_made(making)?.1.iter().map(|made| made.mesh.clone()).collect())
    }

    /// The parts of [`solid`], and how large they are.
    ///
    /// # Errors
    /// As [`solid`].
    pub(crate) fn all_made(&self, making: &Making) -> Result<(Scale, Vec<Arc<Finished>>)> {
        self.all_workable()?;
        let (scale, parts) = (making.scale_of(self)?, self.parts_of(making.product));
        let made = |(index, part): (usize, &usize)| {
            watch::share(index, parts.len(), || make(self, *part, making, scale.millimetres))
        };
        let all = parts.iter().enumerate().map(made).collect::<Result<_>>()?;
        Ok((scale, all))
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
    fn is_of(&self, number: usize, making: &Making, scale: f64) -> bool {
        (self.number, self.tolerance, self.scale, self.product)
            == (number, making.tolerance.map(f64::to_bits), scale.to_bits(), making.product)
    }

    /// Whether the part is still there as it was.
    fn stands(&self, design: &Design) -> bool {
        self.unit == design.unit() && design.parts().get(self.number).is_some_and(|part| self.part.stands_as(part))
    }
}

/// The most triangles that are kept of all parts, some fifty bytes each.
const MOST_KEPT: usize = 1_000_000;

/// The most bodies that are known to be made as usual: of hundreds of parts the meshes are too large to be kept.
const MOST_SOUND: usize = 2_000;

/// What is known of the parts of a design, or of one before it.
struct Known {
    /// The meshes that were made last.
    meshes: Newest<Key, Arc<Finished>>,
    /// The parts that are made within the usual tolerance.
    sound: Newest<Key, ()>,
}

impl Known {
    /// What a solution keeps, with what that of the design before it knew of parts that are still as they were.
    fn of(solution: &Solution) -> Option<&Known> {
        let [kept, before] = solution.made_parts();
        if kept.is_empty() {
            let stands = |key: &Key| key.stands(solution.design());
            kept.keep(match before.get::<Known>() {
                Some(before) => Known { meshes: before.meshes.of(stands), sound: before.sound.of(stands) },
                None => Known { meshes: Newest::new(MOST_KEPT), sound: Newest::new(MOST_SOUND) },
            });
        }
        kept.get()
    }
}

/// One part of [`solid`], which is made once for the picture, the check and the files after it, and not again where another part is changed; `scale` is from model units to millimetres.
///
/// # Errors
/// As [`solid`].
pub(crate) fn make(solution: &Solution, number: usize, making: &Making, scale: f64) -> Result<Arc<Finished>> {
    let (_, part) = solution.existing(number)?;
    let known = Known::of(solution);
    if let Some(made) = known.and_then(|known| known.meshes.find(|of, _| of.is_of(number, making, scale))) {
        return Ok(made);
    }
    let made = Arc::new(made_anew(solution, number, making, scale)?);
    if let Some(known) = known {
        let Making { tolerance, product, .. } = *making;
        let (part, unit) = (Arc::new(part.clone()), solution.design().unit());
        let key = Key { number, part, unit, tolerance: tolerance.map(f64::to_bits), scale: scale.to_bits(), product };
        if tolerance.is_none() {
            known.sound.keep(key.clone(), &(), 1);
        }
        known.meshes.keep(key, &made, made.mesh.n_triangles());
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
    if is_coarse(&skin, making.tolerance)? {
        // What it steps over a finer mesh runs into: that of a file, which is kept for it.
        let usual = Making { tolerance: None, ..*making };
        if Known::of(solution).and_then(|known| known.sound.find(|of, ()| of.is_of(part, &usual, scale))).is_none() {
            make(solution, part, &usual, scale)?;
        }
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
    fn what_is_coarser_than_usual_is_held_against_the_mesh_of_a_file_which_is_made_once() {
        let solution = Solution::of(&design(&[CUP], ""));
        let usual = Making { tolerance: None, ..solid(0.1) };
        let n_kept = |solution: &Solution| Known::of(solution).map_or(0, |known| known.meshes.n_kept());
        for (tolerance, kept) in [(0.2, 2), (0.05, 3), (0.2, 3)] {
            solution.drawn(&Making { product: Product::Pot, ..solid(tolerance) }).unwrap();
            assert_eq!(n_kept(&solution), kept, "{tolerance}");
        }
        let pot = Making { product: Product::Pot, ..usual };
        assert!(solution.check(&pot).unwrap().is_ok());
        assert_eq!((n_kept(&solution), solution.solid(&pot).unwrap().len()), (3, 1));
        assert!(made(&solution, 0, &pot).mesh == made(&Solution::of(solution.design()), 0, &pot).mesh);
        // One that is finer than usual is not.
        let fine = Solution::of(solution.design());
        fine.solid(&Making { product: Product::Pot, ..solid(1e-3) }).unwrap();
        assert_eq!(n_kept(&fine), 1);
    }

    #[test]
    fn a_part_whose_usual_mesh_was_too_large_to_keep_is_known_to_be_sound() {
        let solution = Solution::of(&design(&[CUP], ""));
        let coarse = Making { product: Product::Pot, ..solid(0.2) };
        solution.solid(&coarse).unwrap();
        let next = solution.after(&design(&[CUP], r#", "title": "cup""#));
        let known = Known::of(&next).unwrap();
        let (part, unit) = (Arc::new(next.design().parts()[0].clone()), next.design().unit());
        let large = Key { number: 1, part, unit, tolerance: None, scale: 0, product: Product::Solid };
        known.meshes.keep(large, &made(&solution, 0, &coarse), MOST_KEPT);
        assert_eq!(known.meshes.n_kept(), 1);
        let other = Making { tolerance: Some(0.3), ..coarse };
        assert!(made(&next, 0, &other).mesh == made(&Solution::of(next.design()), 0, &other).mesh);
        assert_eq!(known.meshes.n_kept(), 1);
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
