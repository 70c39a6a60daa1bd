//! Canonical form of boundary-value shapes.

use std::borrow::Cow;
use std::f64::consts::TAU;

use super::boundary_value::{BoundaryValue, Component, Datum, Mode, Order, Span};
#[cfg(feature = "typescript")]
use super::declarations::interface;
use super::described::{Described, Family};
use super::handles::{Handle, HandleId, Handles, Restraint, steps};
use super::number::{plain, rounded};
#[cfg(feature = "typescript")]
use super::tables::{BOUNDARY_VALUE, FOURTH, FOURTH_DATUM, MODE, SECOND, SECOND_DATUM};
use crate::error::{Code, Error, Result};

impl Described for BoundaryValue {
    const FAMILY: Option<Family> = None;

    fn problem(&self) -> Cow<'_, BoundaryValue> {
        Cow::Borrowed(self)
    }

    /// The one way of writing this surface: numbers rounded, modes in ascending `n`, each `n` once, nothing that is 0.
    ///
    /// # Errors
    /// `overflow` when the data of two modes of the same `n` add up to more than a number can hold.
    fn canonical(self) -> Result<Self> {
        let component = |component: Component, name| component.canonical().map_err(|error| error.inside_field(name));
        Ok(BoundaryValue {
            span: self.span.canonical(),
            x: component(self.x, "x")?,
            y: component(self.y, "y")?,
            z: component(self.z, "z")?,
        })
    }

    fn waves(&self) -> Vec<(String, f64)> {
        let components = ["x", "y", "z"].into_iter().zip(self.components());
        let modes =
            components.flat_map(|(name, component)| component.modes.iter().enumerate().map(move |mode| (name, mode)));
        modes.map(|(name, (index, mode))| (format!("{name}.modes[{index}].n"), mode.n)).collect()
    }

    fn link(&self) -> Option<Vec<String>> {
        None
    }

    /// The radius is that of the first harmonic, the height that of the harmonic 0.
    #[inline]
    fn handles(&self) -> Handles {
        let level = self.z.modes.iter().position(|mode| mode.n == 0.0);
        let height = level.map_or((0.0, 0.0), |index| (self.z.modes[index].cos.start, self.z.modes[index].cos.end));
        let is_start = height.1 <= height.0;
        let first = |modes: &[Mode], datum: fn(&Mode) -> &Datum| {
            modes.iter().position(|mode| mode.n == 1.0 && !datum(mode).is_zero())
        };
        let round = first(&self.x.modes, |mode| &mode.cos).zip(first(&self.y.modes, |mode| &mode.sin));
        let fourth = |component: &Component| component.order == Order::Fourth;
        let radial = |name: &str| match round {
            Some((x, y)) => {
                // y may run the other way round the axis: its radius grows with the sign it has.
                let is_against = self.y.modes[y].sin.numbers().find(|number| *number != 0.0) < Some(0.0);
                let sense = if is_against { -1.0 } else { 1.0 };
                let [x, y] = [format!("x.modes[{x}].cos.{name}"), format!("y.modes[{y}].sin.{name}")];
                steps([(&x, 1.0), (&y, sense)])
            }
            None => Vec::new(),
        };
        let axial = |name: &str| match level {
            Some(index) => steps([(&format!("z.modes[{index}].cos.{name}"), 1.0)]),
            None => {
                let mode = format!("z.modes[{}]", self.z.modes.len());
                steps([(&format!("{mode}.n"), 0.0), (&format!("{mode}.cos.{name}"), 1.0)])
            }
        };
        let point = |id, name| {
            let why = round.is_none().then_some(Restraint::NoRadius);
            Handle::new(id, radial(name), axial(name)).held(why)
        };
        let slope = |id, name| {
            let (leans, rises) = (fourth(&self.x) && fourth(&self.y), fourth(&self.z));
            let why_no_lean = if leans { Restraint::NoRadius } else { Restraint::LeanOrder };
            Handle::new(id, if leans { radial(name) } else { Vec::new() }, if rises { axial(name) } else { Vec::new() })
                .held((!leans || round.is_none()).then_some(why_no_lean))
                .held((!rises).then_some(Restraint::RiseOrder))
        };
        let [(rim, rim_u), (foot, foot_u)] = match is_start {
            true => [("start", "start_u"), ("end", "end_u")],
            false => [("end", "end_u"), ("start", "start_u")],
        };
        Handles::new(
            is_start,
            [
                point(HandleId::Rim, rim),
                slope(HandleId::RimSlope, rim_u),
                slope(HandleId::FootSlope, foot_u),
                point(HandleId::Foot, foot),
            ],
        )
    }

    #[cfg(feature = "typescript")]
    fn typescript(_: &str, text: &mut String) {
        interface(text, "BoundaryValue", "Fourier boundary data written out, component by component.", BOUNDARY_VALUE);
        text.push_str(
            "\n/** The equation and the boundary data of one component. */\n\
             export type Component = SecondOrderComponent | FourthOrderComponent;\n",
        );
        interface(text, "SecondOrderComponent", "A component of order 2.", SECOND);
        interface(text, "FourthOrderComponent", "A component of order 4.", FOURTH);
        interface(text, "Mode<Datum>", "One harmonic; data left out are 0.", MODE);
        interface(
            text,
            "SecondOrderDatum",
            "What a harmonic of order 2 is given; what is left out is 0.",
            SECOND_DATUM,
        );
        interface(
            text,
            "FourthOrderDatum",
            "What a harmonic of order 4 is given; what is left out is 0.",
            FOURTH_DATUM,
        );
    }
}

