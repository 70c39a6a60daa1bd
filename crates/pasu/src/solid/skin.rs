//! The placed surface of one part, from foot to rim, with the derivatives that a wall needs.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::DVec3;

use super::frame::Frame;
use super::told::place;
use crate::design::{BoundaryValue, plain};
use crate::error::{Code, Error, Result};
use crate::numeric::golden_section;
use crate::numeric::limit::limit;
use crate::patch::SurfaceJet;
use crate::solution::{Columns, Placed, Stretch, Upright, Walk};

/// An end no wider than this part of the size is a point.
const POLE: f64 = 1e-6;

/// A row between the ends no wider than this part of the size is a pinch.
const PINCH: f64 = 1e-4;

/// What is off a surface of revolution by no more than this part of the size is one.
const ROUND: f64 = 1e-13;

/// Golden sections by which the narrowest row between two is found: they leave 1e-10 of the gap.
const SECTIONS: usize = 48;

/// Rows that are looked at to find size, poles and pinches.
const ROWS: usize = 96;

/// The fewest and the most columns that are looked at.
const COLUMNS: (usize, usize) = (48, 512);

/// `|X_s x X_v|` counts as vanished when it is this small against the lengths of both.
const VANISHED: f64 = 1e-9;

/// How far from a pole the normal is taken where it has no limit of first order. Its derivatives there are limits from 1, 2, 3 and 4 times as far.
const BESIDE_POLE: f64 = 1e-5;

/// An [`Upright`] surface that closes round and is wide everywhere between its ends: what can carry a wall.
#[derive(Debug)]
pub(crate) struct Skin {
    upright: Upright,
    /// The largest distance of two points of the surface, roughly.
    size: f64,
    /// Whether foot and rim are points.
    poles: [bool; 2],
    frame: Frame,
    /// 1 where the foot goes round anti-clockwise seen from the rim, otherwise -1.
    turn: f64,
    n_columns: usize,
    /// What the surface solves, for a lining that is to solve the same.
    problem: Option<Box<BoundaryValue>>,
    /// What lies between the corners of the profile, from foot to rim.
    stretches: Vec<Stretch>,
}

