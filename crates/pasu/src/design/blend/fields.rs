//! The fields of a blend.

use serde::de::{Deserializer, Error as _, Unexpected};
use serde::ser::{SerializeStruct, Serializer};
use serde::{Deserialize, Serialize};

use crate::design::limits::HARMONICS;
use crate::design::list;
use crate::design::names::names;
use crate::design::number::plain;
use crate::design::quantity::{any, is_zero, maybe_positive, or_default, or_zero, positive};

/// A solid `x(u, v, w)` between two sections, `a x_uuuu + b x_vvvv + c x_wwww = 0` (ZY04), with position and `w`-tangent given on both.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(expecting = "a shape")]
pub struct Blend {
    /// The section at `w = 0`.
    pub start: Section,
    /// The section at `w = 1`.
    pub end: Section,
    /// How the equation is solved; [`Blend::method`] says how where nothing is given.
    #[serde(deserialize_with = "or_default")]
    pub method: Option<Method>,
    /// How many terms along `u`, `v` and `w`; of no meaning to [`Method::Exact`], and the last of none to [`Method::Modal`].
    #[serde(deserialize_with = "terms")]
    pub terms: [u32; 3],
    /// The weights `[a, b, c]` of the three directions.
    #[serde(deserialize_with = "weights")]
    pub weights: [f64; 3],
}

names! {
    /// How the equation of a blend is solved.
    pub enum Method {
        /// Each harmonic as the mode problem that it is: nothing is approximated. For sections that are polynomials along `u` and Fourier series or polynomials round `v`.
        Exact = "exact",
        /// Sines along `u` and `v`, each product of two solved exactly along `w`. For any sections.
        Modal = "modal",
        /// Sines along `u` and `v`, squares of sines along `w`, by collocation: the method of ZY04.
        Collocation = "collocation",
    }
}

/// A plane section with its tangents: its positions at height `z`, its tangents `taper` times the position in `x` and `y` and `dz` in `z`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(from = "Given")]
pub struct Section {
    /// Its outline, and how `u` and `v` run over what is inside.
    pub form: Form,
    /// Its height.
    pub z: f64,
    /// Its tangents in `x` and `y`, in parts of the position.
    pub taper: f64,
    /// Its tangents in `z`.
    pub dz: f64,
}

/// What a section is like, before its height.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// `(rx (1 - 2u), ry (1 - 2v))`.
    Rectangle([f64; 2]),
    /// `(rx (2u - 1), ry (2v - 1))`.
    RectangleReversed([f64; 2]),
    /// `(rx u sin 2 pi v, ry u cos 2 pi v)`.
    Disc([f64; 2]),
    /// `(rx (2u - 1), ry (2v - 1) sqrt(1 - (2u - 1)^2))`.
    DiscInSquare([f64; 2]),
    /// A closed curve as a Fourier series in `2 pi v`, drawn together by `u` towards its mean.
    Outline {
        /// The series of `x`.
        x: Vec<Harmonic>,
        /// The series of `y`.
        y: Vec<Harmonic>,
    },
}

/// One harmonic of an outline: `cos cos(2 pi n v) + sin sin(2 pi n v)`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a harmonic with n, cos and sin")]
pub struct Harmonic {
    /// How often it goes up and down round the outline: whole, 0 for the mean.
    #[serde(deserialize_with = "count")]
    pub n: f64,
    /// How far as a cosine.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub cos: f64,
    /// How far as a sine.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub sin: f64,
}

/// The terms of the paper's examples.
pub(in crate::design) const TERMS: [u32; 3] = [4, 4, 3];

/// The most terms along `u` and along `v`, and along `w`.
pub(in crate::design) const MOST_TERMS: [u32; 3] = [256, 256, 64];

impl Blend {
    /// How the equation is solved: as it is said, else [`Method::Exact`] between two closed sections, and [`Method::Modal`] between others.
    ///
    /// ```
    /// use pasu::{Method, Shape};
    ///
    /// let section = |form: &str, z: f64| format!(r#"{{ "form": "{form}", "radius": [2, 1], "z": {z}, "taper": 0, "dz": 3 }}"#);
    /// let method = |form: &str| {
    ///     let text = format!(r#"{{ "kind": "blend", "start": {}, "end": {} }}"#, section(form, 0.0), section("disc", 3.0));
    ///     match Shape::parse(&text)? {
    ///         Shape::Blend(blend) => Ok::<Method, pasu::Error>(blend.method()),
    ///         _ => unreachable!(),
    ///     }
    /// };
    /// assert_eq!(method("disc")?, Method::Exact);
    /// assert_eq!(method("rectangle")?, Method::Modal);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn method(&self) -> Method {
        self.method.unwrap_or_else(|| self.usual_method())
    }

    pub(super) fn usual_method(&self) -> Method {
        let are_closed = [&self.start, &self.end].iter().all(|section| section.form.is_closed());
        if are_closed { Method::Exact } else { Method::Modal }
    }
}

impl Form {
    /// Whether `v` runs once round it, from a seam to the same seam.
    pub(crate) fn is_closed(&self) -> bool {
        matches!(self, Form::Disc(_) | Form::Outline { .. })
    }

