//! The mesh of a body, which passes every check, or the reason why there is none.

use std::sync::Arc;

use glam::DVec3;

use super::solid_mesh::SolidMesh;
use super::woven::{Grid, Woven, field, name, weave, weave_surface};
use crate::check::{self, Topology};
use crate::error::{Code, Error, Result};
use crate::face::FaceKind;
use crate::mesh::places;
use crate::solid::{Pot, Skin, place, short};
use crate::solution::Placed;
use crate::watch;

/// The most triangles of one part.
const MOST_TRIANGLES: usize = 8_000_000;

/// The most triangles of the surface at which a part is looked at once more before it is refused.
pub(super) const MOST_LOOKED_AT: usize = 300_000;

/// How many times as finely as asked for a part is meshed, in turn, before it is refused.
const FINENESS: [f64; 2] = [1.0, 3.0];

/// What is said of triangles that lie so close together that nobody knows whether they cross: of a wall, and of a surface.
const CLOSE: [&str; 2] = ["close", "surface-close"];

/// A wall that is somewhere thinner than this part of what was asked for cannot be made if it was not meshed at once.
const THINNEST: f64 = 0.05;

/// How often rows and columns are added until faces that have no bound beforehand keep the tolerance.
const ROUNDS: usize = 3;

/// The part of the size that the first, coarse mesh keeps.
pub(crate) const COARSE: f64 = 1.0 / 250.0;

/// The part of the size at which a mesh that is only [`glimpsed`] aims.
pub(crate) const GLIMPSE: f64 = 1.0 / 150.0;

/// Rows no further apart than this are the two of a corner.
const CORNER: f64 = 1e-12;

/// The most crossings that are looked at for a reason.
pub(super) const CROSSINGS: usize = 200;

/// A mesh is made finer by no more than this factor at a time.
const LEAST_STEP: f64 = 0.4;

/// What was made of one part.
pub(crate) struct Made {
    pub(crate) mesh: SolidMesh,
    pub(crate) pot: Pot,
    pub(crate) topology: Topology,
    /// The tolerance that was asked for, where the mesh does not keep it.
    pub(crate) unkept: Option<f64>,
}

impl Made {
    /// The mesh of a pot on a surface that does not cross itself; `scale` is from model units to millimetres.
    ///
    /// A coarse mesh may step over what a finer one runs into: what is made more coarsely than without a tolerance has to be made without one too, and what is refused only because it is finer says so.
    ///
    /// # Errors
    /// As [`solid`](crate::solid()).
    pub(crate) fn of(pot: Pot, tolerance: Option<f64>, scale: f64) -> Result<Made> {
        if is_coarse(pot.skin(), tolerance)? {
            meshed(&pot, None, scale)?;
        }
        Made::within(pot, tolerance, scale)
    }

    /// As [`Made::of`], of a pot that is known to be made without a tolerance too where that [is coarse](is_coarse).
    ///
    /// # Errors
    /// As [`solid`](crate::solid()).
    pub(super) fn within(pot: Pot, tolerance: Option<f64>, scale: f64) -> Result<Made> {
        let usual = grid(pot.skin(), None, None)?.bound;
        let is_fine = tolerance.is_some_and(|asked| asked < usual);
        let made = meshed(&pot, tolerance, scale).map_err(|error| match error.code() {
            Code::CrossesItself | Code::NoRoom | Code::PinchedSurface
                if is_fine && meshed(&pot, None, scale).is_ok() =>
            {
                let message = format!("{}, where triangles within {} step over it", error.message(), short(usual));
                error.saying(message).with("bound", usual)
            }
            _ => error,
        });
        made.map(|(topology, mesh, unkept)| Made { mesh, pot, topology, unkept })
    }

    /// A mesh within the usual tolerance, looked at once and no more closely.
    ///
    /// # Errors
    /// As [`Made::of`].
    pub(super) fn at_once(pot: Pot, scale: f64) -> core::result::Result<Made, Box<(Pot, Error)>> {
        match meshed_once(&pot, None, 1.0, scale) {
            Ok((topology, mesh, unkept)) => Ok(Made { mesh, pot, topology, unkept }),
            Err(error) => Err(Box::new((pot, error))),
        }
    }
}

/// Whether a tolerance is coarser than what is usual.
///
/// # Errors
/// What keeps the surface from being meshed.
pub(crate) fn is_coarse(skin: &Skin, tolerance: Option<f64>) -> Result<bool> {
    Ok(match tolerance {
        Some(asked) => asked > grid(skin, None, None)?.bound,
        None => false,
    })
}

