//! The one error of Pasu: whose fault, where, what was found and what was expected.

use std::fmt;

/// What went wrong, as a stable kebab-case word ([`Error::code`]), where in the design it went wrong
/// ([`Error::path`]) and a sentence for the person who caused it ([`Error::message`]).
///
/// The codes are public: programs match on them, so a code once released is never renamed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    code: Code,
    path: String,
    message: String,
    /// Coordinates as bits: errors can then be compared.
    place: Option<[u64; 3]>,
}

/// The result of everything in Pasu that can be refused.
pub type Result<T> = std::result::Result<T, Error>;

/// The closed set of causes behind [`Error::code`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// More parts, modes, characters or vertices than the stated limit.
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
    /// A mistake of Pasu's own.
    Bug,
}

impl Code {
    /// The stable kebab-case word.
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
            Code::Bug => "bug",
        }
    }
}

impl Error {
    /// An error at a path of the design (`parts[2].shape.s[0]`; empty for the design as a whole).
    pub fn new(code: Code, path: impl Into<String>, message: impl Into<String>) -> Self {
        Error { code, path: path.into(), message: message.into(), place: None }
    }

    /// The same error at another path.
    pub(crate) fn at(self, path: impl Into<String>) -> Self {
        Error { path: path.into(), ..self }
    }

    /// The same error at a point of space.
    pub(crate) fn near(self, point: [f64; 3]) -> Self {
        Error { place: Some(point.map(f64::to_bits)), ..self }
    }

    /// The stable kebab-case word for the cause.
    pub fn code(&self) -> &'static str {
        self.code.as_str()
    }

    /// Where in the design; empty for the design as a whole.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Where in space, in model units after placement, if it went wrong at a point of a pot.
    pub fn place(&self) -> Option<[f64; 3]> {
        self.place.map(|place| place.map(f64::from_bits))
    }

    /// One sentence in the user's words: what was found and what was expected.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() { f.write_str(&self.message) } else { write!(f, "{}: {}", self.path, self.message) }
    }
}

impl std::error::Error for Error {}