impl BoundaryValue {
    pub(crate) fn components(&self) -> [&Component; 3] {
        [&self.x, &self.y, &self.z]
    }

    /// How many modes the three components have together.
    pub(crate) fn n_modes(&self) -> usize {
        self.components().iter().map(|component| component.modes.len()).sum()
    }

    /// Whether every number is finite: a family's parameters may be, and their products not.
    pub(crate) fn is_finite(&self) -> bool {
        self.components().into_iter().all(|component| {
            [component.s, component.t, component.w].iter().all(|x| x.is_finite())
                && component.modes.iter().all(|mode| mode.n.is_finite() && mode.cos.is_finite() && mode.sin.is_finite())
        })
    }
}

impl Span {
    /// A length that is `2 pi` to twelve digits is `2 pi`.
    fn canonical(self) -> Self {
        match self {
            Span::Length(length) if rounded(length) != rounded(TAU) => Span::Length(rounded(length)),
            _ => Span::Tau,
        }
    }
}

impl Component {
    fn canonical(self) -> Result<Self> {
        let mut modes: Vec<Mode> = Vec::with_capacity(self.modes.len());
        for mode in self.modes {
            let mode = Mode { n: rounded(mode.n), ..mode };
            // Documents mostly come in order, so that this appends.
            match modes.binary_search_by(|earlier| earlier.n.total_cmp(&mode.n)) {
                Ok(same) => {
                    modes[same].cos.add(&mode.cos);
                    modes[same].sin.add(&mode.sin);
                }
                Err(place) => modes.insert(place, mode),
            }
        }
        for mode in &mut modes {
            if !(mode.cos.is_finite() && mode.sin.is_finite()) {
                let message = format!("the data given for n = {} add up to more than a number can hold", plain(mode.n));
                return Err(Error::new(Code::Overflow, "modes", message));
            }
            mode.cos.canonical();
            mode.sin.canonical();
            // sin(0 v) is 0 whatever its data.
            if mode.n == 0.0 {
                mode.sin = Datum::default();
            }
        }
        modes.retain(|mode| !(mode.cos.is_zero() && mode.sin.is_zero()));
        Ok(Component { order: self.order, s: rounded(self.s), t: rounded(self.t), w: rounded(self.w), modes })
    }
}

impl Datum {
    fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        [self.start, self.end, self.start_u, self.end_u].into_iter().chain(self.force.iter().copied())
    }

    fn is_finite(&self) -> bool {
        self.numbers().all(f64::is_finite)
    }

    /// Whether it need not be written.
    pub(super) fn is_zero(&self) -> bool {
        self.numbers().all(|x| x == 0.0)
    }

    fn add(&mut self, other: &Datum) {
        self.start += other.start;
        self.end += other.end;
        self.start_u += other.start_u;
        self.end_u += other.end_u;
        self.force.resize(self.force.len().max(other.force.len()), 0.0);
        for (coefficient, more) in self.force.iter_mut().zip(&other.force) {
            *coefficient += more;
        }
    }

    fn canonical(&mut self) {
        for x in [&mut self.start, &mut self.end, &mut self.start_u, &mut self.end_u].into_iter().chain(&mut self.force)
        {
            *x = rounded(*x);
        }
        let length = self.force.iter().rposition(|x| *x != 0.0).map_or(0, |last| last + 1);
        self.force.truncate(length);
    }
}
