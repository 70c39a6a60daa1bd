//! How curved a surface is along `u`: what decides where rows are needed.

use glam::{DMat3, DVec3};

use crate::numeric::ascending::distinct;
use crate::surface::{Circumference, RowSuprema, Surface};

/// Even strips to begin with.
const STRIPS: usize = 64;

/// The most strips; a surface of several thin layers may have so many.
const MOST_STRIPS: usize = 768;

/// The same where there are many modes.
const MOST_STRIPS_OF_MANY: usize = 192;

/// How often a strip may be halved: layers of rate 1e7 and less are resolved, for faster ones the bound is still one, only larger.
const MOST_HALVINGS: usize = 24;

/// A strip is halved while more than this part of its bound is remainder.
const REMAINDER: f64 = 0.04;

/// A strip is halved while taking the larger of its ends for both costs more than this part of all rows.
const WASTE: f64 = 3e-4;

/// A surface cut into strips of `u`, with bounds on each of the second derivatives after `u` has been straightened.
///
/// **Straightening.** A distance between two surfaces does not depend on how they are parametrised, yet `X_uu` does: where `X_u` grows longer along a straight line,
/// linear interpolation in `u` is wrong only in where along that line it puts its points. So `u` is replaced by `t(u) = integral of m`, with
/// `m(u) = exp(-integral of g)`. Then `X_t = X_u / m` and `X_tt = (X_uu + g X_u) / m^2`; with `g` as [`RowSuprema::straightening`] says, what remains is
/// what bends. `g` is continuous and linear in each strip, `t` is increasing, and triangles and surface are compared at equal `t`, with the ends of every cell where they are: each
/// point of one is within the bound of a point of the other.
#[derive(Debug)]
pub(super) struct Profile {
    /// The largest distance from the origin.
    pub(super) size: f64,
    /// Where strips begin and end.
    u: Vec<f64>,
    /// `t` at these, or rather a little more than its increases.
    t: Vec<f64>,
    bends: Vec<Bend>,
    /// For each strip whether a row has to stand where it ends.
    is_stop: Vec<bool>,
}

/// Suprema over some strips of `|X_tt|`, `|X_tv|`, `|X_vv|`, `v` scaled to [0, 1].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Bend {
    pub(super) tt: f64,
    pub(super) tv: f64,
    pub(super) vv: f64,
}

impl Bend {
    /// Eight times the distance between a triangle of a cell of size `p x q` in `t` and `v` and the surface.
    ///
    /// On a right triangle with legs `p`, `q` in the parameters, the linear interpolant of `X` is within
    /// `(p^2 |X_tt| + 2 p q |X_tv| + q^2 |X_vv|) / 8` (Filip, Magedson and Markot, *Surface algorithms using bounds on derivatives*, 1986, theorem 2).
    pub(super) fn cost(&self, p: f64, q: f64) -> f64 {
        let cost = p * p * self.tt + 2.0 * p * q * self.tv + q * q * self.vv;
        if cost.is_nan() { f64::INFINITY } else { cost }
    }

    /// The longest `p` for which the cost is within a budget; negative where there is none, infinite where any would do.
    pub(super) fn longest(&self, q: f64, budget: f64) -> f64 {
        step(q * q * self.vv, q * self.tv, self.tt, budget)
    }

    /// The widest `q` for which the cost is within a budget, as [`Self::longest`].
    pub(super) fn widest(&self, p: f64, budget: f64) -> f64 {
        step(p * p * self.tt, p * self.tv, self.vv, budget)
    }

    fn max(self, other: Bend) -> Bend {
        Bend { tt: self.tt.max(other.tt), tv: self.tv.max(other.tv), vv: self.vv.max(other.vv) }
    }
}

/// The largest `x` with `a + 2 b x + c x^2 <= budget`, written without cancellation.
fn step(a: f64, b: f64, c: f64, budget: f64) -> f64 {
    let left = budget - a;
    match left {
        _ if left > 0.0 => left / (b + (b * b + c * left).sqrt()),
        0.0 if b == 0.0 && c == 0.0 => f64::INFINITY,
        _ => -1.0,
    }
}

/// One strip in the making.
#[derive(Debug, Clone, Copy)]
struct Strip {
    from: f64,
    to: f64,
    at: [RowSuprema; 2],
    /// How much `|X|`, `|X_uu + g X_u|`, `|X_uv|`, `|X_vv|` can exceed the line between their values at the ends.
    excess: [f64; 4],
}

