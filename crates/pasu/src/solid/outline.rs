//! What the edges of faces are like, seen along the axis.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::curve::Curve;
use super::sheet::Sheet;
use super::skin::{Skin, middle_of};
use crate::numeric::golden_section;

/// A foot is level if its points are within this part of the size of one plane across the axis.
const LEVEL: f64 = 1e-9;

/// Golden sections by which the highest place between two columns is found: they leave 4e-9 of the gap, by which a height differs by less than rounding.
const SECTIONS: usize = 40;

/// What a closed curve is like, seen along the axis.
pub(super) struct Outline {
    /// The middle of the area that it goes round, at its mean level.
    pub(super) middle: Option<DVec3>,
    pub(super) mean: DVec3,
    pub(super) lowest: f64,
    pub(super) highest: f64,
    pub(super) is_level: bool,
    /// Whether the middle is within it.
    pub(super) goes_round_middle: bool,
    /// Whether all of it is seen from the middle.
    pub(super) is_star: bool,
    /// 1 where it goes round anti-clockwise, otherwise -1.
    pub(super) turn: f64,
    /// The greatest distance from the mean.
    pub(super) widest: f64,
    /// The least distance from the middle.
    pub(super) narrowest: f64,
    /// The direction from the middle to the point at `v = 0`.
    pub(super) phase: f64,
}

impl Outline {
    pub(super) fn of(curve: &Curve, skin: &Skin) -> Outline {
        let frame = skin.frame();
        let points: Vec<(DVec3, DVec3)> = skin.round().map(|v| curve.at(v)).collect();
        let mean = points.iter().map(|(p, _)| *p).sum::<DVec3>() / points.len() as f64;
        let (mut lowest, mut highest, mut level) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
        for (p, _) in &points {
            let height = frame.level(*p);
            (lowest, highest) = (lowest.min(height), highest.max(height));
            level += height / points.len() as f64;
        }
        let is_level = highest - lowest <= LEVEL * skin.size();
        if !is_level {
            let level = |v: f64| frame.level(curve.at(v).0);
            highest = highest.max(extreme(points.len(), level));
            lowest = lowest.min(-extreme(points.len(), |v| -level(v)));
        }
        let centre = frame.plan(mean);
        let seen = || points.iter().map(|(p, dp)| (frame.plan(*p) - centre, frame.turned(*dp)));
        let plan = middle_of(seen()).map(|middle| middle + centre);
        let middle = plan.unwrap_or(centre);
        let (mut least, mut most, mut narrowest) = (f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY);
        let mut area = 0.0;
        for (p, dp) in &points {
            let arm = frame.plan(*p) - middle;
            let turn = arm.perp_dot(frame.turned(*dp));
            area += turn;
            (least, most) = (least.min(turn), most.max(turn));
            narrowest = narrowest.min(arm.length());
        }
        let arms: Vec<DVec2> = points.iter().map(|(p, _)| frame.plan(*p) - middle).collect();
        let turns = arms.iter().zip(arms.iter().cycle().skip(1)).map(|(a, b)| libm::atan2(a.perp_dot(*b), a.dot(*b)));
        let goes_round_middle = turns.sum::<f64>().abs() > 1.0;
        let widest = points.iter().fold(0.0f64, |widest, (p, _)| widest.max((*p - mean).length()));
        let first = points.first().map_or(DVec2::X, |(p, _)| frame.plan(*p) - middle);
        Outline {
            middle: plan.map(|plan| frame.point(plan, level)),
            mean,
            lowest,
            highest,
            is_level,
            goes_round_middle,
            is_star: least > 0.0 || most < 0.0,
            turn: if area < 0.0 { -1.0 } else { 1.0 },
            widest,
            narrowest,
            phase: libm::atan2(first.y, first.x),
        }
    }

    /// A circle round the axis of the foot that goes round as the outline does.
    pub(super) fn circle(&self, sheet: &Arc<Sheet>, radius: f64) -> Curve {
        Curve::Circle { sheet: Arc::clone(sheet), level: self.lowest, radius, phase: self.phase, turn: self.turn }
    }
}

/// The greatest value of a function of `v`, sought by golden sections round the greatest at even columns.
fn extreme(n_columns: usize, f: impl Fn(f64) -> f64) -> f64 {
    let gap = TAU / n_columns as f64;
    let best = (0..n_columns)
        .map(|j| (f(j as f64 * gap), j))
        .fold((f64::NEG_INFINITY, 0), |a, b| if b.0 > a.0 { b } else { a });
    let (from, to) = ((best.1 as f64 - 1.0) * gap, (best.1 as f64 + 1.0) * gap);
    let wrapped = |v: f64| f(if v < 0.0 { v + TAU } else { v });
    wrapped(golden_section::middle_of_greatest(from, to, SECTIONS, wrapped)).max(best.0)
}