    /// The word in a document's `form`.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Form::Rectangle(_) => "rectangle",
            Form::RectangleReversed(_) => "rectangle-reversed",
            Form::Disc(_) => "disc",
            Form::DiscInSquare(_) => "disc-in-square",
            Form::Outline { .. } => "outline",
        }
    }
}

/// A section as a document gives it: the form says what there is to be given.
#[derive(Deserialize)]
#[serde(rename = "form", expecting = "a section")]
enum Given {
    #[serde(rename = "rectangle")]
    Rectangle(WithRadius),
    #[serde(rename = "rectangle-reversed")]
    RectangleReversed(WithRadius),
    #[serde(rename = "disc")]
    Disc(WithRadius),
    #[serde(rename = "disc-in-square")]
    DiscInSquare(WithRadius),
    #[serde(rename = "outline")]
    Outline(Outlined),
}

#[derive(Deserialize)]
#[serde(expecting = "a section")]
struct WithRadius {
    #[serde(deserialize_with = "positive")]
    radius: [f64; 2],
    #[serde(deserialize_with = "any")]
    z: f64,
    #[serde(deserialize_with = "any")]
    taper: f64,
    #[serde(deserialize_with = "any")]
    dz: f64,
}

#[derive(Deserialize)]
#[serde(expecting = "a section")]
struct Outlined {
    #[serde(deserialize_with = "harmonics")]
    x: Vec<Harmonic>,
    #[serde(deserialize_with = "harmonics")]
    y: Vec<Harmonic>,
    #[serde(deserialize_with = "any")]
    z: f64,
    #[serde(deserialize_with = "any")]
    taper: f64,
    #[serde(deserialize_with = "any")]
    dz: f64,
}

impl From<Given> for Section {
    fn from(given: Given) -> Self {
        let of = |form: fn([f64; 2]) -> Form, WithRadius { radius, z, taper, dz }| Section {
            form: form(radius),
            z,
            taper,
            dz,
        };
        match given {
            Given::Rectangle(section) => of(Form::Rectangle, section),
            Given::RectangleReversed(section) => of(Form::RectangleReversed, section),
            Given::Disc(section) => of(Form::Disc, section),
            Given::DiscInSquare(section) => of(Form::DiscInSquare, section),
            Given::Outline(Outlined { x, y, z, taper, dz }) => Section { form: Form::Outline { x, y }, z, taper, dz },
        }
    }
}

impl Serialize for Section {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Section", 6)?;
        fields.serialize_field("form", self.form.name())?;
        match &self.form {
            Form::Rectangle(radius)
            | Form::RectangleReversed(radius)
            | Form::Disc(radius)
            | Form::DiscInSquare(radius) => fields.serialize_field("radius", radius)?,
            Form::Outline { x, y } => {
                fields.serialize_field("x", x)?;
                fields.serialize_field("y", y)?;
            }
        }
        for (name, number) in [("z", self.z), ("taper", self.taper), ("dz", self.dz)] {
            fields.serialize_field(name, &number)?;
        }
        fields.end()
    }
}

impl Serialize for Blend {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Blend", 5)?;
        fields.serialize_field("start", &self.start)?;
        fields.serialize_field("end", &self.end)?;
        match self.method {
            None => fields.skip_field("method")?,
            Some(method) => fields.serialize_field("method", &method)?,
        }
        match self.terms == TERMS {
            true => fields.skip_field("terms")?,
            false => fields.serialize_field("terms", &self.terms)?,
        }
        match self.weights == [1.0; 3] {
            true => fields.skip_field("weights")?,
            false => fields.serialize_field("weights", &self.weights)?,
        }
        fields.end()
    }
}

fn harmonics<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Harmonic>, D::Error> {
    let most = format!("at most {HARMONICS} harmonics");
    list::read(deserializer, "a list of harmonics", Some((HARMONICS, &most)))
}

/// A whole number that is 0 or more.
fn count<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    let n: f64 = any(deserializer)?;
    match n >= 0.0 && n == n.trunc() {
        true => Ok(n),
        false => Err(D::Error::invalid_value(Unexpected::Float(n), &"a whole number, 0 or greater")),
    }
}

/// Three whole numbers, those of the paper when they are left out.
fn terms<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[u32; 3], D::Error> {
    struct Terms([u32; 3]);

    impl Default for Terms {
        fn default() -> Self {
            Terms(TERMS)
        }
    }

    impl<'de> Deserialize<'de> for Terms {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let numbers: [f64; 3] = any(deserializer)?;
            let mut terms = [0; 3];
            for ((term, x), most) in terms.iter_mut().zip(numbers).zip(MOST_TERMS) {
                let expected = format!("a whole number from 1 to {}", plain(f64::from(most)));
                if !(x == x.trunc() && (1.0..=f64::from(most)).contains(&x)) {
                    return Err(D::Error::invalid_value(Unexpected::Float(x), &expected.as_str()));
                }
                *term = x as u32;
            }
            Ok(Terms(terms))
        }
    }

    or_default(deserializer).map(|Terms(terms)| terms)
}

fn weights<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 3], D::Error> {
    maybe_positive(deserializer).map(|weights| weights.unwrap_or([1.0; 3]))
}
