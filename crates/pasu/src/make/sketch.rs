//! From a design to a mesh for the screen while a hand changes the design: checked coarsely, drawn finely.

use crate::design::Side;
use crate::error::Result;
use crate::face::FaceKind;
use crate::solid::{Pot, Product};
use crate::solution::Solution;
use crate::weave::{GLIMPSE, SolidMesh, Woven, closed_patches, compact, finished, glimpsed, grid, weave};

/// A mesh that is refused is looked at once more so many times as finely: a coarse one may cross itself where the faces do not.
const FINER: f64 = 3.0;

/// What a hand drags, in model units.
pub(crate) struct Sketched {
    /// None of an open network, which has a thickness and no foot and rim.
    pub(crate) pot: Option<Pot>,
    /// The face that is the surface of the design itself.
    pub(crate) shown: FaceKind,
    pub(crate) mesh: SolidMesh,
}

/// A pot, or an open network with its thickness, and its mesh in model units, at a tolerance that is aimed at and not proved. A ring or drain that was asked for gives way, as in every body, where the coarse mesh sees that there is no room for it.
///
/// # Errors
/// What [`Pot::new`] and [`solid`](super::made::solid) refuse, as far as it is seen on the coarse mesh; of a network on this one.
pub(crate) fn sketched(solution: &Solution, part: usize, tolerance: Option<f64>) -> Result<Sketched> {
    if solution.has_shell(part, Product::Pot)? {
        let (_, of) = solution.existing(part)?;
        let is_outside = of.wall.as_ref().is_some_and(|wall| wall.side == Side::Outside);
        let (_, mesh) = closed_patches(&*solution.patched(part, Product::Pot)?, tolerance, 1.0)?;
        let shown = if is_outside { FaceKind::Lining } else { FaceKind::Outer };
        return Ok(Sketched { pot: None, shown, mesh });
    }
    let (pot, mesh) = potted(solution, part, tolerance)?;
    Ok(Sketched { shown: pot.surface_kind(), pot: Some(pot), mesh })
}

fn potted(solution: &Solution, part: usize, tolerance: Option<f64>) -> Result<(Pot, SolidMesh)> {
    let asked = solution.quick_pot(part).and_then(|pot| meshed(pot, tolerance));
    match asked {
        Err(error) => match solution.quick_fitted_pot(part)? {
            Some(pot) => meshed(pot, tolerance),
            None => Err(error),
        },
        made => made,
    }
}

fn meshed(pot: Pot, tolerance: Option<f64>) -> Result<(Pot, SolidMesh)> {
    // Crossings are looked for on this mesh, or on one within the tolerance where that is coarser.
    let coarse = GLIMPSE * pot.skin().size();
    let checked = tolerance.map_or(coarse, |tolerance| tolerance.max(coarse));
    let coarse = glimpsed(&pot, checked, 1.0).or_else(|_| glimpsed(&pot, checked / FINER, 1.0))?;
    let woven = if tolerance == Some(checked) { coarse } else { drawn(&pot, tolerance)? };
    let mesh = finished(&woven, pot.part(), 1.0);
    Ok((pot, mesh))
}

/// What is not checked again.
fn drawn(pot: &Pot, tolerance: Option<f64>) -> Result<Woven> {
    let mut woven = weave(pot, &grid(pot.skin(), tolerance, tolerance)?, 1.0)?;
    compact(&mut woven);
    Ok(woven)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use crate::design::Design;
    use crate::face::Face;

    const GALLERY: &str = include_str!("../../tests/reference/gallery.json");

    /// Every exhibit with a wall of every kind, in turn; with its size.
    fn pots() -> Vec<(String, Design, f64)> {
        let exhibits: Vec<serde_json::Value> = serde_json::from_str(GALLERY).expect("the gallery is JSON");
        let pot = |(number, exhibit): (usize, &serde_json::Value)| {
            let document = |wall: serde_json::Value| {
                let part = serde_json::json!({ "shape": exhibit["shape"], "wall": wall });
                Design::parse(&serde_json::json!({ "pasu": 1, "parts": [part] }).to_string()).expect("a design")
            };
            let bare = document(serde_json::json!({ "thickness": 1, "base": 1 }));
            let size =
                crate::solid::Skin::new(Solution::of(&bare).part(0).expect("a solution")).expect("a surface").size();
            let wall = size / [25.0, 40.0, 80.0][number % 3];
            let side = if number % 4 == 3 { "outside" } else { "inside" };
            let rim = if number % 2 == 1 { "rounded" } else { "flat" };
            let design = document(serde_json::json!({ "thickness": wall, "base": wall, "side": side, "rim": rim }));
            (format!("{} {side}", exhibit["name"]), design, size)
        };
        exhibits.iter().enumerate().map(pot).collect()
    }

    #[test]
    fn what_is_drawn_of_the_gallery_is_closed_and_crosses_nothing() {
        let (mut n_made, mut n_overlooked) = (0, 0);
        for (name, design, size) in pots() {
            let full = super::super::made::solid(&design, &super::super::Making::default());
            for fineness in [700.0, 350.0, 150.0] {
                let tolerance = size / fineness;
                let found = potted(&Solution::of(&design), 0, Some(tolerance));
                let (pot, mesh) = match (found, &full) {
                    (Ok(found), Ok(_)) => found,
                    (Err(error), Ok(_)) => panic!("{name} {fineness}: {error}"),
                    (Err(_), Err(_)) => continue,
                    // A crossing that is too fine for the coarse mesh.
                    (Ok(_), Err(error)) => {
                        assert!(
                            matches!(error.code(), crate::Code::CrossesItself | crate::Code::NoRoom),
                            "{name}: {error}"
                        );
                        n_overlooked += 1;
                        continue;
                    }
                };
                n_made += 1;
                let (corners, []) = mesh.positions.as_chunks::<3>() else { panic!("{name}: no triples") };
                let (triangles, []) = mesh.indices.as_chunks::<3>() else { panic!("{name}: no triples") };
                let topology = check::closed(triangles, corners.len());
                assert!(topology.is_ok(), "{name} {fineness}: does not close at {:?}", topology.err());
                // Level faces are cut from an outline without overlaps and so are seen side by side.
                let is_level = |kind| pot.faces().iter().any(|face| face.kind() == kind && face.is_level());
                let group = |triangle: u32| {
                    let of = |&(_, first, count): &(_, u32, u32)| (first..first + count).contains(&(3 * triangle));
                    mesh.faces.iter().position(of).filter(|face| is_level(mesh.faces[*face].0)).map(|face| face as u32)
                };
                assert_eq!(check::a_crossing(corners, triangles, group), None, "{name} {fineness}");
                // A lining of many waves is not looked into again and again until it keeps the tolerance, and says so.
                assert!(mesh.bound <= 8.0 * tolerance, "{name}: {} for {tolerance}", mesh.bound);
            }
        }
        assert!(n_made > 100 && n_overlooked <= 4, "{n_made} were made, {n_overlooked} of them in haste");
    }
}
