//! A mode with rings: a beam under tension on an elastic foundation, held at every ring.
//!
//! Between two rings it is the mode problem of [`Equation`], on an interval whose length shortens the rates. The slopes at smooth rings and at free ends are what makes `q''` continuous there, or 0: one system
//! with three diagonals for the rings between two corners. In the language of approximation this is an interpolating L-spline of the operator (M. H. Schultz and R. S. Varga, *L-splines*, 1967); a cubic spline where all rates are 0.

use core::ops::Range;
use std::sync::Arc;

use super::bays::{Bay, Bays};
use super::equation::Equation;
use super::expansion::Expansion;
use super::force;
use super::order::Order;
use super::ring::Free;
use super::roots::{rate_of, roots, swing};
use super::series;
use super::solution::{ModeData, ModeSolution};
use super::stiffness::Stiffness;
use super::unsolvable::Unsolvable;
use crate::numeric::tridiagonal::Tridiagonal;

/// How much the slopes of a beam that can swing may answer to what holds it: beyond this they cannot be told to the promised digits.
const RESONANCE: f64 = 1e5;

/// The equation of a mode between each two neighbours among the ends and the rings.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Beam {
    /// In `(u - from) / length`, for the first of the different lengths.
    equation: Equation,
    /// What there is besides where there are more bays than one, or slopes to be found. Most beams have none of it: they are the mode problem, and small.
    joints: Option<Box<Joints>>,
}

/// A beam beyond its first equation.
#[derive(Debug, Clone, PartialEq)]
struct Joints {
    bays: Arc<Bays>,
    /// For the other lengths.
    others: Vec<Equation>,
    /// One for every length; none where nothing is to be found.
    stiffnesses: Vec<Stiffness>,
    /// Smooth stretches from one corner or end to the next. None where there is nothing to find: no rings and no free ends, or order 2.
    chains: Vec<Chain>,
}

/// Bays that are joined smoothly.
#[derive(Debug, Clone, PartialEq)]
struct Chain {
    bays: Range<usize>,
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
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Deflection {
    /// On the first bay, which is the only one of most beams.
    first: ModeSolution,
    /// What there is where slopes had to be found, or where there are more bays.
    rest: Option<Box<Rest>>,
}

/// A deflection beyond its first bay.
#[derive(Debug, Clone, PartialEq)]
struct Rest {
    /// On the other bays.
    others: Vec<ModeSolution>,
    /// `q'` at both ends of every bay: neighbours have the same bits.
    slopes: Vec<[f64; 2]>,
}

/// What there is of every bay where there is nothing.
static NOTHING: ModeSolution = ModeSolution::zero();

/// Why a beam has no answer, and between which `u`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Broken {
    pub(crate) why: Unsolvable,
    /// The numbers of the ends and rings that it lies between: 0 is `u = 0`, 1 the first ring.
    pub(crate) between: [usize; 2],
}

// Called for every mode from several places, and each call is long: inlined they would weigh more than they save.
impl Beam {
    /// The equation of the mode with angular frequency `k` on these bays.
    #[inline(never)]
    pub(crate) fn new(
        order: Order,
        [s, t, w]: [f64; 3],
        k: f64,
        bays: &Arc<Bays>,
        free: Free,
    ) -> Result<Arc<Self>, Broken> {
        let n = bays.bays.len();
        let all = |why| Broken { why, between: [0, n] };
        let coefficients = Equation::coefficients(order, s, t, w, k).map_err(all)?;
        if let Some(index) = bays.crowded() {
            return Err(Broken { why: Unsolvable::Crowded, between: [index, index + 1] });
        }
        let [b, c] = coefficients;
        let roots = roots(order, b, c);
        let rate = rate_of(roots, c);
        let equation_on = |kind: usize, length: f64| {
            Equation::on(order, s, coefficients, rate, roots, length).map_err(|why| {
                let index = bays.bays.iter().position(|bay| bay.kind == kind).unwrap_or_default();
                Broken { why, between: [index, index + 1] }
            })
        };
        let (length, other_lengths) = bays.lengths.split_first().unwrap_or((&1.0, &[]));
        let equation = equation_on(0, *length)?;
        let has_slopes = order == Order::Fourth && (n > 1 || free != Free::default());
        if n == 1 && !has_slopes {
            return Ok(Arc::new(Beam { equation, joints: None }));
        }
        let mut others = Vec::with_capacity(other_lengths.len());
        for (length, kind) in other_lengths.iter().zip(1..) {
            others.push(equation_on(kind, *length)?);
        }
        let mut joints = Joints { bays: Arc::clone(bays), others, stiffnesses: Vec::new(), chains: Vec::new() };
        if has_slopes {
            joints.stiffnesses = [&equation].into_iter().chain(&joints.others).map(Stiffness::of).collect();
            let can_swing = swing(order, b, c) > 0.0;
            let (mut first, mut starts_free) = (0, free.start);
            for corner in &bays.corners {
                joints.add_chain(first..*corner, [starts_free, true], can_swing)?;
                (first, starts_free) = (*corner, true);
            }
            joints.add_chain(first..n, [starts_free, free.end], can_swing)?;
        }
        Ok(Arc::new(Beam { equation, joints: Some(Box::new(joints)) }))
    }

