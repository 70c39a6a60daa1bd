//! Reading, canonical form and writing of boundary-value shapes.

use std::f64::consts::TAU;

use super::boundary_value::{BoundaryValue, Component, Datum, Mode, Order, Span};
use super::limits::FORCE;
use super::number::{plain, rounded};
use super::path::Path;
use super::reader::{self, Range, Record};
use super::table::{self, Entry, optional, required};
use super::value::Value;
use crate::error::{Code, Result};

pub(crate) const BOUNDARY_VALUE: &[Entry] = &[
    required("kind", "\"boundary-value\"", "Any Fourier boundary data."),
    required("span", "number | \"2pi\"", "The length of the interval of v round the axis."),
    required("x", "Component", "The equation and the data of x."),
    required("y", "Component", "The equation and the data of y."),
    required("z", "Component", "The equation and the data of z, the axis of a pot."),
];

const S: Entry = required("s", "number", "Shape control parameter of the highest u derivative; not 0.");
const START: Entry = optional("start", "number", "Value at u = 0.");
const END: Entry = optional("end", "number", "Value at u = 1.");
const FORCE_ENTRY: Entry =
    optional("force", "readonly number[]", "Sculpting force in ascending powers of u, at most 512 coefficients.");

/// A component of order 2: `s X_uu + t X_vv = p`.
pub(crate) const SECOND: &[Entry] = &[
    required("order", "2", "The order of the equation s X_uu + t X_vv = p."),
    S,
    required("t", "number", "Shape control parameter of the v derivative."),
    required("modes", "readonly Mode<SecondOrderDatum>[]", "The Fourier sum of boundary data and force."),
];

/// A component of order 4: `s X_uuuu + t X_uuvv + w X_vvvv = p`.
pub(crate) const FOURTH: &[Entry] = &[
    required("order", "4", "The order of the equation s X_uuuu + t X_uuvv + w X_vvvv = p."),
    S,
    required("t", "number", "Shape control parameter of the mixed derivative."),
    required("w", "number", "Shape control parameter of the fourth v derivative."),
    required("modes", "readonly Mode<FourthOrderDatum>[]", "The Fourier sum of boundary data and force."),
];

pub(crate) const MODE: &[Entry] = &[
    required("n", "number", "How often it goes round; the surface closes when it is whole."),
    optional("cos", "Datum", "The data of cos(2 pi n v / span)."),
    optional("sin", "Datum", "The data of sin(2 pi n v / span)."),
];

/// What a mode of order 2 is given; what is left out is 0.
pub(crate) const SECOND_DATUM: &[Entry] = &[START, END, FORCE_ENTRY];

/// What a mode of order 4 is given; what is left out is 0.
pub(crate) const FOURTH_DATUM: &[Entry] = &[
    START,
    END,
    optional("start_u", "number", "Slope in u at u = 0."),
    optional("end_u", "number", "Slope in u at u = 1."),
    FORCE_ENTRY,
];

/// How a document writes [`Span::Tau`].
pub(crate) const TAU_NAME: &str = "2pi";

impl BoundaryValue {
    /// Reads the fields beside `kind`.
    pub(crate) fn read(record: &Record) -> Result<Self> {
        let component = |name| {
            let value = record.require(name, "an equation with its modes")?;
            Component::read(value, record.path.field(name))
        };
        Ok(BoundaryValue { span: Span::read(record)?, x: component("x")?, y: component("y")?, z: component("z")? })
    }

    pub(crate) fn write(&self, into: &mut Vec<(String, Value)>) {
        into.push(("span".into(), self.span.value()));
        for (name, component) in [("x", &self.x), ("y", &self.y), ("z", &self.z)] {
            into.push((name.into(), component.value()));
        }
    }

    /// The one way of writing this surface: numbers rounded, modes in ascending `n`, each `n` once, nothing that is 0.
    ///
    /// # Errors
    /// `overflow` when the data of two modes of the same `n` add up to more than a number can hold.
    pub(crate) fn canonical(self, path: &Path) -> Result<Self> {
        let component = |component: Component, name| component.canonical(&path.field(name));
        Ok(BoundaryValue {
            span: self.span.canonical(),
            x: component(self.x, "x")?,
            y: component(self.y, "y")?,
            z: component(self.z, "z")?,
        })
    }

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
    fn read(record: &Record) -> Result<Self> {
        const EXPECTED: &str = "a number greater than 0 or \"2pi\"";
        let path = record.path.field("span");
        match record.require("span", EXPECTED)? {
            Value::Text(text) if text == TAU_NAME => Ok(Span::Tau),
            value @ Value::Number(_) => Ok(Span::Length(reader::number(value, &path, Range::Positive)?)),
            value => Err(reader::wrong_type(value, &path, EXPECTED)),
        }
    }

    /// A length that is `2 pi` to twelve digits is `2 pi`.
    fn canonical(self) -> Self {
        match self {
            Span::Length(length) if rounded(length) != rounded(TAU) => Span::Length(rounded(length)),
            _ => Span::Tau,
        }
    }

    fn value(self) -> Value {
        match self {
            Span::Tau => Value::Text(TAU_NAME.into()),
            Span::Length(length) => Value::Number(length),
        }
    }
}

