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

    /// The sides of these patches that others share, as [`Seams::shared`] has them and in its order, each with both patches.
    #[cfg(feature = "patchwork")]
    fn shared_by(&self, patches: &[usize]) -> Vec<(Joint, [Run; 2])> {
        let mut joints: Vec<Joint> = Vec::new();
        for patch in patches {
            let sides = self.patches.get(*patch).map_or([Side::Free; 4], |of| of.sides());
            for (side, met) in sides.into_iter().enumerate() {
                if let Side::Shared { patch: other, side: others, is_reversed } = met {
                    let (to, from) = ((*patch, side).max((other, others)), (*patch, side).min((other, others)));
                    joints.push(Joint { to, from, is_reversed });
                }
            }
        }
        joints.sort_unstable();
        joints.dedup();
        let runs = |joint: Joint| {
            let (from, to) = (self.run(joint.from.0, joint.from.1)?, self.run(joint.to.0, joint.to.1)?);
            Some((joint, [if joint.is_reversed { from.reversed() } else { from }, to]))
        };
        joints.into_iter().filter_map(runs).collect()
    }

    /// As [`Seams::close`], where these patches alone are others than before.
    #[cfg(feature = "patchwork")]
    pub(super) fn close_some(&self, changed: &[usize], corners: &Corners, positions: &mut [[f32; 3]]) {
        for (_, [from, to]) in self.shared_by(changed) {
            for (to, from) in to.vertices().zip(from.vertices()) {
                positions[to] = positions[from];
            }
        }
        for first in corners.of_patches(changed) {
            for corner in corners.alike(first) {
                positions[self.corner(*corner)] = positions[self.corner(first)];
            }
        }
    }

    /// As [`Seams::smooth`], where these patches alone are others than before: `raw` are all normals before they are smoothed. Returns the patches of which a normal may be another, ascending.
    #[cfg(feature = "patchwork")]
    pub(super) fn smooth_some(
        &self,
        changed: &[usize],
        corners: &Corners,
        raw: &[[f32; 3]],
        normals: &mut [[f32; 3]],
        crease: f64,
    ) -> Vec<usize> {
        let is_smooth = smoothness(crease);
        let mut written = changed.to_vec();
        for patch in changed {
            let range = self.firsts[*patch]..self.firsts[*patch] + self.lines[*patch].n_vertices();
            normals[range.clone()].copy_from_slice(&raw[range]);
        }
        for (joint, [from, to]) in self.shared_by(changed) {
            written.extend([joint.from.0, joint.to.0]);
            for (one, other) in from.vertices().zip(to.vertices()).take(to.n.saturating_sub(1)).skip(1) {
                let (first, second) = (vector(raw[one]), vector(raw[other]));
                (normals[one], normals[other]) = if is_smooth(first, second) {
                    let mean = single(first + second);
                    (mean, mean)
                } else {
                    (raw[one], raw[other])
                };
            }
        }
        for first in corners.of_patches(changed) {
            let alike = corners.alike(first);
            let mut sets = SignedSets::new(alike.len());
            for (place, here) in alike.iter().enumerate() {
                for there in self.beside(*here) {
                    if let Ok(other) = alike.binary_search(&there)
                        && is_smooth(vector(raw[self.corner(*here)]), vector(raw[self.corner(there)]))
                    {
                        sets.join(place, other, false);
                    }
                }
            }
            let tops: Vec<usize> = (0..alike.len()).map(|place| sets.find(place).0).collect();
            let mut sums = vec![DVec3::ZERO; alike.len()];
            for (corner, top) in alike.iter().zip(&tops) {
                sums[*top] += vector(raw[self.corner(*corner)]);
            }
            for (corner, top) in alike.iter().zip(&tops) {
                normals[self.corner(*corner)] = single(sums[*top]);
                written.push(corner / 4);
            }
        }
        written.sort_unstable();
        written.dedup();
        written
    }

    /// The corners of the patches across the sides that a corner is on.
    #[cfg(feature = "patchwork")]
    fn beside(&self, corner: usize) -> impl Iterator<Item = usize> {
        let sides = self.patches[corner / 4].sides();
        sides.into_iter().enumerate().filter_map(move |(side, met)| {
            let place = ENDS[side].iter().position(|end| *end == corner % 4)?;
            let Side::Shared { patch, side, is_reversed } = met else { return None };
            Some(4 * patch + ENDS[side][if is_reversed { 1 - place } else { place }])
        })
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
        let is_smooth = smoothness(crease);
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

/// Whether two normals turn by less than an angle.
fn smoothness(crease: f64) -> impl Fn(DVec3, DVec3) -> bool {
    let least = libm::cos(crease.min(core::f64::consts::PI));
    move |one, other| one.dot(other) > least
}

/// A side that two patches share, the second of which, by its number and that of its side, comes first: it takes what the first has.
#[cfg(feature = "patchwork")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Joint {
    to: (usize, usize),
    from: (usize, usize),
    is_reversed: bool,
}

/// Which corners of patches are one point: number `4 patch + corner`, as [`first_corners`] has them.
#[cfg(feature = "patchwork")]
#[derive(Debug)]
pub(super) struct Corners {
    first: Vec<usize>,
    /// Corners that are one point beside each other, ascending, and where those of each first corner begin and end.
    sorted: Vec<usize>,
    ranges: Vec<[u32; 2]>,
}

#[cfg(feature = "patchwork")]
impl Corners {
    pub(super) fn of(patches: &[&dyn Patch]) -> Corners {
        let first = first_corners(patches);
        let mut sorted: Vec<usize> = (0..first.len()).collect();
        sorted.sort_by_key(|corner| first[*corner]);
        let mut ranges = vec![[0; 2]; first.len()];
        for (place, corner) in sorted.iter().enumerate() {
            let range: &mut [u32; 2] = &mut ranges[first[*corner]];
            if range[1] == 0 {
                range[0] = place as u32;
            }
            range[1] = place as u32 + 1;
        }
        Corners { first, sorted, ranges }
    }

    /// The first corner of each point that is one of these patches', each once.
    fn of_patches(&self, patches: &[usize]) -> Vec<usize> {
        let corners = patches.iter().flat_map(|patch| self.first.get(4 * patch..4 * patch + 4).unwrap_or_default());
        let mut firsts: Vec<usize> = corners.copied().collect();
        firsts.sort_unstable();
        firsts.dedup();
        firsts
    }

    /// All corners that are one point with a first one, ascending.
    fn alike(&self, first: usize) -> &[usize] {
        let [from, to] = self.ranges.get(first).copied().unwrap_or_default();
        self.sorted.get(from as usize..to as usize).unwrap_or_default()
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
