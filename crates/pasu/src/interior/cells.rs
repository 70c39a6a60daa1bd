//! The cells of a solid.

use glam::DVec3;

use super::plan::Plan;
use super::quality::{of_hexahedron, of_tetrahedron};
use crate::design::{Design, Form, Shape, plain};
use crate::error::{Code, Error, Result};
use crate::solution::Solution;
use crate::watch;

/// What the cells are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum CellShape {
    /// Eight corners: four of one layer, counter-clockwise seen from the next, and four of the next in the same order.
    #[default]
    Hexahedron,
    /// Four corners, the fourth on the side from which the others are counter-clockwise.
    Tetrahedron,
}

/// How finely a solid is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CellsOptions {
    /// How many cells along `u`, `v` and `w`. Of a round solid those along `u` lie round a block in the middle, and those along `v` are rounded up to a multiple of 4.
    pub counts: [usize; 3],
    /// What they are.
    pub shape: CellShape,
}

impl Default for CellsOptions {
    fn default() -> Self {
        CellsOptions { counts: [4, 16, 16], shape: CellShape::Hexahedron }
    }
}

/// The inside of a solid, in model units, after placement.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Cells {
    /// `x, y, z` per point.
    pub positions: Vec<f64>,
    /// The numbers of the corners, cell by cell.
    pub corners: Vec<u32>,
    /// What the cells are.
    pub shape: CellShape,
    /// The scaled Jacobian of each cell, the least over its corners, and of a hexahedron over its middle too: 1 of a box or a regular tetrahedron; what is not above 0 is of no use to a finite element.
    pub quality: Vec<f64>,
}

/// A scaled Jacobian that is no more than this is 0 but for rounding.
const COLLAPSED: f64 = 1e-12;

/// The most points.
const MOST_POINTS: usize = 2_000_000;

impl CellShape {
    /// How many corners a cell has.
    ///
    /// ```
    /// assert_eq!(pasu::CellShape::Hexahedron.n_corners(), 8);
    /// ```
    pub fn n_corners(self) -> usize {
        match self {
            CellShape::Hexahedron => 8,
            CellShape::Tetrahedron => 4,
        }
    }

    /// The word by which it is known: `hexahedron` or `tetrahedron`.
    ///
    /// ```
    /// assert_eq!(pasu::CellShape::Tetrahedron.name(), "tetrahedron");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            CellShape::Hexahedron => "hexahedron",
            CellShape::Tetrahedron => "tetrahedron",
        }
    }
}

impl Cells {
    /// Number of points.
    ///
    /// ```
    /// # let text = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "blend",
    /// #   "start": { "form": "rectangle", "radius": [1, 1], "z": 0, "taper": 0, "dz": 2 }, "end": { "form": "rectangle", "radius": [1, 1], "z": 2, "taper": 0, "dz": 2 } } }] }"#;
    /// let block = pasu::Design::parse(text)?;
    /// let options = pasu::CellsOptions { counts: [2, 3, 4], ..pasu::CellsOptions::default() };
    /// let cells = pasu::cells(&block, 0, &options)?;
    /// assert_eq!((cells.n_points(), cells.n_cells()), (3 * 4 * 5, 2 * 3 * 4));
    /// assert!((cells.least_quality() - 1.0).abs() < 1e-12);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn n_points(&self) -> usize {
        self.positions.len() / 3
    }

    /// Number of cells.
    pub fn n_cells(&self) -> usize {
        self.quality.len()
    }

    /// The scaled Jacobian of the worst cell.
    pub fn least_quality(&self) -> f64 {
        self.quality.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The cells that are collapsed or turned inside out, and so of no use to a finite element.
    pub fn bad(&self) -> impl Iterator<Item = usize> + '_ {
        self.quality.iter().enumerate().filter(|(_, quality)| !(**quality > COLLAPSED)).map(|(cell, _)| cell)
    }

    /// The corners of one cell.
    pub fn cell(&self, cell: usize) -> &[u32] {
        let n = self.shape.n_corners();
        self.corners.get(n * cell..n * (cell + 1)).unwrap_or_default()
    }

    /// The sum of the volumes of all cells, as trilinear hexahedra or tetrahedra have them.
    pub fn volume(&self) -> f64 {
        let point = |index: u32| self.point(index);
        let of = |cell: usize| match (self.shape, self.cell(cell)) {
            (CellShape::Tetrahedron, &[a, b, c, d]) => {
                let [a, b, c, d] = [a, b, c, d].map(point);
                (b - a).cross(c - a).dot(d - a) / 6.0
            }
            (_, corners) => match <[u32; 8]>::try_from(corners) {
                Ok(corners) => trilinear_volume(corners.map(point)),
                Err(_) => 0.0,
            },
        };
        (0..self.n_cells()).map(of).sum()
    }

    fn point(&self, index: u32) -> DVec3 {
        let from = 3 * index as usize;
        self.positions.get(from..from + 3).map_or(DVec3::ZERO, DVec3::from_slice)
    }
}

