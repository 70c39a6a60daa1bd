//! A part on the grids of its patches, whatever kind of shape they are of.

use core::fmt::Write;

use glam::{DMat3, DVec3};
use xxhash_rust::xxh64::Xxh64;

#[cfg(feature = "patchwork")]
use super::bladed::{Bladed, bladed};
use super::cleared::cleared;
use super::contract::{Mesh, MeshOptions, VERTEX_LIMIT};
use super::grid::append_patch;
use super::normal::cofactors;
use super::seams::{Seams, along_side};
use super::sewn::{firsts, sewn};
use super::tolerance::DEFAULT_FINENESS;
use crate::design::plain;
use crate::error::{Code, Error, Result};
#[cfg(feature = "patchwork")]
use crate::octant::Supersphere;
use crate::patch::{Cell, Lines, Patch, Side, Spread, deviation_of, lines_within};
use crate::solution::Placed;

/// One part, ready to be sampled patch by patch. Sums are in double precision and rounded once.
///
/// Sides that patches share, or that a patch joins to its own opposite, are sampled once: both have the same bits there. A pole is one point.
pub(super) struct PatchGrids<'a> {
    placed: &'a Placed,
    lines: Vec<Lines>,
    pub(super) bound: Option<f64>,
}

impl<'a> PatchGrids<'a> {
    /// Chooses the grids; they are bounded where something was left to choose or `is_bounded`.
    ///
    /// # Errors
    /// `tolerance-too-fine`, `too-large`, `overflow`.
    pub(super) fn choose(placed: &'a Placed, options: &MeshOptions, is_bounded: bool) -> Result<PatchGrids<'a>> {
        placed.solved().drawable(&placed.path("shape"))?;
        let patches = placed.solved().patches();
        // The columns of a rotation times a scale are orthogonal, so lengths are those of stretched axes.
        let m = placed.matrix();
        let stretch = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length);
        let whole = Cell { u: [0.0, 1.0], v: [0.0, 1.0] };
        let size = patches.iter().map(|patch| patch.suprema(whole, stretch).size).fold(0.0, f64::max);
        // Half a unit in the last place in each of three directions.
        let rounding = (size + placed.shift().length()) * f64::from(f32::EPSILON);
        let too_fine = |message: String| Error::new(Code::ToleranceTooFine, "tolerance", message);
        let beyond = || {
            let message = format!("more than {VERTEX_LIMIT} vertices are needed for it; ask for a coarser tolerance");
            Error::new(Code::TooLarge, placed.own_path(), message).with("greatest", VERTEX_LIMIT)
        };
        let [rows, columns] = share_of(options, patches.len()).ok_or_else(beyond)?;
        let lines = match (rows, columns) {
            (Some(rows), Some(columns)) => Lines::even_of(&patches, rows, columns),
            (rows, columns) => {
                if !rounding.is_finite() {
                    let message = "this part is so large that its size cannot be computed with";
                    return Err(Error::new(Code::Overflow, placed.own_path(), message));
                }
                let tolerance = options.tolerance.unwrap_or(DEFAULT_FINENESS * size + rounding);
                if !(tolerance > rounding) {
                    return Err(too_fine(format!(
                        "a mesh in single precision is only good to {} for a pot of this size, found {}",
                        plain(rounding),
                        plain(tolerance)
                    )));
                }
                let found = lines_within(&patches, stretch, tolerance - rounding, VERTEX_LIMIT);
                let (mut lines, deviation) = found.ok_or_else(|| match options.tolerance {
                    Some(_) => beyond().with("what", "tolerance"),
                    None => beyond(),
                })?;
                if rows.is_none() && columns.is_none() {
                    let bound = Some(deviation + rounding).filter(|bound| bound.is_finite());
                    return Ok(PatchGrids { placed, lines, bound });
                }
                for lines in &mut lines {
                    let even = Lines::even(rows.unwrap_or(lines.u.len()), columns.unwrap_or(lines.v.len()));
                    if rows.is_some() {
                        lines.u = even.u;
                    }
                    if columns.is_some() {
                        lines.v = even.v;
                    }
                }
                // What is given in one direction meets what was chosen in the other.
                Lines::share(&patches, &mut lines);
                lines
            }
        };
        let is_known = is_bounded || options.tolerance.is_some() || options.rows.is_none() || options.columns.is_none();
        let bound = is_known.then(|| deviation_of(&patches, &lines, stretch) + rounding);
        if let (Some(tolerance), Some(bound)) = (options.tolerance, bound)
            && !(bound <= tolerance * (1.0 + 1e-12))
        {
            let message =
                format!("the rows and columns given cannot hold {}; leave them out, or ask for more", plain(tolerance));
            return Err(too_fine(message));
        }
        Ok(PatchGrids { placed, lines, bound: bound.filter(|bound| bound.is_finite()) })
    }

