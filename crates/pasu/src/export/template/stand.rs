//! What a template shows of a part beside its body: the axis, the rim, and the edge of a strip laid round the pot under it.

use core::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::frame::Frame;
use super::levels::Levels;
use crate::face::{Face, FaceKind};
use crate::numeric::{brent, illinois};

/// Points round the rim.
const RIM: usize = 720;
/// Places down the outside at which the lower edge of the strip is looked for.
const DOWN: usize = 64;
/// How far the strip reaches below the lowest point of the rim, millimetres; half as far as there is wall, where that is less.
const STRIP: f64 = 20.0;
/// A rim whose heights differ by less, in millimetres, is level: nobody sees it.
const LEVEL: f64 = 0.1;
/// A point is higher than another from here on, millimetres: more than rounding makes.
const HIGHER: f64 = 1e-9;
/// Directions whose cosine is at least this are one: less than a degree apart.
const SAME: f64 = 0.9998;
/// Nearer to the axis, in millimetres, a point is in no direction from it.
const NEAR: f64 = 1e-3;

/// What a template shows of a part beside its body.
pub(in crate::export) struct Stand {
    pub(super) frame: Frame,
    /// How high and how wide it is.
    pub(super) levels: Levels,
    /// The edge of the rim once round, in millimetres, the first point not repeated; empty if it is a point.
    pub(super) rim: Vec<DVec3>,
    /// Where each column of the rim comes down to the lower edge of the strip, which is level; empty where one does not.
    pub(super) hem: Vec<DVec3>,
    /// The planes through the axis in which it is cut, at least one.
    pub(super) planes: Vec<Plane>,
}

/// A plane through the axis.
pub(super) struct Plane {
    /// Its direction as it is seen from above, a unit vector.
    pub(super) towards: DVec2,
    /// What it is through; empty for the one along the frame.
    pub(super) through: &'static str,
    /// What is marked at its ends: towards its direction and away from it.
    pub(super) ends: [&'static str; 2],
}

impl Stand {
    /// Of the faces of a part, whose lengths times `millimetres` are millimetres; the frame is in millimetres.
    pub(in crate::export) fn new<'a>(
        frame: Frame,
        faces: impl Iterator<Item = &'a dyn Face>,
        millimetres: f64,
    ) -> Stand {
        let plain = Plane { towards: DVec2::X, through: "", ends: ["section", ""] };
        let faces: Vec<&dyn Face> = faces.collect();
        let levels = Levels::new(&frame, &faces, millimetres);
        let mut stand = Stand { frame, levels, rim: Vec::new(), hem: Vec::new(), planes: vec![plain] };
        let mut upper = None;
        let mut height = f64::NEG_INFINITY;
        for face in faces.into_iter().filter(|face| face.kind() == FaceKind::Outer) {
            let mut walk = face.walk();
            for end in [0.0, 1.0] {
                let curve: Vec<DVec3> = (0..RIM).map(|i| millimetres * walk.jet(end, turn(i)).position).collect();
                let mean = curve.iter().map(|point| frame.height(*point)).sum::<f64>() / RIM as f64;
                if mean > height {
                    height = mean;
                    upper = Some((face, end));
                    stand.rim = curve;
                }
            }
        }
        let across = stand.rim.iter().map(|point| (*point - stand.rim[0]).length()).fold(0.0, f64::max);
        match upper {
            Some((face, end)) if across > 0.0 => {
                let mut walk = face.walk();
                let mut at = |a: f64, v: f64| millimetres * walk.jet(a, v).position;
                stand.planes_through(|v| at(end, v));
                stand.hem_of(end, at);
            }
            _ => stand.rim.clear(),
        }
        stand
    }

    /// Turns the section to the highest and lowest points of a rim that is not level.
    fn planes_through(&mut self, mut rim: impl FnMut(f64) -> DVec3) {
        let frame = self.frame;
        let mut extreme = |sign: f64| {
            // To the micrometre: of points that are equally high the first counts, on every machine.
            let heights: Vec<f64> =
                self.rim.iter().map(|point| libm::round(1e3 * sign * frame.height(*point)) / 1e3).collect();
            let mut most = (0..RIM).fold(0, |most, i| if heights[i] > heights[most] { i } else { most });
            // A rim that is almost flat there is level to the micrometre for degrees: up to its top.
            let height = |i: usize| sign * frame.height(self.rim[i % RIM]);
            while let Some(next) = [1, RIM - 1].into_iter().find(|step| height(most + step) > height(most) + HIGHER) {
                most = (most + next) % RIM;
            }
            let step = TAU / RIM as f64;
            let (v, least) = brent::least(turn(most) - step, turn(most) + step, 1e-6, |v| -sign * frame.height(rim(v)));
            // Between the points, where that is higher.
            if -least > sign * frame.height(self.rim[most]) { rim(v) } else { self.rim[most] }
        };
        let [high, low] = [extreme(1.0), extreme(-1.0)];
        let [towards_high, towards_low] = [high, low].map(|point| frame.above(point));
        let difference = frame.height(high) - frame.height(low);
        if !(difference > LEVEL) || towards_high.length() < NEAR || towards_low.length() < NEAR {
            return;
        }
        let [towards_high, towards_low] = [towards_high, towards_low].map(DVec2::normalize);
        let cosine = towards_high.dot(towards_low);
        self.planes = if cosine.abs() >= SAME {
            let ends = if cosine < 0.0 { ["highest", "lowest"] } else { ["highest, lowest", ""] };
            vec![Plane { towards: towards_high, through: "the rim's highest and lowest points", ends }]
        } else {
            vec![
                Plane { towards: towards_high, through: "the rim's highest point", ends: ["highest", ""] },
                Plane { towards: towards_low, through: "the rim's lowest point", ends: ["lowest", ""] },
            ]
        };
    }

    /// Follows every column of the outside from the rim, which is its end `end`, down to one level below the rim.
    fn hem_of(&mut self, end: f64, mut at: impl FnMut(f64, f64) -> DVec3) {
        let frame = self.frame;
        let (low, _) = extremes(self.rim.iter().map(|point| frame.height(*point)));
        let (_, foot) = extremes((0..RIM).map(|i| frame.height(at(1.0 - end, turn(i)))));
        let level = low - STRIP.min(0.5 * (low - foot));
        if !(level < low) {
            return;
        }
        let down = |step: usize| {
            let part = step as f64 / DOWN as f64;
            if end > 0.0 { 1.0 - part } else { part }
        };
        for i in 0..RIM {
            let v = turn(i);
            let mut above = (end, frame.height(self.rim[i]) - level);
            let reached = (1..=DOWN).find_map(|step| {
                let here = (down(step), frame.height(at(down(step), v)) - level);
                if here.1 <= 0.0 {
                    return Some(illinois::root(above, here, |a| frame.height(at(a, v)) - level));
                }
                above = here;
                None
            });
            match reached {
                Some(a) => self.hem.push(at(a, v)),
                None => return self.hem.clear(),
            }
        }
    }
}

fn turn(i: usize) -> f64 {
    TAU * i as f64 / RIM as f64
}

/// The least and the greatest.
fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
}
