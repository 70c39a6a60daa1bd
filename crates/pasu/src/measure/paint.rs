//! A number for every vertex of a mesh, to be drawn as colour.

use core::f64::consts::TAU;

use super::bare::Bare;
use super::curvature::Kind;
use super::moments::element;
use super::outside::{lean, off_the_end};
use crate::design::Design;
use crate::error::Result;
use crate::mesh::{MeshOptions, grid_places};
use crate::solid::{Face, Pot, Product};

/// What is painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Map {
    /// Mean curvature of the design surface, in 1 / length; positive where it bends like a ball seen from outside.
    MeanCurvature,
    /// Gaussian curvature of the design surface, in 1 / area.
    GaussianCurvature,
    /// Thickness of the wall along the normal, in model units.
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
/// As [`mesh`](crate::mesh); for [`Map::Thickness`] also what [`Pot::new`] refuses.
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
    let grids = grid_places(design, options)?;
    let mut values = Vec::with_capacity(grids.iter().map(|grid| grid.rows.len() * grid.columns).sum());
    for (index, (part, grid)) in design.parts().iter().zip(&grids).enumerate() {
        let bare = Bare::new(part, index)?;
        let pot = if map == Map::Thickness { Some(Pot::new(design, index, Product::Pot)?) } else { None };
        // The last column of a closed surface repeats the first.
        let last = grid.columns - 1;
        let v_of = |j: usize| if j == last && bare.is_closed() { 0.0 } else { TAU * j as f64 / last as f64 };
        for &u in &grid.rows {
            let a = bare.along(u);
            values.extend((0..grid.columns).map(v_of).map(|v| {
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
    Ok(values)
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
