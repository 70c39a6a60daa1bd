//! A drawn line, by how far along it a point is.

use glam::DVec2;

/// Points nearer each other than this part of the length are one.
const SAME: f64 = 1e-12;

/// A line turns sharply where it does by more than this, in radians: 35 degrees.
const SHARP: f64 = 0.61;

/// A line of straight pieces from the foot to the rim, as radius and height.
#[derive(Debug, Clone)]
pub(super) struct Line {
    points: Vec<DVec2>,
    /// How far along each point is, from 0 to 1.
    along: Vec<f64>,
    length: f64,
}

/// The piece of a line that is nearest to a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearest {
    pub(super) piece: usize,
    pub(super) distance: f64,
}

impl Line {
    /// From its points in order; nothing where it has no length.
    pub(super) fn of(points: impl IntoIterator<Item = DVec2>) -> Option<Line> {
        let points: Vec<DVec2> = points.into_iter().collect();
        let whole: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let mut line = Line { points: Vec::with_capacity(points.len()), along: Vec::new(), length: 0.0 };
        for point in points {
            let gap = line.points.last().map_or(0.0, |last| last.distance(point));
            if line.points.is_empty() || gap > SAME * whole {
                line.length += gap;
                line.points.push(point);
                line.along.push(line.length);
            }
        }
        for along in &mut line.along {
            *along /= line.length;
        }
        (line.points.len() > 1 && line.length.is_finite()).then_some(line)
    }

    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// The point there.
    pub(super) fn at(&self, along: f64) -> DVec2 {
        let next = self.along.partition_point(|known| *known <= along).clamp(1, self.points.len() - 1);
        let [from, to] = [self.along[next - 1], self.along[next]];
        self.points[next - 1].lerp(self.points[next], ((along - from) / (to - from)).clamp(0.0, 1.0))
    }

    /// The points of it from one place to another, both among them.
    pub(super) fn between(&self, from: f64, to: f64) -> Vec<DVec2> {
        let first = self.along.partition_point(|along| *along <= from);
        let end = self.along.partition_point(|along| *along < to).max(first);
        let inner = self.points[first..end].iter().copied();
        core::iter::once(self.at(from)).chain(inner).chain([self.at(to)]).collect()
    }

