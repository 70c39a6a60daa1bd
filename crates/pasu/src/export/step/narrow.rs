//! Where a face is no wider than a curve on a part of the turn alone: there neighbours on both sides share their edges.

use std::f64::consts::TAU;

use super::fit::{Boundary, Fitted, Scaled, ScaledWalk, around};
use crate::face::ascending;
use crate::numeric::bisection;

/// Widths are looked at so often round a face, and between its seams.
const PLACES: usize = 256;
/// What is narrower than this part of the tolerance is a curve.
const NARROW: f64 = 0.1;
/// So often a place where a face becomes wide is halved.
const HALVINGS: usize = 48;
/// Parts of a turn that are shorter are left alone.
const SHORTEST: f64 = 1e-6;

/// The stretches of `v` on which a face is no wider than a curve, between 0 and 2 pi; a stretch that runs over the seam is two.
pub(super) struct Narrow {
    stretches: Vec<[f64; 2]>,
}

impl Narrow {
    /// Looks for them, for what is written within the tolerance.
    pub(super) fn of(face: &Scaled, tolerance: f64) -> Narrow {
        let most = NARROW * tolerance * face.looseness();
        let mut walk = face.walk();
        let mut is_narrow = |v: f64| width(&mut walk, v) <= most;
        let places = places(face);
        let mut stretches: Vec<[f64; 2]> = Vec::new();
        let mut since = is_narrow(places[0]).then_some(places[0]);
        for pair in places.windows(2) {
            let is_here = is_narrow(pair[1]);
            if is_here == since.is_some() {
                continue;
            }
            let ends = [(pair[0], !is_here), (pair[1], is_here)];
            let [low, high] = bisection::change(ends[0], ends[1], HALVINGS, &mut is_narrow, |here| *here != is_here);
            let narrow = if is_here { high.0 } else { low.0 };
            match since.take() {
                Some(from) => stretches.push([from, narrow]),
                None => since = Some(narrow),
            }
        }
        stretches.extend(since.map(|from| [from, TAU]));
        stretches.retain(|[from, to]| to - from > SHORTEST);
        Narrow { stretches }
    }

    /// The middles of the stretches on which it is wider, if there are narrow ones.
    pub(super) fn middles(&self) -> impl Iterator<Item = f64> {
        let next = self.stretches.iter().skip(1).chain(self.stretches.first());
        self.stretches.iter().zip(next).map(|([_, end], [start, _])| {
            let start = if start > end { *start } else { start + TAU };
            around(0.5 * (end + start))
        })
    }

    fn contains(&self, v: f64) -> bool {
        self.stretches.iter().any(|[from, to]| (*from..=*to).contains(&v))
    }

    /// Where stretches begin and end, within the turn.
    fn ends(&self) -> impl Iterator<Item = f64> {
        self.stretches.iter().flatten().copied().filter(|v| (SHORTEST..TAU - SHORTEST).contains(v))
    }
}

/// Whether it is wider than this anywhere.
pub(super) fn is_wide(face: &Scaled, most: f64) -> bool {
    let mut walk = face.walk();
    places(face).into_iter().any(|v| width(&mut walk, v) > most)
}

/// How wide a face is at one `v`.
fn width(walk: &mut ScaledWalk, v: f64) -> f64 {
    let start = walk.position(0.0, v);
    [0.5, 1.0].into_iter().map(|a| (walk.position(a, v) - start).length()).fold(0.0, f64::max)
}

