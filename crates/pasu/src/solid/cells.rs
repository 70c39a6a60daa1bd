//! Points sorted into cubes, so that those within a ball are found without looking at all.

use core::ops::ControlFlow;

use glam::DVec3;

use crate::watch;

/// There are no more cubes than this for each point.
const CUBES: f64 = 8.0;

/// Points in the cubes of an even grid over their bounding box.
#[derive(Debug)]
pub(super) struct Cells {
    low: DVec3,
    /// The edge of a cube.
    edge: f64,
    counts: [usize; 3],
    /// For each cube, x fastest, where its points begin in `points`; and at last where they all end.
    first: Vec<u32>,
    points: Vec<DVec3>,
}

impl Cells {
    /// The points in cubes with an edge of at least `edge`: half the radius of usual balls is a good one.
    pub(super) fn new(points: &[DVec3], edge: f64) -> Cells {
        let low = points.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let high = points.iter().copied().reduce(DVec3::max).unwrap_or_default();
        let extent = high - low;
        let least = extent.max_element() / libm::cbrt(CUBES * points.len() as f64);
        let edge = if edge.max(least) > 0.0 { edge.max(least) } else { 1.0 };
        let counts = extent.to_array().map(|length| libm::floor(length / edge) as usize + 1);
        let mut cells = Cells { low, edge, counts, first: Vec::new(), points: vec![DVec3::ZERO; points.len()] };
        let numbers: Vec<u32> = points.iter().map(|point| cells.number(cells.cube(*point)) as u32).collect();
        let mut first = vec![0; counts.iter().product::<usize>() + 1];
        numbers.iter().for_each(|number| first[*number as usize] += 1);
        let mut end = 0;
        for count in &mut first {
            end += *count;
            *count = end;
        }
        // Each cube is filled from its end, which in the end is where it begins.
        for (point, number) in points.iter().zip(&numbers).rev() {
            let slot = &mut first[*number as usize];
            *slot -= 1;
            cells.points[*slot as usize] = *point;
        }
        cells.first = first;
        cells
    }

    /// Calls with every point within a ball, and with some beyond, until told to stop.
    pub(super) fn near(&self, centre: DVec3, radius: f64, mut visit: impl FnMut(DVec3) -> ControlFlow<()>) {
        let [from, to] = [centre - DVec3::splat(radius), centre + DVec3::splat(radius)].map(|corner| self.cube(corner));
        for k in from[2]..=to[2] {
            for j in from[1]..=to[1] {
                let row = self.number([0, j, k]);
                // Cubes side by side along x follow each other.
                let points = self.first[row + from[0]] as usize..self.first[row + to[0] + 1] as usize;
                watch::work(1 + points.len() as u64);
                for point in &self.points[points] {
                    if visit(*point).is_break() {
                        return;
                    }
                }
            }
        }
    }

    /// The cube that holds a point, or is nearest to it.
    fn cube(&self, point: DVec3) -> [usize; 3] {
        let at = ((point - self.low) / self.edge).to_array();
        core::array::from_fn(|axis| (libm::floor(at[axis]).max(0.0) as usize).min(self.counts[axis] - 1))
    }

    fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        (k * self.counts[1] + j) * self.counts[0] + i
    }
}

/// The same points in ever smaller cubes: for a ball those are taken that are not much larger than it.
#[derive(Debug)]
pub(super) struct Ladder {
    /// The largest cubes first; at least one step.
    steps: Vec<Cells>,
}

/// By how much the cubes of a step are smaller.
const STEP: f64 = 4.0;

/// How many steps there are at most.
const STEPS: usize = 3;

impl Ladder {
    /// For balls up to a radius.
    pub(super) fn new(points: &[DVec3], largest: f64) -> Ladder {
        let mut steps = vec![Cells::new(points, largest / 2.0)];
        let mut edge = largest / 2.0;
        for _ in 1..STEPS {
            edge /= STEP;
            let finer = Cells::new(points, edge);
            if !steps.last().is_some_and(|step| finer.edge < step.edge) {
                break;
            }
            steps.push(finer);
        }
        Ladder { steps }
    }

    /// As [`Cells::near`].
    pub(super) fn near(&self, centre: DVec3, radius: f64, visit: impl FnMut(DVec3) -> ControlFlow<()>) {
        let step = self.steps.iter().rev().find(|step| STEP * step.edge >= radius).or(self.steps.first());
        if let Some(step) = step {
            step.near(centre, radius, visit);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_of_a_ball_is_found() {
        let turn = |i: usize, n: usize| i as f64 * 2.4 % n as f64 / n as f64;
        let points: Vec<DVec3> =
            (0..500).map(|i| DVec3::new(turn(i, 7), turn(3 * i, 11), turn(5 * i, 3)) * 9.0).collect();
        for edge in [0.0, 0.3, 2.0, 50.0] {
            let cells = Cells::new(&points, edge);
            for (centre, radius) in
                [(points[3], 0.4), (DVec3::splat(4.0), 2.5), (DVec3::splat(-20.0), 30.0), (DVec3::X, 0.0)]
            {
                let mut found = Vec::new();
                cells.near(centre, radius, |point| {
                    found.push(point);
                    ControlFlow::Continue(())
                });
                let within = |point: &&DVec3| point.distance(centre) <= radius;
                assert_eq!(found.iter().filter(within).count(), points.iter().filter(within).count());
            }
            let mut n = 0;
            cells.near(DVec3::ZERO, 1e9, |_| {
                n += 1;
                if n == 10 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            assert_eq!(n, 10);
        }
    }

    #[test]
    fn every_step_of_a_ladder_finds_them() {
        let points: Vec<DVec3> = (0..4000)
            .map(|i| DVec3::new(i as f64 * 0.37 % 1.0, i as f64 * 0.71 % 1.0, i as f64 * 0.13 % 1.0))
            .collect();
        let ladder = Ladder::new(&points, 1.0);
        assert_eq!(ladder.steps.len(), STEPS);
        for radius in [2.0, 0.9, 0.4, 0.1, 0.03] {
            let mut found = 0;
            ladder.near(points[9], radius, |point| {
                found += usize::from(point.distance(points[9]) <= radius);
                ControlFlow::Continue(())
            });
            assert_eq!(found, points.iter().filter(|point| point.distance(points[9]) <= radius).count(), "{radius}");
        }
    }

    #[test]
    fn points_in_one_place_are_held_in_one_cube() {
        let cells = Cells::new(&[DVec3::ONE; 4], 0.0);
        let mut n = 0;
        cells.near(DVec3::ONE, 0.0, |_| {
            n += 1;
            ControlFlow::Continue(())
        });
        assert_eq!(n, 4);
    }
}