/// Jets of one place of a skin after the other, which share what depends on `s` alone.
pub(crate) struct SkinWalk<'a> {
    skin: &'a Skin,
    walk: Walk<'a>,
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
    /// The skin of a part.
    ///
    /// # Errors
    /// `open-surface`, `pinched-surface`, `overflow`.
    pub(crate) fn new(placed: &Arc<Placed>) -> Result<Skin> {
        let open = |what: &str, message: &str| {
            Err(Error::new(Code::OpenSurface, placed.path("shape"), message).with("what", what))
        };
        let Some(upright) = Upright::new(placed) else {
            return open(
                "no-foot",
                "the shape has no foot and no rim, so there is no wall to stand on one: expected a surface between two curves",
            );
        };
        if !upright.is_closed() {
            return open(
                "not-closed",
                "the surface does not meet itself after one turn, so it encloses nothing: expected whole numbers of waves n",
            );
        }
        let n_columns = (4.0 * upright.waves()).clamp(COLUMNS.0 as f64, COLUMNS.1 as f64) as usize | 1;
        let frame = Frame::new(DVec3::ZERO, placed.axis());
        let stretches = upright.stretches();
        let mut skin =
            Skin { upright, size: 0.0, poles: [false; 2], frame, turn: 1.0, n_columns, problem: None, stretches };
        skin.measure()?;
        skin.frame = Frame::new(skin.middle(0.0), placed.axis());
        let mut walk = skin.walk();
        let area: f64 = skin
            .round()
            .map(|v| walk.second(0.0, v))
            .map(|jet| skin.frame.plan(jet.position).perp_dot(skin.frame.turned(jet.dv)))
            .sum();
        drop(walk);
        skin.turn = if area < 0.0 { -1.0 } else { 1.0 };
        Ok(skin)
    }

    /// The same with the boundary-value problem that it solves.
    pub(crate) fn solving(self, problem: Option<BoundaryValue>) -> Skin {
        Skin { problem: problem.map(Box::new), ..self }
    }

    /// The same as it would be if it were not moved.
    ///
    /// # Errors
    /// As [`Skin::new`].
    pub(super) fn unmoved(&self) -> Result<Skin> {
        let skin = Skin::new(&Arc::new(self.placed().unmoved()))?;
        Ok(Skin { problem: self.problem.clone(), ..skin })
    }

    /// What it solves, where that was said.
    pub(super) fn problem(&self) -> Option<&BoundaryValue> {
        self.problem.as_deref()
    }

    /// Another surface in the place of a skin, on the same axis.
    ///
    /// # Errors
    /// As [`Skin::new`]; `pinched-surface` where it is upside down or goes round the other way.
    pub(super) fn beside(placed: &Arc<Placed>, other: &Skin) -> Result<Skin> {
        let skin = Skin { frame: other.frame, ..Skin::new(placed)? };
        if skin.is_upward() != other.is_upward() || skin.turn != other.turn || skin.outward() != other.outward() {
            let message = "the surface is turned inside out";
            return Err(Error::new(Code::PinchedSurface, placed.path("wall.lining"), message));
        }
        Ok(skin)
    }

    /// Finds the size, the poles and a pinch.
    fn measure(&mut self) -> Result<()> {
        let columns = self.columns(self.n_columns);
        let widths: Vec<f64> = (0..=ROWS).map(|i| self.width(i as f64 / ROWS as f64, &columns)).collect();
        let rise = (self.mean(1.0) - self.mean(0.0)).length();
        self.size = widths.iter().fold(rise, |size, width| size.max(*width));
        if !(self.size.is_finite() && self.size > f64::MIN_POSITIVE && self.size < f64::MAX.sqrt()) {
            let across = if self.size.is_finite() { plain(self.size) } else { "more than 1e308".to_owned() };
            let message = format!("the surface is {across} across, which cannot be computed with");
            return Err(Error::new(Code::Overflow, self.placed().own_path(), message));
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
                    let error = Error::new(Code::PinchedSurface, self.placed().path("shape"), message);
                    return Err(error.near(at.to_array()).with("what", "waist"));
                }
            }
        }
        Ok(())
    }

    /// Twice the largest distance of a row from its mean.
    fn width(&self, s: f64, columns: &Columns) -> f64 {
        let mut walk = self.walk();
        let points: Vec<DVec3> = (0..columns.len()).map(|j| walk.second_at(s, columns, j).position).collect();
        let mean = points.iter().sum::<DVec3>() / points.len() as f64;
        2.0 * points.iter().fold(0.0f64, |most, p| most.max((*p - mean).length()))
    }

    fn mean(&self, s: f64) -> DVec3 {
        let mut walk = self.walk();
        self.round().map(|v| walk.second(s, v).position).sum::<DVec3>() / self.n_columns as f64
    }

    /// Even values of `v`, four for each wave of the highest harmonic.
    pub(crate) fn round(&self) -> impl Iterator<Item = f64> + use<> {
        let n = self.n_columns;
        (0..n).map(move |j| TAU * j as f64 / n as f64)
    }

    /// The middle of the area that a row goes round seen along the axis, at its mean height; the mean of its points where it has no area.
    pub(crate) fn middle(&self, s: f64) -> DVec3 {
        let frame = Frame::new(self.mean(s), self.frame.axis());
        let mut walk = self.walk();
        let curve = self.round().map(|v| {
            let jet = walk.second(s, v);
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

    /// How many waves go round at most.
    pub(crate) fn waves(&self) -> f64 {
        self.upright.waves()
    }

    /// Whether the foot is a point, and the rim.
    pub(crate) fn poles(&self) -> [bool; 2] {
        self.poles
    }

    /// 1 where `X_s x X_v` points out of the pot, otherwise -1.
    pub(crate) fn outward(&self) -> f64 {
        self.upright.outward()
    }

    /// 1 where the foot goes round anti-clockwise seen from the rim, otherwise -1.
    pub(crate) fn turn(&self) -> f64 {
        self.turn
    }

    /// Whether `s` is `u`, not `1 - u`.
    pub(crate) fn is_upward(&self) -> bool {
        self.upright.is_upward()
    }

    /// Whether it is a surface of revolution, but for rounding.
    pub(super) fn is_round(&self) -> bool {
        self.placed().round(self.size).is_some_and(|round| round.off <= ROUND * self.size)
    }

    /// The part.
    pub(crate) fn placed(&self) -> &Placed {
        self.upright.placed()
    }

    /// Where derivatives jump along it.
    pub(super) fn knots(&self) -> Vec<f64> {
        self.upright.knots()
    }

    /// Even columns of this surface.
    pub(crate) fn columns(&self, n: usize) -> Columns {
        self.upright.even_columns(n)
    }

    /// Columns at places of their own.
    pub(crate) fn columns_at(&self, places: Vec<f64>) -> Columns {
        self.upright.columns_at(places)
    }

    /// Jets of one place after the other.
    pub(crate) fn walk(&self) -> SkinWalk<'_> {
        SkinWalk { skin: self, walk: self.upright.walk() }
    }

    /// What lies between the corners of the profile, from foot to rim: all of it in one where there are none.
    pub(crate) fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// As [`Skin::walk`], on one of them and on its continuation beyond its ends.
    pub(crate) fn walk_on(&self, stretch: Stretch) -> SkinWalk<'_> {
        SkinWalk { skin: self, walk: self.upright.walk_on(stretch) }
    }

    /// Position and derivatives up to the second, placed.
    pub(crate) fn second(&self, s: f64, v: f64) -> SurfaceJet {
        self.upright.at(s, v)
    }

    /// Position, derivatives and normal. At a pole or where the surface has no normal it is that of the nearest place which has one.
    pub(crate) fn jet(&self, s: f64, v: f64) -> SkinJet {
        self.with_normal(&self.second(s, v), s, v)
    }

    fn with_normal(&self, jet: &SurfaceJet, s: f64, v: f64) -> SkinJet {
        let is_pole = (s == 0.0 && self.poles[0]) || (s == 1.0 && self.poles[1]);
        let inward = if s < 0.5 { 1.0 } else { -1.0 };
        if !is_pole && let Some([normal, normal_s, normal_v]) = self.normal(jet) {
            return SkinJet { position: jet.position, ds: jet.du, dv: jet.dv, normal, normal_s, normal_v };
        }
        let beside = |n: f64| self.normal(&self.second(s + inward * n * BESIDE_POLE, v));
        let [mut normal, mut normal_s, mut normal_v] = beside(1.0).unwrap_or([DVec3::ZERO; 3]);
        if is_pole {
            if let [Some(one), Some(two), Some(three), Some(four)] = [1.0, 2.0, 3.0, 4.0].map(beside) {
                let near = [one, two, three, four];
                let limit = |which: usize| [0, 1, 2].map(|axis| limit(|n| near[n as usize - 1][which][axis]).0);
                (normal_s, normal_v) = (DVec3::from_array(limit(1)), DVec3::from_array(limit(2)));
            }
            // By Taylor's formula X_s x X_v = h (X_s x X_sv) at a distance h from a pole.
            let limit = jet.du.cross(jet.duv) * (inward * self.outward());
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
        let derivative = |m: DVec3| (m - normal * normal.dot(m)) / length * self.outward();
        let m_s = jet.duu.cross(jet.dv) + jet.du.cross(jet.duv);
        let m_v = jet.duv.cross(jet.dv) + jet.du.cross(jet.dvv);
        Some([normal * self.outward(), derivative(m_s), derivative(m_v)])
    }
}

impl SkinWalk<'_> {
    /// As [`Skin::second`].
    pub(crate) fn second(&mut self, s: f64, v: f64) -> SurfaceJet {
        self.walk.at(s, v)
    }

    /// As [`Skin::second`], at a column.
    pub(crate) fn second_at(&mut self, s: f64, columns: &Columns, column: usize) -> SurfaceJet {
        self.walk.at_column(s, columns, column)
    }

    /// As [`Skin::jet`].
    pub(crate) fn jet(&mut self, s: f64, v: f64) -> SkinJet {
        let jet = self.second(s, v);
        self.skin.with_normal(&jet, s, v)
    }

    /// As [`Skin::jet`], at a column.
    pub(crate) fn jet_at(&mut self, s: f64, columns: &Columns, column: usize) -> SkinJet {
        let jet = self.second_at(s, columns, column);
        self.skin.with_normal(&jet, s, columns.v(column))
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
