//! What patches have in common on their grids.

use glam::DVec3;

use crate::numeric::signed_sets::SignedSets;
use crate::patch::{ENDS, Lines, Patch, Side, first_corners};

/// The grids of patches that share sides, one after the other in the same arrays.
pub(super) struct Seams<'a> {
    pub(super) patches: &'a [&'a dyn Patch],
    pub(super) lines: &'a [Lines],
    /// The first vertex of each grid.
    pub(super) firsts: &'a [usize],
}

impl Seams<'_> {
    /// For every side that two patches share the vertices of both, those that are one point beside each other: first those of the patch that has it.
    fn shared(&self) -> impl Iterator<Item = [Run; 2]> + '_ {
        let sides =
            self.patches.iter().enumerate().flat_map(|(patch, met)| {
                met.sides().into_iter().enumerate().map(move |(side, met)| (patch, side, met))
            });
        sides.filter_map(|(patch, side, met)| match met {
            // The first of the two has it.
            Side::Shared { patch: other, side: others, is_reversed } if (other, others) < (patch, side) => {
                let from = self.run(other, others)?;
                Some([if is_reversed { from.reversed() } else { from }, self.run(patch, side)?])
            }
            _ => None,
        })
    }

    fn run(&self, patch: usize, side: usize) -> Option<Run> {
        let (lines, first) = self.lines.get(patch).zip(self.firsts.get(patch))?;
        let run = Run::of(lines, side);
        Some(Run { first: run.first + first, ..run })
    }

    /// The vertex of corner number `4 patch + corner`.
    fn corner(&self, number: usize) -> usize {
        let Lines { u, v } = &self.lines[number / 4];
        let row = if number % 4 < 2 { 0 } else { u.len() - 1 };
        let column = if number.is_multiple_of(2) { 0 } else { v.len() - 1 };
        self.firsts[number / 4] + row * v.len() + column
    }

    /// Puts what is one point on one place, to the bit.
    pub(super) fn close(&self, positions: &mut [[f32; 3]]) {
        for [from, to] in self.shared() {
            for (to, from) in to.vertices().zip(from.vertices()) {
                positions[to] = positions[from];
            }
        }
        for (corner, first) in first_corners(self.patches).into_iter().enumerate() {
            positions[self.corner(corner)] = positions[self.corner(first)];
        }
    }

    /// For every vertex the one that stands for all that are the same point.
    pub(super) fn numbers(&self) -> Vec<u32> {
        let n: usize = self.lines.iter().map(Lines::n_vertices).sum();
        let mut numbers: Vec<u32> = (0..n as u32).collect();
        let own = self.patches.iter().enumerate().flat_map(|(patch, of)| {
            let sides = of.sides().into_iter().enumerate();
            sides.filter_map(move |(side, met)| match met {
                Side::Pole => {
                    let run = self.run(patch, side)?;
                    Some([Run { step: 0, ..run }, run])
                }
                // The opposite side has it.
                Side::Joined if side % 2 == 1 => Some([self.run(patch, side - 1)?, self.run(patch, side)?]),
                _ => None,
            })
        });
        for [from, to] in own.chain(self.shared()) {
            for (to, from) in to.vertices().zip(from.vertices()) {
                numbers[to] = from as u32;
            }
        }
        for (corner, first) in first_corners(self.patches).into_iter().enumerate() {
            numbers[self.corner(corner)] = self.corner(first) as u32;
        }
        // What is one point with the corner of a pole is so with whatever stands for that corner.
        for vertex in 0..n {
            numbers[vertex] = numbers[numbers[vertex] as usize];
        }
        numbers
    }

    /// Takes the mean of normals on either side of an edge that turn by less than an angle. At a corner all are taken together that lead to each other by such edges.
    pub(super) fn smooth(&self, normals: &mut [[f32; 3]], crease: f64) {
        let least = libm::cos(crease.min(core::f64::consts::PI));
        let is_smooth = |one: DVec3, other: DVec3| one.dot(other) > least;
        let mut corners = SignedSets::new(4 * self.patches.len());
        for (patch, met) in self.patches.iter().enumerate() {
            for (side, met) in met.sides().into_iter().enumerate() {
                let Side::Shared { patch: other, side: others, is_reversed } = met else { continue };
                for (place, corner) in ENDS[side].into_iter().enumerate() {
                    let there = 4 * other + ENDS[others][if is_reversed { 1 - place } else { place }];
                    let here = 4 * patch + corner;
                    if is_smooth(vector(normals[self.corner(here)]), vector(normals[self.corner(there)])) {
                        corners.join(here, there, false);
                    }
                }
            }
        }
        for [from, to] in self.shared() {
            for (one, other) in from.vertices().zip(to.vertices()).take(to.n.saturating_sub(1)).skip(1) {
                let (first, second) = (vector(normals[one]), vector(normals[other]));
                if is_smooth(first, second) {
                    let mean = single(first + second);
                    (normals[one], normals[other]) = (mean, mean);
                }
            }
        }
        let mut sums = vec![DVec3::ZERO; 4 * self.patches.len()];
        let tops: Vec<usize> = (0..sums.len()).map(|corner| corners.find(corner).0).collect();
        for (corner, top) in tops.iter().enumerate() {
            sums[*top] += vector(normals[self.corner(corner)]);
        }
        for (corner, top) in tops.into_iter().enumerate() {
            normals[self.corner(corner)] = single(sums[top]);
        }
    }
}

fn vector(normal: [f32; 3]) -> DVec3 {
    DVec3::from_array(normal.map(f64::from))
}

/// Of unit length; normals that are taken together and are all against each other have no direction.
fn single(sum: DVec3) -> [f32; 3] {
    sum.normalize_or(DVec3::Z).to_array().map(|x| x as f32)
}

/// The vertices of one side of a grid, one after the other.
#[derive(Debug, Clone, Copy)]
struct Run {
    first: usize,
    step: isize,
    n: usize,
}

impl Run {
    /// In the order of the parameter that runs along the side.
    fn of(lines: &Lines, side: usize) -> Run {
        let (rows, columns) = (lines.u.len(), lines.v.len());
        match side {
            0 => Run { first: 0, step: 1, n: columns },
            1 => Run { first: (rows - 1) * columns, step: 1, n: columns },
            2 => Run { first: 0, step: columns as isize, n: rows },
            _ => Run { first: columns - 1, step: columns as isize, n: rows },
        }
    }

    fn reversed(self) -> Run {
        let last = (self.n as isize - 1).max(0);
        Run { first: self.first.wrapping_add_signed(last * self.step), step: -self.step, ..self }
    }

    fn vertices(self) -> impl Iterator<Item = usize> {
        (0..self.n as isize).map(move |i| self.first.wrapping_add_signed(i * self.step))
    }
}

/// The vertices of one side of a grid, in the order of the parameter that runs along it.
pub(super) fn along_side(lines: &Lines, side: usize) -> impl Iterator<Item = usize> + use<> {
    Run::of(lines, side).vertices()
}
