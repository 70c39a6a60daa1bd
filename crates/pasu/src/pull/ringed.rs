//! A pot of rings is pulled: a bump in the radius and the height of the ring under the hand.

use glam::{DVec2, DVec3};

use super::bump::Bump;
use super::curve::under_hand;
use super::kept::kept;
use crate::design::{Hoop, RINGS, Rings, Series, Slopes, Wave, rounded};
use crate::error::Result;
use crate::surface::Surface;

/// Steps of Newton's method at most; it converges in four or five.
const MOST_STEPS: usize = 60;

/// The hand is on a ring if it is no further away: documents have twelve digits.
const ON: f64 = 1e-12;

/// Waves smaller than this part of a ring are rounding.
const NOTHING: f64 = 1e-14;

/// The same pot but for one ring, and the `v` of the point that has come to `to`.
///
/// `d b(v - v0)` is added to the radius and to the height of the ring under the hand, with `b` the bump. What the hand moves round the axis moves the bump's centre: the point that comes to `to` is that of the
/// curve which stands beneath it, and `v0` is its place. The surface is linear in its data and, but for a turn, the same for every `v0`, so that `d` is the way of that point divided by how far a bump of
/// height 1 moves it.
///
/// Where no ring is near one is put where the surface is. That changes nothing where the rings are round. Waves of the radius are shifted round the axis between rings, by something in proportion to their
/// square, for which a ring has no numbers: that is lost.
pub(super) fn pull(pot: &Rings, [u, v]: [f64; 2], to: DVec3, bump: Bump, keep: &[String]) -> Result<(Rings, f64)> {
    let [keeps_r, keeps_z, keeps_v] = kept(["r", "z", "v"], keep)?;
    let has_room = pot.rings.len() < RINGS + 2;
    let (mut pot, index) = match under_hand(pot.rings.iter().map(|hoop| hoop.u), u, has_room) {
        Some(index) => (pot.clone(), index),
        None => with_ring(pot, u)?,
    };
    let track = Track::of(&pot, index, u, bump)?;
    let v0 = if keeps_v { v } else { track.beneath(v, to) };
    let way = to - track.curve.at(v0)[0];
    let hoop = &mut pot.rings[index];
    if !keeps_r {
        hoop.r.add(bump, v0, round_axis(v0)[0].dot(way.truncate()) / track.answer[0]);
    }
    if !keeps_z {
        hoop.z.add(bump, v0, way.z / track.answer[1]);
    }
    Ok((pot, v0))
}

/// The point `at`: on a ring what is given there, without solving anything.
pub(super) fn position(pot: &Rings, [u, v]: [f64; 2]) -> Result<DVec3> {
    match pot.rings.iter().find(|hoop| (hoop.u - u).abs() <= ON) {
        Some(hoop) => Ok(Curve::Ring(hoop.clone()).at(v)[0]),
        None => Ok(solved(pot)?.at(u, v).position),
    }
}

/// A curve of constant `u`, and how far a point at a bump's middle moves outwards and upwards for a bump of height 1.
struct Track {
    curve: Curve,
    answer: [f64; 2],
}

enum Curve {
    /// A ring itself: what it is given as, without solving anything.
    Ring(Hoop),
    Between {
        surface: Box<Surface>,
        u: f64,
    },
}

impl Curve {
    /// Position and derivative.
    fn at(&self, v: f64) -> [DVec3; 2] {
        match self {
            Curve::Ring(hoop) => {
                let ([r, r_v], [z, z_v], [out, on]) = (hoop.r.at(v), hoop.z.at(v), round_axis(v));
                [(out * r).extend(z), (out * r_v + on * r).extend(z_v)]
            }
            Curve::Between { surface, u } => {
                let jet = surface.at(*u, v);
                [jet.position, jet.dv]
            }
        }
    }
}

impl Track {
    fn of(pot: &Rings, index: usize, u: f64, bump: Bump) -> Result<Track> {
        let hoop = &pot.rings[index];
        if (hoop.u - u).abs() <= ON {
            return Ok(Track { curve: Curve::Ring(hoop.clone()), answer: [1.0; 2] });
        }
        let answer = solved(&silent(pot, index, bump))?.at(u, 0.0).position;
        Ok(Track { curve: Curve::Between { surface: Box::new(solved(pot)?), u }, answer: [answer.x, answer.z] })
    }

