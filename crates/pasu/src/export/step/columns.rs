//! The nodes round the faces of a solid, between which splines run.

use std::f64::consts::TAU;

use glam::DVec3;

use super::spline::{Ends, basis, control_points, restricted};

/// The intervals that a turn begins with, and the fewest between two cuts.
const FIRST: usize = 16;
const FEWEST: usize = 4;

/// Values of `v` over one turn, common to all faces of a solid. Without cuts splines are closed round; with cuts one ends at each of them and the next begins: they follow faces that bend sharply there.
pub(super) struct Columns {
    /// From the first cut, or 0, to 2 pi beyond.
    pub(super) nodes: Vec<f64>,
    /// The numbers of the nodes where splines begin and the last one ends.
    breaks: Vec<usize>,
    is_closed: bool,
}

impl Columns {
    /// Those that a fit begins with. `cuts` ascend.
    pub(super) fn first(cuts: &[f64]) -> Columns {
        let start = cuts.first().copied().unwrap_or(0.0);
        let ends: Vec<f64> = cuts.iter().copied().chain([start + TAU]).collect();
        let mut nodes = vec![start];
        let mut breaks = vec![0];
        let mut from = start;
        for to in ends.into_iter().filter(|to| *to > start) {
            let n = (libm::ceil(FIRST as f64 * (to - from) / TAU) as usize).max(FEWEST);
            nodes.extend((1..n).map(|j| from + (to - from) * j as f64 / n as f64));
            nodes.push(to);
            breaks.push(nodes.len() - 1);
            from = to;
        }
        Columns { nodes, breaks, is_closed: cuts.is_empty() }
    }

    pub(super) fn n_intervals(&self) -> usize {
        self.nodes.len() - 1
    }

    /// Halves the intervals that are marked, as long as there are no more than so many nodes; whether there were any.
    pub(super) fn halve(&mut self, marked: &[bool], most: usize) -> bool {
        let ends: Vec<f64> = self.breaks.iter().map(|node| self.nodes[*node]).collect();
        if !halved(&mut self.nodes, marked, most) {
            return false;
        }
        self.breaks = ends.iter().filter_map(|end| self.nodes.iter().position(|node| node == end)).collect();
        true
    }

    /// The control points of the curve through a point at each node: two more than nodes for each spline.
    pub(super) fn control_points(&self, points: &[DVec3]) -> Vec<DVec3> {
        let ends = if self.is_closed { Ends::Closed } else { Ends::Open };
        let splines = self.breaks.windows(2);
        splines
            .flat_map(|pair| control_points(&self.nodes[pair[0]..=pair[1]], &points[pair[0]..=pair[1]], &ends))
            .collect()
    }

    /// A point of a curve in an interval, and its derivative.
    pub(super) fn point(&self, control: &[DVec3], interval: usize, v: f64) -> (DVec3, DVec3) {
        let (spline, from, to) = self.spline(interval);
        let first = interval + 3 * spline;
        let mut found = (DVec3::ZERO, DVec3::ZERO);
        for (r, (value, slope)) in basis(&self.nodes[from..=to], interval - from, v).into_iter().enumerate() {
            found.0 += value * control[first + r];
            found.1 += slope * control[first + r];
        }
        found
    }

    /// The control points of the part of a curve between two nodes of one spline.
    pub(super) fn within(&self, control: &[DVec3], first: usize, last: usize) -> Vec<DVec3> {
        let (spline, from, to) = self.spline(first);
        let own = &control[from + 3 * spline..=to + 3 * spline + 2];
        restricted(&self.nodes[from..=to], own, first - from, last - from)
    }

    /// The nodes at which panels of at most so many intervals begin and the last one ends.
    pub(super) fn panels(&self, most: usize) -> Vec<usize> {
        let within = self.breaks.windows(2).flat_map(|pair| {
            let (from, length) = (pair[0], pair[1] - pair[0]);
            let n_panels = length.div_ceil(most);
            (0..n_panels).map(move |panel| from + panel * length / n_panels)
        });
        within.chain([self.n_intervals()]).collect()
    }

