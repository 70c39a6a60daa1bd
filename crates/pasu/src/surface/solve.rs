//! The closed form of a two-sided surface.

use core::f64::consts::TAU;
use std::sync::Arc;

use super::circle::{self, MOST_MULTIPLES, most_of_many, multiples};
use super::ends::Ends;
use super::recent::{KeptRow, RecentRows};
use super::row_table::RowTable;
use super::term::Term;
use crate::design::{Axis, BoundaryValue, Component, Datum, Part, Shape, Span, plain};
use crate::error::{Code, Error, Result};
use crate::mode::{Bays, Beam, Broken, CLOSEST, Deflection, Free, Held, ModeData, Order, Ring, Unsolvable};
use crate::patch::{AxisJet, SurfaceJet};

/// `X(u, v) = sum_n [ A_n(u) cos(k_n v) + B_n(u) sin(k_n v) ]`, component by component, `k_n = 2 pi n / span` (ZY01 section 3, IA eq 5).
///
/// The closed form holds for every `u` in [0, 1] and every `v`.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    components: [Vec<Term>; 3],
    span: Span,
    rings: Vec<Ring>,
    /// The different `n`, in the order of their first use.
    distinct: Vec<f64>,
    /// Where these are so many that their cosines are found one from the other: the largest.
    most_turns: Option<usize>,
    ends: Ends,
    recent: RecentRows,
}

impl Span {
    /// The length of the `v` interval.
    ///
    /// ```
    /// assert_eq!(pasu::Span::Length(3.0).length(), 3.0);
    /// assert_eq!(pasu::Span::Tau.length(), std::f64::consts::TAU);
    /// ```
    pub fn length(self) -> f64 {
        match self {
            Span::Tau => TAU,
            Span::Length(length) => length,
        }
    }

    /// The angular frequency `k_n = 2 pi n / span`; exactly `n` for a span of `2 pi`.
    fn frequency(self, n: f64) -> f64 {
        match self {
            Span::Tau => n,
            Span::Length(length) => TAU * n / length,
        }
    }
}

/// What makes the beams of two components the same, mode by mode: those of `y` nearly always are those of `x`, and often those of `z`.
#[derive(PartialEq)]
struct Alike {
    order: Order,
    weights: [u64; 3],
    free: Free,
}

impl Alike {
    fn of(component: &Component) -> Self {
        let &Component { order, s, t, w, free, .. } = component;
        Alike { order, weights: [s, t, w].map(f64::to_bits), free }
    }
}

/// The beam of the mode `n` among the terms of one component, which is next nearly always.
fn known(terms: &[Term], next: &mut usize, n: f64) -> Option<Arc<Beam>> {
    let is_next = terms.get(*next).is_some_and(|term| term.n == n);
    let index = if is_next { *next } else { terms.iter().position(|term| term.n == n)? };
    *next = index + 1;
    Some(Arc::clone(&terms[index].beam))
}

#[inline(never)]
fn deflection(beam: &Beam, datum: &Datum) -> core::result::Result<Deflection, Broken> {
    beam.solve(&Held::from(datum))
}

impl<'a> From<&'a Datum> for Held<'a> {
    fn from(datum: &'a Datum) -> Self {
        let &Datum { start, end, start_u, end_u, ref rings, ref force } = datum;
        Held { ends: ModeData { start, start_u, end, end_u, force }, rings }
    }
}

#[cfg(test)]
thread_local! {
    /// How many shapes this thread has solved.
    pub(crate) static SOLVED: core::cell::Cell<usize> = const { core::cell::Cell::new(0) };
}

