//! Boundary data that are written out are pulled: a bump on the ring under the hand.

use core::f64::consts::TAU;

use glam::DVec3;

use super::bump::Bump;
use super::curve::under_hand;
use super::kept::kept;
use crate::design::{BoundaryValue, Component, Datum, Mode, RINGS, Ring, Span, rounded};
use crate::error::Result;
use crate::surface::Surface;

/// The same boundary data but for one curve, by which the point `at` comes to `to`: `d b(v - v0)` is added to it, with `b` the bump and `d` a vector.
///
/// The surface is linear in its data, so that `d` is the way of the point divided by how far a bump of height 1 moves it, component by component. Where no ring is near one is put where the surface is, which changes
/// nothing: the solution solves the new problem too, which has one solution.
pub(super) fn pull(
    problem: &BoundaryValue,
    at: [f64; 2],
    to: DVec3,
    bump: Bump,
    keep: &[String],
) -> Result<BoundaryValue> {
    let kept = kept(["x", "y", "z"], keep)?;
    let places = [0.0].into_iter().chain(problem.rings.iter().map(|ring| ring.u)).chain([1.0]);
    let (mut problem, curve) = match under_hand(places, at[0], problem.rings.len() < RINGS) {
        Some(curve) => (problem.clone(), curve),
        None => with_ring(problem, at[0])?,
    };
    let n_rings = problem.rings.len();
    let waves: Vec<(f64, f64, f64)> = waves(problem.span, bump, at[1]).collect();
    let modes = |by: f64| waves.iter().map(move |(n, cos, sin)| mode(*n, by * cos, by * sin, curve, n_rings));
    let answer = if place(&problem, curve) == rounded(at[0]) {
        [1.0; 3]
    } else {
        let mut unit = problem.clone();
        for component in [&mut unit.x, &mut unit.y, &mut unit.z] {
            component.modes = modes(1.0).collect();
        }
        position(&unit, at)?.to_array()
    };
    let way = (to - position(&problem, at)?).to_array();
    let components: [&mut Component; 3] = [&mut problem.x, &mut problem.y, &mut problem.z];
    for (((component, is_kept), way), answer) in components.into_iter().zip(kept).zip(way).zip(answer) {
        if !is_kept && way != 0.0 {
            component.modes.extend(modes(way / answer));
        }
    }
    Ok(problem)
}

/// The point `at`: on an end or a ring what is given there, without solving anything.
pub(super) fn position(problem: &BoundaryValue, [u, v]: [f64; 2]) -> Result<DVec3> {
    let Some(curve) = (0..problem.rings.len() + 2).find(|curve| place(problem, *curve) == rounded(u)) else {
        return Ok(Surface::solve(problem, "")?.at(u, v).position);
    };
    let turns = TAU * (v / problem.span.length());
    let sum = |component: &Component| {
        let mode = |mode: &Mode| {
            let [cos, sin] = [&mode.cos, &mode.sin].map(|datum| given(datum, curve, problem.rings.len()));
            cos * libm::cos(mode.n * turns) + sin * libm::sin(mode.n * turns)
        };
        component.modes.iter().map(mode).sum()
    };
    Ok(DVec3::new(sum(&problem.x), sum(&problem.y), sum(&problem.z)))
}

/// Where a curve is: 0 is the start, then come the rings, then the end.
fn place(problem: &BoundaryValue, curve: usize) -> f64 {
    match curve {
        0 => 0.0,
        ring => problem.rings.get(ring - 1).map_or(1.0, |ring| ring.u),
    }
}

/// What is given there, of so many rings; all are 0 where there are none.
fn given(datum: &Datum, curve: usize, n_rings: usize) -> f64 {
    match curve {
        0 => datum.start,
        ring if ring <= n_rings => datum.rings.get(ring - 1).copied().unwrap_or_default(),
        _ => datum.end,
    }
}

/// The same surface with one more ring, and the number of that among the ends and rings.
fn with_ring(problem: &BoundaryValue, u: f64) -> Result<(BoundaryValue, usize)> {
    let surface = Surface::solve(problem, "")?;
    let u = rounded(u);
    let mut more = problem.clone();
    let index = more.rings.partition_point(|ring| ring.u < u);
    more.rings.insert(index, Ring { u, sharp: false });
    for (component, terms) in [&mut more.x, &mut more.y, &mut more.z].into_iter().zip(surface.components()) {
        for mode in &mut component.modes {
            // A mode that is 0 everywhere has no term.
            let [cos, sin] = terms.iter().find(|term| term.n == mode.n).map_or([0.0; 2], |term| term.values(u));
            for (datum, value) in [(&mut mode.cos, cos), (&mut mode.sin, sin)] {
                datum.rings.resize(problem.rings.len(), 0.0);
                datum.rings.insert(index, value);
            }
        }
    }
    Ok((more, index + 1))
}

/// The waves of a bump about `v0`: `n`, and the factors of cosine and sine.
fn waves(span: Span, bump: Bump, v0: f64) -> impl Iterator<Item = (f64, f64, f64)> {
    let turns = TAU * (v0 / span.length());
    bump.waves().map(move |(n, amplitude)| {
        let n = f64::from(n);
        (n, amplitude * libm::cos(n * turns), amplitude * libm::sin(n * turns))
    })
}

/// One wave of one curve: 0 is the start, then come the rings, then the end.
fn mode(n: f64, cos: f64, sin: f64, curve: usize, n_rings: usize) -> Mode {
    let datum = |value: f64| match curve {
        0 => Datum { start: value, ..Datum::default() },
        ring if ring <= n_rings => {
            let mut rings = vec![0.0; n_rings];
            rings[ring - 1] = value;
            Datum { rings, ..Datum::default() }
        }
        _ => Datum { end: value, ..Datum::default() },
    };
    Mode { n, cos: datum(cos), sin: datum(sin) }
}
