//! From the faces of a pot to triangles that share their vertices.

use core::f64::consts::{PI, TAU};
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::blocks::{NONE, Rings};
use super::disc;
use crate::error::{Code, Error, Result};
use crate::face::{Face, FaceKind};
use crate::solid::{Form, Piece, Pot, Sheet, SheetWalk, Skin, place};
use crate::solution::Columns;
use crate::watch;

/// A ring no wider than this part of the size is a point.
const POLE: f64 = 1e-6;

/// Vertices of neighbouring rings nearer than this part of the tolerance are one.
const SAME: f64 = 0.02;

/// What is measured between vertices is multiplied by this to be a bound: faces are smooth, and between vertices they bend nearly as at them.
const MARGIN: f64 = 1.25;

/// The most rows between where a sheet begins and its first row of constant `s`.
const MOST_BETWEEN: usize = 48;

/// A row has to be so far from where a sheet begins, as a part of the distance to its neighbour.
const CLEARANCE: f64 = 0.3;

/// Rows along the surface and columns round it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    /// `s` of every row of the sheets, from 0 to 1.
    pub(crate) rows: Vec<f64>,
    /// Columns, without one that repeats the first.
    pub(crate) columns: usize,
    /// The largest distance that is aimed at.
    pub(crate) tolerance: f64,
    /// How far the design surface is at most from its triangles on this grid.
    pub(crate) bound: f64,
}

impl Grid {
    /// How many triangles both sides of a wall have on it.
    pub(crate) fn n_triangles(&self) -> usize {
        4 * self.rows.len() * self.columns
    }
}

/// A mesh of one part.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Woven {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// For each triangle the number of the block that it is in, of which no two cross, or [`NONE`]; empty where nobody looked for blocks.
    pub(crate) blocks: Vec<u32>,
    /// In the order of the triangles.
    pub(crate) faces: Vec<WovenFace>,
    /// The largest distance between triangles and faces, without the rounding of positions.
    pub(crate) bound: f64,
}

/// The triangles of one face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WovenFace {
    pub(crate) kind: FaceKind,
    pub(crate) n_triangles: usize,
    /// Whether all triangles are seen side by side, the same way up, along the axis.
    pub(crate) is_level: bool,
}

impl Woven {
    /// Where a vertex is.
    pub(crate) fn position(&self, vertex: u32) -> DVec3 {
        DVec3::from_array(self.positions[vertex as usize].map(f64::from))
    }

    /// The middle of a triangle.
    pub(crate) fn middle(&self, triangle: u32) -> DVec3 {
        self.triangles[triangle as usize].iter().map(|vertex| self.position(*vertex)).sum::<DVec3>() / 3.0
    }

    /// The number of a group of triangles that do not cross each other, if the triangle is in one: a level face, of which all are seen side by side along the axis, or a [block](super::blocks).
    pub(crate) fn group(&self, triangle: u32) -> Option<u32> {
        let level = self.face(triangle).filter(|face| self.faces.get(*face).is_some_and(|face| face.is_level));
        let block = || self.blocks.get(triangle as usize).copied().filter(|block| *block != NONE);
        level.map(|face| face as u32).or_else(|| block().map(|block| self.faces.len() as u32 + block))
    }

    /// The number of the face that a triangle belongs to.
    pub(crate) fn face(&self, triangle: u32) -> Option<usize> {
        let mut first = 0;
        self.faces.iter().position(|face| {
            first += face.n_triangles;
            (triangle as usize) < first
        })
    }
}

/// A curve across a face: its vertices, and where they are before rounding.
#[derive(Debug, Clone)]
struct Ring {
    /// One vertex, or one for each column.
    vertices: Vec<u32>,
    points: Vec<DVec3>,
}

impl Ring {
    fn vertex(&self, column: usize) -> u32 {
        self.vertices[column % self.vertices.len()]
    }

    fn point(&self, column: usize) -> DVec3 {
        self.points[column % self.points.len()]
    }

    fn is_point(&self) -> bool {
        self.vertices.len() == 1
    }
}

struct Weaver<'a> {
    skin: &'a Skin,
    grid: &'a Grid,
    /// From model units to those of the mesh.
    scale: f64,
    columns: Columns,
    woven: Woven,
}

