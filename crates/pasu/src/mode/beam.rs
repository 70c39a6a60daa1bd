//! A mode with rings: a beam under tension on an elastic foundation, held at every ring.
//!
//! Between two rings it is the mode problem of [`Equation`], on an interval whose length shortens the rates. The slopes at smooth rings and at free ends are what makes `q''` continuous there, or 0: one system
//! with three diagonals for the rings between two corners. In the language of approximation this is an interpolating L-spline of the operator (M. H. Schultz and R. S. Varga, *L-splines*, 1967); a cubic spline where all rates are 0.

use std::sync::Arc;

use super::equation::Equation;
use super::expansion::Expansion;
use super::force;
use super::order::Order;
use super::ring::{Free, Ring};
use super::series;
use super::solution::{ModeData, ModeSolution};
use super::stiffness::Stiffness;
use super::unsolvable::Unsolvable;
use crate::numeric::tridiagonal::Tridiagonal;

/// Rings nearer each other than this are refused: a slope, a value over a gap, would have fewer digits than a mesh shows.
pub(crate) const CLOSEST: f64 = 1e-6;

/// Lengths that differ by no more than this differ by the rounding of where rings are.
const SAME: f64 = 2.0 * f64::EPSILON;

/// How much the slopes of a beam that can swing may answer to what holds it: beyond this they cannot be told to the promised digits.
const RESONANCE: f64 = 1e5;

/// The equation of a mode between each two neighbours among the ends and the rings.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Beam {
    bays: Vec<Bay>,
    /// Smooth stretches from one corner or end to the next. None where there is nothing to find: no rings and no free ends, or order 2.
    chains: Vec<Chain>,
}

/// The beam between two neighbours.
#[derive(Debug, Clone, PartialEq)]
struct Bay {
    from: f64,
    to: f64,
    length: f64,
    /// In `(u - from) / length`; the same for all of one length.
    equation: Arc<Equation>,
}

/// Bays that are joined smoothly.
#[derive(Debug, Clone, PartialEq)]
struct Chain {
    /// Number of the first bay.
    first: usize,
    stiffnesses: Vec<Stiffness>,
    /// Whether the slope at either end is to be found as well.
    is_free: [bool; 2],
    /// For the slopes that are to be found.
    factors: Tridiagonal,
}

/// What is given of a beam.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Held<'a> {
    /// At the ends; slopes at free ends are not used.
    pub(crate) ends: ModeData<'a>,
    /// Values at the rings; all are 0 where there are none.
    pub(crate) rings: &'a [f64],
}

/// `q(u)` of a beam: its solutions bay by bay.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Deflection {
    pieces: Vec<ModeSolution>,
    /// `q'` at both ends of every bay, where there is more than one: neighbours have the same bits.
    slopes: Vec<[f64; 2]>,
}

/// Why a beam has no answer, and between which `u`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Broken {
    pub(crate) why: Unsolvable,
    /// The numbers of the ends and rings that it lies between: 0 is `u = 0`, 1 the first ring.
    pub(crate) between: [usize; 2],
}

// Called for every mode from several places, and each call is long: inlined they would weigh more than they save.
impl Beam {
    /// The equation of the mode with angular frequency `k` through these rings.
    #[inline(never)]
    pub(crate) fn new(order: Order, [s, t, w]: [f64; 3], k: f64, rings: &[Ring], free: Free) -> Result<Self, Broken> {
        let all = |why| Broken { why, between: [0, rings.len() + 1] };
        let [b, c] = Equation::coefficients(order, s, t, w, k).map_err(all)?;
        let places = || rings.iter().map(|ring| ring.u);
        let ends = places().chain([1.0]);
        let mut bays: Vec<Bay> = Vec::with_capacity(rings.len() + 1);
        for (index, (from, to)) in [0.0].into_iter().chain(places()).zip(ends).enumerate() {
            let broken = |why| Broken { why, between: [index, index + 1] };
            let length = to - from;
            if !(length >= CLOSEST) {
                return Err(broken(Unsolvable::Crowded));
            }
            // Rings are often evenly spaced.
            let equation = match bays.last().filter(|bay| (bay.length - length).abs() <= SAME) {
                Some(bay) => Arc::clone(&bay.equation),
                None => Arc::new(Equation::on(order, s, b, c, length).map_err(broken)?),
            };
            bays.push(Bay { from, to, length, equation });
        }
        let mut beam = Beam { bays, chains: Vec::new() };
        if order == Order::Fourth && (!rings.is_empty() || free != Free::default()) {
            let corners = rings.iter().enumerate().filter(|(_, ring)| ring.sharp).map(|(index, _)| index + 1);
            let (mut first, mut starts_free) = (0, free.start);
            for corner in corners {
                beam.add_chain([first, corner], [starts_free, true])?;
                (first, starts_free) = (corner, true);
            }
            beam.add_chain([first, rings.len() + 1], [starts_free, free.end])?;
        }
        Ok(beam)
    }

