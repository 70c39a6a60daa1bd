//! The one placement of a surface about an axis among those that make the same solid.
//!
//! Of the turns about its own axis that leave it as it is ([`Symmetry`]) canonical form takes the one after which it is turned least: that with the greatest trace of the rotation, and where several are as good the one whose `x` axis has the greatest `x`, then `y`, and so on.
//! One that is its own mirror image is never mirrored. Scaled otherwise along `x` than along `y` it keeps those motions alone that take axes to axes.

use super::placement::{Digits, Placement, quaternion};
use super::symmetry::Symmetry;

/// Numbers that are this near count as equal: far above what twelve digits leave of two descriptions of one solid, and far below what tells two directions from each other.
const SLACK: f64 = 1e-9;

/// A turn by less is what rounding a placement leaves.
const STILL: f64 = 1e-10;

/// How often a placement is looked at again. Only where numbers differ by [`SLACK`] to the last digit does rounding change the choice once more.
const TRIES: usize = 4;

/// Directions of the axes of the shape, their lengths, and whether they are those that were there.
struct Candidate {
    directions: [[f64; 3]; 3],
    lengths: [f64; 3],
    is_still: bool,
}

impl Symmetry {
    /// The canonical placement among those that make the same solid as the one that was `given`, whose own canonical form is `place`.
    pub(crate) fn standing(&self, given: &Placement, place: Placement) -> Placement {
        let mut found = place;
        let (Some(mut directions), mut digits) = (given.directions(), given.digits()) else { return place };
        for _ in 0..TRIES {
            let best = match self.best(directions, found.scale.map(f64::abs)) {
                Some(best) if !best.is_still => best,
                _ => return found,
            };
            found = Placement::along(best.directions, best.lengths, place.shift, digits);
            let Some(next) = found.directions() else { return found };
            (directions, digits) = (next, Digits::Twelve);
        }
        found
    }

    fn best(&self, directions: [[f64; 3]; 3], lengths: [f64; 3]) -> Option<Candidate> {
        let candidates = match lengths[0] == lengths[1] {
            true => self.turned(directions, lengths),
            false => self.exchanged(directions, lengths),
        };
        let trace = |candidate: &Candidate| {
            let [x, y, z] = candidate.directions;
            x[0] + handedness(&candidate.directions) * y[1] + z[2]
        };
        let most = candidates.iter().map(trace).fold(f64::NEG_INFINITY, f64::max);
        let is_before = |one: &Candidate, other: &Candidate| {
            let both = one.directions.iter().flatten().zip(other.directions.iter().flatten());
            both.map(|(one, other)| one - other).find(|more| more.abs() > SLACK).is_some_and(|more| more > 0.0)
        };
        let near = candidates.into_iter().filter(|candidate| trace(candidate) >= most - SLACK);
        near.reduce(|best, next| if is_before(&next, &best) { next } else { best })
    }

    /// Turned about the axis as near as may be to where it is turned least.
    fn turned(&self, given: [[f64; 3]; 3], lengths: [f64; 3]) -> Vec<Candidate> {
        let mirror = self.mirror.filter(|_| handedness(&given) < 0.0);
        let [x, y, z] = mirror.map_or(given, |angle| mirrored(given, libm::cos(2.0 * angle), libm::sin(2.0 * angle)));
        let sense = handedness(&[x, y, z]);
        // The trace is `more cos + less sin` of the angle of the turn. Upside down it is the same for every turn.
        let (more, less) = (x[0] + sense * y[1], y[0] - sense * x[1]);
        let is_level = libm::hypot(more, less) <= SLACK;
        // By halves of the angles: close to upside down `more` and `less` are all but nothing, and what is left of them is noise.
        let [real, _, _, up] = quaternion([x, y.map(|c| sense * c), z]);
        let wanted = if is_level { libm::atan2(y[0], x[0]) } else { -2.0 * sense * libm::atan2(up, real) };
        let angles = match self.fold {
            None => vec![wanted],
            Some(fold) => {
                let step = std::f64::consts::TAU / fold;
                let nearest = libm::round(wanted / step);
                [0.0, -1.0, 1.0].into_iter().take(fold as usize).map(|more| (nearest + more) * step).collect()
            }
        };
        let turn = |angle: f64| {
            // Whole turns are none at all.
            let whole = libm::round(angle / std::f64::consts::TAU) * std::f64::consts::TAU;
            let is_still = (angle - whole).abs() <= STILL;
            let (cos, sin) = if is_still { (1.0, 0.0) } else { (libm::cos(angle), libm::sin(angle)) };
            let directions = [mixed(x, cos, y, sin), mixed(x, -sin, y, cos), z];
            Candidate { directions, lengths, is_still: is_still && mirror.is_none() }
        };
        angles.into_iter().map(turn).collect()
    }

    /// Its axes across exchanged or turned round, as far as it has such a symmetry.
    fn exchanged(&self, [x, y, z]: [[f64; 3]; 3], [across, along, up]: [f64; 3]) -> Vec<Candidate> {
        const COSINES: [f64; 4] = [1.0, 0.0, -1.0, 0.0];
        let sine = |quarters: usize| COSINES[(quarters + 3) % 4];
        let is_left = handedness(&[x, y, z]) < 0.0;
        let mirrors: Vec<usize> = (0..4).filter(|eighths| is_left && self.has_mirror(*eighths as f64)).collect();
        let lengths = |quarters: usize| if quarters % 2 == 1 { [along, across, up] } else { [across, along, up] };
        let candidate =
            |directions, quarters: usize, is_still| Candidate { directions, lengths: lengths(quarters), is_still };
        match mirrors.is_empty() {
            false => {
                let mirror = |eighths: usize| mirrored([x, y, z], COSINES[eighths], sine(eighths));
                mirrors.into_iter().map(|eighths| candidate(mirror(eighths), eighths, false)).collect()
            }
            true => {
                let turn = |quarters: usize| {
                    let (cos, sin) = (COSINES[quarters], sine(quarters));
                    candidate([mixed(x, cos, y, sin), mixed(x, -sin, y, cos), z], quarters, quarters == 0)
                };
                (0..4).filter(|quarters| self.has_quarters(*quarters as f64)).map(turn).collect()
            }
        }
    }
}

/// The image in a plane through `z`, by the cosine and sine of twice the angle at which it stands.
fn mirrored([x, y, z]: [[f64; 3]; 3], cos: f64, sin: f64) -> [[f64; 3]; 3] {
    [mixed(x, cos, y, sin), mixed(x, sin, y, -cos), z]
}

fn mixed(one: [f64; 3], a: f64, other: [f64; 3], b: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| a * one[i] + b * other[i])
}

/// 1 of right-handed directions, -1 of left-handed ones.
fn handedness([x, y, z]: &[[f64; 3]; 3]) -> f64 {
    let across = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
    let along: f64 = (0..3).map(|i| across[i] * y[i]).sum();
    if along < 0.0 { -1.0 } else { 1.0 }
}
