//! What is made of a design, to be drawn: no file, but the triangles that files hold.

use super::contents::Body;
use super::shading::{Shaded, shaded};
use super::write::body;
use crate::design::Design;
use crate::error::Result;
use crate::face::FaceKind;
use crate::make::{Making, Scale};
use crate::solution::Solution;
use crate::watch;

/// The share of the time that making takes, as against shading.
const MAKING: f64 = 0.9;

/// The meshes of [`solid`](crate::solid()) as one, with normals, in model units.
///
/// A vertex is split where faces meet, so that edges are drawn sharp. Triangles are counter-clockwise seen from outside the clay.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Drawn {
    /// `x, y, z` per vertex, in model units after placement: before size and shrinkage.
    pub positions: Vec<f32>,
    /// Unit vectors out of the clay, three numbers per vertex: the mean over the triangles of the face that meet there, weighted by their angles.
    pub normals: Vec<f32>,
    /// Three vertex numbers per triangle.
    pub indices: Vec<u32>,
    /// What the triangles are of, in the order of `indices`, which they cover.
    pub faces: Vec<DrawnFace>,
    /// The factors to what is made.
    pub scale: Scale,
}

/// One face of one part in [`Drawn`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct DrawnFace {
    /// What it is.
    pub kind: FaceKind,
    /// The part of the design.
    pub part: usize,
    /// Its first index.
    pub first: usize,
    /// How many indices it has.
    pub count: usize,
}

/// What is made of a design, to be drawn.
///
/// # Errors
/// As [`solid`](crate::solid()).
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// let drawn = pasu::drawn(&cup, &pasu::Making::default())?;
/// assert!(drawn.faces.iter().any(|face| face.kind == pasu::FaceKind::Lining));
/// assert_eq!(drawn.scale.millimetres, 10.0);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn drawn(design: &Design, making: &Making) -> Result<Drawn> {
    Solution::of(design).drawn(making)
}

impl Solution {
    /// As [`drawn`].
    ///
    /// # Errors
    /// As [`drawn`].
    pub fn drawn(&self, making: &Making) -> Result<Drawn> {
        shown(self, making)
    }
}

fn shown(solution: &Solution, making: &Making) -> Result<Drawn> {
    let (scale, all) = watch::between(0.0, MAKING, || solution.all_made(making))?;
    let (positions, normals, indices, faces) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut drawn = Drawn { positions, normals, indices, faces, scale };
    for made in all {
        let body = body(solution.design(), "", &made.mesh);
        add(
            &body,
            made.mesh.part,
            scale.millimetres,
            (&mut drawn.positions, &mut drawn.normals, &mut drawn.indices),
            &mut drawn.faces,
        );
    }
    Ok(drawn)
}

/// Adds the shaded faces of a body, whose numbers are `scale` times those of the model, to positions, normals and indices.
pub(super) fn add(
    body: &Body,
    part: usize,
    scale: f64,
    (positions, normals, indices): (&mut Vec<f32>, &mut Vec<f32>, &mut Vec<u32>),
    faces: &mut Vec<DrawnFace>,
) {
    let (vertices, mut first) = (positions.len() / 3, indices.len());
    let shaded: Shaded = shaded(body);
    positions.extend(shaded.positions.iter().map(|x| (f64::from(*x) / scale) as f32));
    normals.extend(shaded.normals);
    indices.extend(shaded.indices.iter().map(|vertex| vertex + vertices as u32));
    for &(kind, _, count) in &body.faces {
        faces.push(DrawnFace { kind, part, first, count });
        first += count;
    }
}
