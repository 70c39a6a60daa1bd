//! The closed curves in which the faces of a pot meet.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::sheet::Sheet;

/// The step of the difference that gives a second derivative where there is no formula: fourth order, so good to some 1e-11.
const STEP: f64 = 1e-3;

/// Where second derivatives jump at places closer than five such steps, the difference is taken across them.
const LEAST_STEP: f64 = 1e-5;

/// Twelve times the weights of the difference over five places, whose middle is two steps before `v`, one, none, one after it, two.
const WEIGHTS: [[f64; 5]; 5] = [
    [3.0, -16.0, 36.0, -48.0, 25.0],
    [-1.0, 6.0, -18.0, 10.0, 3.0],
    [1.0, -8.0, 0.0, 8.0, -1.0],
    [-3.0, -10.0, 18.0, -6.0, 1.0],
    [-25.0, 48.0, -36.0, 16.0, -3.0],
];

/// A closed curve `C(v)`.
#[derive(Debug, Clone)]
pub(crate) enum Curve {
    /// Everything in one point.
    Point(DVec3),
    /// Where a sheet begins.
    Start(Arc<Sheet>),
    /// Where a sheet ends.
    End(Arc<Sheet>),
    /// Where an offset sheet begins, or beside the foot of the surface at the same distance where that is lower.
    Beside { sheet: Arc<Sheet> },
    /// Another curve moved along the axis to a level.
    Level { curve: Arc<Curve>, sheet: Arc<Sheet>, level: f64 },
    /// Another curve drawn towards the axis of the foot until it is on a cylinder.
    Cylinder { curve: Arc<Curve>, sheet: Arc<Sheet>, centre: DVec3, radius: f64 },
    /// A circle round the axis of the foot; `turn` is 1 or -1.
    Circle { sheet: Arc<Sheet>, level: f64, radius: f64, phase: f64, turn: f64 },
    /// A level curve moved sideways in its plane, to its left for a positive `width`.
    Inset { curve: Arc<Curve>, sheet: Arc<Sheet>, width: f64 },
}

impl Curve {
    /// `C` and `C_v`.
    pub(crate) fn at(&self, v: f64) -> (DVec3, DVec3) {
        match self {
            Curve::Point(point) => (*point, DVec3::ZERO),
            Curve::Start(sheet) => {
                let start = sheet.start(v);
                let jet = sheet.jet(start.s, v);
                (jet.position, jet.dv + jet.ds * start.dv)
            }
            Curve::End(sheet) => {
                let end = sheet.end(v);
                let jet = sheet.jet(end.s, v);
                (jet.position, if end.dv == 0.0 { jet.dv } else { jet.dv + jet.ds * end.dv })
            }
            Curve::Beside { sheet } => {
                let Some(heel) = sheet.heel(v) else { return Curve::Start(Arc::clone(sheet)).at(v) };
                let jet = heel.jet(0.0);
                (jet.position, jet.dv)
            }
            Curve::Level { curve, sheet, level } => {
                let (p, dp) = curve.at(v);
                let frame = sheet.skin().frame();
                (p + frame.axis() * (level - frame.level(p)), frame.flattened(dp))
            }
            Curve::Cylinder { curve, sheet, centre, radius } => {
                let (p, dp) = curve.at(v);
                let frame = sheet.skin().frame();
                let (arm, darm) = (p - *centre, dp);
                let (plan, dplan) = (frame.turned(arm), frame.turned(darm));
                let length = plan.length();
                let share = radius / length;
                (*centre + arm * share, (darm - arm * (plan.dot(dplan) / (length * length))) * share)
            }
            Curve::Circle { sheet, level, radius, phase, turn } => {
                let frame = sheet.skin().frame();
                let angle = phase + turn * v;
                let direction = DVec2::new(libm::cos(angle), libm::sin(angle)) * *radius;
                (frame.point(direction, *level), frame.lifted(direction.perp()) * *turn)
            }
            Curve::Inset { curve, sheet, width } => {
                let frame = sheet.skin().frame();
                let (p, dp) = curve.at(v);
                let (tangent, second) = (frame.turned(dp), frame.turned(curve.second(v)));
                let speed = tangent.length();
                let curvature = tangent.perp_dot(second) / (speed * speed * speed);
                (p + frame.lifted(tangent.perp() / speed) * *width, dp * (1.0 - width * curvature))
            }
        }
    }

    /// The sheet with an interpolated thickness that the curve goes by, and whether it goes by where the sheet begins.
    pub(crate) fn seamed(&self) -> Option<(&Sheet, bool)> {
        match self {
            Curve::Start(sheet) | Curve::Beside { sheet } => Some((sheet, true)),
            Curve::End(sheet) => Some((sheet, false)),
            Curve::Level { curve, .. } | Curve::Cylinder { curve, .. } | Curve::Inset { curve, .. } => {
                return curve.seamed();
            }
            Curve::Point(_) | Curve::Circle { .. } => None,
        }
        .filter(|(sheet, _)| !sheet.is_exact())
        .map(|(sheet, begins)| (&**sheet, begins))
    }

    /// `C_vv`.
    pub(crate) fn second(&self, v: f64) -> DVec3 {
        if let Curve::Start(sheet) = self
            && let Some(second) = sheet.second_round(v)
        {
            return second;
        }
        let (step, shift) = self.stencil(v);
        let slope = |v: f64| self.at(if v < 0.0 { v + TAU } else { v }).1;
        let mut sum = DVec3::ZERO;
        for (place, weight) in WEIGHTS[(shift + 2) as usize].iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
            sum += slope(v + f64::from(place as i32 - 2 + shift) * step) * *weight;
        }
        sum / (12.0 * step)
    }

    /// The step of the difference at `v`, and by how many steps its middle is beside that, so that nothing jumps within it.
    fn stencil(&self, v: f64) -> (f64, i32) {
        let gap = self.seamed().and_then(|(sheet, begins)| sheet.gap_round(v, begins));
        let Some([below, above]) = gap.filter(|[below, above]| above - below >= 5.0 * LEAST_STEP) else {
            return (STEP, 0);
        };
        let step = STEP.min((above - below) / 5.0);
        let (least, most) = (libm::ceil((below - v) / step + 2.0), libm::floor((above - v) / step - 2.0));
        (step, 0.0f64.max(least).min(most).clamp(-2.0, 2.0) as i32)
    }
}