/// The volume of a trilinear hexahedron (Grandy 1997): two Gauss points along each direction are exact.
fn trilinear_volume(corners: [DVec3; 8]) -> f64 {
    const HALF: f64 = 0.288_675_134_594_812_9;
    let places = [0.5 - HALF, 0.5 + HALF];
    let mut sum = 0.0;
    for r in places {
        for s in places {
            for t in places {
                let bilinear = |a: DVec3, b: DVec3, c: DVec3, d: DVec3, p: f64, q: f64| {
                    a * (1.0 - p) * (1.0 - q) + b * p * (1.0 - q) + c * p * q + d * (1.0 - p) * q
                };
                let [p0, p1, p2, p3, p4, p5, p6, p7] = corners;
                let along = bilinear(p1 - p0, p2 - p3, p6 - p7, p5 - p4, s, t);
                let across = bilinear(p3 - p0, p2 - p1, p6 - p5, p7 - p4, r, t);
                let up = bilinear(p4 - p0, p5 - p1, p6 - p2, p7 - p3, r, s);
                sum += along.cross(across).dot(up) / 8.0;
            }
        }
    }
    sum
}

/// The inside of part number `part` as cells. What has no inside of its own is refused: a surface, a vessel, a network of patches.
///
/// The corners lie on the solid itself, to rounding; between them cells have straight edges.
///
/// # Errors
/// `no-such-point` for a part that does not exist; `unsupported-shape` for a part that is no blend without a wall; `out-of-range` for counts of 0, `too-large` for more than 2,000,000 points, and for more waves than are made; `out-of-range` for fewer terms along `v` than two for each wave of a section; what solving refuses.
pub fn cells(design: &Design, part: usize, options: &CellsOptions) -> Result<Cells> {
    Solution::of(design).cells(part, options)
}

impl Solution {
    /// As [`cells`].
    ///
    /// # Errors
    /// As [`cells`].
    pub fn cells(&self, part: usize, options: &CellsOptions) -> Result<Cells> {
        let (_, described) = self.existing(part)?;
        let path = format!("parts[{part}].shape");
        let Shape::Blend(blend) = &described.shape else {
            let message = format!(
                "expected a blend, found a shape of the kind {:?}: it has no inside that is known",
                described.shape.kind()
            );
            return Err(Error::new(Code::UnsupportedShape, path, message).with("what", "no-inside"));
        };
        if described.wall.is_some() {
            let message = "expected a solid, found a blend with a wall, which is hollow";
            return Err(Error::new(Code::UnsupportedShape, path, message).with("what", "hollow"));
        }
        let forms = [&blend.start.form, &blend.end.form];
        if forms.iter().all(|form| matches!(form, Form::DiscInSquare(_))) {
            let message =
                "the cells of two discs in squares have no volume where u is 0 or 1: expected discs or outlines";
            return Err(Error::new(Code::UnsupportedShape, path, message).with("what", "collapsed"));
        }
        let plan = planned(options, forms.iter().all(|form| form.is_closed()))?;
        let placed = self.workable(part)?;
        if let Some(unseen) = placed.solved().unseen() {
            let message = format!(
                "expected at least {} terms along v, found {}: fewer do not see a wave that goes round {} times, and carry the inside far off",
                plain(unseen.least()),
                unseen.terms,
                plain(unseen.n)
            );
            let error = Error::new(Code::OutOfRange, format!("{path}.terms[1]"), message).with("what", "few-terms");
            let error = error.with("least", unseen.least()).with("found", f64::from(unseen.terms));
            return Err(error.with("waves", unseen.n));
        }
        let Some(volume) = placed.solved().volume() else {
            return Err(Error::new(Code::Bug, path, "a blend without an inside"));
        };
        let [.., n_w] = options.counts;
        let places: Vec<_> = plan.places.iter().map(|[u, v]| [volume.place(0, *u), volume.place(1, *v)]).collect();
        let mut points = Vec::with_capacity(places.len() * (n_w + 1));
        for k in 0..=n_w {
            watch::go_on()?;
            let layer = volume.layer(k as f64 / n_w as f64);
            let placed = places.iter().map(|[along, across]| {
                let position = layer.partial(along, across, [0, 0, 0]);
                placed.matrix() * position + placed.shift()
            });
            points.extend(placed);
        }
        if !points.iter().all(|point| point.is_finite()) {
            return Err(Error::new(Code::Overflow, path, "the solid leaves the range of numbers"));
        }
        Ok(cut(&plan, &points, n_w, options.shape))
    }
}

