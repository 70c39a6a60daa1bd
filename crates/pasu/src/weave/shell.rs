//! The closed mesh of a body that is all patches: a solid between two sections, a network without an edge.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::body::{Body, Made};
use super::meshed::{compact, finished};
use super::woven::{Woven, WovenFace};
use crate::check;
use crate::error::{Code, Error, Result};
use crate::face::FaceKind;
use crate::mesh::part_mesh;
use crate::solid::place;
use crate::solution::Placed;
use crate::watch;

/// The most triangles of one part.
const MOST_TRIANGLES: usize = 8_000_000;

impl Made {
    /// The mesh of the patches of a part, which close; `scale` is from model units to millimetres.
    ///
    /// # Errors
    /// As [`solid`](crate::solid()).
    pub(crate) fn of_patches(placed: &Arc<Placed>, tolerance: Option<f64>, scale: f64) -> Result<Made> {
        watch::go_on()?;
        let mut woven = welded(placed, tolerance, scale)?;
        compact(&mut woven);
        let path = placed.path("shape");
        let refused = |code: Code, message: String, at: DVec3, what: &'static str| {
            Error::new(code, path.as_str(), message).near(at.to_array()).with("what", what)
        };
        let corners = |triangle: &[u32; 3]| triangle.map(|vertex| woven.positions[vertex as usize]);
        if let Some(triangle) = woven.triangles.iter().find(|triangle| check::is_degenerate(corners(triangle))) {
            let at = woven.position(triangle[0]) / scale;
            let message = format!(
                "the surface shrinks to nothing at {}: expected it to be wider than numbers of seven digits can hold",
                place(at)
            );
            return Err(refused(Code::PinchedSurface, message, at, "shrinks"));
        }
        let topology = check::closed(&woven.triangles, woven.positions.len()).map_err(|vertex| {
            let at = woven.position(vertex) / scale;
            let message = format!("the surface touches itself at {}: expected one that goes round a body", place(at));
            refused(Code::CrossesItself, message, at, "does-not-close")
        })?;
        let (crossings, given_up) = check::crossings_soon(&woven.positions, &woven.triangles, |_| None, 1);
        if let Some(pair) = crossings.first() {
            let at = woven.middle(pair[0]) / scale;
            let message = format!("the surface runs through itself near {}: expected one that does not", place(at));
            return Err(refused(Code::CrossesItself, message, at, "surface"));
        }
        if let Some(triangle) = given_up {
            let at = woven.middle(triangle) / scale;
            let message = format!(
                "so much of the surface lies close to itself near {} that it cannot be told whether it runs through itself: expected one that does not",
                place(at)
            );
            return Err(refused(Code::CrossesItself, message, at, "surface-close"));
        }
        let mesh = finished(&woven, placed.index(), scale);
        Ok(Made { mesh, body: Body::Patches(Arc::clone(placed)), topology, unkept: None })
    }
}

/// The triangles of all patches, of which points that are the same to the bit are one. Triangles of a pole that have no width are left out.
fn welded(placed: &Arc<Placed>, tolerance: Option<f64>, scale: f64) -> Result<Woven> {
    let mesh = part_mesh(placed, tolerance)?;
    if mesh.n_triangles() > MOST_TRIANGLES {
        let message = format!("needs more than {MOST_TRIANGLES} triangles: expected a coarser tolerance");
        let error = Error::new(Code::TooLarge, placed.own_path(), message).with("what", "triangles");
        return Err(error.with("greatest", MOST_TRIANGLES));
    }
    let mut positions: Vec<[f32; 3]> = Vec::new();
    let mut known: BTreeMap<[u32; 3], u32> = BTreeMap::new();
    let mut number = Vec::with_capacity(mesh.n_vertices());
    for point in mesh.positions.as_chunks::<3>().0 {
        // Without a sign of 0, which is no difference.
        let point = point.map(|x| (f64::from(x) * scale) as f32 + 0.0);
        if !point.iter().all(|x| x.is_finite()) {
            let message = "the solid is beyond what a mesh can hold; numbers up to 3e38 can be held";
            return Err(Error::new(Code::Overflow, placed.own_path(), message));
        }
        number.push(*known.entry(point.map(f32::to_bits)).or_insert_with(|| {
            positions.push(point);
            positions.len() as u32 - 1
        }));
    }
    let triangles =
        mesh.indices.as_chunks::<3>().0.iter().map(|triangle| triangle.map(|vertex| number[vertex as usize]));
    let triangles: Vec<[u32; 3]> = triangles.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    let n_triangles = triangles.len();
    let faces = vec![WovenFace { kind: FaceKind::Outer, n_triangles, is_level: false }];
    Ok(Woven { positions, triangles, faces, bound: mesh.bound.unwrap_or_default() })
}