/// Triangles of all faces of a pot, in units of `1 / scale`.
///
/// # Errors
/// `crosses-itself` where a level face has an outline that crosses itself; `overflow` for a point beyond single precision.
pub(crate) fn weave(pot: &Pot, grid: &Grid, scale: f64) -> Result<Woven> {
    let mut weaver =
        Weaver { skin: pot.skin(), grid, scale, columns: pot.skin().columns(grid.columns), woven: Woven::default() };
    let mut last: Option<Ring> = None;
    let mut first: Option<Ring> = None;
    let n_pieces = pot.faces().len();
    for (index, piece) in pot.faces().iter().enumerate() {
        let start = match last.take() {
            Some(ring) => ring,
            None => weaver.ring(weaver.curve(piece, 0.0), None)?,
        };
        let end = first.as_ref().filter(|_| index + 1 == n_pieces && pot.is_ring()).cloned();
        if first.is_none() {
            first = Some(start.clone());
        }
        last = Some(weaver.face(piece, start, end)?);
    }
    Ok(weaver.woven)
}

/// Triangles of the surface of a design alone, which are open at its ends.
///
/// # Errors
/// As [`weave`].
pub(crate) fn weave_surface(skin: &Arc<Skin>, grid: &Grid, scale: f64) -> Result<Woven> {
    let columns = skin.columns(grid.columns);
    let mut weaver = Weaver { skin, grid, scale, columns, woven: Woven::default() };
    let surface = Piece::surface(skin);
    let start = weaver.ring(weaver.curve(&surface, 0.0), None)?;
    weaver.face(&surface, start, None)?;
    Ok(weaver.woven)
}