    #[inline(never)]
    fn add_chain(&mut self, between: [usize; 2], is_free: [bool; 2]) -> Result<(), Broken> {
        let bays = &self.bays[between[0]..between[1]];
        let mut stiffnesses: Vec<Stiffness> = Vec::with_capacity(bays.len());
        for (index, bay) in bays.iter().enumerate() {
            let before = index.checked_sub(1).filter(|before| Arc::ptr_eq(&bays[*before].equation, &bay.equation));
            stiffnesses.push(before.map_or_else(|| Stiffness::of(&bay.equation), |before| stiffnesses[before]));
        }
        let (mut rows, mut scales) = (vec![[0.0; 3]; bays.len() + 1], vec![0.0; bays.len() + 1]);
        for (index, (bay, stiffness)) in bays.iter().zip(&stiffnesses).enumerate() {
            let [near, far] = stiffness.near_and_far().map(|part| part / bay.length);
            rows[index][1] += near;
            rows[index][2] = far;
            rows[index + 1][0] = far;
            rows[index + 1][1] += near;
            let scale = near.abs().max(far.abs());
            scales[index] += scale;
            scales[index + 1] += scale;
        }
        let unknown = usize::from(!is_free[0])..rows.len() - usize::from(!is_free[1]);
        let resonant = Broken { why: Unsolvable::Resonant, between };
        if bays.iter().any(|bay| bay.equation.swing() > 0.0) {
            // In proportion to how stiff the beam is beside each ring.
            let scaled = unknown.clone().map(|index| {
                let root = |index: usize| scales.get(index).map_or(1.0, |scale: &f64| scale.sqrt());
                let by = [index.wrapping_sub(1), index, index + 1].map(|other| root(index) * root(other));
                core::array::from_fn(|column| rows[index][column] / by[column])
            });
            let factors = Tridiagonal::factors(&scaled.collect::<Vec<[f64; 3]>>()).ok_or(resonant)?;
            if !(factors.inverse_norm() < RESONANCE) {
                return Err(resonant);
            }
        }
        let factors = Tridiagonal::factors(&rows[unknown]).ok_or(Broken { why: Unsolvable::Overflow, between })?;
        self.chains.push(Chain { first: between[0], stiffnesses, is_free, factors });
        Ok(())
    }

    /// What it takes up under what is given.
    ///
    /// # Errors
    /// [`Unsolvable::Overflow`] if the solution leaves the range of doubles.
    #[inline(never)]
    pub(crate) fn solve(&self, held: &Held) -> Result<Deflection, Broken> {
        let Held { ends, rings } = *held;
        if let [Bay { equation, .. }] = &self.bays[..]
            && self.chains.is_empty()
        {
            let broken = |why| Broken { why, between: [0, 1] };
            return Ok(Deflection { pieces: vec![equation.solve(&ends).map_err(broken)?], slopes: Vec::new() });
        }
        if ends.is_zero() && rings.iter().all(|value| *value == 0.0) {
            let pieces = self.bays.iter().map(|_| ModeSolution::zero()).collect();
            return Ok(Deflection { pieces, slopes: vec![[0.0; 2]; self.bays.len()] });
        }
        let inner = (0..self.bays.len() - 1).map(|index| rings.get(index).copied().unwrap_or(0.0));
        let values: Vec<f64> = [ends.start].into_iter().chain(inner).chain([ends.end]).collect();
        let forces: Vec<Vec<f64>> = self.bays.iter().map(|bay| bay.force(ends.force)).collect();
        let mut slopes = vec![[0.0; 2]; self.bays.len()];
        slopes[0][0] = ends.start_u;
        slopes[self.bays.len() - 1][1] = ends.end_u;
        for chain in &self.chains {
            let bays = chain.first..chain.first + chain.stiffnesses.len();
            chain.find_slopes(
                &self.bays[bays.clone()],
                &values[chain.first..],
                &forces[bays.clone()],
                &mut slopes[bays],
            );
        }
        let mut pieces = Vec::with_capacity(self.bays.len());
        for (index, (bay, force)) in self.bays.iter().zip(&forces).enumerate() {
            let [start_u, end_u] = slopes[index].map(|slope| slope * bay.length);
            let data = ModeData { start: values[index], end: values[index + 1], start_u, end_u, force };
            let broken = |why| Broken { why, between: [index, index + 1] };
            pieces.push(bay.equation.solve(&data).map_err(broken)?);
        }
        Ok(Deflection { pieces, slopes })
    }