/// The mesh of a pot within a tolerance, or within the usual one; with the tolerance where it is not kept.
fn meshed(pot: &Pot, tolerance: Option<f64>, scale: f64) -> Result<(Topology, SolidMesh, Option<f64>)> {
    let part = pot.part();
    let mut refusal = None;
    for (attempt, fineness) in FINENESS.into_iter().enumerate() {
        if attempt > 0 && is_too_fine(pot, tolerance, fineness) {
            break;
        }
        match meshed_once(pot, tolerance, fineness, scale) {
            Ok(made) => return Ok(made),
            // Looking more closely does not make a pot smaller.
            Err(error) if matches!(error.code(), Code::Overflow | Code::TooLarge | Code::ToleranceTooFine) => {
                return Err(error);
            }
            // Nor does it make less lie in one place.
            Err(error) if error.arg("what").is_some_and(|what| CLOSE.iter().any(|close| *what == (*close).into())) => {
                return Err(error);
            }
            Err(error) => refusal = Some(error),
        }
        if attempt == 0
            && let Some(error) = too_thin(pot, tolerance)
        {
            return Err(error);
        }
    }
    Err(refusal.unwrap_or_else(|| Error::new(Code::CrossesItself, pot_path(part), "the pot cannot be meshed")))
}

/// Whether so many times as finely as usual takes so many triangles that nobody would wait for them, only to be refused again. Who asks for a tolerance waits.
fn is_too_fine(pot: &Pot, tolerance: Option<f64>, fineness: f64) -> bool {
    let Ok(usual) = grid(pot.skin(), None, None) else { return true };
    tolerance.is_none_or(|asked| asked >= usual.bound) && usual.n_triangles() as f64 * fineness > MOST_LOOKED_AT as f64
}

/// As [`meshed`], so many times as finely as asked for.
///
/// # Errors
/// As [`solid`](crate::solid()).
pub(crate) fn meshed_once(
    pot: &Pot,
    tolerance: Option<f64>,
    fineness: f64,
    scale: f64,
) -> Result<(Topology, SolidMesh, Option<f64>)> {
    watch::go_on()?;
    let mut woven = woven(pot, tolerance, fineness, scale)?;
    compact(&mut woven);
    let topology = verdict(pot, &woven, scale)?;
    let mesh = finished(&woven, pot.part(), scale);
    let unkept = tolerance.filter(|asked| mesh.bound > *asked);
    Ok((topology, mesh, unkept))
}

/// A mesh that aims at a tolerance once, whatever it keeps, and passes every check.
///
/// # Errors
/// As [`solid`](crate::solid()), as far as it is seen on such a mesh.
pub(crate) fn glimpsed(pot: &Pot, tolerance: f64, scale: f64) -> Result<Woven> {
    let mut woven = weave(pot, &grid(pot.skin(), Some(tolerance), Some(tolerance))?, scale)?;
    compact(&mut woven);
    verdict(pot, &woven, scale)?;
    Ok(woven)
}

fn pot_path(part: usize) -> String {
    format!("parts[{part}]")
}

/// A mesh that keeps the tolerance.
fn woven(pot: &Pot, tolerance: Option<f64>, fineness: f64, scale: f64) -> Result<Woven> {
    let mut promised = tolerance.map(|tolerance| tolerance / fineness);
    let is_asked_for = promised.is_some();
    let mut asked = promised;
    let mut round = 1;
    loop {
        let grid = grid(pot.skin(), asked, promised)?;
        let tolerance = *promised.get_or_insert(grid.bound / fineness);
        let woven = weave(pot, &grid, scale)?;
        // What was asked for is kept by the file, whose positions are rounded.
        let rounded = if is_asked_for { rounding(&woven, scale) } else { 0.0 };
        if woven.bound + rounded <= tolerance || round >= ROUNDS {
            return Ok(woven);
        }
        let step = ((tolerance - rounded) / woven.bound).clamp(LEAST_STEP, 0.9);
        asked = Some(tolerance.min(grid.bound) * step);
        round += 1;
    }
}

/// That the wall is nearly nothing somewhere, if it is.
fn too_thin(pot: &Pot, tolerance: Option<f64>) -> Option<Error> {
    let (_, at) = pot.thinned()?;
    let (thinnest, thickest) = pot.thickness();
    let is_too_thin = thinnest < THINNEST * thickest || tolerance.is_some_and(|tolerance| thinnest < tolerance);
    is_too_thin.then(|| {
        let message = format!(
            "the surface bends so sharply at {}, or comes so close to itself, that a wall there would be only {} thick: expected a smoother surface",
            place(at),
            short(thinnest)
        );
        Error::new(Code::NoRoom, pot.skin().placed().path("wall.thickness"), message).near(at.to_array()).with("what", "bends-too-sharply").with("thickness", thinnest)
    })
}

