//! The placed surface of one part, from foot to rim, with the derivatives that a wall needs.

use core::cell::RefCell;
use core::f64::consts::TAU;

use glam::{DMat3, DVec3};

use super::frame::Frame;
use crate::design::{Part, plain};
use crate::error::{Code, Error, Result};
use crate::numeric::golden_section;
use crate::surface::{RowTable, Surface, SurfaceJet, distinct, of_turns, points_outward};

/// An end no wider than this part of the size is a point.
const POLE: f64 = 1e-6;

/// A row between the ends no wider than this part of the size is a pinch.
const PINCH: f64 = 1e-4;

/// Golden sections by which the narrowest row between two is found: they leave 1e-10 of the gap.
const SECTIONS: usize = 48;

/// Rows that are looked at to find size, poles and pinches.
const ROWS: usize = 96;

/// The fewest and the most columns that are looked at.
const COLUMNS: (usize, usize) = (48, 512);

/// `|X_s x X_v|` counts as vanished when it is this small against the lengths of both.
const VANISHED: f64 = 1e-9;

/// How far from a pole the normal is taken where it has no limit of first order.
const BESIDE_POLE: f64 = 1e-5;

/// `X(s, v)` after placement: `s = 0` is the foot, the end whose mean height along the axis is lower, and `v` in [0, 2 pi].
#[derive(Debug)]
pub(crate) struct Skin {
    surface: Surface,
    matrix: DMat3,
    shift: DVec3,
    is_upward: bool,
    /// 1 where `X_s x X_v` points out of the pot, otherwise -1.
    outward: f64,
    distinct: Vec<f64>,
    /// The row that was asked for last.
    row: RefCell<(f64, RowTable<3>)>,
    /// The largest distance of two points of the surface, roughly.
    size: f64,
    /// Whether foot and rim are points.
    poles: [bool; 2],
    frame: Frame,
    /// 1 where the foot goes round anti-clockwise seen from the rim, otherwise -1.
    turn: f64,
    n_columns: usize,
    /// The number of the part.
    index: usize,
}

/// Cosines and sines of every harmonic of a surface at several columns.
#[derive(Debug, Clone)]
pub(crate) struct Columns {
    places: Vec<f64>,
    /// Column by column.
    circles: Vec<(f64, f64)>,
}

impl Columns {
    /// The number of columns.
    pub(crate) fn len(&self) -> usize {
        self.places.len()
    }

    /// `v` of a column.
    pub(crate) fn v(&self, column: usize) -> f64 {
        self.places.get(column).copied().unwrap_or(0.0)
    }
}

/// Position, first derivatives and unit normal with its derivatives. The normal points out of the pot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SkinJet {
    pub(crate) position: DVec3,
    pub(crate) ds: DVec3,
    pub(crate) dv: DVec3,
    pub(crate) normal: DVec3,
    pub(crate) normal_s: DVec3,
    pub(crate) normal_v: DVec3,
}

impl Skin {
    /// The surface of part number `index`.
    ///
    /// # Errors
    /// What [`Surface::solve`] refuses; `open-surface`, `pinched-surface`, `overflow`.
    pub(crate) fn new(part: &Part, index: usize) -> Result<Skin> {
        let surface = Surface::of_part(part, index)?;
        if !surface.is_closed() {
            let message = "the surface does not meet itself after one turn, so it encloses nothing: expected whole numbers of waves n";
            return Err(Error::new(Code::OpenSurface, format!("parts[{index}].shape"), message));
        }
        let matrix = DMat3::from_cols_array_2d(&part.place.matrix()).transpose();
        let shift = DVec3::from_array(part.place.shift);
        let is_forwards = points_outward(&surface) != (matrix.determinant() < 0.0);
        let distinct = distinct(&surface);
        let highest = distinct.iter().fold(0.0f64, |highest, n| highest.max(n.abs()));
        let n_columns = (4.0 * highest).clamp(COLUMNS.0 as f64, COLUMNS.1 as f64) as usize | 1;
        let row = RefCell::new((f64::NAN, RowTable::at(&surface, &distinct, 0.0)));
        let axis = matrix.z_axis.normalize_or(DVec3::Z);
        let mut skin = Skin {
            surface,
            matrix,
            shift,
            is_upward: true,
            outward: if is_forwards { 1.0 } else { -1.0 },
            distinct,
            row,
            size: 0.0,
            poles: [false; 2],
            frame: Frame::new(DVec3::ZERO, axis),
            turn: 1.0,
            n_columns,
            index,
        };
        let [start, end] = [0.0, 1.0].map(|s| axis.dot(skin.mean(s)));
        if end < start {
            skin.is_upward = false;
            skin.outward = -skin.outward;
        }
        skin.measure()?;
        skin.frame = Frame::new(skin.middle(0.0), axis);
        let area: f64 = skin
            .round()
            .map(|v| skin.second(0.0, v))
            .map(|jet| skin.frame.plan(jet.position).perp_dot(skin.frame.turned(jet.dv)))
            .sum();
        skin.turn = if area < 0.0 { -1.0 } else { 1.0 };
        Ok(skin)
    }

