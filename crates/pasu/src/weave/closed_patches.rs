//! The closed mesh of patches that go round a body as they are, which passes every check, or the reason why there is none.

use glam::DVec3;

use super::meshed::{CROSSINGS, MOST_LOOKED_AT, compact, finished, latest_first, lies_close, runs_through};
use super::solid_mesh::SolidMesh;
use super::woven::{Woven, WovenFace};
use crate::check::{self, Topology};
use crate::error::{Code, Error, Result};
use crate::face::{FaceKind, kind_of};
use crate::mesh::{Welded, welded, welded_clear};
use crate::patch::Side;
use crate::solid::place;
use crate::solution::Placed;
use crate::watch;

/// How many times as finely as asked for a body is meshed, in turn, before it is refused, and whether without lines that lie too near to each other for single precision: of a tube of two patches each may be flat at first, and what such lines
/// leave may be too coarse at first. Less finely only where no tolerance is asked for.
const ATTEMPTS: [(f64, bool); 6] = [(1.0, false), (1.0, true), (0.4, true), (1.5, true), (3.0, false), (3.0, true)];

/// Where no tolerance is asked for, a mesh without lines that are in the way may be off by so many times as much as one with them.
const LOOSER: f64 = 3.0;

/// A body of many patches is looked at once more, before it is refused, where that takes no more triangles a patch than these.
const MANY_A_PATCH: usize = 100;

/// The most triangles of one body.
const MOST_TRIANGLES: usize = 8_000_000;

/// The mesh of closed patches within a tolerance, or within the usual one; `scale` is from model units to millimetres.
///
/// # Errors
/// `open-surface` for patches that do not close, or have no inside; `crosses-itself`, `pinched-surface`, `too-large`, `tolerance-too-fine`, `overflow`.
pub(crate) fn closed_patches(placed: &Placed, tolerance: Option<f64>, scale: f64) -> Result<(Topology, SolidMesh)> {
    refuse_open(placed)?;
    let mut asked = tolerance;
    let mut refusal = None;
    let mut n_usual = 0;
    let n_patches = placed.solved().patches().len();
    for (fineness, is_clear) in ATTEMPTS {
        watch::go_on()?;
        if fineness < 1.0 && tolerance.is_some() {
            continue;
        }
        if tolerance.is_none() && is_too_fine(n_usual, n_patches, fineness) {
            continue;
        }
        let within = asked.map(|asked| asked / fineness);
        let woven = match is_clear {
            false => welded(placed, within).map(Some),
            true => welded_clear(placed, within, tolerance.unwrap_or(LOOSER * asked.unwrap_or(f64::INFINITY))),
        };
        let Welded { positions, triangles, of_patches, bound } = match woven {
            Ok(Some(woven)) => woven,
            Ok(None) => continue,
            // What is refused for being too fine was refused for something else before.
            Err(error) => return Err(refusal.unwrap_or(error)),
        };
        asked.get_or_insert(bound);
        n_usual = n_usual.max(triangles.len());
        if triangles.len() > MOST_TRIANGLES {
            let message = format!("needs more than {MOST_TRIANGLES} triangles: expected a coarser tolerance");
            let error = Error::new(Code::TooLarge, placed.own_path(), message).with("what", "triangles");
            return Err(error.with("greatest", MOST_TRIANGLES));
        }
        let faces = faces_of(placed, &of_patches);
        let positions: Vec<[f32; 3]> = positions.iter().map(|at| (*at * scale).to_array().map(|x| x as f32)).collect();
        if positions.iter().flatten().any(|x| !x.is_finite()) {
            let message = "the body is larger than a file can hold: numbers up to 3e38 millimetres can be held";
            return Err(Error::new(Code::Overflow, placed.own_path(), message));
        }
        let mut woven = Woven { positions, triangles, blocks: Vec::new(), faces, bound };
        compact(&mut woven);
        match verdict(placed, &woven, scale) {
            Ok(topology) => {
                let mut mesh = finished(&woven, placed.index(), scale);
                // That of the patches has the rounding in it.
                mesh.bound = bound;
                return Ok((topology, mesh));
            }
            Err(error) => refusal = Some(error),
        }
    }
    Err(refusal.unwrap_or_else(|| Error::new(Code::CrossesItself, placed.own_path(), "the patches cannot be meshed")))
}

/// Whether so many times as finely as what took so many triangles is too many to look at once more, only to be refused again: nobody waits for that.
fn is_too_fine(n_usual: usize, n_patches: usize, fineness: f64) -> bool {
    fineness > 1.0 && n_usual as f64 * fineness > MOST_LOOKED_AT.max(MANY_A_PATCH * n_patches) as f64
}

/// The triangles of patches one after the other that are of one kind, as one face.
fn faces_of(placed: &Placed, of_patches: &[usize]) -> Vec<WovenFace> {
    let mut faces: Vec<WovenFace> = Vec::new();
    for (patch, n_triangles) in of_patches.iter().copied().enumerate() {
        let kind = kind_of(placed, patch);
        match faces.last_mut().filter(|last| last.kind == kind) {
            Some(last) => last.n_triangles += n_triangles,
            None => faces.push(WovenFace { kind, n_triangles, is_level: false }),
        }
    }
    faces
}

/// Whether it is an octant that thins out towards an edge.
fn has_blades(placed: &Placed) -> bool {
    #[cfg(feature = "patchwork")]
    return placed.solved().octant().is_some_and(crate::octant::Supersphere::has_blades);
    #[cfg(not(feature = "patchwork"))]
    {
        let _ = placed;
        false
    }
}