    /// What it takes up under what is given.
    ///
    /// # Errors
    /// [`Unsolvable::Overflow`] if the solution leaves the range of doubles.
    #[inline]
    pub(crate) fn solve(&self, held: &Held) -> Result<Deflection, Broken> {
        // Half of all data are 0: cosines of what is of sines.
        if held.ends.is_zero() && held.rings.iter().all(|value| *value == 0.0) {
            return Ok(Deflection::default());
        }
        self.bend(held)
    }

    #[inline(never)]
    fn bend(&self, held: &Held) -> Result<Deflection, Broken> {
        let Held { ends, rings } = *held;
        let Some(joints) = &self.joints else {
            let first = self.equation.solve(&ends).map_err(|why| Broken { why, between: [0, 1] })?;
            return Ok(Deflection { first, rest: None });
        };
        let bays = &joints.bays.bays[..];
        let n = bays.len();
        let mut values = Vec::with_capacity(n + 1);
        values.push(ends.start);
        values.extend((0..n - 1).map(|index| rings.get(index).copied().unwrap_or(0.0)));
        values.push(ends.end);
        let forces: Vec<Vec<f64>> = match ends.force {
            [] => Vec::new(),
            force => bays.iter().map(|bay| self.force(bay, force)).collect(),
        };
        let force = |index: usize| forces.get(index).map_or(&[][..], Vec::as_slice);
        let mut slopes = vec![[0.0; 2]; n];
        slopes[0][0] = ends.start_u;
        slopes[n - 1][1] = ends.end_u;
        for chain in &joints.chains {
            self.find_slopes(joints, chain, &values, &forces, &mut slopes);
        }
        let mut first = ModeSolution::zero();
        let mut others = Vec::with_capacity(n - 1);
        for (index, bay) in bays.iter().enumerate() {
            let [start_u, end_u] = slopes[index].map(|slope| slope * bay.length);
            let data = ModeData { start: values[index], end: values[index + 1], start_u, end_u, force: force(index) };
            let broken = |why| Broken { why, between: [index, index + 1] };
            let piece = self.equation_of(bay).solve(&data).map_err(broken)?;
            if index == 0 {
                first = piece;
            } else {
                others.push(piece);
            }
        }
        Ok(Deflection { first, rest: Some(Box::new(Rest { others, slopes })) })
    }

    /// Slopes for which `q''` is continuous between the bays of a chain and 0 at free ends. Those given stand at the outer ends already.
    #[inline(never)]
    fn find_slopes(
        &self,
        joints: &Joints,
        chain: &Chain,
        values: &[f64],
        forces: &[Vec<f64>],
        slopes: &mut [[f64; 2]],
    ) {
        let n = chain.bays.len();
        let (first, slopes) = (chain.bays.start, &mut slopes[chain.bays.clone()]);
        let given = [slopes[0][0], slopes[n - 1][1]];
        let known = |end: usize| if chain.is_free[end] { 0.0 } else { given[end] };
        // What would bend a beam whose unknown slopes are 0.
        let mut unbalanced = vec![0.0; n + 1];
        for (index, bay) in joints.bays.bays[chain.bays.clone()].iter().enumerate() {
            let particular = match forces.get(first + index) {
                Some(force) => force::particular(self.equation_of(bay), force),
                None => Vec::new(),
            };
            let [[p0, p0_u, p0_uu], [p1, p1_u, p1_uu]] = [0.0, 1.0].map(|x| series::jet::<3>(&particular, x));
            let start_u = if index == 0 { known(0) * bay.length } else { 0.0 };
            let end_u = if index + 1 == n { known(1) * bay.length } else { 0.0 };
            let by_values = [values[first + index] - p0, values[first + index + 1] - p1];
            let [start, end] =
                joints.stiffnesses[bay.kind].second_derivatives(by_values, [start_u - p0_u, end_u - p1_u]);
            let square = bay.length * bay.length;
            unbalanced[index] += (start + p0_uu) / square;
            unbalanced[index + 1] -= (end + p1_uu) / square;
        }
        let unknown = usize::from(!chain.is_free[0])..n + 1 - usize::from(!chain.is_free[1]);
        chain.factors.solve(&mut unbalanced[unknown.clone()]);
        for index in unknown {
            if index < n {
                slopes[index][0] = unbalanced[index];
            }
            if index > 0 {
                slopes[index - 1][1] = unbalanced[index];
            }
        }
    }