/// Refuses a surface that crosses itself: seen on a coarse mesh, and again on one that keeps the tolerance.
///
/// # Errors
/// `crosses-itself` with the place; what keeps the surface from being meshed.
pub(crate) fn refuse_crossing(skin: &Arc<Skin>, tolerance: Option<f64>, scale: f64) -> Result<()> {
    let coarse = COARSE * skin.size();
    let mut steps = vec![tolerance];
    if tolerance.is_none_or(|tolerance| tolerance < coarse) {
        steps.insert(0, Some(coarse));
    }
    let mut found = None;
    for asked in steps {
        let grid = grid(skin, asked, asked)?;
        let woven = weave_surface(skin, &grid, scale)?;
        let (crossings, given_up) =
            check::crossings_soon(&woven.positions, &woven.triangles, |triangle| woven.group(triangle), 1);
        found = Some(match (crossings.first(), given_up) {
            (Some(pair), _) => surface_crosses(skin, woven.middle(pair[0]) / scale),
            (None, Some(triangle)) => surface_is_crowded(skin, woven.middle(triangle) / scale),
            (None, None) => return Ok(()),
        });
    }
    found.map_or(Ok(()), Err)
}

/// The rows and columns that keep a tolerance of the surface of the design; `promised` is what is aimed at for the other faces.
pub(crate) fn grid(skin: &Skin, asked: Option<f64>, promised: Option<f64>) -> Result<Grid> {
    let (rows, columns, bound) = places(skin.placed(), asked)?;
    let bound = bound.unwrap_or_else(|| asked.unwrap_or(skin.size()));
    let mut rows: Vec<f64> = if skin.is_upward() { rows } else { rows.iter().rev().map(|u| 1.0 - u).collect() };
    // The two of a corner are where two faces meet.
    if skin.stretches().len() > 1 {
        rows.dedup_by(|next, kept| *next - *kept < CORNER);
    }
    let grid = Grid { rows, columns: columns - 1, tolerance: promised.unwrap_or(bound), bound };
    if grid.n_triangles() > MOST_TRIANGLES {
        let message = format!("needs more than {MOST_TRIANGLES} triangles: expected a coarser tolerance");
        let error = Error::new(Code::TooLarge, skin.placed().own_path(), message).with("what", "triangles");
        return Err(error.with("greatest", MOST_TRIANGLES));
    }
    Ok(grid)
}

/// Removes vertices that no triangle uses.
pub(crate) fn compact(woven: &mut Woven) {
    let mut number = vec![u32::MAX; woven.positions.len()];
    let mut kept = Vec::with_capacity(woven.positions.len());
    for vertex in woven.triangles.iter_mut().flatten() {
        let slot = &mut number[*vertex as usize];
        if *slot == u32::MAX {
            *slot = kept.len() as u32;
            kept.push(woven.positions[*vertex as usize]);
        }
        *vertex = *slot;
    }
    woven.positions = kept;
}

/// Whether a mesh is one that may be written.
///
/// # Errors
/// Why it is not.
pub(crate) fn verdict(pot: &Pot, woven: &Woven, scale: f64) -> Result<Topology> {
    let at = |vertex: u32| woven.position(vertex) / scale;
    let kind_of = |triangle: u32| woven.face(triangle).map_or(FaceKind::Outer, |face| woven.faces[face].kind);
    let group = |triangle: u32| woven.group(triangle);
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| woven.positions[vertex as usize]);
    if let Some(number) = woven.triangles.iter().position(|triangle| check::is_degenerate(corners(triangle))) {
        let kind = kind_of(number as u32);
        let message = format!(
            "the {} shrinks to nothing at {}: expected it to be wider than numbers of seven digits can hold",
            name(kind),
            place(at(woven.triangles[number][0]))
        );
        let place = at(woven.triangles[number][0]).to_array();
        let error = Error::new(Code::PinchedSurface, pot.skin().placed().path(field(kind)), message).near(place);
        return Err(error.with("what", "shrinks").with("face", kind.name()));
    }
    let topology = check::closed(&woven.triangles, woven.positions.len()).map_err(|vertex| {
        let message = format!("the faces do not close at {}", place(at(vertex)));
        let error = Error::new(Code::CrossesItself, pot_path(pot.part()), message).near(at(vertex).to_array());
        error.with("what", "does-not-close")
    })?;
    let (crossings, given_up) = check::crossings_soon(&woven.positions, &woven.triangles, group, CROSSINGS);
    let kinds = |pair: &[u32; 2]| pair.map(kind_of);
    // If the surface itself is at fault, that is the reason.
    let worst = crossings.iter().find(|pair| kinds(pair) == [pot.surface_kind(); 2]).or(crossings.first());
    match (worst, given_up) {
        (Some(pair), _) => Err(crossing(pot, kinds(pair), woven.middle(pair[0]) / scale)),
        (None, Some(triangle)) => Err(crowded(pot, kind_of(triangle), woven.middle(triangle) / scale)),
        (None, None) => Ok(topology),
    }
}

