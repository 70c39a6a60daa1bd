//! How far two surfaces are apart at least, proven.
//!
//! Both are cut into cells. In one direction `n` a cell lies, by the error of interpolation between its corners `c` (C. de Boor, *A practical guide to splines*, 1978, chapter II), applied along one parameter and then the other,
//!
//! ```text
//! n . X >= min n . c - p^2 / 8 max(0, sup n . X_ss) - q^2 / 8 max(0, sup n . X_vv)
//! ```
//!
//! with `p` and `q` its lengths, and the suprema are known from the derivatives at its middle and from bounds of the next ones. So two cells are apart by at least the gap between them in any direction. Cells that might be nearer than what is to be proven are cut in four until they are not, or until it is plain that they are.

use core::f64::consts::TAU;
use std::collections::HashMap;

use glam::DVec3;

use super::boxes::{Bounded, Boxes, Inside};
use super::skin::{Skin, SkinWalk};
use crate::numeric::scattered::Scatter;
use crate::patch::SurfaceJet;
use crate::surface::{Surface, ThirdSuprema};
use crate::watch;

/// At first cells are no longer than so many times what is to be proven,
const LONGEST: f64 = 1.0;

/// and bend away from a plane by no more than this part of it,
const BENT: f64 = 0.02;

/// unless there were more cells than this of one surface.
const MOST: usize = 30_000;

/// The fewest rows and columns.
const FEWEST: [usize; 2] = [16, 24];

/// How closely the distance of two cells is known where it turns out to be less than what was to be proven, as a part of that.
const CLOSE: f64 = 2e-3;

/// How often a cell is cut in four.
const DEEPEST: u32 = 7;

/// Once so many pairs of cells were looked at, none is cut any more.
const MOST_PAIRS: usize = 4_000_000;

/// Surfaces of which so many pairs are near are so finely folded that nothing will be proven of them: nobody waits for the rest.
const HOPELESS: usize = 16_000_000;

/// The most pairs that are looked at in all proofs of one lining, each of which draws it in further.
const MOST_WORK: usize = 64_000_000;

/// What rounding may take, as a part of the size.
const ROUNDING: f64 = 1e-12;

/// Along a surface it is known of so many stretches what is missing.
const STRETCHES: usize = 64;

/// What is known of the distance of two surfaces.
#[derive(Debug, Clone)]
pub(super) struct Proof {
    /// They are nowhere nearer than this, which is no more than was to be proven.
    pub(super) bound: f64,
    /// Where on the first surface, if that is less than what was to be proven.
    pub(super) at: Option<DVec3>,
    /// By how much they may be nearer than that, stretch by stretch of the first.
    lacks: Vec<f64>,
}

impl Proof {
    /// Nothing.
    pub(super) fn none(least: f64) -> Proof {
        Proof { bound: 0.0, at: None, lacks: vec![least; STRETCHES] }
    }

    /// Places `s` of the first where they may be nearer than was to be proven, and by how much.
    pub(super) fn lacks(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let all = self.lacks.iter().enumerate().filter(|(_, lack)| **lack > 0.0);
        all.map(|(k, lack)| ((k as f64 + 0.5) / STRETCHES as f64, *lack))
    }
}

/// A rectangle of a surface.
#[derive(Debug)]
struct Cell {
    s: [f64; 2],
    v: [f64; 2],
    corners: [DVec3; 4],
    middle: DVec3,
    /// A unit normal at the middle, or none.
    normal: DVec3,
    /// `p^2 / 8 X_ss` and `q^2 / 8 X_vv` at the middle.
    bend: [DVec3; 2],
    /// As much of it as they may change by on the cell.
    change: [f64; 2],
    /// And suprema of it.
    most: [f64; 2],
    depth: u32,
    /// The number of the first of its quarters; 0 where it is not cut.
    quarters: usize,
}

impl Cell {
    /// How far it bends towards `n` beyond the hull of its corners at most.
    fn bulge(&self, n: DVec3) -> f64 {
        let along = |k: usize| (n.dot(self.bend[k]) + self.change[k]).min(self.most[k]).max(0.0);
        along(0) + along(1)
    }

    /// The largest `n . X`, or more.
    fn highest(&self, n: DVec3) -> f64 {
        self.corners.iter().fold(f64::NEG_INFINITY, |most, c| most.max(n.dot(*c))) + self.bulge(-n)
    }

    /// The least `n . X`, or less.
    fn lowest(&self, n: DVec3) -> f64 {
        self.corners.iter().fold(f64::INFINITY, |least, c| least.min(n.dot(*c))) - self.bulge(n)
    }

    /// How far it bends at most.
    fn bulk(&self) -> f64 {
        let along = |k: usize| (self.bend[k].length() + self.change[k]).min(self.most[k]);
        along(0) + along(1)
    }