    /// The number of the spline that an interval is in, and the nodes at its ends.
    fn spline(&self, interval: usize) -> (usize, usize, usize) {
        let spline = self.breaks[1..].iter().take_while(|end| **end <= interval).count();
        (spline, self.breaks[spline], self.breaks[spline + 1])
    }
}

/// A place within an interval.
pub(super) fn between(nodes: &[f64], interval: usize, part: f64) -> f64 {
    nodes[interval] + part * (nodes[interval + 1] - nodes[interval])
}

/// Halves the intervals that are marked, as long as there is room; whether there were any.
pub(super) fn halved(nodes: &mut Vec<f64>, marked: &[bool], most: usize) -> bool {
    let n_marked = marked.iter().filter(|marked| **marked).count();
    if n_marked == 0 || nodes.len() + n_marked > most {
        return false;
    }
    let mut finer = vec![nodes[0]];
    for (interval, marked) in marked.iter().enumerate() {
        if *marked {
            finer.push(between(nodes, interval, 0.5));
        }
        finer.push(nodes[interval + 1]);
    }
    *nodes = finer;
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A curve that turns sharply at 1 and 4.
    fn bent(v: f64) -> DVec3 {
        let v = if v >= TAU { v - TAU } else { v };
        let height = if (1.0..4.0).contains(&v) { libm::sin(TAU * (v - 1.0) / 6.0) } else { 0.0 };
        DVec3::new(libm::cos(v), libm::sin(v), height)
    }

    fn off(columns: &Columns) -> f64 {
        let points: Vec<DVec3> = columns.nodes.iter().map(|v| bent(*v)).collect();
        let control = columns.control_points(&points);
        let mut most = 0.0f64;
        for interval in 0..columns.n_intervals() {
            for part in [0.1, 0.5, 0.8] {
                let v = between(&columns.nodes, interval, part);
                let (found, slope) = columns.point(&control, interval, v);
                let (next, _) = columns.point(&control, interval, v + 1e-6);
                assert!(((next - found) / 1e-6 - slope).length() < 1e-4, "{interval}");
                most = most.max((found - bent(v)).length());
            }
        }
        most
    }

    #[test]
    fn splines_follow_a_curve_that_is_bent_at_the_cuts() {
        let mut columns = Columns::first(&[1.0, 4.0]);
        assert_eq!((columns.nodes[0], columns.nodes[columns.n_intervals()]), (1.0, 1.0 + TAU));
        let before = off(&columns);
        assert!(columns.halve(&vec![true; columns.n_intervals()], 1000));
        let after = off(&columns);
        assert!(before < 1e-3 && after < before / 12.0, "{before} {after}");
        assert!(off(&Columns::first(&[])) > 0.02, "closed round it is rounded off");
    }

    #[test]
    fn a_panel_is_within_one_spline() {
        let mut columns = Columns::first(&[1.0, 4.0]);
        columns.halve(&vec![true; columns.n_intervals()], 1000);
        let panels = columns.panels(5);
        assert!(panels.windows(2).all(|pair| pair[1] - pair[0] <= 5 && pair[1] > pair[0]));
        for cut in [1.0, 4.0, 1.0 + TAU] {
            assert!(panels.iter().any(|node| columns.nodes[*node] == cut));
        }
        let points: Vec<DVec3> = columns.nodes.iter().map(|v| bent(*v)).collect();
        let control = columns.control_points(&points);
        for pair in panels.windows(2) {
            let part = columns.within(&control, pair[0], pair[1]);
            assert_eq!(part.len(), pair[1] - pair[0] + 3);
            for (point, node) in [(part[0], pair[0]), (part[part.len() - 1], pair[1])] {
                assert!((point - points[node]).length() < 1e-15);
            }
        }
    }
}
