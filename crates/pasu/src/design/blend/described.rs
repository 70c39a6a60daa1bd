//! What there is to know of a blend beside its fields.

use super::fields::{Blend, Form, Harmonic, Method, Section, TERMS};
#[cfg(feature = "typescript")]
use crate::design::declarations::{interface, union};
use crate::design::described::{Address, Described};
use crate::design::number::rounded;
use crate::design::placement::Placement;
#[cfg(feature = "typescript")]
use crate::design::tables::{BLEND, HARMONIC, OUTLINE_SECTION, SECTION};
use crate::error::{Code, Error, Result};

impl Described for Blend {
    fn address(&self) -> Address {
        Address::Volume
    }

    /// Numbers rounded, harmonics in ascending `n`, each `n` once, nothing that is 0; the method is left out where it is the usual one, and terms where the method does not use them.
    fn canonical(mut self) -> Result<Self> {
        self.start.canonical();
        self.end.canonical();
        self.weights = self.weights.map(rounded);
        self.method = Some(self.method()).filter(|method| *method != self.usual_method());
        match self.method() {
            Method::Exact => self.terms = TERMS,
            Method::Modal => self.terms[2] = TERMS[2],
            Method::Collocation => {}
        }
        self.finite()
    }

    /// The harmonics of closed sections, or the products of sines that each have a system of their own.
    fn cost(&self) -> usize {
        let harmonics = self.harmonics().count();
        match self.method() {
            Method::Exact => harmonics + 1,
            _ => harmonics + self.terms[0] as usize * self.terms[1] as usize,
        }
    }

    fn waves(&self) -> Vec<(String, f64)> {
        self.harmonics().map(|(place, harmonic)| (format!("{place}.n"), harmonic.n)).collect()
    }

    fn standing(self, given: &Placement, place: Placement) -> (Self, Placement) {
        let is_upright = place.angle == 0.0 && place.scale[1] > 0.0;
        let place = if is_upright { place } else { self.symmetry().standing(given, place) };
        (self, place)
    }

    /// Refuses outlines without a wave, a method that the sections do not have, and numbers whose products leave the range of numbers.
    fn finite(self) -> Result<Self> {
        for (name, section) in self.sections() {
            section.finite().map_err(|error| error.inside_field(name))?;
            if self.method() == Method::Exact && matches!(section.form, Form::DiscInSquare(_)) {
                return Err(section.form.no_closed_form().inside_field("method"));
            }
        }
        Ok(self)
    }

    #[cfg(feature = "typescript")]
    fn typescript(_: &str, text: &mut String) {
        interface(text, "Blend", "A solid that flows from one section into another (ZY04).", BLEND);
        text.push_str(
            "\n/** A plane section with its tangents. */\n\
             export type Section = FormedSection | OutlineSection;\n",
        );
        interface(text, "FormedSection", "A section of one of the forms of ZY04.", SECTION);
        interface(text, "OutlineSection", "A section within a closed curve.", OUTLINE_SECTION);
        interface(text, "Harmonic", "One harmonic of a closed curve.", HARMONIC);
        union(text, "Method", "How the equation of a blend is solved.", Method::NAMES);
    }
}

impl Blend {
    fn sections(&self) -> [(&'static str, &Section); 2] {
        [("start", &self.start), ("end", &self.end)]
    }

    /// Every harmonic with where it stands.
    pub(crate) fn harmonics(&self) -> impl Iterator<Item = (String, &Harmonic)> {
        self.sections().into_iter().flat_map(|(name, section)| {
            section.form.series().into_iter().zip(["x", "y"]).flat_map(move |(series, axis)| {
                let places = series.iter().enumerate();
                places.map(move |(index, harmonic)| (format!("{name}.{axis}[{index}]"), harmonic))
            })
        })
    }
}

impl Form {
    /// The series of `x` and of `y`; empty where it is none.
    fn series(&self) -> [&[Harmonic]; 2] {
        match self {
            Form::Outline { x, y } => [x, y],
            _ => [&[], &[]],
        }
    }

    /// That a section of this form has no closed form, which the method `exact` takes.
    pub(crate) fn no_closed_form(&self) -> Error {
        let form = self.name();
        let message = format!(
            "expected \"modal\" or \"collocation\", found \"exact\": a {form} has no closed form, as it is neither a polynomial nor a Fourier series"
        );
        Error::new(Code::OutOfRange, "", message).with("form", form)
    }
}

impl Section {
    fn canonical(&mut self) {
        for number in [&mut self.z, &mut self.taper, &mut self.dz] {
            *number = rounded(*number);
        }
        match &mut self.form {
            Form::Rectangle(radius)
            | Form::RectangleReversed(radius)
            | Form::Disc(radius)
            | Form::DiscInSquare(radius) => *radius = radius.map(rounded),
            Form::Outline { x, y } => {
                canonical_series(x);
                canonical_series(y);
            }
        }
    }

    fn finite(&self) -> Result<()> {
        let sizes = match &self.form {
            Form::Rectangle(radius)
            | Form::RectangleReversed(radius)
            | Form::Disc(radius)
            | Form::DiscInSquare(radius) => *radius,
            Form::Outline { .. } => {
                for (name, series) in ["x", "y"].into_iter().zip(self.form.series()) {
                    if !series.iter().any(|wave| wave.n != 0.0 && (wave.cos != 0.0 || wave.sin != 0.0)) {
                        let message = "expected a wave that goes round the outline, n of 1 or more, found none";
                        return Err(Error::new(Code::OutOfRange, name, message));
                    }
                }
                self.form.series().map(|series| series.iter().map(|wave| wave.cos.abs() + wave.sin.abs()).sum())
            }
        };
        let products = sizes.iter().flat_map(|size| [4.0 * size, 4.0 * size * self.taper]);
        let levels = [4.0 * self.z, 4.0 * self.dz];
        match products.chain(levels).all(f64::is_finite) {
            true => Ok(()),
            false => {
                let message = "these numbers are so large that their products cannot be computed";
                Err(Error::new(Code::Overflow, "", message))
            }
        }
    }
}

fn canonical_series(series: &mut Vec<Harmonic>) {
    let mut harmonics: Vec<Harmonic> = Vec::with_capacity(series.len());
    for harmonic in series.drain(..) {
        let harmonic = Harmonic { n: rounded(harmonic.n), ..harmonic };
        match harmonics.binary_search_by(|earlier| earlier.n.total_cmp(&harmonic.n)) {
            Ok(same) => {
                harmonics[same].cos += harmonic.cos;
                harmonics[same].sin += harmonic.sin;
            }
            Err(place) => harmonics.insert(place, harmonic),
        }
    }
    for harmonic in &mut harmonics {
        (harmonic.cos, harmonic.sin) = (rounded(harmonic.cos), rounded(harmonic.sin));
        // sin(0 v) is 0 whatever its factor.
        if harmonic.n == 0.0 {
            harmonic.sin = 0.0;
        }
    }
    harmonics.retain(|harmonic| harmonic.cos != 0.0 || harmonic.sin != 0.0);
    *series = harmonics;
}
