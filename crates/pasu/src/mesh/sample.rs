//! Sampling a design on grids.

use core::ops::Range;

use super::contract::{Mesh, MeshOptions, VERTEX_LIMIT};
use super::fill::Workspace;
#[cfg(feature = "patchwork")]
use super::followed::Followed;
use super::grids::{Grids, Places};
use super::part::PartGrid;
use crate::design::{Design, plain};
use crate::error::{Code, Error, Result};
use crate::solution::{Placed, Solution};
use crate::surface::Curves;

/// The mesh of every part of a design, placed, in one set of arrays.
///
/// # Errors
/// `too-large` beyond [`VERTEX_LIMIT`]; `tolerance-too-fine` where the tolerance cannot be promised (single precision positions, or rows and columns that are
/// given); `out-of-range` for options outside their range; what [`Surface::solve`](crate::Surface::solve) refuses; `overflow` for a point beyond single precision.
///
/// ```
/// use pasu::{Design, MeshOptions};
///
/// let vase = Design::parse("#1/bloor-wilson?n1=5")?;
/// let mesh = pasu::mesh(&vase, &MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() })?;
/// assert!(mesh.bound.is_some_and(|bound| bound <= 0.01));
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn mesh(design: &Design, options: &MeshOptions) -> Result<Mesh> {
    Solution::of(design).mesh(options)
}

impl Solution {
    /// As [`mesh`].
    ///
    /// # Errors
    /// As [`mesh`].
    pub fn mesh(&self, options: &MeshOptions) -> Result<Mesh> {
        let mut sampler = Sampler::new();
        sampler.fill(&choose(self.parts(), options, false, &mut Vec::new())?, None)?;
        Ok(sampler.mesh)
    }

    /// As [`bound`].
    ///
    /// # Errors
    /// As [`bound`].
    pub fn bound(&self, options: &MeshOptions) -> Result<f64> {
        let message = "the surface bends more sharply than numbers can tell";
        largest_bound(&choose(self.parts(), options, true, &mut Vec::new())?)
            .ok_or_else(|| Error::new(Code::Overflow, "parts", message))
    }
}

/// Samples one design after the other into the same arrays: what a drag needs, where each mesh takes the place of the one before.
#[derive(Debug, Default)]
pub struct Sampler {
    mesh: Mesh,
    workspace: Workspace,
    topology: String,
    /// Expansions of earlier meshes, whose memory the next one takes.
    spare: Vec<Curves>,
    /// What the mesh is of, where that is a network of which the next one may be the same elsewhere.
    #[cfg(feature = "patchwork")]
    followed: Option<Followed>,
    written: Vec<Range<usize>>,
}

impl Sampler {
    /// A sampler that holds nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// The mesh of a design, as [`mesh`] makes it. After an error the sampler is as good as a new one.
    ///
    /// # Errors
    /// As [`mesh`].
    ///
    /// ```
    /// use pasu::{Design, MeshOptions, Sampler};
    ///
    /// let options = MeshOptions { rows: Some(33), columns: Some(65), ..MeshOptions::default() };
    /// let mut sampler = Sampler::new();
    /// for a in ["1", "1.1", "1.2"] {
    ///     let vase = Design::parse(&format!("#1/bloor-wilson?a={a}"))?;
    ///     assert_eq!(sampler.sample(&vase, &options)?, &pasu::mesh(&vase, &options)?);
    /// }
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn sample(&mut self, design: &Design, options: &MeshOptions) -> Result<&Mesh> {
        check(options)?;
        let parts = design.parts().iter().enumerate();
        let placed = parts.map(|(index, part)| Placed::new(part, index)).collect::<Result<Vec<Placed>>>()?;
        let grids = choose(placed.iter().map(Ok), options, false, &mut self.spare)?;
        self.take(grids, None)
    }