impl Surface {
    /// Solves every mode problem of a shape. `path` is where the shape stands in its design, for the error.
    ///
    /// # Errors
    /// `resonant-problem`, naming component and mode, where oscillating solutions leave no unique answer; `out-of-range` where `s` is 0, or where rings are nearer each other than a
    /// millionth; `overflow` where the solution leaves the range of doubles.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// let problem = vase.parts()[0].shape.boundary_value().expect("a vase has two ends");
    /// let surface = pasu::Surface::solve(&problem, "parts[0].shape")?;
    /// assert!(surface.is_closed());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn solve(shape: &BoundaryValue, path: &str) -> Result<Surface> {
        #[cfg(test)]
        SOLVED.set(SOLVED.get() + 1);
        let bays = Arc::new(Bays::between(&shape.rings));
        let solve = |axis: Axis, component: &Component, before: &[(&Component, &[Term])]| {
            let Component { order, s, t, w, free, .. } = *component;
            let alike = Alike::of(component);
            let mut next = [0; 2];
            let mut terms = Vec::with_capacity(component.modes.len());
            for (index, mode) in component.modes.iter().enumerate() {
                let k = shape.span.frequency(mode.n);
                let mut all = before.iter().zip(&mut next).filter(|((other, _), _)| Alike::of(other) == alike);
                let beam = all.find_map(|((_, terms), next)| known(terms, next, mode.n));
                let beam = beam.map_or_else(|| Beam::new(order, [s, t, w], k, &bays, free), Ok);
                let refused = |why| unsolvable(why, shape, axis, index, path);
                let beam = beam.map_err(refused)?;
                let cos = deflection(&beam, &mode.cos).map_err(refused)?;
                let sin = deflection(&beam, &mode.sin).map_err(refused)?;
                if !(cos.is_zero() && (sin.is_zero() || mode.n == 0.0)) {
                    terms.push(Term { n: mode.n, k, column: 0, beam, cos, sin });
                }
            }
            Ok(terms)
        };
        let x = solve(Axis::X, &shape.x, &[])?;
        let y = solve(Axis::Y, &shape.y, &[(&shape.x, &x)])?;
        let z = solve(Axis::Z, &shape.z, &[(&shape.x, &x), (&shape.y, &y)])?;
        let mut components = [x, y, z];
        let mut distinct = Vec::with_capacity(components[0].len());
        for component in &mut components {
            // Components have the same modes nearly always: where one is, the next is behind it.
            let mut next = 0;
            for term in component {
                let is_next = distinct.get(next) == Some(&term.n);
                let known = if is_next { Some(next) } else { distinct.iter().position(|n| *n == term.n) };
                term.column = known.unwrap_or_else(|| {
                    distinct.push(term.n);
                    distinct.len() - 1
                });
                next = term.column + 1;
            }
        }
        let whole = distinct.iter().filter(|n| 0.0 <= **n && **n <= MOST_MULTIPLES as f64 && **n == n.trunc());
        // What draws the first pot measures nothing, and has to be small.
        let most_turns = if cfg!(feature = "patchwork") { most_of_many(whole.map(|n| *n as usize)) } else { None };
        Ok(Surface {
            components,
            span: shape.span,
            rings: shape.rings.clone(),
            distinct,
            most_turns,
            ends: Ends::default(),
            recent: RecentRows::default(),
        })
    }

    /// Solves the shape of part number `index` of a design.
    ///
    /// # Errors
    /// As [`Surface::solve`]; a named family has no modes in the document, so its path ends at the shape. `unsupported-shape` for a shape that is no surface between two ends.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/second-order?height=9")?;
    /// let surface = pasu::Surface::of_part(&vase.parts()[0], 0)?;
    /// assert!((surface.at(0.5, 0.0).position.z - 4.5).abs() < 1e-12);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn of_part(part: &Part, index: usize) -> Result<Surface> {
        let path = format!("parts[{index}].shape");
        let Some(problem) = part.shape.problem() else {
            let message = format!("a shape of the kind {:?} is no surface between two ends", part.shape.kind());
            return Err(Error::new(Code::UnsupportedShape, path, message).with("what", "no-ends"));
        };
        Surface::solve(&problem, &path).map_err(|error| match &part.shape {
            Shape::BoundaryValue(_) => error,
            _ => error.at(path),
        })
    }

    /// The length of the `v` interval.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert_eq!(pasu::Surface::of_part(&vase.parts()[0], 0)?.span(), std::f64::consts::TAU);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn span(&self) -> f64 {
        self.span.length()
    }

    /// Whether the surface meets itself at `v = 0` and `v = span`: every `n` in use is whole.
    ///
    /// ```
    /// use pasu::{Design, Surface};
    ///
    /// let closed = |link: &str| Ok(Surface::of_part(&Design::parse(link)?.parts()[0], 0)?.is_closed());
    /// assert_eq!(closed("#1/second-order?n=1,8"), Ok(true));
    /// assert_eq!(closed("#1/second-order?n=1,8.5"), Ok::<bool, pasu::Error>(false));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn is_closed(&self) -> bool {
        self.components.iter().flatten().all(|term| term.n == term.n.trunc())
    }

    /// Where the rings are, and whether the profile may have a corner there.
    pub(crate) fn rings(&self) -> impl Iterator<Item = (f64, bool)> + '_ {
        let has_corners = self.components.iter().flatten().any(|term| term.beam.has_corners());
        self.rings.iter().map(move |ring| (ring.u, ring.sharp || has_corners))
    }

    /// Where rows of samples have to stand inside (0, 1): on every ring, and right before it too where there is a corner, so that both sides have theirs.
    pub(crate) fn stops(&self) -> Vec<f64> {
        let mut stops = Vec::with_capacity(self.rings.len());
        for (u, is_corner) in self.rings() {
            stops.extend(is_corner.then(|| u.next_down()));
            stops.push(u);
        }
        stops
    }

    /// The different `n`, in the order of their first use.
    pub(crate) fn distinct(&self) -> &[f64] {
        &self.distinct
    }

    /// The number of modes of all components.
    pub(crate) fn n_terms(&self) -> usize {
        self.components.iter().map(Vec::len).sum()
    }

    /// `(cos, sin)` of each of [`Surface::distinct`] after so many turns.
    pub(super) fn circles(&self, turns: f64) -> Vec<(f64, f64)> {
        let alone = |n: &f64| circle::of_turns(n * turns);
        match self.most_turns {
            Some(most) if cfg!(feature = "patchwork") => {
                let all = multiples(turns, most);
                let known = |n: f64| if n >= 0.0 && n == n.trunc() { all.get(n as usize).copied() } else { None };
                self.distinct.iter().map(|n| known(*n).unwrap_or_else(|| alone(n))).collect()
            }
            _ => self.distinct.iter().map(alone).collect(),
        }
    }

    /// The coefficients at `u`; those at an end are made once, others again where they were not asked for lately.
    pub(super) fn row_table(&self, u: f64) -> KeptRow<'_> {
        let make = || RowTable::at(&self.components, u);
        self.ends.at(u, make).map_or_else(|| KeptRow::Recent(self.recent.row(u, self.n_terms(), make)), KeptRow::End)
    }

    /// The coefficients at `u` by the closed form between two rings or ends, which goes on beyond them.
    pub(super) fn row_table_along(&self, u: f64, [low, high]: [f64; 2]) -> KeptRow<'_> {
        let is_within = low <= u && (u < high || high == 1.0);
        if is_within && u <= 1.0 {
            return self.row_table(u);
        }
        KeptRow::Recent(Arc::new(RowTable::along(&self.components, u, [low, high])))
    }

    /// The modes of each component.
    pub(crate) fn components(&self) -> &[Vec<Term>; 3] {
        &self.components
    }

    /// Position and derivatives at `(u, v)`, `u` in [0, 1], `v` in the units of the span.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/second-order?height=9")?;
    /// let jet = pasu::Surface::of_part(&vase.parts()[0], 0)?.at(0.5, 0.25);
    /// assert!((jet.position.z - 4.5).abs() < 1e-12 && (jet.du.z + 9.0).abs() < 1e-12);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn at(&self, u: f64, v: f64) -> SurfaceJet {
        let mut jet = SurfaceJet::default();
        for (axis, terms) in self.components.iter().enumerate() {
            let mut sums = AxisJet::default();
            for term in terms {
                let [a, b] = term.beam.jets::<3, 2>([&term.cos, &term.sin], u);
                sums.add(term.k, &a, &b, self.angle(term.n, v));
            }
            jet.set(axis, sums);
        }
        jet
    }

    /// `(cos, sin)` of `k_n v`.
    fn angle(&self, n: f64, v: f64) -> (f64, f64) {
        match self.span {
            Span::Tau => (libm::cos(n * v), libm::sin(n * v)),
            Span::Length(length) => circle::of_turns(n * (v / length)),
        }
    }
}