    /// The equation where it is the same from end to end.
    fn single(&self) -> Option<&Equation> {
        match &self.bays[..] {
            [bay] => Some(&bay.equation),
            _ => None,
        }
    }

    /// Whether every ring is a corner, as those of order 2 are.
    pub(crate) fn has_corners(&self) -> bool {
        self.bays.len() > 1 && self.chains.is_empty()
    }

    /// The number of the bay at `u`; at a ring the one behind it.
    fn bay_at(&self, u: f64) -> usize {
        self.bays.partition_point(|bay| bay.from <= u).saturating_sub(1)
    }

    /// Several deflections at `u` in [0, 1], each with its derivatives up to order `N - 1`; at a ring on the side of larger `u`.
    pub(crate) fn jets<const N: usize, const M: usize>(&self, of: [&Deflection; M], u: f64) -> [[f64; N]; M] {
        self.jets_in(self.bay_at(u), of, u)
    }

    /// As [`Beam::jets`], by the closed form of the bays in `[low, high]` alone, which goes on beyond them: at `high` it is the side of smaller `u`.
    pub(crate) fn jets_along<const N: usize, const M: usize>(
        &self,
        of: [&Deflection; M],
        u: f64,
        [low, high]: [f64; 2],
    ) -> [[f64; N]; M] {
        let index = self.bay_at(u.min(high.next_down()).max(low));
        let x = self.bays.get(index).map_or(0.0, |bay| bay.beyond(u));
        self.jets_of(index, of, x)
    }

    fn jets_in<const N: usize, const M: usize>(&self, index: usize, of: [&Deflection; M], u: f64) -> [[f64; N]; M] {
        let x = self.bays.get(index).map_or(0.0, |bay| bay.within(u));
        self.jets_of(index, of, x)
    }

    fn jets_of<const N: usize, const M: usize>(&self, index: usize, of: [&Deflection; M], x: f64) -> [[f64; N]; M] {
        let Some(bay) = self.bays.get(index) else { return [[0.0; N]; M] };
        let mut jets = bay.equation.jets::<N, M>(of.map(|deflection| &deflection.pieces[index]), x);
        if self.bays.len() == 1 && self.chains.is_empty() {
            return jets;
        }
        for (jet, deflection) in jets.iter_mut().zip(of) {
            bay.lengthen(jet);
            let end = [0.0, 1.0].into_iter().position(|end| x == end);
            if let (Some(end), Some(slope), Order::Fourth) = (end, jet.get_mut(1), bay.equation.order) {
                *slope = deflection.slopes[index][end];
            }
        }
        jets
    }

    /// Bounds of `|q|` and its derivatives up to order `N - 1` on all of `[from, to]`, a part of [0, 1], for several deflections. At a ring they are those of the side on which the rest of it lies.
    pub(crate) fn suprema<const N: usize, const M: usize>(
        &self,
        of: [&Deflection; M],
        from: f64,
        to: f64,
    ) -> [[f64; N]; M] {
        let mut suprema = [[0.0f64; N]; M];
        let first = self.bay_at(from);
        let among = self.bays.iter().enumerate().skip(first);
        let among = among.take_while(|(index, bay)| *index == first || bay.from < to);
        for (index, bay) in among {
            let pieces = of.map(|deflection| &deflection.pieces[index]);
            let mut here = bay.equation.suprema::<N, M>(pieces, bay.within(from), bay.within(to));
            for (most, here) in suprema.iter_mut().zip(&mut here) {
                bay.lengthen(here);
                for (most, here) in most.iter_mut().zip(here) {
                    *most = if here.is_nan() { f64::INFINITY } else { most.max(*here) };
                }
            }
        }
        suprema
    }