/// Triangles of a surface that lie so close together that nobody knows whether they cross.
fn surface_is_crowded(skin: &Skin, at: DVec3) -> Error {
    let message = format!(
        "so much of the surface lies close to itself near {} that it cannot be told whether it runs through itself: expected one that does not",
        place(at)
    );
    let error = Error::new(Code::CrossesItself, skin.placed().path("shape"), message).near(at.to_array());
    error.with("what", "surface-close")
}

/// The same of a wall.
fn crowded(pot: &Pot, kind: FaceKind, at: DVec3) -> Error {
    if kind == pot.surface_kind() || !pot.has_wall() {
        return surface_is_crowded(pot.skin(), at);
    }
    lies_close(pot.skin().placed(), kind, at)
}

/// A face of a wall of which so much lies so close together that nobody knows whether it crosses.
pub(super) fn lies_close(placed: &Placed, kind: FaceKind, at: DVec3) -> Error {
    let message = format!(
        "so much of the {} lies close to itself near {} that it cannot be told whether it has room: expected a thinner wall",
        name(kind),
        place(at)
    );
    let error = Error::new(Code::NoRoom, placed.path("wall.thickness"), message).near(at.to_array());
    error.with("what", "close").with("face", kind.name())
}

fn surface_crosses(skin: &Skin, at: DVec3) -> Error {
    let message = format!("the surface runs through itself near {}: expected one that does not", place(at));
    let error = Error::new(Code::CrossesItself, skin.placed().path("shape"), message).near(at.to_array());
    error.with("what", "surface")
}

/// What a crossing of two faces means to a potter.
fn crossing(pot: &Pot, kinds: [FaceKind; 2], at: DVec3) -> Error {
    if kinds == [pot.surface_kind(); 2] {
        return surface_crosses(pot.skin(), at);
    }
    let kinds @ [first, _] = latest_first(kinds);
    let path = match first {
        FaceKind::Outer | FaceKind::Lining if pot.is_lined() => "wall.lining",
        FaceKind::Outer | FaceKind::Lining => "wall.thickness",
        FaceKind::Underside if !pot.has_wall() => "shape",
        kind => field(kind),
    };
    runs_through(pot.skin().placed(), path, kinds, at)
}

/// Two faces, first that which was added to the surface later.
pub(super) fn latest_first(kinds: [FaceKind; 2]) -> [FaceKind; 2] {
    let order = |kind: FaceKind| match kind {
        FaceKind::Drain => 5,
        FaceKind::FootRing | FaceKind::Recess => 4,
        FaceKind::Rim => 3,
        FaceKind::Underside | FaceKind::Floor | FaceKind::Lid => 2,
        FaceKind::Outer | FaceKind::Lining => 1,
    };
    if order(kinds[0]) >= order(kinds[1]) { kinds } else { [kinds[1], kinds[0]] }
}

/// A face for which another leaves no room.
pub(super) fn runs_through(placed: &Placed, path: &str, [first, second]: [FaceKind; 2], at: DVec3) -> Error {
    let message = if first == second {
        format!("the {} has no room: it runs through itself near {}", name(first), place(at))
    } else {
        format!("the {} has no room: it runs through the {} near {}", name(first), name(second), place(at))
    };
    let error = Error::new(Code::NoRoom, placed.path(path), message).near(at.to_array());
    error.with("what", "crossing").with("face", first.name()).with("other", second.name())
}

/// What the single precision of a file takes from its positions, in model units: half a unit in the last place in each of three directions.
fn rounding(woven: &Woven, scale: f64) -> f64 {
    let largest = woven.positions.iter().flatten().fold(0.0f32, |largest, x| largest.max(x.abs()));
    f64::from(largest) * f64::from(f32::EPSILON) / scale
}

pub(crate) fn finished(woven: &Woven, part: usize, scale: f64) -> SolidMesh {
    let mut first = 0;
    let faces = woven.faces.iter().map(|face| {
        let count = 3 * face.n_triangles as u32;
        first += count;
        (face.kind, first - count, count)
    });
    let faces = faces.collect();
    SolidMesh {
        positions: woven.positions.concat(),
        indices: woven.triangles.concat(),
        faces,
        part,
        bound: woven.bound + rounding(woven, scale),
    }
}
