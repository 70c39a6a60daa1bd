//! A number for every vertex of a mesh, to be drawn as colour.

use core::f64::consts::TAU;

use super::bare::Bare;
use super::curvature::Kind;
use super::moments::element;
use super::outside::{lean, off_the_end};
use crate::design::Design;
use crate::error::Result;
use crate::face::Face;
use crate::mesh::{MeshOptions, Places, grid_places};
use crate::solid::Product;
use crate::solution::{Placed, Solution};
use crate::watch;

/// What is painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Map {
    /// Mean curvature of the design surface, in 1 / length; positive where it bends like a ball seen from outside.
    MeanCurvature,
    /// Gaussian curvature of the design surface, in 1 / area.
    GaussianCurvature,
    /// Thickness of the wall along the normal, in model units; of one with a lining of its own the distance to that.
    Thickness,
    /// The angle of the outward normal below the horizontal, in degrees: 0 on a vertical wall, 90 on a level ceiling, -90 where the surface faces straight up.
    Overhang,
}

impl Map {
    /// Every map.
    pub const ALL: [Map; 4] = [Map::MeanCurvature, Map::GaussianCurvature, Map::Thickness, Map::Overhang];

    /// The word by which it is known: `mean-curvature`, `gaussian-curvature`, `thickness`, `overhang`.
    ///
    /// ```
    /// assert_eq!(pasu::Map::MeanCurvature.name(), "mean-curvature");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Map::MeanCurvature => "mean-curvature",
            Map::GaussianCurvature => "gaussian-curvature",
            Map::Thickness => "thickness",
            Map::Overhang => "overhang",
        }
    }
}

/// One value for each vertex of [`mesh`](crate::mesh) with the same options, in the same order.
///
/// At poles and cusps the limit from within the surface, and 0 where there is none; values beyond single precision are its largest. Every value is finite.
///
/// # Errors
/// As [`mesh`](crate::mesh); for [`Map::Thickness`] also what [`Pot::new`](crate::Pot::new) refuses.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// use pasu::{Map, MeshOptions};
///
/// let options = MeshOptions { rows: Some(5), columns: Some(9), ..MeshOptions::default() };
/// let thickness = pasu::paint(&cup, Map::Thickness, &options)?;
/// assert_eq!(thickness.len(), 5 * 9);
/// assert!(thickness.iter().all(|thickness| (thickness - 0.5).abs() < 1e-6));
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn paint(design: &Design, map: Map, options: &MeshOptions) -> Result<Vec<f32>> {
    Solution::of(design).paint(map, options)
}

impl Solution {
    /// As [`paint`].
    ///
    /// # Errors
    /// As [`paint`].
    pub fn paint(&self, map: Map, options: &MeshOptions) -> Result<Vec<f32>> {
        painted(self, map, options)
    }
}

fn painted(solution: &Solution, map: Map, options: &MeshOptions) -> Result<Vec<f32>> {
    solution.all_workable()?;
    let grids = grid_places(solution, options)?;
    let mut values = Vec::new();
    for (index, places) in grids.iter().enumerate() {
        let placed = solution.workable(index)?;
        let pot = if map == Map::Thickness { Some(solution.pot(index, Product::Pot)?) } else { None };
        match (places, Bare::new(placed)) {
            (Places::Fourier { rows, columns }, Some(bare)) => {
                // The last column of a closed surface repeats the first.
                let last = columns - 1;
                let v_of = |j: usize| if j == last && bare.is_closed() { 0.0 } else { TAU * j as f64 / last as f64 };
                for &u in rows {
                    watch::go_on()?;
                    let a = bare.along(u);
                    values.extend((0..*columns).map(v_of).map(|v| {
                        let value = match (map, &pot) {
                            (Map::MeanCurvature, _) => Kind::Mean.at(&bare, a, v),
                            (Map::GaussianCurvature, _) => Kind::Gaussian.at(&bare, a, v),
                            (Map::Thickness, pot) => pot.as_ref().map_or(0.0, |pot| pot.thickness_at(a, v)),
                            (Map::Overhang, _) => overhang(&bare, a, v),
                        };
                        single(value)
                    }));
                }
            }
            (Places::Patches(lines), _) => {
                for (patch, [rows, columns]) in lines.iter().enumerate() {
                    watch::go_on()?;
                    let places = rows.iter().flat_map(|u| columns.iter().map(move |v| (*u, *v)));
                    values.extend(places.map(|(u, v)| single(of_patch(map, placed, patch, u, v))));
                }
            }
            (Places::Fourier { rows, columns }, None) => {
                values.extend(core::iter::repeat_n(0.0, rows.len() * columns));
            }
        }
    }
    Ok(values)
}

/// A curvature or the overhang of a patch that is no side of a wall; beside a pole in its stead.
fn of_patch(map: Map, placed: &Placed, patch: usize, u: f64, v: f64) -> f64 {
    let outward = if placed.is_forwards(patch) { 1.0 } else { -1.0 };
    let patch = placed.solved().patch(patch);
    let at = |u: f64| {
        let jet = placed.place(&patch.jet(u, v));
        match map {
            Map::MeanCurvature => Kind::Mean.of(&jet, outward),
            Map::GaussianCurvature => Kind::Gaussian.of(&jet, outward),
            Map::Thickness => 0.0,
            Map::Overhang => lean(jet.du.cross(jet.dv) * outward).to_degrees(),
        }
    };
    let here = at(u);
    if here.is_finite() { here } else { at(off_the_end(u)) }
}

fn overhang(bare: &Bare, a: f64, v: f64) -> f64 {
    let at = |a: f64| lean(element(bare, &bare.jet(a, v))).to_degrees();
    let here = at(a);
    if here.is_finite() { here } else { at(off_the_end(a)) }
}

/// The nearest finite number of single precision; 0 for none.
fn single(value: f64) -> f32 {
    if value.is_nan() { 0.0 } else { (value as f32).clamp(f32::MIN, f32::MAX) }
}
