//! A model as spline patches or as polygons, shared along edges.

use std::collections::BTreeSet;

use pasu::Result;

use super::chart::{Cell, Chart, Layout};
use super::curve::along;
use super::edges::Link;
use super::point::{Point, minus, plus, sum};
use super::spline::{Basis, Row, inverse};
use super::truth::Truth;

/// What is laid over every chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// A patch of B-splines of a degree, by least squares.
    Spline(usize),
    /// Two triangles for every cell of a grid, whose points are on the truth.
    OnTruth,
    /// The same, by least squares.
    Between,
}

/// A way to lie over charts, and how finely: so many spans, or cells, along a side of a frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fit {
    pub(super) kind: Kind,
    pub(super) spans: f64,
}

/// A model as one of these.
pub(super) struct Fitted<'a> {
    fit: Fit,
    truth: &'a Truth<'a>,
    layout: &'a Layout,
    /// Lengths and middles of all edges, even along strips.
    even: (Vec<f64>, Vec<f64>),
    /// Points over each arc, with those at its ends.
    arcs: Vec<Vec<Point>>,
    laid: Vec<Laid>,
    /// For each patch its chart, where in it, and how it lies there.
    whereabouts: Vec<(usize, [usize; 2], Cell)>,
}

/// Links one after the other, with the even lengths and middles of their strips.
struct Run {
    links: Vec<Link>,
    starts: Vec<f64>,
    lengths: Vec<f64>,
    middles: Vec<f64>,
}

/// What lies over one chart, along x and y.
struct Laid {
    runs: [Run; 2],
    bases: [Basis; 2],
    /// By x, then by y.
    points: Vec<Point>,
}

impl Run {
    /// How far along the run a parameter of the link of this number is.
    fn position(&self, (link, s): (usize, f64)) -> f64 {
        self.starts[link] + self.lengths[link] * along(self.middles[link], s)
    }
}

impl Fit {
    fn degree(self) -> usize {
        if let Kind::Spline(degree) = self.kind { degree } else { 1 }
    }

    /// Where breaks are along a run: numbers of links, and parameters in them.
    fn breaks(self, run: &Run) -> Vec<(usize, f64)> {
        let n = run.links.len();
        let spans = ((self.spans * n as f64).round() as usize).max(1);
        let at = |k: usize| {
            let link = (k * n / spans).min(n - 1);
            (link, (k * n - link * spans) as f64 / spans as f64)
        };
        (0..=spans).map(at).collect()
    }

    fn basis(self, run: &Run) -> Basis {
        Basis::new(self.degree(), self.breaks(run).into_iter().map(|at| run.position(at)).collect())
    }

    /// Where the truth is looked at along a run.
    fn samples(self, run: &Run) -> Vec<(usize, f64)> {
        if self.kind == Kind::OnTruth {
            let breaks = self.breaks(run);
            return breaks[1..breaks.len() - 1].to_vec();
        }
        let n = (3.0 * (self.spans + self.degree() as f64)).ceil() as usize;
        (0..run.links.len() * n).map(|k| (k / n, ((k % n) as f64 + 0.5) / n as f64)).collect()
    }

    /// Lays it over all charts: first over the arcs between them, which neighbours have in common, then inside.
    ///
    /// # Errors
    /// When the truth has no such point.
    pub(super) fn over<'a>(self, truth: &'a Truth, layout: &'a Layout) -> Result<Fitted<'a>> {
        let lengths: Vec<f64> = truth.curves.iter().map(|curve| curve.length()).collect();
        let middles: Vec<f64> = truth.curves.iter().map(|curve| curve.middle()).collect();
        let mut fitted = Fitted {
            fit: self,
            truth,
            layout,
            even: truth.edges.even(&lengths, &middles),
            arcs: Vec::new(),
            laid: Vec::new(),
            whereabouts: Vec::new(),
        };
        fitted.arcs = layout.arcs.iter().map(|links| fitted.over_arc(links)).collect::<Result<_>>()?;
        fitted.laid = layout.charts.iter().map(|chart| fitted.over_chart(chart)).collect::<Result<_>>()?;
        let cells = layout.charts.iter().enumerate().flat_map(|(number, chart)| {
            let of_column = move |(i, column): (usize, &'a Vec<Cell>)| {
                column.iter().enumerate().map(move |(j, cell)| (number, [i, j], *cell))
            };
            chart.cells.iter().enumerate().flat_map(of_column)
        });
        fitted.whereabouts = cells.collect();
        fitted.whereabouts.sort_by_key(|(_, _, cell)| cell.patch);
        Ok(fitted)
    }
}