impl Weaver<'_> {
    fn v(&self, column: usize) -> f64 {
        TAU * column as f64 / self.grid.columns as f64
    }

    /// The points of a face at constant `a`.
    fn curve(&self, piece: &Piece, a: f64) -> Vec<DVec3> {
        let mut walk = piece.walk();
        (0..self.grid.columns).map(|j| walk.jet(a, self.v(j)).position).collect()
    }

    /// Makes vertices of points; those that are where the ring before has its own share them.
    fn ring(&mut self, points: Vec<DVec3>, before: Option<&Ring>) -> Result<Ring> {
        watch::go_on()?;
        let mean = points.iter().sum::<DVec3>() / points.len() as f64;
        let width = points.iter().fold(0.0f64, |width, p| width.max((*p - mean).length()));
        let points = if width <= POLE * self.skin.size() { vec![mean] } else { points };
        let mut vertices = Vec::with_capacity(points.len());
        for (j, point) in points.iter().enumerate() {
            let same = before.filter(|ring| {
                !ring.is_point() && points.len() > 1 && ring.point(j).distance(*point) <= SAME * self.grid.tolerance
            });
            vertices.push(match same {
                Some(ring) => ring.vertex(j),
                None => self.vertex(*point)?,
            });
        }
        Ok(Ring { vertices, points })
    }

    fn vertex(&mut self, point: DVec3) -> Result<u32> {
        let position = point.to_array().map(|x| (x * self.scale) as f32);
        if position.iter().any(|x| !x.is_finite()) {
            let message = "the pot is larger than a file can hold: numbers up to 3e38 millimetres can be held";
            return Err(Error::new(Code::Overflow, self.skin.placed().own_path(), message));
        }
        self.woven.positions.push(position);
        Ok(self.woven.positions.len() as u32 - 1)
    }

    /// Weaves one face from its first ring to its last, which may be given.
    fn face(&mut self, piece: &Piece, start: Ring, end: Option<Ring>) -> Result<Ring> {
        let before = self.woven.triangles.len();
        let mut rings = vec![start];
        for points in self.between(piece) {
            let ring = self.ring(points, rings.last())?;
            rings.push(ring);
        }
        let end = match end {
            Some(ring) => ring,
            None => self.ring(self.curve(piece, 1.0), rings.last())?,
        };
        rings.push(end);
        let is_forwards = piece.outward() > 0.0;
        let blocks = self.blocks(&rings);
        for (pair, blocks) in rings.windows(2).zip(blocks.chunks(self.grid.columns)) {
            watch::work(10 * self.grid.columns as u64);
            self.strip([&pair[0], &pair[1]], is_forwards, blocks);
        }
        if piece.is_level() && !self.is_unfolded(before, &rings) {
            self.level_face(before, &rings, piece)?;
        }
        let is_design = matches!(&piece.form, Form::Sheet { sheet, .. } if sheet.is_whole_design());
        let bound = if is_design { self.grid.bound } else { MARGIN * self.deviation(&rings) };
        self.woven.bound = self.woven.bound.max(bound);
        let n_triangles = self.woven.triangles.len() - before;
        self.woven.faces.push(WovenFace { kind: piece.kind(), n_triangles, is_level: piece.is_level() });
        Ok(rings.pop().unwrap_or_else(|| Ring { vertices: Vec::new(), points: Vec::new() }))
    }

    /// The rings of a face between its ends.
    fn between(&self, piece: &Piece) -> Vec<Vec<DVec3>> {
        match &piece.form {
            Form::Ruled { .. } => Vec::new(),
            Form::Bead(_) => {
                let widest = self
                    .curve(piece, 0.0)
                    .iter()
                    .zip(self.curve(piece, 1.0))
                    .fold(0.0f64, |w, (p, q)| w.max(p.distance(q)));
                let share = (self.grid.tolerance / widest.max(f64::MIN_POSITIVE)).min(0.25);
                // The sagitta of a chord of a circle of radius r over an angle: r (1 - cos(angle / 2)).
                let n = libm::ceil(PI / (2.0 * libm::acos(1.0 - 2.0 * share))).clamp(4.0, 64.0) as usize;
                (1..n).map(|i| self.curve(piece, i as f64 / n as f64)).collect()
            }
            Form::Heel { sheet } => {
                let [radius, turn] = sheet.greatest_heel();
                let n = self.chords(radius, turn);
                (1..n).map(|i| self.curve(piece, i as f64 / n as f64)).collect()
            }
            Form::Shoulder { crease, .. } => {
                let n = self.chords(crease.radius(), crease.greatest_turn());
                (1..n).map(|i| self.curve(piece, i as f64 / n as f64)).collect()
            }
            Form::Sheet { sheet, is_back } => {
                let mut rings = self.sheet(sheet);
                if *is_back {
                    rings.reverse();
                }
                rings
            }
        }
    }

    /// How many chords of an arc keep the tolerance.
    fn chords(&self, radius: f64, angle: f64) -> usize {
        let share = (self.grid.tolerance / radius.max(f64::MIN_POSITIVE)).min(0.5);
        let n = libm::ceil(angle / (2.0 * libm::acos(1.0 - share)));
        if n.is_finite() { n.clamp(2.0, 64.0) as usize } else { 2 }
    }

    /// The rings of a sheet between its ends: rows of constant `s`, and before and behind them what leads over from its edges.
    fn sheet(&self, sheet: &Sheet) -> Vec<Vec<DVec3>> {
        let starts: Vec<f64> = (0..self.grid.columns).map(|j| sheet.start(self.v(j)).s).collect();
        let ends: Vec<f64> = (0..self.grid.columns).map(|j| sheet.end(self.v(j)).s).collect();
        let own = sheet.is_lining().then(|| sheet.skin().columns(self.grid.columns));
        let columns = own.as_ref().unwrap_or(&self.columns);
        let mut walk = sheet.walk();
        let range = |all: &[f64]| {
            all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), s| (least.min(*s), most.max(*s)))
        };
        let ((least, most), (low, high)) = (range(&starts), range(&ends));
        let rows = &self.grid.rows;
        let is_inside = |i: usize| {
            rows[i] > most
                && rows[i] - most >= CLEARANCE * (rows[i] - rows[i - 1])
                && rows[i] < low
                && (high == 1.0 || low - rows[i] >= CLEARANCE * (rows[i + 1] - rows[i]))
        };
        let inside: Vec<usize> = (1..rows.len() - 1).filter(|i| is_inside(*i)).collect();
        let mut rings = Vec::new();
        // Of two curves across the columns as many in between as there would be rows.
        let lead = |walk: &mut SheetWalk, from: &dyn Fn(usize) -> f64, to: &dyn Fn(usize) -> f64, range: (f64, f64)| {
            let skipped = rows.iter().filter(|row| **row > range.0 && **row < range.1).count();
            let n = (skipped + 1).min(MOST_BETWEEN);
            let between = |share: f64, j: usize| from(j) + share * (to(j) - from(j));
            let mut ring = |i: usize| -> Vec<DVec3> {
                let share = i as f64 / n as f64;
                (0..self.grid.columns).map(|j| walk.position_at(between(share, j), columns, j)).collect()
            };
            (1..n).map(&mut ring).collect::<Vec<_>>()
        };
        let (start, end) = (|j: usize| starts[j], |j: usize| ends[j]);
        let (Some(&first), Some(&last)) = (inside.first(), inside.last()) else {
            if most > least || high > low {
                rings = lead(&mut walk, &start, &end, (least, high));
            }
            return rings;
        };
        if most > least {
            rings = lead(&mut walk, &start, &|_| rows[first], (least, rows[first]));
        }
        for s in rows[first..=last].iter().take_while(|_| !watch::is_stopped()) {
            rings.push((0..self.grid.columns).map(|j| walk.position_at(*s, columns, j)).collect());
        }
        if high > low {
            rings.extend(lead(&mut walk, &|_| rows[last], &end, (rows[last], high)));
        }
        rings
    }

    /// The blocks of the cells between rings, numbered from those of the faces before.
    fn blocks(&self, rings: &[Ring]) -> Vec<u32> {
        let known = self.woven.blocks.iter().filter(|block| **block != NONE).max();
        let at = |ring: usize, column: usize| self.at(rings[ring].vertex(column));
        let rings = Rings { at, n_rings: rings.len(), n_columns: self.grid.columns };
        rings.blocks(known.map_or(0, |block| block + 1))
    }

    /// Triangles between two rings, cut along the shorter diagonals; of each cell the block is given.
    fn strip(&mut self, [from, to]: [&Ring; 2], is_forwards: bool, blocks: &[u32]) {
        for (j, block) in blocks.iter().enumerate() {
            let (a, d, b, c) = (from.vertex(j), from.vertex(j + 1), to.vertex(j), to.vertex(j + 1));
            let halves = if self.distance(a, c) <= self.distance(b, d) {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            };
            for [a, b, c] in halves {
                if a != b && b != c && c != a {
                    self.woven.triangles.push(if is_forwards { [a, b, c] } else { [a, c, b] });
                    self.woven.blocks.push(*block);
                }
            }
        }
    }

    fn at(&self, vertex: u32) -> DVec3 {
        DVec3::from_array(self.woven.positions[vertex as usize].map(f64::from))
    }

    fn distance(&self, a: u32, b: u32) -> f64 {
        (self.at(a) - self.at(b)).length_squared()
    }

    fn plan(&self, vertex: u32) -> DVec2 {
        self.skin.frame().plan(self.at(vertex) / self.scale)
    }

    /// Whether the triangles of a level face, from a number on, all lie the same way up.
    fn is_unfolded(&self, first: usize, rings: &[Ring]) -> bool {
        let area = |[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| self.plan(*vertex));
            robust::orient2d(coord(a), coord(b), coord(c))
        };
        let triangles = &self.woven.triangles[first..];
        let Some(sign) = triangles.first().map(|triangle| area(triangle).signum()) else { return true };
        triangles.iter().all(|triangle| area(triangle) * sign > 0.0) && rings.len() == 2
    }

    /// Other triangles for a level face that folds.
    fn level_face(&mut self, first: usize, rings: &[Ring], piece: &Piece) -> Result<()> {
        let outline =
            |ring: &Ring| ring.vertices.iter().map(|vertex| (self.plan(*vertex), *vertex)).collect::<Vec<_>>();
        let outlines: Vec<_> = rings.iter().filter(|ring| !ring.is_point()).map(outline).collect();
        let mut triangles = disc::triangles(&outlines).map_err(|vertex| {
            let at = self.at(vertex) / self.scale;
            let message = format!("the outline of the {} crosses itself near {}", name(piece.kind()), place(at));
            let error = Error::new(Code::CrossesItself, self.skin.placed().path(field(piece.kind())), message);
            error.near(at.to_array()).with("what", "outline").with("face", piece.kind().name())
        })?;
        // Anti-clockwise seen from along the axis is right for what faces that way.
        let area = |ring: &Ring| {
            (0..ring.vertices.len())
                .map(|j| self.plan(ring.vertex(j)).perp_dot(self.plan(ring.vertex(j + 1))))
                .sum::<f64>()
        };
        let (from, to) = (&rings[0], &rings[rings.len() - 1]);
        // A face that widens along a, from a turn that is anti-clockwise, has F_a x F_v along the axis.
        let widening = if from.is_point() {
            1.0
        } else if to.is_point() {
            -1.0
        } else {
            (area(to).abs() - area(from).abs()).signum()
        };
        let turn = area(if to.is_point() { from } else { to }).signum();
        if widening * turn * piece.outward() < 0.0 {
            for triangle in &mut triangles {
                triangle.swap(1, 2);
            }
        }
        self.woven.triangles.truncate(first);
        self.woven.triangles.extend(triangles);
        self.woven.blocks.truncate(first);
        self.woven.blocks.resize(self.woven.triangles.len(), NONE);
        Ok(())
    }

    /// How far the face is from the triangles, from second differences of the points: eight times it is the sum of those along and across and of twice the twist, as for a quadratic
    /// face, each along the normal.
    fn deviation(&self, rings: &[Ring]) -> f64 {
        let mut most = 0.0f64;
        for i in 0..rings.len() - 1 {
            let (ring, next) = (&rings[i], &rings[i + 1]);
            watch::work(10 * self.grid.columns as u64);
            for j in 0..self.grid.columns {
                let left = (j + self.grid.columns - 1) % self.grid.columns;
                let [a, b, c, d] = [ring.point(j), ring.point(j + 1), next.point(j), next.point(j + 1)];
                let normal = (d - a).cross(c - b).normalize_or_zero();
                let across = [ring, next]
                    .map(|ring| (ring.point(left) - ring.point(j) * 2.0 + ring.point(j + 1)).dot(normal).abs());
                let twist = (d - c - b + a).dot(normal).abs();
                let mut along = 0.0f64;
                for (before, here, after) in [(i.wrapping_sub(1), i, i + 1), (i, i + 1, i + 2)] {
                    if let (Some(before), Some(after)) = (rings.get(before), rings.get(after)) {
                        let here = &rings[here];
                        let [back, on] = [here.point(j) - before.point(j), after.point(j) - here.point(j)];
                        let (h, k) = (back.length(), on.length());
                        if h > 0.0 && k > 0.0 {
                            let length = (c - a).length();
                            along =
                                along.max(((on / k - back / h) * 2.0 / (h + k)).dot(normal).abs() * length * length);
                        }
                    }
                }
                most = most.max((across[0].max(across[1]) + along + 2.0 * twist) / 8.0);
            }
        }
        most
    }
}

fn coord(p: DVec2) -> robust::Coord<f64> {
    robust::Coord { x: p.x, y: p.y }
}

/// What decides about a face in the document.
pub(crate) fn field(kind: FaceKind) -> &'static str {
    match kind {
        FaceKind::Outer | FaceKind::Lid => "shape",
        FaceKind::Lining => "wall.thickness",
        FaceKind::Rim => "wall.rim",
        FaceKind::FootRing | FaceKind::Recess => "wall.foot",
        FaceKind::Drain => "wall.drain",
        FaceKind::Underside | FaceKind::Floor => "wall.base",
    }
}

/// What a potter calls a face.
pub(crate) fn name(kind: FaceKind) -> &'static str {
    match kind {
        FaceKind::Outer => "outside",
        FaceKind::Lining => "lining",
        FaceKind::Rim => "rim",
        FaceKind::Underside => "underside",
        FaceKind::FootRing => "foot ring",
        FaceKind::Recess => "recess under the base",
        FaceKind::Floor => "floor",
        FaceKind::Drain => "drain hole",
        FaceKind::Lid => "lid",
    }
}