impl Strip {
    /// A vector function is within `gap^2 / 8` times its second derivative of the line between its ends.
    fn new(surface: &Surface, stretch: [f64; 3], from: f64, to: f64, at: [RowSuprema; 2]) -> Strip {
        let strip = surface.strip_suprema(from, to, stretch);
        let gap = to - from;
        let [g0, g1] = at.map(|row| row.straightening);
        let [uu, uuu, uuuu] = strip.along;
        let straightened = uuuu + g0.abs().max(g1.abs()) * uuu + 2.0 * ((g1 - g0) / gap).abs() * uu;
        let excess = [uu, straightened, strip.once_round, strip.twice_round].map(|d| 0.125 * gap * gap * d);
        Strip { from, to, at, excess }
    }

    fn gap(&self) -> f64 {
        self.to - self.from
    }

    fn largest(&self, of: impl Fn(&RowSuprema) -> f64) -> f64 {
        of(&self.at[0]).max(of(&self.at[1]))
    }
}

impl Profile {
    pub(super) fn of(surface: &Surface, placement: DMat3) -> Profile {
        // The columns of a rotation times a scale are orthogonal, so lengths are those of stretched axes.
        let stretch = [placement.x_axis, placement.y_axis, placement.z_axis].map(DVec3::length);
        let mut circumference = Circumference::new(surface);
        let most_strips = if circumference.has_many_modes { MOST_STRIPS_OF_MANY } else { MOST_STRIPS };
        let mut row = |u: f64| circumference.suprema(surface, u, stretch);
        let mut strips = Vec::with_capacity(2 * STRIPS);
        let (mut from, mut before) = (0.0, row(0.0));
        let stops = surface.stops();
        for to in distinct((1..=STRIPS).map(|i| i as f64 / STRIPS as f64).chain(stops.iter().copied())) {
            let after = row(to);
            strips.push(Strip::new(surface, stretch, from, to, [before, after]));
            (from, before) = (to, after);
        }
        let most_strips = most_strips + strips.len() - STRIPS;
        for _ in 0..MOST_HALVINGS {
            let coarse = coarse(&strips);
            let n_coarse = coarse.iter().filter(|is_coarse| **is_coarse).count();
            if n_coarse == 0 || strips.len() + n_coarse > most_strips {
                break;
            }
            let mut finer = Vec::with_capacity(strips.len() + n_coarse);
            for (strip, is_coarse) in strips.into_iter().zip(coarse) {
                if is_coarse {
                    let Strip { from, to, at: [start, end], .. } = strip;
                    let middle = 0.5 * from + 0.5 * to;
                    let between = row(middle);
                    finer.push(Strip::new(surface, stretch, from, middle, [start, between]));
                    finer.push(Strip::new(surface, stretch, middle, to, [between, end]));
                } else {
                    finer.push(strip);
                }
            }
            strips = finer;
        }
        let mut profile = Self::straightened(&strips);
        profile.is_stop = strips.iter().map(|strip| stops.contains(&strip.to)).collect();
        profile
    }

    fn straightened(strips: &[Strip]) -> Profile {
        let (bends, is_stop) = (Vec::with_capacity(strips.len()), Vec::new());
        let mut profile = Profile { size: 0.0, u: vec![0.0], t: vec![0.0], bends, is_stop };
        let (mut t, mut log) = (0.0, 0.0);
        for strip in strips {
            let [g0, g1] = strip.at.map(|row| row.straightening);
            let next = log - 0.5 * strip.gap() * (g0 + g1);
            // The logarithm of m is quadratic, and so far from the line between its ends at most.
            let curved = 0.125 * strip.gap() * (g1 - g0).abs();
            let (most, least) = (libm::exp(log.max(next) + curved), libm::exp(log.min(next) - curved));
            log = next;
            let bound = |of: fn(&RowSuprema) -> f64, excess: f64| {
                // The last part is for the rounding of all that went before.
                let bound = (strip.largest(of) + excess) * (1.0 + 1e-9);
                if bound.is_nan() { f64::INFINITY } else { bound }
            };
            let [size, uu, uv, vv] = strip.excess;
            profile.size = profile.size.max(bound(|row| row.size, size));
            profile.bends.push(Bend {
                tt: bound(|row| row.uu, uu) / (least * least),
                tv: bound(|row| row.uv, uv) / least,
                vv: bound(|row| row.vv, vv),
            });
            t += strip.gap() * most;
            profile.u.push(strip.to);
            profile.t.push(t);
        }
        profile
    }