    /// The size of the fastest rate, as [`Equation::largest_rate`].
    pub(crate) fn largest_rate(&self) -> f64 {
        self.bays.first().map_or(0.0, |bay| bay.equation.largest_rate() / bay.length)
    }

    /// The rate of the fastest solution that swings without falling off, as [`Equation::swing`].
    pub(crate) fn swing(&self) -> f64 {
        self.bays.first().map_or(0.0, |bay| bay.equation.swing() / bay.length)
    }
}

impl Beam {
    /// The half-width of intervals on which few terms of a power series are enough for both, as [`Equation::reach`]. 0 where there are rings: a series ends at each.
    pub(crate) fn reach(&self, of: [&Deflection; 2]) -> f64 {
        let (Some(equation), [Some(one), Some(other)]) = (self.single(), of.map(Deflection::single)) else {
            return 0.0;
        };
        equation.reach(one).min(equation.reach(other))
    }

    /// The expansions of both about `centre`, as [`Equation::expansions`]; none where [`Beam::reach`] is 0.
    pub(crate) fn expansions(&self, of: [&Deflection; 2], centre: f64, half: f64) -> [Expansion; 2] {
        match (self.single(), of.map(Deflection::single)) {
            (Some(equation), [Some(one), Some(other)]) => equation.expansions([one, other], centre, half),
            _ => Default::default(),
        }
    }
}

impl Bay {
    /// Where `u` is between its ends, from 0 to 1.
    fn within(&self, u: f64) -> f64 {
        self.beyond(u).clamp(0.0, 1.0)
    }

    /// The same for any `u`.
    fn beyond(&self, u: f64) -> f64 {
        if u == self.to { 1.0 } else { (u - self.from) / self.length }
    }

    /// Derivatives in `u` from those in what runs from 0 to 1.
    fn lengthen<const N: usize>(&self, jet: &mut [f64; N]) {
        let mut power = 1.0;
        for value in jet.iter_mut().skip(1) {
            power *= self.length;
            *value /= power;
        }
    }

    /// A force on the whole beam as what acts on this bay's equation.
    #[inline(never)]
    fn force(&self, force: &[f64]) -> Vec<f64> {
        let power = match self.equation.order {
            Order::Second => self.length * self.length,
            Order::Fourth => (self.length * self.length) * (self.length * self.length),
        };
        let mut scale = power;
        series::about(force, self.from)
            .into_iter()
            .map(|coefficient| {
                let scaled = coefficient * scale;
                scale *= self.length;
                scaled
            })
            .collect()
    }
}

impl Chain {
    /// Slopes for which `q''` is continuous between the bays and 0 at free ends. Those given stand at the outer ends already.
    #[inline(never)]
    fn find_slopes(&self, bays: &[Bay], values: &[f64], forces: &[Vec<f64>], slopes: &mut [[f64; 2]]) {
        let n = bays.len();
        let given = [slopes[0][0], slopes[n - 1][1]];
        let known = |end: usize| if self.is_free[end] { 0.0 } else { given[end] };
        // What would bend a beam whose unknown slopes are 0.
        let mut unbalanced = vec![0.0; n + 1];
        for (index, ((bay, stiffness), force)) in bays.iter().zip(&self.stiffnesses).zip(forces).enumerate() {
            let particular = force::particular(&bay.equation, force);
            let [[p0, p0_u, p0_uu], [p1, p1_u, p1_uu]] = [0.0, 1.0].map(|x| series::jet::<3>(&particular, x));
            let start_u = if index == 0 { known(0) * bay.length } else { 0.0 };
            let end_u = if index + 1 == n { known(1) * bay.length } else { 0.0 };
            let by_values = [values[index] - p0, values[index + 1] - p1];
            let [start, end] = stiffness.second_derivatives(by_values, [start_u - p0_u, end_u - p1_u]);
            let square = bay.length * bay.length;
            unbalanced[index] += (start + p0_uu) / square;
            unbalanced[index + 1] -= (end + p1_uu) / square;
        }
        let unknown = usize::from(!self.is_free[0])..n + 1 - usize::from(!self.is_free[1]);
        self.factors.solve(&mut unbalanced[unknown.clone()]);
        for index in unknown {
            if index < n {
                slopes[index][0] = unbalanced[index];
            }
            if index > 0 {
                slopes[index - 1][1] = unbalanced[index];
            }
        }
    }
}

