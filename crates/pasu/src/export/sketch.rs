//! What is made of a design, to be drawn while a hand changes it.

use super::drawn::{DrawnFace, add};
use super::write::body;
use crate::design::{Design, plain};
use crate::error::{Code, Error, Result};
use crate::make::{Sketched, sketched};
use crate::measure::{WaterSurface, filled};
use crate::solution::Solution;

/// What [`sketch`] is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SketchOptions {
    /// How far triangles may be from the true faces, in model units; one two-thousandth of each part's size when left out. It is aimed at, not proved.
    pub tolerance: Option<f64>,
    /// How full the pot is, as a share of the depth from its lowest point to where water runs out, from 0 to 1; no water when left out.
    pub fill: Option<f64>,
}

/// The faces of pots that the [mesh](crate::mesh) of the design does not show, and water.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Sketch {
    /// `x, y, z` per vertex, in model units after placement. Vertices are split where faces meet.
    pub positions: Vec<f32>,
    /// Unit vectors out of the clay, three numbers per vertex.
    pub normals: Vec<f32>,
    /// Three vertex numbers per triangle, counter-clockwise seen from outside the clay.
    pub indices: Vec<u32>,
    /// What the triangles are of, in the order of `indices`, which they cover.
    pub faces: Vec<DrawnFace>,
    /// The water that was asked for; `None` also where nothing holds any.
    pub water: Option<WaterSurface>,
}

/// The pots of a design as [`drawn`](crate::drawn()) shows them, in a fraction of the time: for a screen, while a hand changes the design. Parts without a wall are passed over.
///
/// The wall is that of [`Pot::new`](crate::Pot::new), thinned alike. That no faces cross is checked on a coarser mesh than the one that is drawn, so [`drawn`](crate::drawn()) may refuse
/// what this shows, where the faces cross by less than one part in 150 of the size, and no file is made of it; a ring or drain that has no room by less than that is shown as asked for, and otherwise as it is fitted. Left out is the face that is the surface of the design itself, which
/// [`mesh`](crate::mesh) shows.
///
/// # Errors
/// `out-of-range` for a tolerance that is not a distance or a share that is not one; what [`Pot::new`](crate::Pot::new) and [`solid`](crate::solid()) refuse.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// let options = pasu::SketchOptions { fill: Some(0.5), ..pasu::SketchOptions::default() };
/// let sketch = pasu::sketch(&cup, &options)?;
/// // Half of the depth from the floor, at 1, to the brim, at 4.
/// assert!(sketch.water.is_some_and(|water| (water.level - 2.5).abs() < 1e-6));
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn sketch(design: &Design, options: &SketchOptions) -> Result<Sketch> {
    Solution::of(design).sketch(options)
}

impl Solution {
    /// As [`sketch`].
    ///
    /// # Errors
    /// As [`sketch`].
    pub fn sketch(&self, options: &SketchOptions) -> Result<Sketch> {
        drafted(self, options)
    }
}

fn drafted(solution: &Solution, options: &SketchOptions) -> Result<Sketch> {
    let design = solution.design();
    if let Some(fill) = options.fill.filter(|fill| !(0.0..=1.0).contains(fill)) {
        let message = format!("expected a share of the depth from 0 to 1, found {}", plain(fill));
        let error = Error::new(Code::OutOfRange, "fill", message).with("least", 0.0).with("greatest", 1.0);
        return Err(error.with("found", fill));
    }
    let mut sketch = Sketch::default();
    let mut pots = Vec::with_capacity(design.parts().len());
    for (part, of) in design.parts().iter().enumerate() {
        if of.wall.is_none() {
            pots.push(None);
            continue;
        }
        let Sketched { pot, shown, mesh } = sketched(solution, part, options.tolerance)?;
        let mut body = body(design, "", &mesh);
        body.faces.retain(|(kind, ..)| *kind != shown);
        add(&body, part, 1.0, (&mut sketch.positions, &mut sketch.normals, &mut sketch.indices), &mut sketch.faces);
        pots.push(pot);
    }
    if let Some(fill) = options.fill {
        sketch.water = filled(solution, &pots, fill)?;
    }
    Ok(sketch)
}
