//! Where the beginning of a trimmed side of a wall leaps: there the surface goes below the level and comes up again beside a place where it stays above.

use core::f64::consts::TAU;

use super::start::Start;
use crate::numeric::turn;

/// Leaps of less than this part of the way from foot to rim are none.
const LEAST: f64 = 2e-4;

/// What is less surprising than this is not looked into.
const PLAIN: f64 = 1e-5;

/// How often the gap in which one is sought is halved, and how often both halves are looked into.
const HALVINGS: usize = 40;
const BOTH: usize = 3;

/// How wide a bridge is at most on either side of the leap, in radians.
const REACH: f64 = 0.05;

/// Of the way to the next leap, it takes no more than this part.
const SHARE: f64 = 0.3;

/// Places beyond a leap at which the highest is sought.
const PLACES: usize = 16;

/// What leads from the lower side of a leap up to the higher one, so that a side of a wall begins at a continuous curve: with `S(v)` where columns rise above the level and `T` the highest of these beside the leap,
/// they begin at `(1 - w) S + w T` below it, `w` rising from 0 to 1 with two derivatives that vanish at either end, and at `T` above it until `S` is there. That is nowhere before `S`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bridge {
    /// Where it begins, on the lower side, from 0 to a turn.
    from: f64,
    /// From there to the leap, and to where it ends: positive if the leap is upwards in the sense of `v`, else negative.
    leap: f64,
    end: f64,
    top: f64,
}

impl Bridge {
    /// Those over the leaps of `start`, which are sought between each of these ascending places round and the next.
    pub(super) fn all(round: &[f64], start: &mut dyn FnMut(f64) -> Start) -> Vec<Bridge> {
        let known: Vec<(f64, Start)> = round.iter().map(|v| (*v, start(*v))).collect();
        let first = known.first().map(|(v, start)| (v + TAU, *start));
        let next = known.iter().skip(1).copied().chain(first);
        let mut leaps = Vec::new();
        known.iter().zip(next).for_each(|(left, right)| look_into(*left, right, 0, start, &mut leaps));
        let n = leaps.len();
        let apart = |k: usize| {
            let way = leaps[(k + 1) % n][0].0 - leaps[k][0].0;
            if way > 0.0 { way } else { way + TAU }
        };
        let over = |k: usize| {
            let [left, right] = leaps[k];
            let reach = [apart((k + n - 1) % n), apart(k)].map(|apart| REACH.min(SHARE * apart));
            // From the lower side to the higher.
            let (sign, low, high, [below, above]) = if left.1.s < right.1.s {
                (1.0, left, right, reach)
            } else {
                (-1.0, right, left, [reach[1], reach[0]])
            };
            let places = (0..=PLACES).map(|i| above * i as f64 / PLACES as f64);
            let (end, top) = places.fold((0.0, high.1.s), |best, way| {
                let s = start(turn::within(high.0 + sign * way)).s;
                if s > best.1 { (way, s) } else { best }
            });
            let from = low.0 - sign * below;
            Bridge { from: turn::within(from), leap: sign * below, end: high.0 - from + sign * end, top }
        };
        (0..n).map(over).collect()
    }

    /// Where the column at `v` begins in place of where it would.
    pub(super) fn lead(&self, v: f64, start: Start) -> Option<Start> {
        let sign = self.end.signum();
        let way = turn::within(sign * (v - self.from));
        let [leap, end] = [self.leap, self.end].map(f64::abs);
        if way >= end {
            return None;
        }
        let t = (way / leap).min(1.0);
        let w = t * t * t * (10.0 + t * (6.0 * t - 15.0));
        let w_v = 30.0 * (t * (1.0 - t)) * (t * (1.0 - t)) * (sign / leap);
        let s = start.s + w * (self.top - start.s);
        Some(Start { s, dv: (1.0 - w) * start.dv + w_v * (self.top - start.s) })
    }
}

/// Adds the places next to each other between which it leaps.
fn look_into(
    left: (f64, Start),
    right: (f64, Start),
    depth: usize,
    start: &mut dyn FnMut(f64) -> Start,
    leaps: &mut Vec<[(f64, Start); 2]>,
) {
    if surprise(left, right) < if depth < BOTH { PLAIN } else { LEAST } {
        return;
    }
    if depth == HALVINGS {
        leaps.push([left, right]);
        return;
    }
    let v = 0.5 * (left.0 + right.0);
    let middle = (v, start(turn::within(v)));
    let is_left = surprise(left, middle) > surprise(middle, right);
    if depth < BOTH || is_left {
        look_into(left, middle, depth + 1, start, leaps);
    }
    if depth < BOTH || !is_left {
        look_into(middle, right, depth + 1, start, leaps);
    }
}

/// By how much what is at one place differs from what the slopes at it and at the other let expect.
fn surprise((a, from): (f64, Start), (b, to): (f64, Start)) -> f64 {
    (to.s - from.s - 0.5 * (b - a) * (from.dv + to.dv)).abs()
}