    /// A force on the whole beam as what acts on the equation of a bay.
    #[inline(never)]
    fn force(&self, bay: &Bay, force: &[f64]) -> Vec<f64> {
        let square = bay.length * bay.length;
        let mut scale = match self.equation_of(bay).order {
            Order::Second => square,
            Order::Fourth => square * square,
        };
        series::about(force, bay.from)
            .into_iter()
            .map(|coefficient| {
                let scaled = coefficient * scale;
                scale *= bay.length;
                scaled
            })
            .collect()
    }

    /// The equation where it is the same from end to end.
    fn single(&self) -> Option<&Equation> {
        let has_one = self.joints.as_ref().is_none_or(|joints| joints.bays.bays.len() == 1);
        has_one.then_some(&self.equation)
    }

    fn equation_of(&self, bay: &Bay) -> &Equation {
        let other = bay.kind.checked_sub(1).zip(self.joints.as_ref());
        other.and_then(|(kind, joints)| joints.others.get(kind)).unwrap_or(&self.equation)
    }

    /// Whether every ring is a corner, as those of order 2 are.
    pub(crate) fn has_corners(&self) -> bool {
        self.joints.as_ref().is_some_and(|joints| joints.chains.is_empty())
    }

    /// Several deflections at `u` in [0, 1], each with its derivatives up to order `N - 1`; at a ring on the side of larger `u`.
    pub(crate) fn jets<const N: usize, const M: usize>(&self, of: [&Deflection; M], u: f64) -> [[f64; N]; M] {
        let (index, x) = self.place(u);
        self.jets_of(index, of, x)
    }

    /// As [`Beam::jets`], by the closed form of the bays in `[low, high]` alone, which goes on beyond them: at `high` it is the side of smaller `u`.
    pub(crate) fn jets_along<const N: usize, const M: usize>(
        &self,
        of: [&Deflection; M],
        u: f64,
        [low, high]: [f64; 2],
    ) -> [[f64; N]; M] {
        let (index, _) = self.place(u.min(high.next_down()).max(low));
        let bay = self.joints.as_ref().and_then(|joints| joints.bays.bays.get(index));
        self.jets_of(index, of, bay.map_or(u, |bay| bay.beyond(u)))
    }

    /// The number of the bay at `u`, and where in it that is, from 0 to 1.
    #[inline(never)]
    fn place(&self, u: f64) -> (usize, f64) {
        let Some(Joints { bays, .. }) = self.joints.as_deref() else { return (0, u.clamp(0.0, 1.0)) };
        let index = bays.at(u);
        (index, bays.bays.get(index).map_or(0.0, |bay| bay.within(u)))
    }