/// The plan of one layer.
fn planned(options: &CellsOptions, is_round: bool) -> Result<Plan> {
    let [n_u, n_v, n_w] = options.counts;
    if options.counts.contains(&0) {
        return Err(Error::new(Code::OutOfRange, "counts", "expected at least one cell along each direction, found 0")
            .with("least", 1.0));
    }
    let per_layer = if is_round {
        let n = n_v.div_ceil(4) as f64;
        (n + 1.0) * (n + 1.0) + 4.0 * n * n_u as f64
    } else {
        (n_u as f64 + 1.0) * (n_v as f64 + 1.0)
    };
    let n_points = per_layer * (n_w as f64 + 1.0);
    if !(n_points <= MOST_POINTS as f64) {
        let message = format!("expected at most {MOST_POINTS} points, found {n_points}");
        let error = Error::new(Code::TooLarge, "counts", message).with("greatest", MOST_POINTS);
        return Err(error.with("found", n_points));
    }
    Ok(if is_round { Plan::round([n_u, n_v]) } else { Plan::square([n_u, n_v]) })
}

/// Cells between layers of the same plan, turned so that most of them are not inside out.
fn cut(plan: &Plan, points: &[DVec3], n_w: usize, shape: CellShape) -> Cells {
    let n = plan.places.len() as u32;
    let hexahedron = |k: u32, quad: &[u32; 4], is_turned: bool| -> [u32; 8] {
        let [a, b, c, d] = if is_turned { [quad[0], quad[3], quad[2], quad[1]] } else { *quad };
        let (low, high) = (k * n, (k + 1) * n);
        [low + a, low + b, low + c, low + d, high + a, high + b, high + c, high + d]
    };
    let corners_of = |corners: [u32; 8]| corners.map(|corner| points[corner as usize]);
    let layers = 0..n_w as u32;
    let all = || layers.clone().flat_map(|k| plan.quads.iter().map(move |quad| (k, quad)));
    let whole: f64 = all().map(|(k, quad)| trilinear_volume(corners_of(hexahedron(k, quad, false)))).sum();
    let is_turned = whole < 0.0;
    let (mut corners, mut quality) = (Vec::new(), Vec::new());
    match shape {
        CellShape::Hexahedron => {
            for (k, quad) in all() {
                let cell = hexahedron(k, quad, is_turned);
                quality.push(of_hexahedron(&corners_of(cell)));
                corners.extend(cell);
            }
        }
        CellShape::Tetrahedron => {
            let triangles: Vec<[u32; 3]> = plan.triangles().collect();
            for k in layers.clone() {
                for triangle in &triangles {
                    for mut cell in prism(triangle, k * n, (k + 1) * n) {
                        if is_turned {
                            cell.swap(0, 1);
                        }
                        quality.push(of_tetrahedron(&cell.map(|corner| points[corner as usize])));
                        corners.extend(cell);
                    }
                }
            }
        }
    }
    let positions = points.iter().flat_map(|point| point.to_array()).collect();
    Cells { positions, corners, shape, quality }
}

/// A prism between two layers as three tetrahedra. Each of its sides is cut from the corner of the least number below to the one of the greatest above, so that neighbours agree.
fn prism(triangle: &[u32; 3], low: u32, high: u32) -> [[u32; 4]; 3] {
    let mut order = *triangle;
    order.sort_unstable();
    let [a, b, c] = order;
    // Turned round where sorting has turned the triangle round.
    let is_even = [[a, b, c], [b, c, a], [c, a, b]].contains(triangle);
    let cells = [
        [low + a, low + b, low + c, high + c],
        [low + a, low + b, high + c, high + b],
        [low + a, high + b, high + c, high + a],
    ];
    cells.map(|[p, q, r, s]| if is_even { [p, q, r, s] } else { [q, p, r, s] })
}
