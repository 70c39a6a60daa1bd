//! Triangles that cross by less than the numbers of a file tell are mended: of the edges near by that can be flipped or collapsed so that fewer cross the one is that moves least.

use super::net::{Net, Step};
use crate::check;
use crate::watch;

/// What crosses more often is no matter of rounding.
const MOST_PAIRS: usize = 512;

/// So many steps are taken at most.
const MOST_STEPS: usize = 4 * MOST_PAIRS;

/// What triangles may cross: those of a net as they were before the last steps, and those that were made since.
struct Around {
    neighbours: check::Neighbours,
    numbers: Vec<u32>,
    first_made: u32,
}

impl Net<'_> {
    /// Mends triangles that cross, as far as that can be done; whether any was.
    pub(super) fn uncross(&mut self) -> bool {
        let numbers = self.kept();
        let triangles: Vec<[u32; 3]> = numbers.iter().map(|of| self.triangles[*of as usize]).collect();
        let (pairs, given_up) = check::crossings_soon(self.points, &triangles, |_| None, MOST_PAIRS + 1);
        if given_up.is_some() || pairs.len() > MOST_PAIRS {
            return false;
        }
        let mut waiting: Vec<[u32; 2]> =
            pairs.into_iter().map(|pair| pair.map(|index| numbers[index as usize])).collect();
        let neighbours = check::Neighbours::of(triangles.iter().map(|corners| self.corners(*corners)));
        let around = Around { neighbours, numbers, first_made: self.triangles.len() as u32 };
        let mut n_left = MOST_STEPS;
        // What could not be mended may be when what is beside it has been.
        loop {
            let mut is_any = false;
            let mut left = Vec::new();
            while let Some(pair) = waiting.pop().filter(|_| n_left > 0 && !watch::is_stopped()) {
                if pair.iter().any(|number| self.is_gone[*number as usize]) {
                    continue;
                }
                let Some(step) = self.mending(pair, &around) else {
                    left.push(pair);
                    continue;
                };
                n_left -= 1;
                is_any = true;
                let first = self.triangles.len() as u32;
                self.take(step);
                for number in first..self.triangles.len() as u32 {
                    let others = self.beside(self.triangles[number as usize], &around);
                    let against = check::Against::of(self.points, self.triangles[number as usize]);
                    let crosses = |of: &u32| *of != number && against.crosses(self.triangles[*of as usize]);
                    waiting.extend(others.into_iter().filter(crosses).map(|other| [number, other]));
                }
            }
            if !is_any {
                return self.triangles.len() as u32 > around.first_made;
            }
            waiting = left;
        }
    }

    /// Of all steps near two triangles that cross, after which fewer cross than before, the one that moves least.
    fn mending(&self, pair: [u32; 2], around: &Around) -> Option<Step> {
        let edges = pair.into_iter().flat_map(|number| {
            let [a, b, c] = self.triangles[number as usize];
            [[a, b, c], [b, c, a], [c, a, b]].map(|edge| (number, edge))
        });
        let steps = edges.flat_map(|(number, [a, b, c])| {
            let apex = |of: u32| self.triangles[of as usize].into_iter().find(|vertex| *vertex != a && *vertex != b);
            let other = self.across(number, [a, b]).and_then(|of| self.flipped(of, [b, a, apex(of)?]));
            [self.collapsed(a, b), self.collapsed(b, a), self.flipped(number, [a, b, c]), other]
        });
        let mut steps: Vec<Step> = steps.flatten().collect();
        steps.sort_by(|one, other| one.length.total_cmp(&other.length));
        steps.into_iter().find(|step| {
            let gone: Vec<[u32; 3]> = step.gone.iter().map(|of| self.triangles[*of as usize]).collect();
            let made: Vec<[u32; 3]> = step.made.iter().map(|(corners, _)| *corners).collect();
            let [before, after] = [gone, made].map(|some| self.n_crossings(&some, &step.gone, around));
            after < before
        })
    }

    /// How many pairs cross of some triangles, and of these and others but for some.
    fn n_crossings(&self, some: &[[u32; 3]], but: &[u32], around: &Around) -> usize {
        let crossing = |(at, one): (usize, &[u32; 3])| {
            let against = check::Against::of(self.points, *one);
            let others = self.beside(*one, around).into_iter().filter(|of| !but.contains(of));
            let others = others.map(|of| self.triangles[of as usize]);
            some[at + 1..].iter().copied().chain(others).filter(|other| against.crosses(*other)).count()
        };
        some.iter().enumerate().map(crossing).sum()
    }

    /// The triangles that one may cross.
    fn beside(&self, triangle: [u32; 3], around: &Around) -> Vec<u32> {
        let before = around.neighbours.beside(self.corners(triangle)).into_iter();
        let made = around.first_made..self.triangles.len() as u32;
        let all = before.map(|index| around.numbers[index as usize]).chain(made);
        all.filter(|of| !self.is_gone[*of as usize]).collect()
    }

    fn corners(&self, triangle: [u32; 3]) -> [[f32; 3]; 3] {
        triangle.map(|vertex| self.points[vertex as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_that_is_folded_back_by_rounding_is_turned_to_where_it_belongs() {
        // A tent whose front edge has a corner that is a few steps within the roof, where it should be on its border.
        let points = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.5, 1.0, 1.0], [0.5, 5e-7, 1.0], [0.5, 0.4, 0.0]];
        let triangles = [[0, 1, 2], [0, 3, 1], [3, 0, 4], [1, 3, 4], [2, 1, 4], [0, 2, 4]];
        assert!(check::closed(&triangles, points.len()).is_ok());
        let n_crossing = |triangles: &[[u32; 3]]| check::crossings_soon(&points, triangles, |_| None, 99).0.len();
        assert!(n_crossing(&triangles) > 0);
        let mut net = Net::of(&points, &triangles, &[7, 7, 1, 2, 3, 4]);
        assert!(net.uncross());
        let (found, labels): (Vec<[u32; 3]>, Vec<u32>) = net.kept().into_iter().map(|of| net.labelled(of)).unzip();
        assert_eq!((n_crossing(&found), found.len()), (0, 6));
        assert!(check::closed(&found, points.len()).is_ok());
        assert_eq!(labels.iter().filter(|label| **label == 7).count(), 2);
    }

    #[test]
    fn what_crosses_by_more_than_rounding_stays() {
        let tetrahedron = |x: f32| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
        let points: Vec<[f32; 3]> = [tetrahedron(0.0), tetrahedron(0.25)].concat();
        let one = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        let triangles: Vec<[u32; 3]> = [one, one.map(|corners| corners.map(|vertex| vertex + 4))].concat();
        let mut net = Net::of(&points, &triangles, &[0; 8]);
        assert!(!net.uncross());
        assert_eq!(net.kept().len(), 8);
    }
}