    /// As [`Sampler::sample`], of a design that may have been solved already.
    ///
    /// # Errors
    /// As [`mesh`].
    ///
    /// ```
    /// use pasu::{Design, MeshOptions, Sampler, Solution};
    ///
    /// let solution = Solution::of(&Design::parse("#1/bloor-wilson?n1=5")?);
    /// let (mut sampler, options) = (Sampler::new(), MeshOptions::default());
    /// assert_eq!(sampler.sample_solution(&solution, &options)?, &solution.mesh(&options)?);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn sample_solution(&mut self, solution: &Solution, options: &MeshOptions) -> Result<&Mesh> {
        #[cfg(feature = "patchwork")]
        if let Some(mut followed) = self.followed.take() {
            // What is refused on the way leaves nothing behind.
            let mut mesh = core::mem::take(&mut self.mesh);
            let written = followed.follow(solution, options, &mut mesh)?;
            self.mesh = mesh;
            if let Some(written) = written {
                (self.followed, self.written) = (Some(followed), written);
                return Ok(&self.mesh);
            }
        }
        let grids = choose(solution.parts(), options, false, &mut self.spare)?;
        #[cfg(feature = "patchwork")]
        if let Some(mut followed) = Followed::of(solution, options, &grids) {
            self.take(grids, Some(followed.normals_mut()))?;
            self.followed = Some(followed);
            return Ok(&self.mesh);
        }
        self.take(grids, None)
    }

    /// The vertices of the last mesh that may be elsewhere, or have another normal, than in the one before, ascending. All of them, unless both were sampled by [`Sampler::sample_solution`] with the same given rows and columns, and
    /// the second solution is that of one network of patches [after](Solution::after) the first, with its points elsewhere: then patches alone are sampled again that are on the strips of a point that moved.
    ///
    /// ```
    /// use pasu::{Design, MeshOptions, Sampler, Solution};
    ///
    /// let at = |z: f64| {
    ///     let points = format!("[0,0,0],[1,0,1],[2,0,0],[2,1,1],[2,2,0],[1,2,1],[0,2,0],[0,1,1],[4,0,0],[5,0,1],[6,0,0],[6,1,1],[6,2,{z}],[5,2,1],[4,2,0],[4,1,1]");
    ///     let patches = r#"{"frame":[0,1,2,3,4,5,6,7]},{"frame":[8,9,10,11,12,13,14,15]}"#;
    ///     Design::parse(&format!(r#"{{"pasu":1,"parts":[{{"shape":{{"kind":"vertex-frame","vertices":[{points}],"patches":[{patches}]}}}}]}}"#))
    /// };
    /// let (mut sampler, options) = (Sampler::new(), MeshOptions { rows: Some(4), columns: Some(8), tolerance: None });
    /// let first = Solution::of(&at(0.0)?);
    /// let n = sampler.sample_solution(&first, &options)?.n_vertices();
    /// assert_eq!(sampler.written(), &[0..n]);
    /// let second = first.after(&at(0.5)?);
    /// assert_eq!(sampler.sample_solution(&second, &options)?, &second.mesh(&options)?);
    /// assert_eq!(sampler.written(), &[n / 2..n]);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn written(&self) -> &[Range<usize>] {
        &self.written
    }

    /// The last mesh; an empty one where there is none, and after an error.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    fn take(&mut self, grids: Vec<Grids>, unsmoothed: Option<&mut Vec<[f32; 3]>>) -> Result<&Mesh> {
        #[cfg(feature = "patchwork")]
        {
            self.followed = None;
        }
        let filled = self.fill(&grids, unsmoothed);
        self.spare.extend(grids.into_iter().filter_map(Grids::into_curves));
        filled?;
        Ok(&self.mesh)
    }

    /// Normals of patches as they are before they are smoothed go into `unsmoothed`: those of the last part.
    fn fill(&mut self, grids: &[Grids], mut unsmoothed: Option<&mut Vec<[f32; 3]>>) -> Result<()> {
        let mut mesh = core::mem::take(&mut self.mesh);
        self.topology.clear();
        for grid in grids {
            grid.append_topology(&mut self.topology);
        }
        let is_as_before = self.topology == mesh.topology;
        if !is_as_before {
            mesh.clear();
            mesh.topology.push_str(&self.topology);
            for grid in grids {
                grid.append_to(&mut mesh);
            }
        }
        mesh.bound = largest_bound(grids);
        let mut first = 0;
        for grid in grids {
            let range = 3 * first..3 * (first + grid.n_vertices());
            first += grid.n_vertices();
            if let (Some(positions), Some(normals)) =
                (mesh.positions.get_mut(range.clone()), mesh.normals.get_mut(range))
            {
                grid.fill(&mut self.workspace, positions, normals, unsmoothed.as_deref_mut())?;
            }
        }
        self.written.clear();
        self.written.push(0..mesh.n_vertices());
        self.mesh = mesh;
        Ok(())
    }
}

/// Where the vertices of [`mesh`] are, part by part.
///
/// # Errors
/// As [`mesh`].
pub(crate) fn grid_places(solution: &Solution, options: &MeshOptions) -> Result<Vec<Places>> {
    let grids = choose(solution.parts(), options, false, &mut Vec::new())?;
    Ok(grids.iter().map(Grids::places).collect())
}

/// The mesh of even rows and columns with every sum in double precision, rounded once, the parts in this order. Of a shape that is no series each patch is cut into so many pieces between its knots, both ways.
///
/// # Errors
/// As [`mesh`].
pub(crate) fn exact_mesh(
    solution: &Solution,
    order: &[usize],
    rows: usize,
    columns: usize,
    pieces: usize,
) -> Result<Mesh> {
    let options = MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None };
    let parts = order.iter().map(|index| solution.part(*index));
    let mut grids = chosen(parts, |placed| match placed.solved().fourier() {
        Some(_) => Grids::choose(placed, &options, false, &mut Vec::new()),
        None => Ok(Grids::pieces(placed, pieces)),
    })?;
    for grid in &mut grids {
        grid.make_precise();
    }
    let mut sampler = Sampler::new();
    sampler.fill(&grids, None)?;
    Ok(sampler.mesh)
}