impl Deflection {
    /// Whether `q` is 0 everywhere.
    pub(crate) fn is_zero(&self) -> bool {
        self.pieces.iter().all(ModeSolution::is_zero)
    }

    /// The closed form where there is one from end to end.
    fn single(&self) -> Option<&ModeSolution> {
        match &self.pieces[..] {
            [piece] => Some(piece),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RINGS: [Ring; 4] = [
        Ring { u: 0.2, sharp: false },
        Ring { u: 0.201, sharp: true },
        Ring { u: 0.6, sharp: true },
        Ring { u: 0.9, sharp: false },
    ];

    fn held<'a>(force: &'a [f64], rings: &'a [f64]) -> Held<'a> {
        Held { ends: ModeData { start: 1.0, start_u: -3.0, end: -0.5, end_u: 2.0, force }, rings }
    }

    /// Inside of an interval, and up to the rings at its ends.
    #[test]
    fn nothing_between_is_larger() {
        let mut checked = 0;
        for order in [Order::Second, Order::Fourth] {
            for [t, w] in [[0.0, 0.0], [2.0, 1.0], [3.0, 0.0], [-2.0, 0.3], [1.0, 5.0], [60.0, 40.0]] {
                for k in [0.0, 1.0, 7.0, 60.0] {
                    let free = Free { start: false, end: order == Order::Fourth };
                    let Ok(beam) = Beam::new(order, [1.0, t, w], k, &RINGS, free) else { continue };
                    let Ok(solution) = beam.solve(&held(&[3.0, -20.0, 4.0], &[0.3, 0.31, -2.0, 1.0])) else { continue };
                    for (from, to) in [(0.0, 0.2), (0.1, 0.5), (0.2, 0.201), (0.6, 0.6), (0.25, 1.0), (0.0, 1.0)] {
                        let [suprema] = beam.suprema::<4, 1>([&solution], from, to);
                        for i in 0..=40 {
                            // Of the last place the side on which the interval lies.
                            let u = (from + (to - from) * f64::from(i) / 40.0).min(f64::max(to.next_down(), from));
                            let [jet] = beam.jets::<4, 1>([&solution], u);
                            for (value, supremum) in jet.iter().zip(suprema) {
                                let rounding = 1e-9 * (1.0 + supremum);
                                assert!(
                                    value.abs() <= supremum + rounding,
                                    "{order:?} t {t} w {w} k {k} at {u}: {jet:?}, {suprema:?}"
                                );
                            }
                            checked += 1;
                        }
                    }
                }
            }
        }
        assert!(checked > 8000);
    }

    #[test]
    fn without_rings_it_is_the_mode_problem_to_the_bit() {
        let held = held(&[1.0, 2.0], &[]);
        let beam = Beam::new(Order::Fourth, [1.5, 3.0, 2.0], 5.0, &[], Free::default()).unwrap();
        let equation = Equation::new(Order::Fourth, 1.5, 3.0, 2.0, 5.0).unwrap();
        let (deflection, solution) = (beam.solve(&held).unwrap(), equation.solve(&held.ends).unwrap());
        for i in 0..=64 {
            let u = f64::from(i) / 64.0;
            assert_eq!(beam.jets::<3, 1>([&deflection], u), equation.jets::<3, 1>([&solution], u));
        }
        assert_eq!(beam.largest_rate(), equation.largest_rate());
    }

    #[test]
    fn a_side_of_a_corner_is_next_to_it() {
        let beam =
            Beam::new(Order::Fourth, [1.0, 0.0, 0.0], 0.0, &RINGS[2..3], Free { start: true, end: true }).unwrap();
        let deflection = beam.solve(&held(&[], &[4.0])).unwrap();
        let slope = |u: f64| beam.jets::<2, 1>([&deflection], u)[0];
        assert_eq!(slope(0.6)[0], 4.0);
        let [before, after] = [slope(0.6_f64.next_down()), slope(0.6)].map(|jet| jet[1]);
        assert!((before - 5.0).abs() < 1e-13 && (after + 11.25).abs() < 1e-13, "{before} {after}");
    }
}
