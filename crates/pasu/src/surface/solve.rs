//! The closed form of a two-sided surface.

use core::f64::consts::TAU;
use std::borrow::Cow;

use super::circle;
use super::ends::Ends;
use super::row_table::RowTable;
use super::term::Term;
use crate::design::{Axis, BoundaryValue, Component, Datum, Part, Shape, Span, plain};
use crate::error::{Code, Error, Result};
use crate::mode::{Equation, ModeData, Unsolvable};
use crate::patch::SurfaceJet;

/// `X(u, v) = sum_n [ A_n(u) cos(k_n v) + B_n(u) sin(k_n v) ]`, component by component, `k_n = 2 pi n / span` (ZY01 section 3, IA eq 5).
///
/// The closed form holds for every `u` in [0, 1] and every `v`.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    components: [Vec<Term>; 3],
    span: Span,
    /// The different `n`, in the order of their first use.
    distinct: Vec<f64>,
    ends: Ends,
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

impl<'a> From<&'a Datum> for ModeData<'a> {
    fn from(datum: &'a Datum) -> Self {
        let &Datum { start, end, start_u, end_u, ref force } = datum;
        ModeData { start, start_u, end, end_u, force }
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
    /// `resonant-problem`, naming component and mode, where oscillating solutions leave no unique answer; `out-of-range` where `s` is 0;
    /// `overflow` where the solution leaves the range of doubles.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// let surface = pasu::Surface::solve(&vase.parts()[0].shape.boundary_value(), "parts[0].shape")?;
    /// assert!(surface.is_closed());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn solve(shape: &BoundaryValue, path: &str) -> Result<Surface> {
        #[cfg(test)]
        SOLVED.set(SOLVED.get() + 1);
        // What x has solved: y nearly always, and z often, have the same equations.
        let mut equations: Vec<Equation> = Vec::with_capacity(shape.x.modes.len());
        let mut component = |axis: Axis, component: &Component| {
            let Component { order, s, t, w, .. } = *component;
            let is_as_x = (order, s, t, w) == (shape.x.order, shape.x.s, shape.x.t, shape.x.w);
            let mut terms = Vec::with_capacity(component.modes.len());
            for (index, mode) in component.modes.iter().enumerate() {
                let k = shape.span.frequency(mode.n);
                let known = equations.get(index).filter(|_| is_as_x && shape.x.modes[index].n == mode.n);
                let equation = known.map_or_else(|| Equation::new(order, s, t, w, k), |known| Ok(known.clone()));
                let solved = equation.and_then(|equation| {
                    if axis == Axis::X {
                        equations.push(equation.clone());
                    }
                    let cos = equation.solve(&ModeData::from(&mode.cos))?;
                    let sin = equation.solve(&ModeData::from(&mode.sin))?;
                    Ok(Term { n: mode.n, k, equation, cos, sin })
                });
                let term = solved.map_err(|why| unsolvable(why, component, axis, mode.n, index, path))?;
                if !(term.cos.is_zero() && (term.sin.is_zero() || term.n == 0.0)) {
                    terms.push(term);
                }
            }
            Ok(terms)
        };
        let components = [component(Axis::X, &shape.x)?, component(Axis::Y, &shape.y)?, component(Axis::Z, &shape.z)?];
        let mut distinct = Vec::with_capacity(4);
        for term in components.iter().flatten() {
            if !distinct.contains(&term.n) {
                distinct.push(term.n);
            }
        }
        Ok(Surface { components, span: shape.span, distinct, ends: Ends::default() })
    }

    /// Solves the shape of part number `index` of a design.
    ///
    /// # Errors
    /// As [`Surface::solve`]; a named family has no modes in the document, so its path ends at the shape.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/second-order?height=9")?;
    /// let surface = pasu::Surface::of_part(&vase.parts()[0], 0)?;
    /// assert!((surface.at(0.5, 0.0).position.z - 4.5).abs() < 1e-12);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn of_part(part: &Part, index: usize) -> Result<Surface> {
        let path = format!("parts[{index}].shape");
        let is_written_out = matches!(part.shape, Shape::BoundaryValue(_));
        Surface::solve(&part.shape.problem(), &path)
            .map_err(|error| if is_written_out { error } else { error.at(path) })
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

    /// The different `n`, in the order of their first use.
    pub(crate) fn distinct(&self) -> &[f64] {
        &self.distinct
    }

    /// The coefficients at `u`; at an end they are made once.
    pub(super) fn row_table(&self, u: f64) -> Cow<'_, RowTable<3>> {
        let make = || RowTable::at(&self.components, &self.distinct, u);
        self.ends.at(u, make).map_or_else(|| Cow::Owned(make()), Cow::Borrowed)
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
            for term in terms {
                let [a, b] = term.equation.jets::<3, 2>([&term.cos, &term.sin], u);
                jet.add(axis, term.k, &a, &b, self.angle(term.n, v));
            }
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

fn unsolvable(why: Unsolvable, component: &Component, axis: Axis, n: f64, index: usize, path: &str) -> Error {
    let name = match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    };
    let Component { s, t, w, .. } = component;
    let named = [("n", n), ("s", *s), ("t", *t), ("w", *w)];
    let [n, s, t, w] = named.map(|(_, number)| plain(number));
    let path = format!("{path}.{name}.modes[{index}]");
    let error = match why {
        Unsolvable::NoHighestDerivative => {
            Error::new(Code::OutOfRange, path, format!("the equation of {name} needs an s that is not 0, found {s}"))
        }
        Unsolvable::Resonant => Error::new(
            Code::ResonantProblem,
            path,
            format!(
                "component {name}, mode n = {n} is in resonance: with s = {s}, t = {t}, w = {w} the equation oscillates between the two \
                 boundaries by itself, so the boundary curves do not decide the surface; change s, t, w or n a little"
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