/// The bound that [`mesh`] with the same options keeps: the largest distance between its triangles and the true surface, in model units.
///
/// It is [`Mesh::bound`] wherever that is known, and is found also for rows and columns that are both given, at the cost of some hundred rows of vertices.
///
/// # Errors
/// As [`mesh`]; `overflow` where second derivatives leave the range of numbers, not where points do, which only sampling finds.
///
/// ```
/// use pasu::{Design, MeshOptions};
///
/// let vase = Design::parse("#1/bloor-wilson")?;
/// let grid = |rows| MeshOptions { rows: Some(rows), columns: Some(2 * rows), ..MeshOptions::default() };
/// assert!(pasu::bound(&vase, &grid(64))? < pasu::bound(&vase, &grid(32))?);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn bound(design: &Design, options: &MeshOptions) -> Result<f64> {
    Solution::of(design).bound(options)
}

/// The rows and columns that [`mesh`] chooses for one part, as [`PartGrid::places`] gives them.
///
/// # Errors
/// As [`mesh`].
pub(crate) fn places(placed: &Placed, tolerance: Option<f64>) -> Result<(Vec<f64>, usize, Option<f64>)> {
    let options = MeshOptions { tolerance, ..MeshOptions::default() };
    check(&options)?;
    let Some(surface) = placed.solved().fourier() else {
        let message = "a shape without foot and rim has no rows";
        return Err(Error::new(Code::OpenSurface, placed.path("shape"), message));
    };
    let grid = PartGrid::choose(placed, surface, &options, false, Curves::default())?;
    let (rows, columns) = (grid.tessellation.along + 1.0, grid.tessellation.round + 1.0);
    if rows * columns > VERTEX_LIMIT as f64 {
        let error = too_many(placed, [rows, columns], "; ask for a coarser tolerance");
        // What was asked for and what is usual have different remedies; where points are beyond counting it is the size.
        let is_asked = tolerance.is_some() && (rows * columns).is_finite();
        return Err(if is_asked { error.with("what", "tolerance") } else { error });
    }
    Ok(grid.places())
}

/// The refusal of so many rows and columns; where they are beyond counting it is not said how many.
fn too_many(placed: &Placed, [rows, columns]: [f64; 2], advice: &str) -> Error {
    if !(rows * columns).is_finite() {
        let message = "numbers have too few digits for a mesh of this part, which is too large, or too far from the origin for its size: expected it smaller or nearer";
        return Error::new(Code::TooLarge, placed.own_path(), message).with("greatest", VERTEX_LIMIT);
    }
    let message = format!("needs {} rows of {} vertices{advice}", plain(rows), plain(columns));
    let error = Error::new(Code::TooLarge, placed.own_path(), message).with("rows", rows);
    error.with("columns", columns).with("greatest", VERTEX_LIMIT)
}

/// The largest bound of all parts, if every part has one.
fn largest_bound(grids: &[Grids]) -> Option<f64> {
    grids.iter().try_fold(0.0f64, |largest, grid| grid.bound().map(|bound| largest.max(bound)))
}

fn choose<'a, P: AsRef<Placed> + 'a>(
    parts: impl Iterator<Item = Result<&'a P>>,
    options: &MeshOptions,
    is_bounded: bool,
    spare: &mut Vec<Curves>,
) -> Result<Vec<Grids<'a>>> {
    check(options)?;
    chosen(parts, |placed| Grids::choose(placed, options, is_bounded, spare))
}

/// The grids of all parts, as each is chosen.
fn chosen<'a, P: AsRef<Placed> + 'a>(
    parts: impl Iterator<Item = Result<&'a P>>,
    mut choose: impl FnMut(&'a Placed) -> Result<Grids<'a>>,
) -> Result<Vec<Grids<'a>>> {
    let mut grids = Vec::new();
    let mut n_vertices = 0.0;
    for placed in parts {
        let placed: &'a Placed = placed?.as_ref();
        let grid = choose(placed)?;
        let [rows, columns] = grid.counts();
        n_vertices += rows * columns;
        if n_vertices > VERTEX_LIMIT as f64 {
            let advice = format!(
                ", which takes the mesh beyond {VERTEX_LIMIT} vertices; ask for a coarser tolerance or fewer rows and columns"
            );
            return Err(too_many(placed, [rows, columns], &advice));
        }
        grids.push(grid);
    }
    Ok(grids)
}

fn check(options: &MeshOptions) -> Result<()> {
    for (name, count, least) in [("rows", options.rows, 2), ("columns", options.columns, 4)] {
        if let Some(count) = count.filter(|count| !(least..=VERTEX_LIMIT).contains(count)) {
            let message = format!("expected a whole number from {least} to {VERTEX_LIMIT}, found {count}");
            let error = Error::new(Code::OutOfRange, name, message).with("least", least);
            return Err(error.with("greatest", VERTEX_LIMIT).with("found", count));
        }
    }
    match options.tolerance {
        Some(tolerance) if !(tolerance > 0.0 && tolerance.is_finite()) => {
            let message = format!("expected a distance greater than 0 in model units, found {}", plain(tolerance));
            Err(Error::new(Code::OutOfRange, "tolerance", message).with("above", 0.0).with("found", tolerance))
        }
        _ => Ok(()),
    }
}
