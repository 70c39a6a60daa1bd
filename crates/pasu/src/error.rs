//! The one error of Pasu: whose fault, where, what was found and what was expected.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

/// What went wrong, as a stable code ([`Error::code`]), where in the design it went wrong ([`Error::path`]), a sentence for the person
/// who caused it ([`Error::message`]), and what that sentence names ([`Error::args`]).
///
/// The codes are public: programs match on them, so a code once released is never renamed.
///
/// ```
/// use pasu::{Arg, Code, Design};
///
/// let vase = Design::parse("#1/second-order").unwrap();
/// let error = pasu::evaluate(&vase, 0, &[0.5, 0.0, 1.5, 0.0]).unwrap_err();
/// assert_eq!(error.code(), Code::NoSuchPoint);
/// assert_eq!(error.path(), "at[2]");
/// assert_eq!(error.message(), "expected u from 0 to 1, found 1.5");
/// assert_eq!(error.arg("found"), Some(&Arg::Number(1.5)));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    code: Code,
    path: String,
    message: String,
    args: Vec<(&'static str, Arg)>,
    /// Coordinates as bits: errors can then be compared.
    place: Option<[u64; 3]>,
}

/// The result of everything in Pasu that can be refused.
pub type Result<T> = std::result::Result<T, Error>;

/// One thing that a message names: with the code and the path, a page has what it takes to say it in its own language.
///
/// Numbers are equal if their bits are, so that errors can be compared: what was found may be NaN.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
#[non_exhaustive]
pub enum Arg {
    /// A number, a count among them.
    Number(f64),
    /// A text of the design, or a word of the format.
    Text(String),
    /// Words of the format, one of which was expected.
    Words(Vec<String>),
}

/// What a finding or a reason names, each under its name, as [`Error::args`] of an error.
pub(crate) type Args = BTreeMap<&'static str, Arg>;

impl PartialEq for Arg {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Arg::Number(one), Arg::Number(other)) => one.to_bits() == other.to_bits(),
            (Arg::Text(one), Arg::Text(other)) => one == other,
            (Arg::Words(one), Arg::Words(other)) => one == other,
            _ => false,
        }
    }
}

impl Eq for Arg {}

impl From<f64> for Arg {
    fn from(number: f64) -> Self {
        Arg::Number(number)
    }
}

impl From<usize> for Arg {
    fn from(count: usize) -> Self {
        Arg::Number(count as f64)
    }
}

impl From<&str> for Arg {
    fn from(text: &str) -> Self {
        Arg::Text(text.to_owned())
    }
}

impl From<&[&str]> for Arg {
    fn from(words: &[&str]) -> Self {
        Arg::Words(words.iter().map(|word| (*word).to_owned()).collect())
    }
}

/// What can go wrong. Causes are added as the format grows, and none is renamed.
///
/// ```
/// use pasu::{Code, Design};
///
/// let error = Design::parse("#1/teapot").unwrap_err();
/// assert_eq!(error.code(), Code::UnknownName);
/// assert_eq!(error.code().as_str(), "unknown-name");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Code {
    /// The text is not JSON.
    NotJson,
    /// A field that the format does not know.
    UnknownField,
    /// A field that the format requires is absent.
    MissingField,
    /// The same field twice, or two parts with one name.
    Duplicate,
    /// A value of the wrong type.
    WrongType,
    /// A number that is not finite.
    NotFinite,
    /// A value outside its stated range.
    OutOfRange,
    /// A kind, unit, glaze or clay that the format does not know.
    UnknownName,
    /// A format version that this program does not know.
    UnknownVersion,
    /// A kind of shape that the format knows and this release cannot yet compute.
    UnsupportedShape,
    /// More parts, modes, characters, vertices or waves than the stated limit, a surface that changes faster, a file that is larger.
    TooLarge,
    /// A link that is not one of Pasu's, damaged, or cut short.
    DamagedLink,
    /// A boundary-value problem without a unique solution.
    ResonantProblem,
    /// A problem whose solution leaves the range of numbers.
    Overflow,
    /// A tolerance finer than the mesh's numbers can hold, or than the vertex limit allows.
    ToleranceTooFine,
    /// A part or parameter point that does not exist.
    NoSuchPoint,
    /// A part that is to be a pot and has no wall.
    NoWall,
    /// A surface that does not meet itself round the axis.
    OpenSurface,
    /// A surface that shrinks to a point or an edge without width between its ends, or at an end that needs width.
    PinchedSurface,
    /// A surface, or the clay on it, that runs through itself.
    CrossesItself,
    /// A surface that closes at the end where a pot is open.
    NoOpening,
    /// A wall, floor, ring or hole that does not fit.
    NoRoom,
    /// A call that was ended by whoever [watched](crate::watched) it.
    Cancelled,
    /// A mistake of Pasu's own.
    Bug,
}