    fn width(&self) -> f64 {
        let [a, b, c, d] = self.corners;
        a.distance_squared(d).max(b.distance_squared(c))
    }
}

/// A surface in cells.
pub(super) struct Cells<'a> {
    skin: &'a Skin,
    surface: &'a Surface,
    stretch: [f64; 3],
    /// The level to which it goes straight from where the surface begins; none for the surface itself.
    led: Option<f64>,
    walk: SkinWalk<'a>,
    cells: Vec<Cell>,
    strips: HashMap<[u64; 2], ThirdSuprema, Scatter>,
}

impl<'a> Cells<'a> {
    /// The surface, for distances of about this; `None` where it is no sum of products.
    pub(super) fn of(skin: &'a Skin, distance: f64) -> Option<Cells<'a>> {
        let mut cells = Cells::none(skin, None)?;
        let mut scale = 1.0;
        let (rows, columns) = loop {
            let (rows, columns) = division(skin, scale * LONGEST * distance, scale * BENT * distance);
            let n = (rows.len() - 1) * columns;
            if n <= MOST {
                break (rows, columns);
            }
            scale *= (n as f64 / MOST as f64).max(1.1);
        };
        cells.cut(&rows, columns);
        Some(cells)
    }

    /// What leads straight from where the surface begins to a level.
    pub(super) fn led(skin: &'a Skin, level: f64, distance: f64) -> Option<Cells<'a>> {
        let mut cells = Cells::none(skin, Some(level))?;
        let longest = (0..FEWEST[1])
            .map(|j| TAU * j as f64 / FEWEST[1] as f64)
            .fold(0.0f64, |most, v| most.max((skin.frame().level(skin.second(0.0, v).position) - level).abs()));
        let n = libm::ceil(longest / distance).clamp(1.0, 64.0) as usize;
        let (_, columns) = division(skin, LONGEST * distance, BENT * distance);
        let rows: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
        cells.cut(&rows, columns.min(MOST / n));
        Some(cells)
    }

    fn none(skin: &'a Skin, led: Option<f64>) -> Option<Cells<'a>> {
        let placed = skin.placed();
        let matrix = placed.matrix();
        let stretch = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(DVec3::length);
        let surface = placed.solved().fourier()?;
        Some(Cells { skin, surface, stretch, led, walk: skin.walk(), cells: Vec::new(), strips: HashMap::default() })
    }

    fn cut(&mut self, rows: &[f64], columns: usize) {
        let step = TAU / columns as f64;
        let row = |cells: &mut Self, s: f64, shift: f64| -> Vec<SurfaceJet> {
            (0..columns).map(|j| cells.jet(s, (j as f64 + shift) * step)).collect()
        };
        let mut below = row(self, rows[0], 0.0);
        for pair in rows.array_windows::<2>().take_while(|_| !watch::is_stopped()) {
            let middles = row(self, 0.5 * (pair[0] + pair[1]), 0.5);
            let above = row(self, pair[1], 0.0);
            for (j, middle) in middles.iter().enumerate() {
                let next = (j + 1) % columns;
                let corners = [&below[j], &below[next], &above[j], &above[next]].map(|jet| jet.position);
                let v = [j as f64 * step, (j + 1) as f64 * step];
                let cell = self.cell(*pair, v, corners, middle, 0);
                self.cells.push(cell);
            }
            below = above;
        }
    }

    fn jet(&mut self, s: f64, v: f64) -> SurfaceJet {
        let Some(level) = self.led else { return self.walk.second(s, v) };
        let start = self.walk.second(0.0, v);
        let frame = self.skin.frame();
        let axis = frame.axis();
        let way = axis * (level - frame.level(start.position));
        let round = |d: DVec3| d - axis * (s * axis.dot(d));
        SurfaceJet {
            position: start.position + way * s,
            du: way,
            dv: round(start.dv),
            duu: DVec3::ZERO,
            duv: -axis * axis.dot(start.dv),
            dvv: round(start.dvv),
        }
    }

    fn strip(&mut self, s: [f64; 2]) -> ThirdSuprema {
        let key = s.map(f64::to_bits);
        if let Some(known) = self.strips.get(&key) {
            return *known;
        }
        let along = |s: f64| if self.skin.is_upward() { s } else { 1.0 - s };
        let found = match self.led {
            None => {
                let [a, b] = s.map(along);
                self.surface.third_suprema([a.min(b), a.max(b)], self.stretch)
            }
            Some(_) => {
                let ThirdSuprema { second, third } = self.surface.third_suprema([along(0.0); 2], self.stretch);
                ThirdSuprema { second: [0.0, second[1]], third: [0.0, 0.0, second[1], third[3]] }
            }
        };
        self.strips.insert(key, found);
        found
    }

    fn cell(&mut self, s: [f64; 2], v: [f64; 2], corners: [DVec3; 4], middle: &SurfaceJet, depth: u32) -> Cell {
        let ThirdSuprema { second: [ss, vv], third: [sss, ssv, svv, vvv] } = self.strip(s);
        let (p, q) = (s[1] - s[0], v[1] - v[0]);
        let [by_p, by_q] = [p, q].map(|length| length * length / 8.0);
        let change = [0.5 * (p * sss + q * ssv), 0.5 * (p * svv + q * vvv)];
        Cell {
            s,
            v,
            corners,
            middle: middle.position,
            normal: middle.du.cross(middle.dv).normalize_or_zero(),
            bend: [middle.duu * by_p, middle.dvv * by_q],
            change: [change[0] * by_p, change[1] * by_q],
            most: [ss * by_p, vv * by_q],
            depth,
            quarters: 0,
        }
    }

    /// The number of the first of four quarters of a cell.
    fn quarters(&mut self, number: usize) -> usize {
        let cell = &self.cells[number];
        if cell.quarters > 0 {
            return cell.quarters;
        }
        let (s, v, [a, b, c, d], depth) = (cell.s, cell.v, cell.corners, cell.depth + 1);
        let middle = cell.middle;
        let half = |[from, to]: [f64; 2]| [[from, 0.5 * (from + to)], [0.5 * (from + to), to]];
        let ([s0, s1], [v0, v1]) = (half(s), half(v));
        let (left, right) = (self.jet(s0[1], v[0]).position, self.jet(s0[1], v[1]).position);
        let (bottom, top) = (self.jet(s[0], v0[1]).position, self.jet(s[1], v0[1]).position);
        let first = self.cells.len();
        for (s, v, corners) in [
            (s0, v0, [a, bottom, left, middle]),
            (s0, v1, [bottom, b, middle, right]),
            (s1, v0, [left, middle, c, top]),
            (s1, v1, [middle, right, top, d]),
        ] {
            let jet = self.jet(0.5 * (s[0] + s[1]), 0.5 * (v[0] + v[1]));
            let cell = self.cell(s, v, corners, &jet, depth);
            self.cells.push(cell);
        }
        self.cells[number].quarters = first;
        first
    }
}

/// Rows, the rings among them, and the number of columns of cells no longer than `longest` that bend away from a plane by about `bent`.
fn division(skin: &Skin, longest: f64, bent: f64) -> (Vec<f64>, usize) {
    let places: Vec<f64> = [0.0].into_iter().chain(skin.knots()).chain([1.0]).collect();
    let mut coarse = vec![0.0];
    for pair in places.array_windows::<2>() {
        let width = pair[1] - pair[0];
        let n = libm::ceil(width * FEWEST[0] as f64).max(1.0) as usize;
        coarse.extend((1..n).map(|i| pair[0] + width * i as f64 / n as f64));
        coarse.push(pair[1]);
    }
    let n_columns = skin.round().count().max(FEWEST[1]);
    let columns = skin.columns(n_columns);
    let mut walk = skin.walk();
    let (mut rows, mut round) = (vec![0.0], n_columns as f64);
    for pair in coarse.array_windows::<2>() {
        let width = pair[1] - pair[0];
        let mut n = 1.0f64;
        for s in [0.125, 0.5, 0.875].map(|share| pair[0] + share * width) {
            for j in 0..n_columns {
                let jet = walk.second_at(s, &columns, j);
                let normal = jet.du.cross(jet.dv).normalize_or_zero();
                let parts =
                    |d: DVec3, dd: DVec3| (d.length() / longest).max(libm::sqrt(normal.dot(dd).abs() / (8.0 * bent)));
                n = n.max(width * parts(jet.du, jet.duu));
                round = round.max(TAU * parts(jet.dv, jet.dvv));
            }
        }
        let n = libm::ceil(n).clamp(1.0, MOST as f64) as usize;
        rows.extend((1..n).map(|i| pair[0] + width * i as f64 / n as f64));
        rows.push(pair[1]);
    }
    (rows, libm::ceil(round).clamp(1.0, MOST as f64) as usize)
}

/// The box round a cell, with the number of that.
#[derive(Debug)]
struct Round {
    bounds: [DVec3; 2],
    number: usize,
}

impl Bounded for Round {
    fn bounds(&self) -> [DVec3; 2] {
        self.bounds
    }
}

/// The cells of a surface, among which those that are near are found.
pub(super) struct Nearby(Boxes<Round>);

impl Nearby {
    pub(super) fn of(cells: &Cells) -> Nearby {
        let all = cells.cells.iter().enumerate().map(|(number, cell)| Round { bounds: around(cell), number });
        Nearby(Boxes::new(all.collect()))
    }

    /// The numbers of the cells in boxes that are nearer to a box than `distance`.
    fn near(&self, [low, high]: [DVec3; 2], distance: f64, found: &mut Vec<usize>) {
        let mut left = vec![0];
        let mut n_seen = 0;
        while let Some(index) = left.pop() {
            let node = self.0.node(index);
            n_seen += 1;
            let gap = (node.low - high).max(low - node.high).max(DVec3::ZERO);
            if !(gap.length_squared() < distance * distance) {
                continue;
            }
            match self.0.inside(index) {
                Inside::Things(cells) => found.extend(cells.iter().map(|cell| cell.number)),
                Inside::Halves(halves) => left.extend(halves),
            }
        }
        watch::work(n_seen);
    }
}

/// The box round a cell.
fn around(cell: &Cell) -> [DVec3; 2] {
    let bulk = DVec3::splat(cell.bulk());
    let [a, b, c, d] = cell.corners;
    [a.min(b).min(c.min(d)) - bulk, a.max(b).max(c.max(d)) + bulk]
}

/// What two cells are apart at least, by the gap in the likeliest directions; less than 0 where none was found.
fn gap(one: &Cell, other: &Cell, enough: f64) -> f64 {
    let way = other.middle - one.middle;
    let turned = |n: DVec3| if n.dot(way) < 0.0 { -n } else { n };
    let mut best = f64::NEG_INFINITY;
    for n in [way.normalize_or_zero(), turned(other.normal), turned(one.normal)] {
        let here = other.lowest(n) - one.highest(n);
        // What is no number proves nothing.
        if here > best && n != DVec3::ZERO {
            best = here;
        }
        if best >= enough {
            break;
        }
    }
    best
}

/// Work that may still be done.
pub(super) struct Budget(usize);

impl Budget {
    /// For the proofs of one lining.
    pub(super) fn new() -> Budget {
        Budget(MOST_WORK)
    }
}

/// Whether two surfaces are apart by `least` wherever the first is above a level, as far as that can be proven.
///
/// # Errors
/// A place on the first up to which so many pairs were looked at that it was given up.
pub(super) fn proven(
    of: &mut Cells,
    from: &mut Cells,
    boxes: &Nearby,
    (least, level): (f64, f64),
    budget: &mut Budget,
) -> Result<Proof, DVec3> {
    let most = HOPELESS.min(budget.0);
    let mut proof = Proof { bound: least, at: None, lacks: vec![0.0; STRETCHES] };
    let least = least + ROUNDING * from.skin.size();
    let axis = of.skin.frame().axis();
    let floor = level + axis.dot(of.skin.frame().point(glam::DVec2::ZERO, 0.0));
    let (mut near, mut pairs, mut n_pairs) = (Vec::new(), Vec::new(), 0);
    for number in 0..of.cells.len() {
        if watch::is_stopped() {
            break;
        }
        let cell = &of.cells[number];
        if cell.highest(axis) < floor {
            continue;
        }
        near.clear();
        boxes.near(around(cell), least, &mut near);
        pairs.extend(near.iter().map(|other| (number, *other)));
        while let Some((a, b)) = pairs.pop() {
            let (one, other) = (&of.cells[a], &from.cells[b]);
            n_pairs += 1;
            if n_pairs > most {
                return Err(one.middle);
            }
            watch::work(1);
            let stretch = (0.5 * (one.s[0] + one.s[1]) * STRETCHES as f64) as usize;
            // What is missing by no more than is known to be missing there tells nothing.
            let enough = least - proof.lacks[stretch];
            let apart = gap(one, other, enough);
            if apart >= enough || one.highest(axis) < floor {
                continue;
            }
            let sampled = one.middle.distance(other.middle);
            let is_known = sampled - apart <= CLOSE * least && sampled <= least;
            let can_cut = [one, other].map(|cell| cell.depth < DEEPEST);
            if is_known || can_cut == [false; 2] || n_pairs > MOST_PAIRS {
                let lack = least - apart.max(0.0);
                proof.lacks[stretch] = lack;
                if least - lack < proof.bound {
                    proof.bound = (least - lack).max(0.0);
                    proof.at = Some(one.middle);
                }
                continue;
            }
            if can_cut[0] && (one.width() >= other.width() || !can_cut[1]) {
                let first = of.quarters(a);
                pairs.extend((first..first + 4).map(|a| (a, b)));
            } else {
                let first = from.quarters(b);
                pairs.extend((first..first + 4).map(|b| (a, b)));
            }
        }
    }
    budget.0 -= n_pairs;
    Ok(proof)
}
