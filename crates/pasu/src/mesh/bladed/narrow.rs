//! Triangles that are too narrow for single precision are done away with, one at a time: an edge is collapsed into one of its ends, or flipped to the other diagonal.
//!
//! What stays true throughout: the triangles are the boundary of one body, those of the curved side are seen from the origin, so that none crosses another, and those of the flat sides lie in their planes.

use std::collections::VecDeque;

use glam::DVec3;

use super::apart::apart;
use super::weaver::{Triangle, Weaver};
use crate::mesh::cleared::height;
use crate::watch;

/// A vertex with more triangles round it stays: every step at it would take as long as there are, and those at its neighbours do as well.
const MOST_ROUND: usize = 64;

/// How much wider the narrower of two triangles has to be after an edge has been flipped for that alone.
const WIDER: f64 = 1.01;

/// After so many triangles at which no step leaves fewer narrow ones no edge is flipped for that alone, which might go round in a circle, and after so many it is given up.
const MOST_FLIPS: usize = 2048;
const MOST_DETOURS: usize = 4096;

/// The mesh while triangles are done away with.
struct Net<'a> {
    places: &'a [DVec3],
    triangles: Vec<Triangle>,
    is_gone: Vec<bool>,
    /// How far the points of each triangle have been moved at most.
    drift: Vec<f64>,
    /// The triangles round each vertex.
    round: Vec<Vec<usize>>,
    /// The least height of a triangle.
    least: f64,
    /// No step moves a point further.
    reach: f64,
}

/// What a step leaves: triangles instead of others, and how far it moves a point at most.
struct Outcome {
    gone: Vec<usize>,
    made: Vec<(Triangle, f64)>,
    length: f64,
    /// How many narrow triangles it leaves.
    n_narrow: usize,
    /// The least height of those that are made.
    lowest: f64,
}

impl Weaver {
    /// Does away with all triangles lower than `least` by steps that move no point further than `reach`; returns how far a point of the surface has been moved at most, `None` where some cannot be spared.
    pub(super) fn without_narrow(&mut self, least: f64, reach: f64) -> Option<f64> {
        let triangles = std::mem::take(&mut self.triangles);
        let mut round = vec![Vec::new(); self.places.len()];
        for (number, triangle) in triangles.iter().enumerate() {
            triangle.corners.iter().for_each(|corner| round[*corner as usize].push(number));
        }
        let n = triangles.len();
        let mut net =
            Net { places: &self.places, triangles, is_gone: vec![false; n], drift: vec![0.0; n], round, least, reach };
        let is_clear = net.clear();
        let kept = net.is_gone.iter().zip(&net.drift).filter(|(is_gone, _)| !**is_gone);
        let drift = kept.fold(0.0, |most: f64, (_, drift)| most.max(*drift));
        let Net { triangles, is_gone, .. } = net;
        self.triangles =
            triangles.into_iter().zip(is_gone).filter_map(|(of, is_gone)| (!is_gone).then_some(of)).collect();
        is_clear.then_some(drift)
    }
}