impl Component {
    fn read(value: &Value, path: Path) -> Result<Self> {
        let record = Record::open(value, path, "an equation with its modes")?;
        let order = Order::read(&record)?;
        let record = record.only(&table::names(match order {
            Order::Second => SECOND,
            Order::Fourth => FOURTH,
        }))?;
        let number =
            |name, range: Range| reader::number(record.require(name, "a number")?, &record.path.field(name), range);
        let s = number("s", Range::NotZero)?;
        let t = number("t", Range::Any)?;
        let w = match order {
            Order::Second => 0.0,
            Order::Fourth => number("w", Range::Any)?,
        };
        let path = record.path.field("modes");
        let modes = reader::list(record.require("modes", "a list of modes")?, &path, "a list of modes")?;
        let modes = modes.iter().enumerate().map(|(index, mode)| Mode::read(mode, path.item(index), order));
        Ok(Component { order, s, t, w, modes: modes.collect::<Result<_>>()? })
    }

    fn canonical(self, path: &Path) -> Result<Self> {
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
                return Err(path.field("modes").error(Code::Overflow, message));
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

    fn value(&self) -> Value {
        let number = |name: &str, x: f64| (name.to_owned(), Value::Number(x));
        let mut fields = vec![number("order", self.order.number()), number("s", self.s), number("t", self.t)];
        if self.order == Order::Fourth {
            fields.push(number("w", self.w));
        }
        fields.push(("modes".into(), Value::List(self.modes.iter().map(Mode::value).collect())));
        Value::Record(fields)
    }
}

impl Order {
    fn number(self) -> f64 {
        match self {
            Order::Second => 2.0,
            Order::Fourth => 4.0,
        }
    }

    fn read(record: &Record) -> Result<Self> {
        const EXPECTED: &str = "2 or 4";
        let path = record.path.field("order");
        match record.require("order", EXPECTED)? {
            Value::Number(2.0) => Ok(Order::Second),
            Value::Number(4.0) => Ok(Order::Fourth),
            value @ Value::Number(_) => {
                // A number that is not finite is refused as such.
                reader::number(value, &path, Range::Any)?;
                Err(path.error(Code::OutOfRange, format!("expected {EXPECTED}, found {}", value.described())))
            }
            value => Err(reader::wrong_type(value, &path, EXPECTED)),
        }
    }
}

impl Mode {
    fn read(value: &Value, path: Path, order: Order) -> Result<Self> {
        let record = Record::open(value, path, "a mode with n, cos and sin")?.only(&table::names(MODE))?;
        let n = reader::number(record.require("n", "a number")?, &record.path.field("n"), Range::Any)?;
        let datum = |name| match record.get(name) {
            Some(value) => Datum::read(value, record.path.field(name), order),
            None => Ok(Datum::default()),
        };
        Ok(Mode { n, cos: datum("cos")?, sin: datum("sin")? })
    }

    fn value(&self) -> Value {
        let mut fields = vec![("n".to_owned(), Value::Number(self.n))];
        for (name, datum) in [("cos", &self.cos), ("sin", &self.sin)] {
            if !datum.is_zero() {
                fields.push((name.into(), datum.value()));
            }
        }
        Value::Record(fields)
    }
}

impl Datum {
    fn read(value: &Value, path: Path, order: Order) -> Result<Self> {
        let record = Record::open(value, path, "boundary data")?.only(&table::names(match order {
            Order::Second => SECOND_DATUM,
            Order::Fourth => FOURTH_DATUM,
        }))?;
        let number = |name| match record.get(name) {
            Some(value) => reader::number(value, &record.path.field(name), Range::Any),
            None => Ok(0.0),
        };
        let force = match record.get("force") {
            Some(value) => read_force(value, &record.path.field("force"))?,
            None => Vec::new(),
        };
        Ok(Datum {
            start: number("start")?,
            end: number("end")?,
            start_u: number("start_u")?,
            end_u: number("end_u")?,
            force,
        })
    }

    fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        [self.start, self.end, self.start_u, self.end_u].into_iter().chain(self.force.iter().copied())
    }

    fn is_finite(&self) -> bool {
        self.numbers().all(f64::is_finite)
    }

    fn is_zero(&self) -> bool {
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

    fn value(&self) -> Value {
        let named = [("start", self.start), ("end", self.end), ("start_u", self.start_u), ("end_u", self.end_u)];
        let numbers = named.into_iter().filter(|(_, x)| *x != 0.0);
        let mut fields: Vec<_> = numbers.map(|(name, x)| (name.to_owned(), Value::Number(x))).collect();
        if !self.force.is_empty() {
            fields.push(("force".into(), Value::List(self.force.iter().map(|x| Value::Number(*x)).collect())));
        }
        Value::Record(fields)
    }
}

fn read_force(value: &Value, path: &Path) -> Result<Vec<f64>> {
    let items = reader::list(value, path, "a list of numbers")?;
    if items.len() > FORCE {
        let message = format!("expected at most {FORCE} coefficients, found {}", items.len());
        return Err(path.error(Code::TooLarge, message));
    }
    items.iter().enumerate().map(|(index, item)| reader::number(item, &path.item(index), Range::Any)).collect()
}