/// Refuses patches that are no boundary of a body.
fn refuse_open(placed: &Placed) -> Result<()> {
    const SIDES: [&str; 4] = ["u = 0", "u = 1", "v = 0", "v = 1"];
    if placed.solved().is_closed() {
        return Ok(());
    }
    let patches = placed.solved().patches();
    let mut sides = patches
        .iter()
        .enumerate()
        .flat_map(|(patch, of)| of.sides().into_iter().enumerate().map(move |side| (patch, side)));
    let Some((patch, (side, _))) = sides.find(|(_, (_, met))| *met == Side::Free) else {
        let message = "the surface has one side only, so that it has no inside: expected one with two";
        return Err(Error::new(Code::OpenSurface, placed.path("shape"), message).with("what", "one-sided"));
    };
    let (u, v) = [(0.0, 0.5), (1.0, 0.5), (0.5, 0.0), (0.5, 1.0)][side];
    let at = placed.place(&patches[patch].jet(u, v)).position;
    let message = format!(
        "the side {} of patch {patch} is free, at {}, so that nothing is enclosed: expected patches that close, which are a solid as they are, or a wall and the pot as product",
        SIDES[side],
        place(at)
    );
    let error = Error::new(Code::OpenSurface, placed.path(&format!("shape.patches[{patch}]")), message);
    Err(error.with("what", "free-edge").near(at.to_array()))
}

/// Whether a mesh is one that may be written.
fn verdict(placed: &Placed, woven: &Woven, scale: f64) -> Result<Topology> {
    let error = |code: Code, what: &str, at: DVec3, message: String| {
        Err(Error::new(code, placed.path("shape"), message).with("what", what).near(at.to_array()))
    };
    // Of such an octant no more is wrong than that it is a blade.
    let thin = |at: DVec3| {
        let message = format!(
            "this octant thins out near {} to less than numbers of seven digits can hold: expected exponents of at least 1, or an octant that is neither turned nor moved",
            place(at)
        );
        error(Code::PinchedSurface, "thin-edge", at, message)
    };
    let is_blade = has_blades(placed);
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| woven.positions[vertex as usize]);
    if let Some(number) = woven.triangles.iter().position(|triangle| check::is_degenerate(corners(triangle))) {
        let at = woven.middle(number as u32) / scale;
        if is_blade {
            return thin(at);
        }
        let message = format!(
            "the surface shrinks to nothing at {}: expected it to be wider than numbers of seven digits can hold",
            place(at)
        );
        return error(Code::PinchedSurface, "shrinks", at, message)
            .map_err(|error| error.with("face", FaceKind::Outer.name()));
    }
    let topology = match check::closed(&woven.triangles, woven.positions.len()) {
        Ok(topology) => topology,
        Err(vertex) => {
            let at = woven.position(vertex) / scale;
            let message = format!(
                "the patches meet in a single point at {}: expected them to have edges in common there",
                place(at)
            );
            return error(Code::CrossesItself, "does-not-close", at, message);
        }
    };
    // Of a network with a thickness the side that was added to the surface, and the rims, may cross what the surface does not.
    let own = placed.solved().thinnest().map(|_| kind_of(placed, 0));
    let most = if own.is_some() { CROSSINGS } else { 1 };
    let (crossings, given_up) = check::crossings_soon(&woven.positions, &woven.triangles, |_| None, most);
    let kind = |triangle: u32| woven.face(triangle).map_or(FaceKind::Outer, |face| woven.faces[face].kind);
    let is_of_surface = |kinds: &[FaceKind]| own.is_none_or(|own| kinds.iter().all(|kind| *kind == own));
    // If the surface itself is at fault, that is the reason.
    let worst = crossings.iter().find(|pair| is_of_surface(&pair.map(kind))).or(crossings.first()).copied();
    match (worst, given_up) {
        (Some([triangle, _]), _) | (None, Some(triangle)) if is_blade => thin(woven.middle(triangle) / scale),
        (Some(pair), _) if !is_of_surface(&pair.map(kind)) => {
            let at = woven.middle(pair[0]) / scale;
            Err(runs_through(placed, "wall.thickness", latest_first(pair.map(kind)), at))
        }
        (None, Some(triangle)) if !is_of_surface(&[kind(triangle)]) => {
            Err(lies_close(placed, kind(triangle), woven.middle(triangle) / scale))
        }
        (Some([triangle, _]), _) => {
            let at = woven.middle(triangle) / scale;
            let message = format!("the surface runs through itself near {}: expected one that does not", place(at));
            error(Code::CrossesItself, "surface", at, message)
        }
        (None, Some(triangle)) => {
            let at = woven.middle(triangle) / scale;
            let message = format!(
                "so much of the surface lies close to itself near {} that it cannot be told whether it runs through itself: expected one that does not",
                place(at)
            );
            error(Code::CrossesItself, "surface-close", at, message)
        }
        (None, None) => Ok(topology),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A blend of 220,000 triangles was meshed of two millions, to find again that they run through each other: half a minute on a page.
    #[test]
    fn what_takes_many_triangles_is_not_meshed_more_finely_to_be_refused_again() {
        assert!(is_too_fine(220_000, 8, 3.0) && is_too_fine(220_000, 8, 1.5));
        assert!(!is_too_fine(20_000, 8, 3.0), "an octant or a tube of few patches is looked at again");
        assert!(!is_too_fine(320_000, 10_000, 3.0), "nor are these many for a large network");
        assert!(!is_too_fine(8_000_000, 1, 1.0) && !is_too_fine(8_000_000, 1, 0.4));
    }
}