impl Fitted<'_> {
    fn run(&self, links: Vec<Link>) -> Run {
        let lengths: Vec<f64> = links.iter().map(|(edge, _)| self.even.0[*edge]).collect();
        let starts = (0..links.len()).map(|link| lengths[..link].iter().sum()).collect();
        let middle = |(edge, is_against): &Link| {
            let middle = self.even.1[*edge];
            if *is_against { 1.0 - middle } else { middle }
        };
        Run { starts, lengths, middles: links.iter().map(middle).collect(), links }
    }

    fn over_arc(&self, links: &[Link]) -> Result<Vec<Point>> {
        let run = self.run(links.to_vec());
        let (basis, samples) = (self.fit.basis(&run), self.fit.samples(&run));
        let rows: Vec<Row> = samples.iter().map(|at| basis.at(run.position(*at))).collect();
        let (first, last) = (self.on_edge(links, (0, 0.0))?, self.on_edge(links, (links.len() - 1, 1.0))?);
        let mut points = vec![[0.0; 3]; basis.len()];
        (points[0], points[basis.len() - 1]) = (first, last);
        let ends = |row: &Row| sum(&row.values, points[row.first..].iter().copied());
        let left = samples.iter().zip(&rows).map(|(at, row)| Ok(minus(self.on_edge(links, *at)?, ends(row))));
        let left = left.collect::<Result<Vec<Point>>>()?;
        for (place, weights) in inverse(&rows, basis.len()).iter().enumerate() {
            points[place + 1] = sum(weights, left.iter().copied());
        }
        Ok(points)
    }

    /// The point of the truth at a parameter of the link of this number.
    fn on_edge(&self, links: &[Link], (link, s): (usize, f64)) -> Result<Point> {
        let (edge, is_against) = links[link];
        let (patch, side) = self.truth.edges.patches[edge][0];
        let t = if is_against ^ self.truth.edges.of_patch[patch][side].1 { 1.0 - s } else { s };
        Ok(self.truth.points(patch, &[[[0.0, t], [1.0, t], [t, 0.0], [t, 1.0]][side]])?[0])
    }

    fn over_chart(&self, chart: &Chart) -> Result<Laid> {
        let in_direction = |(arc, is_against): Link| {
            let links = self.layout.arcs[arc].iter();
            match is_against {
                true => links.rev().map(|(edge, is_against)| (*edge, !is_against)).collect(),
                false => links.copied().collect(),
            }
        };
        let runs = [2, 0].map(|side| self.run(in_direction(chart.sides[side])));
        let bases = runs.each_ref().map(|run| self.fit.basis(run));
        let [n, m] = bases.each_ref().map(Basis::len);
        let mut points = vec![[0.0; 3]; n * m];
        for (side, (arc, is_against)) in chart.sides.into_iter().enumerate() {
            let count = self.arcs[arc].len();
            for (k, point) in self.arcs[arc].iter().enumerate() {
                let k = if is_against { count - 1 - k } else { k };
                points[[k, m * (n - 1) + k, m * k, m * k + m - 1][side]] = *point;
            }
        }
        let samples = runs.each_ref().map(|run| self.fit.samples(run));
        let rows: [Vec<Row>; 2] =
            [0, 1].map(|axis| samples[axis].iter().map(|at| bases[axis].at(runs[axis].position(*at))).collect());
        let [across, up] = [inverse(&rows[0], n), inverse(&rows[1], m)];
        let mut laid = Laid { runs, bases, points };
        // What the rim leaves: y first, then x.
        let mut lines = Vec::new();
        for ((i, x), row) in samples[0].iter().zip(&rows[0]) {
            let mut left = Vec::new();
            for same in samples[1].chunk_by(|one, other| one.0 == other.0) {
                let cell = chart.cells[*i][same[0].0];
                let at: Vec<[f64; 2]> = same.iter().map(|(_, y)| cell.point([*x, *y])).collect();
                for point in self.truth.points(cell.patch, &at)? {
                    left.push(minus(point, laid.at(row, &rows[1][left.len()])));
                }
            }
            lines.push(up.iter().map(|weights| sum(weights, left.iter().copied())).collect::<Vec<Point>>());
        }
        for (i, weights) in across.iter().enumerate() {
            for j in 0..m - 2 {
                laid.points[m * (i + 1) + j + 1] = sum(weights, lines.iter().map(|line| line[j]));
            }
        }
        Ok(laid)
    }

    /// Every point of it, once.
    pub(super) fn points(&self) -> Vec<Point> {
        let mut distinct = Vec::new();
        let mut seen = BTreeSet::new();
        for (links, points) in self.layout.arcs.iter().zip(&self.arcs) {
            let last = points.len() - 1;
            for (vertex, place) in
                [(self.truth.edges.start(links[0]), 0), (self.truth.edges.end(links[links.len() - 1]), last)]
            {
                if seen.insert(vertex) {
                    distinct.push(points[place]);
                }
            }
            distinct.extend(&points[1..last]);
        }
        for Laid { bases: [x, y], points, .. } in &self.laid {
            let (n, m) = (x.len(), y.len());
            distinct.extend((1..n - 1).flat_map(|i| &points[m * i + 1..m * i + m - 1]));
        }
        distinct
    }

    /// How many patches it is, or triangles.
    pub(super) fn pieces(&self) -> usize {
        let cells = |laid: &Laid| laid.bases.iter().map(|basis| basis.len() - 1).product::<usize>();
        match self.fit.kind {
            Kind::Spline(_) => self.laid.len(),
            _ => 2 * self.laid.iter().map(cells).sum::<usize>(),
        }
    }

    /// Where it is at points of a patch.
    pub(super) fn at(&self, patch: usize, at: &[[f64; 2]]) -> Vec<Point> {
        let (chart, [i, j], cell) = self.whereabouts[patch];
        let laid = &self.laid[chart];
        let one = |at: &[f64; 2]| {
            let [x, y] = cell.place(*at);
            let x = laid.bases[0].at(laid.runs[0].position((i, x)));
            let y = laid.bases[1].at(laid.runs[1].position((j, y)));
            if let Kind::Spline(_) = self.fit.kind { laid.at(&x, &y) } else { laid.in_triangles(&x, &y) }
        };
        at.iter().map(one).collect()
    }

    /// How far it is from the truth.
    ///
    /// # Errors
    /// When the truth has no such point.
    pub(super) fn rms(&self) -> Result<f64> {
        self.truth.rms(&mut |patch, at| Ok(self.at(patch, at)))
    }
}