/// Where widths are looked at: evenly, and halfway between two lines along which a face bends.
fn places(face: &Scaled) -> Vec<f64> {
    let mut places: Vec<f64> = (0..=PLACES).map(|k| TAU * k as f64 / PLACES as f64).collect();
    let round = face.face.seams().map(|seams| seams.round).unwrap_or_default();
    places.extend(round.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    if let (Some(first), Some(last)) = (round.first(), round.last()) {
        places.push(0.5 * first);
        places.push(0.5 * (last + TAU));
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// Where columns of the splines have to be, ascending.
pub(super) fn cuts(narrow: &[Narrow]) -> Vec<f64> {
    let mut cuts = ascending(narrow.iter().flat_map(Narrow::ends).collect());
    cuts.dedup_by(|next, before| *next - *before < SHORTEST);
    cuts
}

/// Which of several boundaries' edges and vertices are one, panel by panel.
pub(super) struct Joined {
    curves: Vec<Boundary>,
    /// For each panel and each curve the one whose edge is written.
    edges: Vec<Vec<usize>>,
    /// The same for the vertex at which the panel begins.
    vertices: Vec<Vec<usize>>,
    /// Face by face and panel by panel, whether it is there.
    is_wide: Vec<Vec<bool>>,
}

impl Joined {
    /// Joins what bounds faces where they are narrow. Of two curves the edge of that is kept for which `is_level` holds, which has to stay in its plane.
    pub(super) fn new(
        narrow: &[Narrow],
        boundaries: &[[Boundary; 2]],
        fitted: &Fitted,
        panels: &[usize],
        is_level: impl Fn(usize) -> bool,
    ) -> Joined {
        let mut curves: Vec<Boundary> = Vec::new();
        let mut ranks: Vec<bool> = Vec::new();
        for (face, ends) in boundaries.iter().enumerate() {
            for boundary in ends.iter().filter(|end| matches!(end, Boundary::Curve { .. })) {
                let known = curves.iter().position(|curve| curve == boundary).unwrap_or_else(|| {
                    curves.push(*boundary);
                    ranks.push(false);
                    curves.len() - 1
                });
                ranks[known] |= is_level(face);
            }
        }
        let n_panels = panels.len() - 1;
        let apart: Vec<usize> = (0..curves.len()).collect();
        let mut joined = Joined {
            edges: vec![apart.clone(); n_panels],
            vertices: vec![apart; n_panels],
            is_wide: vec![vec![true; n_panels]; boundaries.len()],
            curves,
        };
        for (face, (narrow, ends)) in narrow.iter().zip(boundaries).enumerate() {
            let [Some(near), Some(far)] = ends.map(|end| joined.number(end)) else { continue };
            for panel in 0..n_panels {
                let middle = 0.5 * (fitted.columns.nodes[panels[panel]] + fitted.columns.nodes[panels[panel + 1]]);
                if !narrow.contains(around(middle)) {
                    continue;
                }
                joined.is_wide[face][panel] = false;
                join(&mut joined.edges[panel], near, far, &ranks);
                for vertex in [panel, (panel + 1) % n_panels] {
                    join(&mut joined.vertices[vertex], near, far, &ranks);
                }
            }
        }
        joined
    }

    fn number(&self, boundary: Boundary) -> Option<usize> {
        self.curves.iter().position(|curve| *curve == boundary)
    }

    /// The boundary whose edge stands for that of this one.
    pub(super) fn edge(&self, boundary: Boundary, panel: usize) -> Boundary {
        self.number(boundary).map_or(boundary, |number| self.curves[self.edges[panel][number]])
    }

    /// The boundary whose vertex stands for that of this one, where a panel begins or the last one ends.
    pub(super) fn vertex(&self, boundary: Boundary, panel: usize) -> Boundary {
        let panel = panel % self.vertices.len();
        self.number(boundary).map_or(boundary, |number| self.curves[self.vertices[panel][number]])
    }

    /// Whether a face is there in a panel.
    pub(super) fn is_wide(&self, face: usize, panel: usize) -> bool {
        self.is_wide[face][panel]
    }

    /// Whether a face is there all round.
    pub(super) fn is_whole(&self, face: usize) -> bool {
        self.is_wide[face].iter().all(|is_wide| *is_wide)
    }
}

fn join(kept: &mut [usize], near: usize, far: usize, is_level: &[bool]) {
    let (near, far) = (kept[near], kept[far]);
    let [stays, goes] = if (is_level[far], near) > (is_level[near], far) { [far, near] } else { [near, far] };
    for kept in kept.iter_mut().filter(|kept| **kept == goes) {
        *kept = stays;
    }
}