impl Code {
    /// The stable kebab-case word.
    ///
    /// ```
    /// assert_eq!(pasu::Code::DamagedLink.as_str(), "damaged-link");
    /// ```
    pub fn as_str(self) -> &'static str {
        match self {
            Code::NotJson => "not-json",
            Code::UnknownField => "unknown-field",
            Code::MissingField => "missing-field",
            Code::Duplicate => "duplicate",
            Code::WrongType => "wrong-type",
            Code::NotFinite => "not-finite",
            Code::OutOfRange => "out-of-range",
            Code::UnknownName => "unknown-name",
            Code::UnknownVersion => "unknown-version",
            Code::UnsupportedShape => "unsupported-shape",
            Code::TooLarge => "too-large",
            Code::DamagedLink => "damaged-link",
            Code::ResonantProblem => "resonant-problem",
            Code::Overflow => "overflow",
            Code::ToleranceTooFine => "tolerance-too-fine",
            Code::NoSuchPoint => "no-such-point",
            Code::NoWall => "no-wall",
            Code::OpenSurface => "open-surface",
            Code::PinchedSurface => "pinched-surface",
            Code::CrossesItself => "crosses-itself",
            Code::NoOpening => "no-opening",
            Code::NoRoom => "no-room",
            Code::Cancelled => "cancelled",
            Code::Bug => "bug",
        }
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl Error {
    /// An error at a path of the design (`parts[2].shape.s[0]`; empty for the design as a whole).
    ///
    /// For whoever reads documents or options in a language of their own, as the bindings for JavaScript do.
    ///
    /// ```
    /// let error = pasu::Error::new(pasu::Code::OutOfRange, "rows", "expected at least 2 rows, found 1");
    /// assert_eq!(error.to_string(), "rows: expected at least 2 rows, found 1");
    /// ```
    pub fn new(code: Code, path: impl Into<String>, message: impl Into<String>) -> Self {
        Error { code, path: path.into(), message: message.into(), args: Vec::new(), place: None }
    }

    /// The same error with something that its message names. [`Error::args`] lists the names.
    ///
    /// ```
    /// use pasu::{Arg, Code, Error};
    ///
    /// let error = Error::new(Code::OutOfRange, "rows", "expected at least 2 rows, found 1").with("found", 1.0);
    /// assert_eq!(error.args(), [("found", Arg::Number(1.0))]);
    /// ```
    pub fn with(mut self, name: &'static str, arg: impl Into<Arg>) -> Self {
        self.args.push((name, arg.into()));
        self
    }

    /// The same error at another path.
    pub fn at(self, path: impl Into<String>) -> Self {
        Error { path: path.into(), ..self }
    }

    /// Code, path and what is named, without the sentence.
    pub(crate) fn cause(&self) -> (&'static str, Option<String>, Args) {
        let path = Some(self.path.clone()).filter(|path| !path.is_empty());
        (self.code.as_str(), path, self.args.iter().cloned().collect())
    }

    /// The same error in other words.
    pub(crate) fn saying(self, message: impl Into<String>) -> Self {
        Error { message: message.into(), ..self }
    }

    /// The same error at a point of space.
    pub(crate) fn near(self, point: [f64; 3]) -> Self {
        Error { place: Some(point.map(f64::to_bits)), ..self }
    }

    /// What went wrong.
    ///
    /// ```
    /// assert_eq!(pasu::Design::parse("#1~").unwrap_err().code(), pasu::Code::DamagedLink);
    /// ```
    pub fn code(&self) -> Code {
        self.code
    }

    /// Where in the design; empty for the design as a whole.
    ///
    /// ```
    /// assert_eq!(pasu::Design::parse("#1/second-order?s=1,0").unwrap_err().path(), "parts[0].shape.s[1]");
    /// ```
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Where in space, in model units after placement, if it went wrong at a point of a pot.
    ///
    /// ```
    /// use pasu::{Design, Product};
    ///
    /// // From radius 2 to radius -2: a point in the middle.
    /// let shape = r#"{ "kind": "second-order", "r": [2, 0, -2, 0], "t": [0, 0], "n": [1, 2], "height": 5 }"#;
    /// let wall = r#"{ "thickness": 0.2, "base": 0.3 }"#;
    /// let pinched = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#))?;
    /// let error = pasu::Pot::new(&pinched, 0, Product::Pot).unwrap_err();
    /// assert!(error.place().is_some_and(|[_, _, z]| (z - 2.5).abs() < 1e-9));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn place(&self) -> Option<[f64; 3]> {
        self.place.map(|place| place.map(f64::from_bits))
    }

    /// One sentence in the user's words: what was found and what was expected.
    ///
    /// ```
    /// assert_eq!(pasu::Design::parse("#1/second-order?s=1,0").unwrap_err().message(), "expected a number other than 0, found 0");
    /// ```
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What the message names, each under one of these names:
    ///
    /// | name | what it is |
    /// | --- | --- |
    /// | `found` | the number or the text that was refused, or how many there are |
    /// | `least`, `greatest` | the range of what was expected, both ends included |
    /// | `above`, `below` | the same, without the end |
    /// | `not` | a number that was not expected |
    /// | `words` | the words one of which was expected |
    /// | `component`, `n` | the component `x`, `y` or `z` and the mode of an equation |
    /// | `s`, `t`, `w` | the parameters of the equation |
    /// | `rows`, `columns` | vertices along `u` and round the axis that a mesh would need or has |
    /// | `face`, `other` | the faces of a pot that meet where they should not, in the words of [`FaceKind::name`](crate::FaceKind::name) |
    /// | `what` | which of several things it is that have this code, as a stable kebab-case word |
    /// | `thickness` | of the wall, where it was found too thin |
    /// | `end` | `foot`, `rim`, `floor` or `underside` of the pot |
    /// | `base`, `width`, `drain` | of the wall that was asked for: of its base, of its ring, of its drain |
    /// | `room` | how wide what is to hold it is |
    /// | `bound` | within which triangles step over what finer ones run into |
    ///
    /// Lengths are in the unit of the design; those whose names end in `Mm` are in millimetres of what is made.
    ///
    /// A message that names nothing has none; a name that is not listed here may come with a later release.
    pub fn args(&self) -> &[(&'static str, Arg)] {
        &self.args
    }

    /// One of [`Error::args`] by its name.
    pub fn arg(&self, name: &str) -> Option<&Arg> {
        self.args.iter().find(|(known, _)| *known == name).map(|(_, arg)| arg)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() { f.write_str(&self.message) } else { write!(f, "{}: {}", self.path, self.message) }
    }
}

impl std::error::Error for Error {}