impl Laid {
    fn at(&self, x: &Row, y: &Row) -> Point {
        let m = self.bases[1].len();
        let line = |i: usize| sum(&y.values, self.points[m * i + y.first..].iter().copied());
        sum(&x.values, (x.first..).map(line))
    }

    /// On the two triangles of the cell.
    fn in_triangles(&self, x: &Row, y: &Row) -> Point {
        let m = self.bases[1].len();
        let corner = |i: usize, j: usize| self.points[m * (x.first + i) + y.first + j];
        let (p, q) = (x.values[1], y.values[1]);
        let aside = if p >= q { corner(1, 0) } else { corner(0, 1) };
        let from = plus(corner(0, 0), minus(aside, corner(0, 0)), p.max(q));
        plus(from, minus(corner(1, 1), aside), p.min(q))
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::Model;
    use super::*;
    use crate::storage::truth::tests::torus;

    #[test]
    fn points_are_counted_once_as_one_counts_them_by_hand() {
        // Three by three frames: 16 corners, 24 edges, 9 insides.
        let model = torus(3);
        let truth = Truth::of(&model).unwrap();
        let each = Layout::of_each(&truth.edges);
        let largest = Layout::of_largest(&truth.edges);
        assert_eq!((each.charts.len(), each.arcs.len(), largest.charts.len(), largest.arcs.len()), (9, 24, 1, 4));
        let count = |kind, spans, layout| Fit { kind, spans }.over(&truth, layout).unwrap().points().len();
        assert_eq!(count(Kind::OnTruth, 4.0, &each), 13 * 13);
        assert_eq!(count(Kind::OnTruth, 4.0, &largest), 13 * 13);
        assert_eq!(count(Kind::Spline(2), 1.0, &each), 16 + 24 + 9);
        assert_eq!(count(Kind::Spline(3), 2.0, &each), 16 + 24 * 3 + 9 * 9);
        assert_eq!(count(Kind::Spline(3), 2.0, &largest), 9 * 9);
        assert_eq!(count(Kind::Spline(3), 1.0 / 3.0, &largest), 4 * 4);
    }

    #[test]
    fn splines_come_to_the_truth_faster_than_polygons_do_which_come_with_the_square() {
        let model = torus(3);
        let truth = Truth::of(&model).unwrap();
        let largest = Layout::of_largest(&truth.edges);
        let each = Layout::of_each(&truth.edges);
        // A patch of Gregory has no twist of its own at its corners, so that cubics do not come nearer any faster than parabolas.
        for (kind, layout, wanted) in [
            (Kind::Spline(2), &each, 2.5..3.1),
            (Kind::Spline(3), &each, 2.5..3.1),
            (Kind::OnTruth, &each, 1.9..2.1),
            (Kind::Between, &largest, 1.9..2.2),
        ] {
            let rms = |spans| Fit { kind, spans }.over(&truth, layout).unwrap().rms().unwrap();
            let [coarse, fine] = [2.0, 4.0].map(rms);
            assert!(wanted.contains(&(coarse / fine).log2()), "{kind:?} {coarse} {fine}");
        }
        let [on, between] = [Kind::OnTruth, Kind::Between]
            .map(|kind| Fit { kind, spans: 3.0 }.over(&truth, &each).unwrap().rms().unwrap());
        assert!(between < 0.7 * on, "{on} {between}");
    }

    #[test]
    fn what_lies_over_frames_holds_together_along_their_edges() {
        let models = Model::all(super::super::MODELS).unwrap();
        for model in models.iter().filter(|model| model.frames.len() > 1) {
            let truth = Truth::of(model).unwrap();
            for layout in [Layout::of_each(&truth.edges), Layout::of_largest(&truth.edges)] {
                // Between two charts lies one arc, the whole of it on either side.
                let mut charts = vec![0; layout.arcs.len()];
                layout.charts.iter().flat_map(|chart| chart.sides).for_each(|(arc, _)| charts[arc] += 1);
                for (arc, charts) in layout.arcs.iter().zip(charts) {
                    assert!(arc.iter().all(|(edge, _)| truth.edges.patches[*edge].len() == charts), "{}", model.name);
                }
                for (kind, spans) in [(Kind::Spline(2), 1.0), (Kind::OnTruth, 1.5)] {
                    let fitted = Fit { kind, spans }.over(&truth, &layout).unwrap();
                    for edge in 0..truth.edges.len() {
                        let at = |(patch, side): (usize, usize)| {
                            let t = if truth.edges.of_patch[patch][side].1 { 0.7 } else { 0.3 };
                            fitted.at(patch, &[[[0.0, t], [1.0, t], [t, 0.0], [t, 1.0]][side]])[0]
                        };
                        let points: Vec<Point> = truth.edges.patches[edge].iter().map(|place| at(*place)).collect();
                        let apart = points.iter().map(|point| super::super::point::length(minus(*point, points[0])));
                        assert!(apart.fold(0.0, f64::max) < 1e-6, "{} {edge} {points:?}", model.name);
                    }
                }
            }
        }
    }
}