    fn jets_of<const N: usize, const M: usize>(&self, index: usize, of: [&Deflection; M], x: f64) -> [[f64; N]; M] {
        let bay = self.joints.as_ref().and_then(|joints| joints.bays.bays.get(index));
        let equation = bay.map_or(&self.equation, |bay| self.equation_of(bay));
        let mut jets = equation.jets::<N, M>(of.map(|deflection| deflection.piece(index)), x);
        let Some(bay) = bay else { return jets };
        for (jet, deflection) in jets.iter_mut().zip(of) {
            bay.lengthen(jet);
            let end = [0.0, 1.0].into_iter().position(|end| x == end);
            if let (Some(end), Some(slope), Order::Fourth) = (end, jet.get_mut(1), equation.order) {
                *slope = deflection.slopes(index)[end];
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
        let known = |bound: f64| if bound.is_nan() { f64::INFINITY } else { bound };
        // One bay is the whole: nothing is longer or shorter there, and no other is larger. Most surfaces are asked so, hundreds of times for a mesh.
        if let Some(equation) = self.single() {
            let pieces = of.map(|deflection| deflection.piece(0));
            return equation.suprema::<N, M>(pieces, from, to).map(|bounds| bounds.map(known));
        }
        let mut suprema = [[0.0f64; N]; M];
        let Some(Joints { bays, .. }) = self.joints.as_deref() else { return suprema };
        let first = bays.at(from);
        let among = bays.bays.iter().enumerate().skip(first);
        let among = among.take_while(|(index, bay)| *index == first || bay.from < to);
        for (index, bay) in among {
            let pieces = of.map(|deflection| deflection.piece(index));
            let mut here = self.equation_of(bay).suprema::<N, M>(pieces, bay.within(from), bay.within(to));
            for (most, here) in suprema.iter_mut().zip(&mut here) {
                bay.lengthen(here);
                for (most, here) in most.iter_mut().zip(here) {
                    *most = most.max(known(*here));
                }
            }
        }
        suprema
    }

    /// The size of the fastest rate, as [`Equation::largest_rate`].
    pub(crate) fn largest_rate(&self) -> f64 {
        self.first().map_or(0.0, |(equation, length)| equation.largest_rate() / length)
    }

    /// The rate of the fastest solution that swings without falling off, as [`Equation::swing`].
    pub(crate) fn swing(&self) -> f64 {
        self.first().map_or(0.0, |(equation, length)| equation.swing() / length)
    }

    fn first(&self) -> Option<(&Equation, f64)> {
        let lengths = self.joints.as_ref().map(|joints| &joints.bays.lengths[..]);
        lengths.map_or(Some(1.0), |lengths| lengths.first().copied()).map(|length| (&self.equation, length))
    }
}

impl Beam {
    /// The half-width of intervals on which few terms of a power series are enough for both, as [`Equation::reach`]. 0 where there are rings: a series ends at each.
    pub(crate) fn reach(&self, of: [&Deflection; 2]) -> f64 {
        let Some(equation) = self.single() else { return 0.0 };
        let [one, other] = of.map(|deflection| equation.reach(deflection.piece(0)));
        one.min(other)
    }

    /// The expansions of both about `centre`, as [`Equation::expansions`]; none where [`Beam::reach`] is 0.
    pub(crate) fn expansions(&self, of: [&Deflection; 2], centre: f64, half: f64) -> [Expansion; 2] {
        match self.single() {
            Some(equation) => equation.expansions(of.map(|deflection| deflection.piece(0)), centre, half),
            None => Default::default(),
        }
    }
}

impl Joints {
    #[inline(never)]
    fn add_chain(&mut self, bays: Range<usize>, is_free: [bool; 2], can_swing: bool) -> Result<(), Broken> {
        let n = bays.len();
        let between = [bays.start, bays.end];
        let (mut rows, mut scales) = (vec![[0.0; 3]; n + 1], Vec::new());
        for (index, bay) in self.bays.bays[bays.clone()].iter().enumerate() {
            let [near, far] = self.stiffnesses[bay.kind].near_and_far().map(|part| part / bay.length);
            rows[index][1] += near;
            rows[index][2] = far;
            rows[index + 1][0] = far;
            rows[index + 1][1] += near;
            if can_swing {
                scales.resize(index + 2, 0.0);
                let scale = near.abs().max(far.abs());
                scales[index] += scale;
                scales[index + 1] += scale;
            }
        }
        let unknown = usize::from(!is_free[0])..rows.len() - usize::from(!is_free[1]);
        let resonant = Broken { why: Unsolvable::Resonant, between };
        if can_swing {
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
        self.chains.push(Chain { bays, is_free, factors });
        Ok(())
    }
}

impl Deflection {
    /// Whether `q` is 0 everywhere.
    pub(crate) fn is_zero(&self) -> bool {
        self.first.is_zero() && self.rest.iter().flat_map(|rest| &rest.others).all(ModeSolution::is_zero)
    }

    /// `q'` at both ends of this bay, of a beam whose slopes were found.
    fn slopes(&self, index: usize) -> [f64; 2] {
        self.rest.as_ref().and_then(|rest| rest.slopes.get(index)).copied().unwrap_or_default()
    }

    /// The closed form of this bay.
    fn piece(&self, index: usize) -> &ModeSolution {
        match index.checked_sub(1) {
            None => &self.first,
            Some(index) => self.rest.as_ref().and_then(|rest| rest.others.get(index)).unwrap_or(&NOTHING),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Ring;
    use super::*;

    const RINGS: [Ring; 4] = [
        Ring { u: 0.2, sharp: false },
        Ring { u: 0.201, sharp: true },
        Ring { u: 0.6, sharp: true },
        Ring { u: 0.9, sharp: false },
    ];

    fn bays(rings: &[Ring]) -> Arc<Bays> {
        Arc::new(Bays::between(rings))
    }

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
                    let Ok(beam) = Beam::new(order, [1.0, t, w], k, &bays(&RINGS), free) else { continue };
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
        let beam = Beam::new(Order::Fourth, [1.5, 3.0, 2.0], 5.0, &bays(&[]), Free::default()).unwrap();
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
        let beam = Beam::new(Order::Fourth, [1.0, 0.0, 0.0], 0.0, &bays(&RINGS[2..3]), Free { start: true, end: true })
            .unwrap();
        let deflection = beam.solve(&held(&[], &[4.0])).unwrap();
        let slope = |u: f64| beam.jets::<2, 1>([&deflection], u)[0];
        assert_eq!(slope(0.6)[0], 4.0);
        let [before, after] = [slope(0.6_f64.next_down()), slope(0.6)].map(|jet| jet[1]);
        assert!((before - 5.0).abs() < 1e-13 && (after + 11.25).abs() < 1e-13, "{before} {after}");
    }
}