    /// Finds the size, the poles and a pinch.
    fn measure(&mut self) -> Result<()> {
        let columns = self.columns(self.n_columns);
        let widths: Vec<f64> = (0..=ROWS).map(|i| self.width(i as f64 / ROWS as f64, &columns)).collect();
        let rise = (self.mean(1.0) - self.mean(0.0)).length();
        self.size = widths.iter().fold(rise, |size, width| size.max(*width));
        if !(self.size.is_finite() && self.size > f64::MIN_POSITIVE && self.size < f64::MAX.sqrt()) {
            let message = format!("the surface is {} across, which cannot be computed with", plain(self.size));
            return Err(Error::new(Code::Overflow, format!("parts[{}]", self.index), message));
        }
        self.poles = [widths[0], widths[ROWS]].map(|width| width <= POLE * self.size);
        for i in 1..ROWS {
            if widths[i] <= widths[i - 1] && widths[i] <= widths[i + 1] {
                let (before, after) = ((i - 1) as f64 / ROWS as f64, (i + 1) as f64 / ROWS as f64);
                let (s, width) = golden_section::least(before, after, SECTIONS, |s| self.width(s, &columns));
                if width <= PINCH * self.size {
                    let at = self.mean(s);
                    let message = format!(
                        "the surface is pinched to a point at {}: expected it to be wide everywhere between foot and rim",
                        place(at)
                    );
                    return Err(Error::new(Code::PinchedSurface, self.path("shape"), message).near(at.to_array()));
                }
            }
        }
        Ok(())
    }

    /// Twice the largest distance of a row from its mean.
    fn width(&self, s: f64, columns: &Columns) -> f64 {
        let points: Vec<DVec3> = (0..columns.len()).map(|j| self.second_at(s, columns, j).position).collect();
        let mean = points.iter().sum::<DVec3>() / points.len() as f64;
        2.0 * points.iter().fold(0.0f64, |most, p| most.max((*p - mean).length()))
    }

    fn mean(&self, s: f64) -> DVec3 {
        self.round().map(|v| self.second(s, v).position).sum::<DVec3>() / self.n_columns as f64
    }

    /// Even values of `v`, four for each wave of the highest harmonic.
    pub(crate) fn round(&self) -> impl Iterator<Item = f64> + use<> {
        let n = self.n_columns;
        (0..n).map(move |j| TAU * j as f64 / n as f64)
    }

    /// The middle of the area that a row goes round seen along the axis, at its mean height; the mean of its points where it has no area.
    pub(crate) fn middle(&self, s: f64) -> DVec3 {
        let frame = Frame::new(self.mean(s), self.frame.axis());
        let curve = self.round().map(|v| {
            let jet = self.second(s, v);
            (frame.plan(jet.position), frame.turned(jet.dv))
        });
        middle_of(curve).map_or(frame.point(glam::DVec2::ZERO, 0.0), |middle| frame.point(middle, 0.0))
    }

    /// The frame whose origin is the middle of the foot.
    pub(crate) fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The largest distance of two points, roughly.
    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// Whether the foot is a point, and the rim.
    pub(crate) fn poles(&self) -> [bool; 2] {
        self.poles
    }

    /// 1 where `X_s x X_v` points out of the pot, otherwise -1.
    pub(crate) fn outward(&self) -> f64 {
        self.outward
    }

    /// 1 where the foot goes round anti-clockwise seen from the rim, otherwise -1.
    pub(crate) fn turn(&self) -> f64 {
        self.turn
    }

    /// Whether `s` is `u`, not `1 - u`.
    pub(crate) fn is_upward(&self) -> bool {
        self.is_upward
    }

    /// The number of the part.
    pub(crate) fn index(&self) -> usize {
        self.index
    }

    /// Where something of this part is in the design.
    pub(crate) fn path(&self, field: &str) -> String {
        format!("parts[{}].{field}", self.index)
    }

    /// Even columns of this surface.
    pub(crate) fn columns(&self, n: usize) -> Columns {
        let circles = (0..n)
            .flat_map(|j| self.distinct.iter().map(move |k| of_turns(libm::fmod(k * j as f64, n as f64) / n as f64)));
        Columns { places: (0..n).map(|j| TAU * j as f64 / n as f64).collect(), circles: circles.collect() }
    }

    /// Columns at places of their own.
    pub(crate) fn columns_at(&self, places: Vec<f64>) -> Columns {
        let circles = places.iter().flat_map(|v| self.distinct.iter().map(move |k| of_turns(k * (v / TAU)))).collect();
        Columns { places, circles }
    }

    /// Position and derivatives up to the second, placed.
    pub(crate) fn second(&self, s: f64, v: f64) -> SurfaceJet {
        let turns = v / TAU;
        self.placed(s, |n| of_turns(self.distinct.get(n).copied().unwrap_or(0.0) * turns))
    }