#[inline(never)]
fn unsolvable(broken: Broken, shape: &BoundaryValue, axis: Axis, index: usize, path: &str) -> Error {
    let (name, component) = match axis {
        Axis::X => ("x", &shape.x),
        Axis::Y => ("y", &shape.y),
        Axis::Z => ("z", &shape.z),
    };
    let Component { s, t, w, modes, .. } = component;
    let n = modes[index].n;
    let Broken { why, between } = broken;
    let u = |place: usize| place.checked_sub(1).map_or(0.0, |ring| shape.rings.get(ring).map_or(1.0, |ring| ring.u));
    let [from, to] = between.map(|place| plain(u(place)));
    let named = [("n", n), ("s", *s), ("t", *t), ("w", *w)];
    let [n, s, t, w] = named.map(|(_, number)| plain(number));
    // Of the two rings that are too near each other the second, unless that is an end.
    let ring = between[1].min(shape.rings.len()).saturating_sub(1);
    let path = match why {
        Unsolvable::Crowded => format!("{path}.rings[{ring}].u"),
        _ => format!("{path}.{name}.modes[{index}]"),
    };
    let (among, curves) = match shape.rings.is_empty() {
        true => ("the two boundaries".to_owned(), "the boundary curves"),
        false => (format!("the curves from u = {from} to u = {to}"), "these"),
    };
    let error = match why {
        Unsolvable::Crowded => {
            let (message, gap) = (plain(CLOSEST), u(between[1]) - u(between[0]));
            let message = format!(
                "rings at u = {from} and u = {to} are too near each other to tell the slope between them (mode n = {n} of {name}); expected {message} or more between rings, and from the ends"
            );
            Error::new(Code::OutOfRange, path, message).with("least", CLOSEST).with("found", gap)
        }
        Unsolvable::NoHighestDerivative => {
            Error::new(Code::OutOfRange, path, format!("the equation of {name} needs an s that is not 0, found {s}"))
        }
        Unsolvable::Resonant => Error::new(
            Code::ResonantProblem,
            path,
            format!(
                "component {name}, mode n = {n} is in resonance: with s = {s}, t = {t}, w = {w} the equation oscillates between {among} \
                 by itself, so {curves} do not decide the surface; change s, t, w or n a little"
            ),
        ),
        Unsolvable::Overflow => Error::new(
            Code::Overflow,
            path,
            format!(
                "component {name}, mode n = {n} is too large to compute: with s = {s}, t = {t}, w = {w} its solution leaves the range of numbers"
            ),
        ),
    };
    named.into_iter().fold(error.with("component", name), |error, (name, number)| error.with(name, number))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{Free, Mode};

    /// A surface with these waves, half of them of `x` alone.
    fn with(waves: &[f64]) -> Surface {
        let datum = |start: f64| Datum { start, end: 0.5 * start, ..Datum::default() };
        let mode = |n: &f64| Mode { n: *n, cos: datum(1.0 / (1.0 + n.abs())), sin: datum(0.3) };
        let component = |waves: &[f64]| Component {
            order: Order::Fourth,
            s: 1.0,
            t: 0.0,
            w: 1.0,
            free: Free::default(),
            modes: waves.iter().map(mode).collect(),
        };
        let (x, y, z) = (component(waves), component(&waves[waves.len() / 2..]), component(&[0.0]));
        let problem = BoundaryValue { span: Span::Length(1.0), rings: Vec::new(), x, y, z };
        Surface::solve(&problem, "shape").unwrap()
    }

    #[test]
    fn many_waves_found_one_from_the_other_are_those_by_themselves() {
        use crate::patch::Patch;

        let many: Vec<f64> = (1..=120).map(f64::from).collect();
        let mixed: Vec<f64> = [0.5, -3.0].into_iter().chain((0..40).map(f64::from)).chain([4000.0]).collect();
        for (waves, are_many) in [(&many, true), (&mixed, false), (&mixed[..42].to_vec(), true)] {
            let surface = with(waves);
            assert_eq!(surface.most_turns.is_some(), are_many, "{waves:?}");
            for (u, v) in [(0.0, 0.0), (0.3, 0.77), (1.0, 0.25), (0.5, 1.0), (0.9, 0.123)] {
                let (row, alone) = (Patch::row(&surface, u).jet(v), surface.at(u, v));
                let scale = waves.iter().fold(1.0f64, |most, n| most.max(n.abs()));
                let pairs = [
                    (row.position, alone.position, 1.0),
                    (row.du, alone.du, scale),
                    (row.dvv, alone.dvv, 40.0 * scale * scale),
                ];
                for (found, expected, size) in pairs {
                    assert!((found - expected).length() <= 1e-12 * size * scale, "{u} {v}: {found} {expected}");
                }
            }
        }
    }
}