    /// How far a point is from one of its pieces.
    pub(super) fn distance_of(&self, piece: usize, point: DVec2) -> f64 {
        let (from, to) = (self.points[piece], self.points[piece + 1]);
        let way = to - from;
        let part = ((point - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        (point - from - way * part).length()
    }

    /// The piece that is nearest to a point, or the first that is found no further away than is near enough; the sooner, the nearer the one that is looked at first.
    ///
    /// A piece that is so far along from a point of the line that its distance from there cannot make up for it is passed over.
    pub(super) fn nearest(&self, point: DVec2, first: usize, enough: f64) -> Nearest {
        let mut nearest = Nearest { piece: first, distance: self.distance_of(first, point) };
        let mut index = 0;
        while index + 1 < self.points.len() && nearest.distance > enough {
            let distance = self.distance_of(index, point);
            if distance < nearest.distance {
                nearest = Nearest { piece: index, distance };
            }
            index += 1;
            let too_far = self.points[index].distance(point) - nearest.distance;
            let beyond = self.along[index] + too_far / self.length;
            if too_far > 0.0 {
                // The piece on which the line may come near again.
                index = (self.along.partition_point(|along| *along <= beyond) - 1).max(index);
            }
        }
        nearest
    }

    /// Where it turns sharply, seen over this length to either side.
    pub(super) fn corners(&self, over: f64) -> Vec<f64> {
        let reach = over / self.length;
        let turn = |index: usize| {
            let (here, along) = (self.points[index], self.along[index]);
            let [before, after] = [here - self.at((along - reach).max(0.0)), self.at((along + reach).min(1.0)) - here];
            libm::fabs(libm::atan2(before.perp_dot(after), before.dot(after)))
        };
        let turns: Vec<f64> = (1..self.points.len() - 1).map(turn).collect();
        let mut corners: Vec<(f64, f64)> = Vec::new();
        for (along, turn) in self.along[1..].iter().zip(turns).filter(|(_, turn)| *turn > SHARP) {
            match corners.last_mut() {
                // Of neighbours that see the same corner, the sharpest.
                Some(last) if along - last.0 < reach => {
                    if turn > last.1 {
                        *last = (*along, turn);
                    }
                }
                _ => corners.push((*along, turn)),
            }
        }
        corners.into_iter().map(|(along, _)| along).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[[f64; 2]]) -> Line {
        Line::of(points.iter().map(|point| DVec2::from(*point))).unwrap()
    }

    #[test]
    fn it_is_run_through_evenly() {
        let bent = line(&[[1.0, 0.0], [1.0, 0.0], [4.0, 0.0], [4.0, 9.0]]);
        assert_eq!(bent.length(), 12.0);
        assert_eq!(
            [0.0, 0.125, 0.25, 0.5, 1.0].map(|along| bent.at(along).to_array()),
            [[1.0, 0.0], [2.5, 0.0], [4.0, 0.0], [4.0, 3.0], [4.0, 9.0]]
        );
        assert_eq!(bent.nearest(DVec2::new(0.0, -1.0), 1, 0.0).distance, 2f64.sqrt());
        assert_eq!(bent.nearest(DVec2::new(6.0, 5.0), 0, 0.0).distance, 2.0);
        assert_eq!(bent.nearest(DVec2::new(6.0, 5.0), 0, 9.0).piece, 0);
        let points =
            |from: f64, to: f64| bent.between(from, to).iter().map(|point| point.to_array()).collect::<Vec<_>>();
        assert_eq!(points(0.125, 0.5), [[2.5, 0.0], [4.0, 0.0], [4.0, 3.0]]);
        assert_eq!(points(0.5, 1.0), [[4.0, 3.0], [4.0, 9.0]]);
        assert!(Line::of([DVec2::ONE, DVec2::ONE]).is_none() && Line::of([]).is_none());
    }

    /// Against every piece.
    #[test]
    fn no_nearer_piece_is_passed_over() {
        let wavy = |i: i32| DVec2::new(3.0 + (0.4 * f64::from(i)).sin() * f64::from(i % 7), 0.1 * f64::from(i));
        let line = Line::of((0..300).map(wavy)).unwrap();
        for i in 0..200 {
            let point = DVec2::new(f64::from(i % 13) - 3.0, 0.17 * f64::from(i));
            let pieces = line.points.len() - 1;
            let each = (0..pieces).map(|piece| line.distance_of(piece, point)).fold(f64::INFINITY, f64::min);
            for first in [0, 90, pieces - 1] {
                let nearest = line.nearest(point, first, 0.0);
                assert!((nearest.distance - each).abs() < 1e-12, "{i} {first}");
                assert_eq!(line.distance_of(nearest.piece, point), nearest.distance);
            }
        }
    }

    #[test]
    fn corners_are_told_from_curves() {
        assert_eq!(line(&[[1.0, 0.0], [4.0, 0.0], [4.0, 9.0]]).corners(0.1), [0.25]);
        let round = (0..=90).map(|i| f64::from(i).to_radians()).map(|angle| DVec2::new(angle.cos(), angle.sin()));
        assert!(Line::of(round.clone()).unwrap().corners(0.1).is_empty());
        // A neck on a ball: one corner, whatever the points are.
        let necked: Vec<DVec2> = round.take(60).chain([DVec2::new(0.5, 3.0)]).collect();
        let corners = Line::of(necked).unwrap().corners(0.05);
        assert!(corners.len() == 1 && (corners[0] - 1.03 / 3.16).abs() < 0.02, "{corners:?}");
    }
}