    /// The `v` nearest to that given at which the way from the curve to `to` leads neither onwards nor back: by Newton's method, halving steps that lead further from it.
    fn beneath(&self, v: f64, to: DVec3) -> f64 {
        let onwards = |v: f64| {
            let ([position, dv], [out, on]) = (self.curve.at(v), round_axis(v));
            let way = (to - position).truncate();
            (on.dot(way), -out.dot(way) - on.dot(dv.truncate()))
        };
        let (mut v, (mut off, mut slope)) = (v, onwards(v));
        for _ in 0..MOST_STEPS {
            let mut step = (-off / slope).clamp(-1.0, 1.0);
            let least = f64::EPSILON * (1.0 + v.abs());
            if !(step.abs() > least) {
                break;
            }
            let (next_off, next_slope) = loop {
                let next = onwards(v + step);
                if next.0.abs() <= off.abs() || step.abs() < least {
                    break next;
                }
                step *= 0.5;
            };
            (v, off, slope) = (v + step, next_off, next_slope);
        }
        v
    }
}

fn solved(pot: &Rings) -> Result<Surface> {
    Surface::solve(&pot.boundary_value(), "")
}

/// Outwards and onwards at `v`.
fn round_axis(v: f64) -> [DVec2; 2] {
    let (cos, sin) = (libm::cos(v), libm::sin(v));
    [DVec2::new(cos, sin), DVec2::new(-sin, cos)]
}

/// The same pot with a ring at `u` where the surface is, and its number.
fn with_ring(pot: &Rings, u: f64) -> Result<(Rings, usize)> {
    let surface = solved(pot)?;
    let u = rounded(u);
    let (mut r, mut z) = (Series { mean: 0.0, waves: Vec::new() }, Series { mean: 0.0, waves: Vec::new() });
    let [xs, ys, zs] = surface.components();
    // r = x cos v + y sin v, with products of waves written as sums.
    for (terms, is_x) in [(xs, true), (ys, false)] {
        for term in terms {
            let [cos, sin] = term.values(u);
            let (cos, sin) = (0.5 * cos, 0.5 * sin);
            let (above, below) = if is_x { ([cos, sin], [cos, sin]) } else { ([-sin, cos], [sin, -cos]) };
            r.add_wave(term.n + 1.0, above[0], above[1]);
            r.add_wave(term.n - 1.0, below[0], below[1]);
        }
    }
    for term in zs {
        let [cos, sin] = term.values(u);
        z.add_wave(term.n, cos, sin);
    }
    let size = r.mean.abs();
    for series in [&mut r, &mut z] {
        series.waves.retain(|wave| libm::hypot(wave.cos, wave.sin) > NOTHING * size);
    }
    let mut more = pot.clone();
    let index = more.rings.partition_point(|hoop| hoop.u < u);
    more.rings.insert(index, Hoop { u, r, z, sharp: false });
    Ok((more, index))
}

/// The same rings without data but for a bump of height 1 about `v = 0` in the radius and the height of one.
fn silent(pot: &Rings, index: usize, bump: Bump) -> Rings {
    let nothing = || Series { mean: 0.0, waves: Vec::new() };
    let mut silent = pot.clone();
    for (number, hoop) in silent.rings.iter_mut().enumerate() {
        (hoop.r, hoop.z) = (nothing(), nothing());
        if number == index {
            hoop.r.add(bump, 0.0, 1.0);
            hoop.z.add(bump, 0.0, 1.0);
        }
    }
    for slopes in [&mut silent.foot, &mut silent.rim].into_iter().flatten() {
        *slopes = Slopes { r: nothing(), z: nothing() };
    }
    silent
}

impl Series {
    /// Value and derivative.
    fn at(&self, v: f64) -> [f64; 2] {
        self.waves.iter().fold([self.mean, 0.0], |[value, slope], wave| {
            let (cos, sin) = (libm::cos(wave.n * v), libm::sin(wave.n * v));
            [value + wave.cos * cos + wave.sin * sin, slope + wave.n * (wave.sin * cos - wave.cos * sin)]
        })
    }

    /// Adds a bump of this height about `v0`.
    fn add(&mut self, bump: Bump, v0: f64, height: f64) {
        for (n, amplitude) in bump.waves() {
            let n = f64::from(n);
            let amplitude = height * amplitude;
            self.add_wave(n, amplitude * libm::cos(n * v0), amplitude * libm::sin(n * v0));
        }
    }

    /// Adds `cos cos(n v) + sin sin(n v)`; `n` may be -1, 0 and more.
    fn add_wave(&mut self, n: f64, cos: f64, sin: f64) {
        let (n, sin) = if n < 0.0 { (-n, -sin) } else { (n, sin) };
        if n == 0.0 {
            self.mean += cos;
            return;
        }
        match self.waves.iter_mut().find(|wave| wave.n == n) {
            Some(wave) => {
                wave.cos += cos;
                wave.sin += sin;
            }
            None => self.waves.push(Wave { n, cos, sin }),
        }
    }
}