    /// As [`Self::second`], at a column.
    pub(crate) fn second_at(&self, s: f64, columns: &Columns, column: usize) -> SurfaceJet {
        let circles = columns.circles.get(column * self.distinct.len()..).unwrap_or_default();
        self.placed(s, |n| circles.get(n).copied().unwrap_or((1.0, 0.0)))
    }

    fn placed(&self, s: f64, circle: impl Fn(usize) -> (f64, f64)) -> SurfaceJet {
        let u = if self.is_upward { s } else { 1.0 - s };
        let mut row = self.row.borrow_mut();
        if row.0 != u {
            *row = (u, RowTable::at(&self.surface, &self.distinct, u));
        }
        let jet = row.1.jet(circle);
        let (m, along, round) = (self.matrix, if self.is_upward { 1.0 } else { -1.0 }, self.surface.span() / TAU);
        SurfaceJet {
            position: m * jet.position + self.shift,
            du: m * jet.du * along,
            dv: m * jet.dv * round,
            duu: m * jet.duu,
            duv: m * jet.duv * (along * round),
            dvv: m * jet.dvv * (round * round),
        }
    }

    /// Position, derivatives and normal. At a pole or where the surface has no normal it is that of the nearest place which has one.
    pub(crate) fn jet(&self, s: f64, v: f64) -> SkinJet {
        self.with_normal(&self.second(s, v), s, v)
    }

    /// As [`Self::jet`], at a column.
    pub(crate) fn jet_at(&self, s: f64, columns: &Columns, column: usize) -> SkinJet {
        self.with_normal(&self.second_at(s, columns, column), s, columns.v(column))
    }

    fn with_normal(&self, jet: &SurfaceJet, s: f64, v: f64) -> SkinJet {
        let is_pole = (s == 0.0 && self.poles[0]) || (s == 1.0 && self.poles[1]);
        let inward = if s < 0.5 { 1.0 } else { -1.0 };
        if !is_pole && let Some([normal, normal_s, normal_v]) = self.normal(jet) {
            return SkinJet { position: jet.position, ds: jet.du, dv: jet.dv, normal, normal_s, normal_v };
        }
        let beside = self.second(s + inward * BESIDE_POLE, v);
        let [mut normal, normal_s, normal_v] = self.normal(&beside).unwrap_or([DVec3::ZERO; 3]);
        if is_pole {
            // By Taylor's formula X_s x X_v = h (X_s x X_sv) at a distance h from a pole.
            let limit = jet.du.cross(jet.duv) * (inward * self.outward);
            if limit.length() > 1e-9 * jet.du.length() * jet.duv.length() {
                normal = limit.normalize_or(normal);
            }
        }
        SkinJet { position: jet.position, ds: jet.du, dv: jet.dv, normal, normal_s, normal_v }
    }

    /// `N`, `N_s`, `N_v`: `N_s = (M_s - N (N . M_s)) / |M|` for `M = X_s x X_v`, which is Weingarten's equation without its fundamental forms.
    fn normal(&self, jet: &SurfaceJet) -> Option<[DVec3; 3]> {
        let m = jet.du.cross(jet.dv);
        let length = m.length();
        if !(length > VANISHED * jet.du.length() * jet.dv.length()) {
            return None;
        }
        let normal = m / length;
        let derivative = |m: DVec3| (m - normal * normal.dot(m)) / length * self.outward;
        let m_s = jet.duu.cross(jet.dv) + jet.du.cross(jet.duv);
        let m_v = jet.duv.cross(jet.dv) + jet.du.cross(jet.dvv);
        Some([normal * self.outward, derivative(m_s), derivative(m_v)])
    }
}

/// The middle of the area that a closed plane curve goes round, from even samples of position and derivative.
pub(crate) fn middle_of(curve: impl Iterator<Item = (glam::DVec2, glam::DVec2)>) -> Option<glam::DVec2> {
    let (mut area, mut moment, mut size) = (0.0, glam::DVec2::ZERO, 0.0);
    for (p, dp) in curve {
        let turn = p.perp_dot(dp);
        area += turn / 2.0;
        moment += p * (turn / 3.0);
        size += p.length() * dp.length();
    }
    (area.abs() > 1e-6 * size).then(|| moment / area)
}

/// A point as people read it, to four digits of its largest coordinate.
pub(crate) fn place(at: DVec3) -> String {
    let largest = at.abs().max_element();
    let [x, y, z] = at.to_array().map(|x| rounded(x, largest));
    format!("({x}, {y}, {z})")
}

/// A length as people read it, to four digits.
pub(crate) fn short(x: f64) -> String {
    rounded(x, x.abs())
}

/// A number to the fourth digit of another.
fn rounded(x: f64, size: f64) -> String {
    if !(size > 0.0 && size.is_finite()) {
        return plain(x);
    }
    let digits = 3.0 - libm::floor(libm::log10(size));
    let power = libm::pow(10.0, digits.clamp(-300.0, 300.0));
    // Dividing by a power of ten, and not multiplying by a tenth of one, gives the nearest double; adding 0 takes the sign of -0.
    plain(libm::round(x * power) / power + 0.0)
}
