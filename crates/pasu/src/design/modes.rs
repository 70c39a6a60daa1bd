//! Canonical form of boundary-value shapes.

use std::borrow::Cow;
use std::f64::consts::TAU;

use super::boundary_value::{BoundaryValue, Component, Datum, Free, Mode, Order, Ring, Span};
#[cfg(feature = "typescript")]
use super::declarations::interface;
use super::described::Described;
use super::handles::{Handle, HandleId, Handles, Restraint, steps};
use super::number::{plain, rounded};
use super::ring::ascending;
#[cfg(feature = "typescript")]
use super::tables::{BOUNDARY_VALUE, FOURTH, FOURTH_DATUM, MODE, RING, SECOND, SECOND_DATUM};
use crate::error::{Code, Error, Result};

impl Described for BoundaryValue {
    fn problem(&self) -> Option<Cow<'_, BoundaryValue>> {
        Some(Cow::Borrowed(self))
    }

    /// The one way of writing this surface: numbers rounded, modes in ascending `n`, each `n` once, nothing that is 0.
    ///
    /// # Errors
    /// `overflow` when the data of two modes of the same `n` add up to more than a number can hold.
    fn canonical(self) -> Result<Self> {
        let component = |component: Component, name| component.canonical().map_err(|error| error.inside_field(name));
        let rings: Vec<Ring> = self.rings.into_iter().map(|ring| Ring { u: rounded(ring.u), ..ring }).collect();
        // Rounding may put a ring on its neighbour.
        ascending(rings.iter().map(|ring| ring.u), 0).map_err(|error| error.inside_field("rings"))?;
        Ok(BoundaryValue {
            span: self.span.canonical(),
            rings,
            x: component(self.x, "x")?,
            y: component(self.y, "y")?,
            z: component(self.z, "z")?,
        })
    }

    /// Refuses numbers that do not fit together as well: rings that do not follow each other, data that are not of as many rings, slopes at free ends.
    #[inline]
    fn finite(self) -> Result<Self> {
        ascending(self.rings.iter().map(|ring| ring.u), 0).map_err(|error| error.inside_field("rings"))?;
        for (name, component) in ["x", "y", "z"].into_iter().zip(self.components()) {
            for (index, mode) in component.modes.iter().enumerate() {
                for (field, datum) in [("cos", &mode.cos), ("sin", &mode.sin)] {
                    datum.fits(self.rings.len(), component.free).map_err(|error| {
                        error.inside_field(field).inside_item(index).inside_field("modes").inside_field(name)
                    })?;
                }
            }
        }
        Ok(self)
    }

    fn waves(&self) -> Vec<(String, f64)> {
        let components = ["x", "y", "z"].into_iter().zip(self.components());
        let modes =
            components.flat_map(|(name, component)| component.modes.iter().enumerate().map(move |mode| (name, mode)));
        modes.map(|(name, (index, mode))| (format!("{name}.modes[{index}].n"), mode.n)).collect()
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
        interface(text, "Ring", "A curve of constant u between the two ends that the surface passes through.", RING);
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
        let [s, t, w] = [self.s, self.t, self.w].map(rounded);
        Ok(Component { s, t, w, modes, ..self })
    }
}

impl Datum {
    fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let ends = [self.start, self.end, self.start_u, self.end_u];
        ends.into_iter().chain(self.rings.iter().copied()).chain(self.force.iter().copied())
    }

    /// Refuses data of another number of rings, and slopes at ends that are free.
    #[inline]
    fn fits(&self, n_rings: usize, free: Free) -> Result<()> {
        if !(self.rings.is_empty() || self.rings.len() == n_rings) {
            let message = match n_rings {
                0 => "expected no values, as there are no rings".to_owned(),
                _ => format!(
                    "expected a list of {n_rings} numbers, one for each ring, found a list of {}",
                    self.rings.len()
                ),
            };
            return Err(Error::new(Code::WrongType, "rings", message));
        }
        for (name, slope, is_free) in [("start_u", self.start_u, free.start), ("end_u", self.end_u, free.end)] {
            if is_free && slope != 0.0 {
                let message = format!("expected no slope at a free end, found {}", plain(slope));
                return Err(Error::new(Code::OutOfRange, name, message).with("found", slope));
            }
        }
        Ok(())
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
        for (numbers, others) in [(&mut self.rings, &other.rings), (&mut self.force, &other.force)] {
            numbers.resize(numbers.len().max(others.len()), 0.0);
            for (number, more) in numbers.iter_mut().zip(others) {
                *number += more;
            }
        }
    }

    fn canonical(&mut self) {
        let ends = [&mut self.start, &mut self.end, &mut self.start_u, &mut self.end_u];
        for x in ends.into_iter().chain(&mut self.rings).chain(&mut self.force) {
            *x = rounded(*x);
        }
        if self.rings.iter().all(|x| *x == 0.0) {
            self.rings.clear();
        }
        let length = self.force.iter().rposition(|x| *x != 0.0).map_or(0, |last| last + 1);
        self.force.truncate(length);
    }
}