impl Net<'_> {
    /// Takes steps while there are any; whether no triangle is narrow then.
    fn clear(&mut self) -> bool {
        let mut waiting: VecDeque<usize> = (0..self.triangles.len()).filter(|of| self.is_narrow(*of)).collect();
        let (mut n_stuck, mut n_detours) = (0, 0);
        while let Some(number) = waiting.pop_front() {
            if watch::is_stopped() {
                return false;
            }
            if self.is_gone[number] || !self.is_narrow(number) {
                continue;
            }
            let step = self.best(number).or_else(|| {
                n_detours += 1;
                self.wider(number).filter(|_| n_detours < MOST_FLIPS).or_else(|| self.fewer(number))
            });
            if n_detours > MOST_DETOURS {
                return false;
            }
            let Some(outcome) = step else {
                n_stuck += 1;
                waiting.push_back(number);
                if n_stuck > waiting.len() {
                    return false;
                }
                continue;
            };
            n_stuck = 0;
            let first = self.triangles.len();
            self.take(outcome);
            waiting.extend((first..self.triangles.len()).filter(|of| self.is_narrow(*of)));
        }
        true
    }

    fn height(&self, corners: [u32; 3]) -> f64 {
        let [a, b, c] = corners.map(|vertex| self.places[vertex as usize]);
        height(a, b, c)
    }

    fn is_narrow(&self, number: usize) -> bool {
        !(self.height(self.triangles[number].corners) >= self.least)
    }

    fn edges(&self, number: usize) -> [[u32; 3]; 3] {
        let [a, b, c] = self.triangles[number].corners;
        [[a, b, c], [b, c, a], [c, a, b]]
    }

    fn collapses(&self, number: usize) -> impl Iterator<Item = Outcome> {
        let both = |[a, b, _]: [u32; 3]| [self.collapsed(a, b), self.collapsed(b, a)];
        self.edges(number).into_iter().flat_map(both).flatten()
    }

    fn flips(&self, number: usize) -> impl Iterator<Item = Outcome> {
        self.edges(number).into_iter().filter_map(move |edge| self.flipped(number, edge))
    }

    /// Of all steps at a triangle that leave fewer narrow ones than before that which moves points least; where there is none at its own edges, of those that take one of its corners elsewhere.
    fn best(&self, number: usize) -> Option<Outcome> {
        let corners = self.triangles[number].corners;
        let elsewhere = corners.into_iter().flat_map(|from| {
            let others = self.neighbours(from).into_iter().filter(move |to| !corners.contains(to));
            others.filter_map(move |to| self.collapsed(from, to))
        });
        self.shortest(self.collapses(number).chain(self.flips(number))).or_else(|| self.shortest(elsewhere))
    }

    /// The flip after which what is narrow is less so.
    fn wider(&self, number: usize) -> Option<Outcome> {
        let is_wider = |step: &Outcome| step.length <= self.reach && step.lowest > WIDER * self.lowest(&step.gone);
        let wider = self.flips(number).filter(is_wider);
        wider.max_by(|one, other| one.lowest.total_cmp(&other.lowest))
    }

    /// The collapse that moves next to nothing and leaves the fewest narrow triangles, be they more than before: there is a vertex less.
    fn fewer(&self, number: usize) -> Option<Outcome> {
        self.collapses(number).filter(|step| step.length <= self.least).min_by_key(|step| step.n_narrow)
    }

    /// Of all that leave fewer narrow triangles than before that which moves points least.
    fn shortest(&self, outcomes: impl Iterator<Item = Outcome>) -> Option<Outcome> {
        let fewer = outcomes.filter(|outcome| {
            let before = outcome.gone.iter().filter(|of| self.is_narrow(**of)).count();
            outcome.length <= self.reach && outcome.n_narrow < before
        });
        fewer.min_by(|one, other| one.length.total_cmp(&other.length))
    }

    fn lowest(&self, all: &[usize]) -> f64 {
        all.iter().map(|of| self.height(self.triangles[*of].corners)).fold(f64::INFINITY, f64::min)
    }

    /// The vertices to which a vertex has an edge.
    fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let corners = self.round[vertex as usize].iter().flat_map(|of| self.triangles[*of].corners);
        let mut all: Vec<u32> = corners.filter(|of| *of != vertex).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn collapsed(&self, from: u32, to: u32) -> Option<Outcome> {
        let (own, goal) = (self.places[from as usize], self.places[to as usize]);
        // Tips and the origin stay, and what is in a plane stays in it.
        let is_corner = own == DVec3::ZERO || self.is_tip(from);
        if is_corner || (0..3).any(|axis| own[axis] == 0.0 && goal[axis] != 0.0) {
            return None;
        }
        if self.round[from as usize].len() > MOST_ROUND {
            return None;
        }
        // The ends of an edge that can be collapsed have two neighbours in common.
        let others = self.neighbours(to);
        let is_common = |vertex: &&u32| others.binary_search(vertex).is_ok();
        if self.neighbours(from).iter().filter(is_common).count() != 2 {
            return None;
        }
        let gone = self.round[from as usize].clone();
        let (lost, changed): (Vec<usize>, Vec<usize>) =
            gone.iter().copied().partition(|of| self.triangles[*of].corners.contains(&to));
        let length = self.moved(from, to, &gone, &changed)?;
        let mut made = Vec::new();
        for number in changed {
            let Triangle { corners, patch } = self.triangles[number];
            let mut drift = self.drift[number];
            // What is lost falls on the edge that it shares with this one.
            for lost in &lost {
                let n_shared = self.triangles[*lost].corners.iter().filter(|of| corners.contains(of)).count();
                if n_shared == 2 {
                    drift = drift.max(self.drift[*lost]);
                }
            }
            let corners = corners.map(|vertex| if vertex == from { to } else { vertex });
            made.push((Triangle { corners, patch }, drift + length));
        }
        self.outcome(gone, made, length)
    }

    /// How far the surface moves at most where the first vertex goes to the second; `None` where it would leave its edge.
    fn moved(&self, from: u32, to: u32, gone: &[usize], changed: &[usize]) -> Option<f64> {
        let (own, goal) = (self.places[from as usize], self.places[to as usize]);
        let (curved, flat): (Vec<usize>, Vec<usize>) =
            gone.iter().copied().partition(|of| self.triangles[*of].patch == 0);
        // On an axis it is the flat sides alone that are divided in another way.
        if curved.is_empty() {
            return Some(0.0);
        }
        let is_round = |all: &[usize], vertex: u32| all.iter().any(|of| self.triangles[*of].corners.contains(&vertex));
        let mut at = own;
        let mut length = 0.0;
        if !flat.is_empty() {
            // Along an edge it first goes to the line between its neighbours there.
            let corners = curved.iter().flat_map(|of| self.triangles[*of].corners);
            let before = corners.clone().find(|of| *of != from && *of != to && is_round(&flat, *of))?;
            if !(is_round(&curved, to) && is_round(&flat, to)) {
                return None;
            }
            let start = self.places[before as usize];
            let along = ((own - start).dot(goal - start) / (goal - start).length_squared()).clamp(0.0, 1.0);
            at = start + (goal - start) * along;
            length = at.distance(own);
        }
        let most = own.distance(goal);
        let old = curved.iter().map(|of| self.triangles[*of].corners);
        let new = changed.iter().filter(|of| self.triangles[**of].patch == 0).map(|of| self.triangles[*of].corners);
        let place = |vertex: u32| if vertex == from { at } else { self.places[vertex as usize] };
        let old: Vec<[DVec3; 3]> = old.map(|corners| corners.map(place)).collect();
        let new: Vec<[DVec3; 3]> =
            new.map(|corners| corners.map(|of| if of == from { goal } else { place(of) })).collect();
        Some(match apart(at, goal, &old, &new, self.least, flat.is_empty()) {
            Some(distance) => most.min(length + distance),
            None => most,
        })
    }

    fn flipped(&self, number: usize, [a, b, c]: [u32; 3]) -> Option<Outcome> {
        let is_other = |of: &usize| *of != number && self.triangles[*of].corners.contains(&b);
        let other = self.round[a as usize].iter().copied().find(is_other)?;
        let Triangle { corners, patch } = self.triangles[other];
        let d = corners.into_iter().find(|vertex| *vertex != a && *vertex != b)?;
        let [from, to, apex] = [a, b, c].map(|vertex| self.places[vertex as usize]);
        let along = (apex - from).dot(to - from) / (to - from).length_squared();
        let is_edge = self.round[c as usize].iter().any(|of| self.triangles[*of].corners.contains(&d));
        // The foot of the third corner is on the edge, which goes there.
        if is_edge || !(0.0 < along && along < 1.0) {
            return None;
        }
        let is_elsewhere = patch != 0 && apex[patch - 1] != 0.0;
        if is_elsewhere {
            return None;
        }
        let is_flat = patch != 0 && patch == self.triangles[number].patch;
        let length = if is_flat { 0.0 } else { apex.distance(from + (to - from) * along) };
        let drift = self.drift[number].max(self.drift[other]) + length;
        let made = [[a, d, c], [d, b, c]].map(|corners| (Triangle { corners, patch }, drift));
        self.outcome(vec![number, other], made.into(), length)
    }

    /// `None` where a triangle would be turned over.
    fn outcome(&self, gone: Vec<usize>, made: Vec<(Triangle, f64)>, length: f64) -> Option<Outcome> {
        let is_turned = made.iter().any(|(Triangle { corners, patch }, _)| {
            let [a, b, c] = corners.map(|vertex| self.places[vertex as usize]);
            let normal = (b - a).cross(c - a);
            match *patch {
                0 => !(normal.dot(a) > 0.0),
                flat => !(normal[flat - 1] < 0.0),
            }
        });
        if is_turned {
            return None;
        }
        let heights = made.iter().map(|(of, _)| self.height(of.corners));
        let lowest = heights.clone().fold(f64::INFINITY, f64::min);
        let n_narrow = heights.filter(|height| !(*height >= self.least)).count();
        Some(Outcome { gone, made, length, n_narrow, lowest })
    }

    fn take(&mut self, Outcome { gone, made, .. }: Outcome) {
        for number in gone {
            self.is_gone[number] = true;
            for corner in self.triangles[number].corners {
                self.round[corner as usize].retain(|of| *of != number);
            }
        }
        for (triangle, drift) in made {
            let number = self.triangles.len();
            triangle.corners.iter().for_each(|corner| self.round[*corner as usize].push(number));
            self.triangles.push(triangle);
            self.is_gone.push(false);
            self.drift.push(drift);
        }
    }

    fn is_tip(&self, vertex: u32) -> bool {
        let place = self.places[vertex as usize];
        let n_zero = (0..3).filter(|axis| place[*axis] == 0.0).count();
        let of_curved = |of: &usize| self.triangles[*of].patch == 0;
        n_zero == 2 && self.round[vertex as usize].iter().any(of_curved)
    }
}