    /// The most of `|X_vv|` anywhere.
    pub(super) fn roundest(&self) -> f64 {
        self.bends.iter().fold(0.0f64, |most, bend| most.max(bend.vv))
    }

    /// About how many cells along `u` a budget takes, for a number that may be any.
    pub(super) fn estimate(&self, q: f64, budget: f64) -> f64 {
        self.bends.iter().zip(self.t.windows(2)).map(|(bend, t)| (t[1] - t[0]) / bend.longest(q, budget).max(0.0)).sum()
    }

    /// Walks from `u = 0` to `u = 1` with the longest steps whose cells cost no more than the budget, no step across a ring, and tells where each ends. The number of steps, or `None` where there are more than
    /// `most` or no step holds.
    pub(super) fn walk(&self, q: f64, budget: f64, most: usize, visit: &mut dyn FnMut(f64)) -> Option<usize> {
        let (mut strip, mut at) = (0, 0.0);
        for n_steps in 1..=most {
            let (start, mut worst) = (at, Bend::default());
            loop {
                worst = worst.max(*self.bends.get(strip)?);
                let (begin, end) = (self.t[strip].max(start), self.t[strip + 1]);
                let reach = start + worst.longest(q, budget);
                if reach >= end {
                    strip += 1;
                    if strip == self.bends.len() {
                        visit(1.0);
                        return Some(n_steps);
                    }
                    if self.is_stop.get(strip - 1) == Some(&true) {
                        at = self.t[strip];
                        visit(self.u[strip]);
                        break;
                    }
                    continue;
                }
                at = if reach > begin { reach } else { begin };
                if at <= start {
                    return None;
                }
                let share = (at - self.t[strip]) / (self.t[strip + 1] - self.t[strip]);
                visit(self.u[strip] + share * (self.u[strip + 1] - self.u[strip]));
                break;
            }
        }
        None
    }

    /// The number of steps of [`Profile::walk`].
    pub(super) fn steps(&self, q: f64, budget: f64, most: usize) -> Option<usize> {
        self.walk(q, budget, most, &mut |_| {})
    }

    /// What the cells between rows at these `u`, which ascend from 0 to 1, cost: for each its length in `t` and the worst bend.
    pub(super) fn cells(&self, rows: &mut dyn Iterator<Item = f64>, visit: &mut dyn FnMut(f64, Bend)) {
        let mut strip = 0;
        let mut before: Option<(f64, f64)> = None;
        for u in rows {
            let mut worst = Bend::default();
            if before.is_some() {
                worst = worst.max(self.bends[strip]);
            }
            while self.u[strip + 1] < u {
                strip += 1;
                worst = worst.max(self.bends[strip]);
            }
            let share = (u - self.u[strip]) / (self.u[strip + 1] - self.u[strip]);
            let t = self.t[strip] + share * (self.t[strip + 1] - self.t[strip]);
            if let Some((_, t_before)) = before {
                visit(t - t_before, worst);
            }
            before = Some((u, t));
            // A row on the edge of a strip belongs to the next.
            if self.u[strip + 1] <= u && strip + 1 < self.bends.len() {
                strip += 1;
            }
        }
    }
}

/// Which strips are worth halving.
fn coarse(strips: &[Strip]) -> Vec<bool> {
    let all = strips.iter().map(|strip| strip.gap() * strip.largest(|row| row.uu).sqrt()).sum::<f64>();
    let roundest = strips.iter().fold(0.0f64, |most, strip| most.max(strip.largest(|row| row.vv)));
    let is_coarse = |strip: &Strip| {
        let [_, uu, uv, vv] = strip.excess;
        let largest = strip.largest(|row| row.uu);
        let smallest = strip.at[0].uu.min(strip.at[1].uu);
        let waste = strip.gap() * (largest.sqrt() - smallest.sqrt());
        let rows = strip.gap() * uu.sqrt();
        (uu > REMAINDER * largest && rows > WASTE * all)
            || waste > WASTE * all
            || vv > REMAINDER * roundest
            || uv > REMAINDER * (strip.largest(|row| row.uv) + ((largest + uu) * roundest).sqrt())
    };
    strips.iter().map(is_coarse).collect()
}