    /// Cut into so many pieces between their knots, both ways.
    pub(super) fn pieces(placed: &'a Placed, pieces: usize) -> PatchGrids<'a> {
        PatchGrids { placed, lines: Lines::pieces_of(&placed.solved().patches(), pieces), bound: None }
    }

    /// Grids that were chosen for the same patches elsewhere.
    #[cfg(feature = "patchwork")]
    pub(super) fn of(placed: &'a Placed, lines: Vec<Lines>) -> PatchGrids<'a> {
        PatchGrids { placed, lines, bound: None }
    }

    #[cfg(feature = "patchwork")]
    pub(super) fn into_lines(self) -> Vec<Lines> {
        self.lines
    }

    /// For each patch the lines of its grid.
    pub(super) fn lines(&self) -> &[Lines] {
        &self.lines
    }

    pub(super) fn n_vertices(&self) -> usize {
        self.lines.iter().map(Lines::n_vertices).sum()
    }

    /// Names the grids and their winding.
    pub(super) fn append_topology(&self, topology: &mut String) {
        let mut hash = Xxh64::new(0);
        for (patch, Lines { u, v }) in self.lines.iter().enumerate() {
            hash.update(&[u8::from(self.placed.is_forwards(patch))]);
            for lines in [u, v] {
                hash.update(&(lines.len() as u32).to_le_bytes());
                lines.iter().for_each(|place| hash.update(&place.to_le_bytes()));
            }
        }
        // A String takes whatever is written to it.
        let _ = write!(topology, "{}p{}v{:016x}", self.lines.len(), self.n_vertices(), hash.digest());
    }

    /// Appends what depends on the grids alone, and room for positions and normals.
    pub(super) fn append_to(&self, mesh: &mut Mesh) {
        let first = mesh.indices.len() as u32;
        for (patch, Lines { u, v }) in self.lines.iter().enumerate() {
            let base = mesh.n_vertices() as u32;
            let n = u.len() * v.len();
            mesh.positions.resize(mesh.positions.len() + 3 * n, 0.0);
            mesh.normals.resize(mesh.normals.len() + 3 * n, 0.0);
            mesh.uvs.extend(u.iter().flat_map(|u| v.iter().flat_map(|v| [*u as f32, *v as f32])));
            let is_forwards = self.placed.is_forwards(patch);
            append_patch(&mut mesh.indices, base, u.len() as u32, v.len() as u32, is_forwards);
        }
        mesh.groups.extend_from_slice(&[first, mesh.indices.len() as u32 - first, self.placed.index() as u32]);
    }

    /// Fills positions and normals; these as they are before they are smoothed go into `unsmoothed` too.
    ///
    /// # Errors
    /// `overflow` for a point beyond single precision.
    pub(super) fn fill(
        &self,
        positions: &mut [f32],
        normals: &mut [f32],
        unsmoothed: Option<&mut Vec<[f32; 3]>>,
    ) -> Result<()> {
        let (positions, normals) = (positions.as_chunks_mut::<3>().0, normals.as_chunks_mut::<3>().0);
        let patches = self.placed.solved().patches();
        let firsts = firsts(&self.lines);
        self.fill_patches(0..patches.len(), &firsts, positions, normals)?;
        if let Some(unsmoothed) = unsmoothed {
            unsmoothed.clear();
            unsmoothed.extend_from_slice(normals);
        }
        let seams = Seams { patches: &patches, lines: &self.lines, firsts: &firsts };
        seams.close(positions);
        if let Some(crease) = self.placed.solved().crease() {
            seams.smooth(normals, crease);
        }
        Ok(())
    }

    /// Fills positions and normals of some patches, each by itself.
    ///
    /// # Errors
    /// As [`PatchGrids::fill`].
    pub(super) fn fill_patches(
        &self,
        which: impl Iterator<Item = usize>,
        firsts: &[usize],
        positions: &mut [[f32; 3]],
        normals: &mut [[f32; 3]],
    ) -> Result<()> {
        let outward = cofactors(self.placed.matrix());
        for index in which {
            let (Some(lines), Some(first)) = (self.lines.get(index), firsts.get(index)) else { continue };
            let range = *first..first + lines.n_vertices();
            let outward = outward * if self.placed.is_forwards(index) { 1.0 } else { -1.0 };
            if let (Some(positions), Some(normals)) = (positions.get_mut(range.clone()), normals.get_mut(range)) {
                self.fill_patch(self.placed.solved().patch(index), lines, outward, positions, normals)?;
            }
        }
        Ok(())
    }

    fn fill_patch(
        &self,
        patch: &dyn Patch,
        lines: &Lines,
        outward: DMat3,
        positions: &mut [[f32; 3]],
        normals: &mut [[f32; 3]],
    ) -> Result<()> {
        let n_columns = lines.v.len();
        let columns = patch.columns(Spread::At(&lines.v));
        for (i, u) in lines.u.iter().enumerate() {
            let row = patch.row(*u);
            for (j, v) in lines.v.iter().enumerate() {
                let jet = row.jet_at(&columns, j);
                let normal = outward * direction(patch, (*u, *v), jet.du, jet.dv);
                let position = self.placed.point(jet.position).to_array().map(|x| x as f32);
                if position.iter().any(|x| !x.is_finite()) {
                    let message = format!(
                        "the surface runs beyond what a mesh can hold at row {i}, column {j}; numbers up to 3e38 can be held"
                    );
                    return Err(Error::new(Code::Overflow, self.placed.own_path(), message));
                }
                let vertex = i * n_columns + j;
                positions[vertex] = position;
                normals[vertex] = normal.normalize_or(DVec3::Z).to_array().map(|x| x as f32);
            }
        }
        for (side, met) in patch.sides().into_iter().enumerate() {
            let mut here = along_side(lines, side);
            match met {
                Side::Pole => {
                    if let Some(first) = here.next() {
                        here.for_each(|vertex| positions[vertex] = positions[first]);
                    }
                }
                // The opposite side has it.
                Side::Joined if side % 2 == 1 => {
                    for (to, from) in here.zip(along_side(lines, side - 1)) {
                        (positions[to], normals[to]) = (positions[from], normals[from]);
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// `X_u x X_v` counts as vanished when it is this small against the lengths of both.
const VANISHED: f64 = 1e-10;

/// A direction along `X_u x X_v`, at a pole or a cusp its limit; the axis where there is none.
fn direction(patch: &dyn Patch, (u, v): (f64, f64), du: DVec3, dv: DVec3) -> DVec3 {
    let normal = du.cross(dv);
    if normal.length() > VANISHED * du.length() * dv.length() {
        return normal.normalize_or(DVec3::Z);
    }
    patch.normal_limit(u, v).unwrap_or(DVec3::Z)
}

/// The least that each patch of several has in either direction: its corners and the middles of its edges.
const FEWEST: usize = 3;

/// Rows and columns of each of so many patches. Several have as many rows as columns, because their sides meet in any direction, and together about as many vertices as one grid of the rows and columns that are asked for.
/// `None` beyond the limit.
fn share_of(options: &MeshOptions, n_patches: usize) -> Option<[Option<usize>; 2]> {
    let each = match [options.rows, options.columns] {
        [Some(rows), Some(columns)] if n_patches > 1 => {
            let even = libm::sqrt(rows as f64 * columns as f64 / n_patches as f64) as usize;
            [Some(even.max(FEWEST)); 2]
        }
        given => given,
    };
    let n = each.iter().fold(n_patches as f64, |n, lines| n * lines.map_or(2.0, |lines| lines as f64));
    (n <= VERTEX_LIMIT as f64).then_some(each)
}

/// Triangles that share their vertices, in model units after placement.
pub(crate) struct Welded {
    /// By vertex number; some are of no triangle.
    pub(crate) positions: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// How many of them each patch has, in their order.
    pub(crate) of_patches: Vec<usize>,
    /// How far they are from the patches at most, rounding to single precision included.
    pub(crate) bound: f64,
}

impl Welded {
    fn of(placed: &Placed, lines: &[Lines], bound: f64) -> Welded {
        let (positions, numbered) = sewn(placed, lines);
        let mut of_patches = vec![0; lines.len()];
        for (_, (patch, _)) in &numbered {
            of_patches[*patch] += 1;
        }
        let triangles = numbered.into_iter().map(|(corners, _)| corners).collect();
        Welded { positions, triangles, of_patches, bound }
    }
}

/// The patches of a part within a tolerance, or within the usual one, with one vertex for each point.
///
/// # Errors
/// `tolerance-too-fine`, `too-large`.
pub(crate) fn welded(placed: &Placed, tolerance: Option<f64>) -> Result<Welded> {
    let grids = PatchGrids::choose(placed, &MeshOptions { tolerance, ..MeshOptions::default() }, true)?;
    Ok(Welded::of(placed, &grids.lines, grids.bound.unwrap_or(f64::INFINITY)))
}

/// The same without lines so near to each other that triangles between them are narrower than single precision tells, and of an octant that thins out with what is thinner than that; `None` where nothing of that is in the way, and where without it it is further from the patches than `most`.
///
/// # Errors
/// As [`welded`].
pub(crate) fn welded_clear(placed: &Placed, tolerance: Option<f64>, most: f64) -> Result<Option<Welded>> {
    let grids = PatchGrids::choose(placed, &MeshOptions { tolerance, ..MeshOptions::default() }, true)?;
    #[cfg(feature = "patchwork")]
    if placed.solved().octant().is_some_and(Supersphere::has_blades) {
        return Ok(bladed(placed, &grids.lines, most).map(|Bladed { positions, triangles, bound }| {
            let of_patches = triangles.iter().map(Vec::len).collect();
            Welded { positions, triangles: triangles.concat(), of_patches, bound }
        }));
    }
    let m = placed.matrix();
    let stretch = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length);
    let Some((lines, rounding)) = cleared(placed, &grids.lines) else { return Ok(None) };
    let bound = deviation_of(&placed.solved().patches(), &lines, stretch) + rounding;
    Ok((bound <= most).then(|| Welded::of(placed, &lines, bound)))
}
