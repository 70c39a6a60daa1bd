//! The fields of a pot of rings.

use serde::de::{Deserialize, Deserializer, Error as _, Unexpected};
use serde::ser::{SerializeStruct, Serializer};
use serde::{Serialize, de};

use crate::design::limits::RINGS;
use crate::design::list;
use crate::design::number::{plain, rounded};
use crate::design::quantity::{any, is_zero, or_default, or_zero};
use crate::design::ring::ascending;
use crate::error::{Code, Error, Result};
use crate::numeric::ascending::distinct;

/// A pot through any number of rings, `(d2/du2 + a^2 d2/dv2)^2 X = 0` between each two of them. `u = 0` is the foot, `u = 1` the rim.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(expecting = "a shape")]
pub struct Rings {
    /// The smoothing parameter: how strongly the wall is drawn towards a round tube. 1 when left out.
    #[serde(deserialize_with = "or_one")]
    pub a: f64,
    /// From the foot to the rim: 2 to 66.
    #[serde(deserialize_with = "hoops")]
    pub rings: Vec<Hoop>,
    /// The slopes at the foot; without them it is free.
    #[serde(deserialize_with = "or_default")]
    pub foot: Option<Slopes>,
    /// The slopes at the rim; without them it is free.
    #[serde(deserialize_with = "or_default")]
    pub rim: Option<Slopes>,
}

/// One ring of a pot.
#[derive(Debug, Clone, PartialEq, Serialize, serde::Deserialize)]
#[serde(expecting = "a ring with u, r and z")]
pub struct Hoop {
    /// Where it is along the profile: 0 at the foot, 1 at the rim.
    #[serde(deserialize_with = "any")]
    pub u: f64,
    /// Its radius.
    pub r: Series,
    /// Its height.
    pub z: Series,
    /// Whether the profile has a corner there; at the foot and the rim without meaning.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_not")]
    pub sharp: bool,
}

/// Derivatives in `u` of radius and height at an end.
#[derive(Debug, Clone, PartialEq, Serialize, serde::Deserialize)]
#[serde(expecting = "slopes r and z")]
pub struct Slopes {
    /// Of the radius.
    pub r: Series,
    /// Of the height.
    pub z: Series,
}

/// `mean + sum_n [ cos cos(n v) + sin sin(n v) ]`.
#[derive(Debug, Clone, PartialEq, Serialize, serde::Deserialize)]
#[serde(expecting = "a mean with waves")]
pub struct Series {
    /// The mean round the axis.
    #[serde(deserialize_with = "any")]
    pub mean: f64,
    /// What goes up and down about it.
    #[serde(deserialize_with = "waves", skip_serializing_if = "Vec::is_empty")]
    pub waves: Vec<Wave>,
}

/// One harmonic of a series.
#[derive(Debug, Clone, PartialEq, Serialize, serde::Deserialize)]
#[serde(expecting = "a wave with n, cos and sin")]
pub struct Wave {
    /// How often it goes up and down round the axis: whole, and 1 or more.
    #[serde(deserialize_with = "count")]
    pub n: f64,
    /// How far as `cos(n v)`.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub cos: f64,
    /// How far as `sin(n v)`.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub sin: f64,
}

/// The most rings with foot and rim.
const MOST: usize = RINGS + 2;

impl Rings {
    /// What a readable link starts from: a bottle. Frozen with version 1 of the format.
    #[inline]
    pub(super) fn start() -> Rings {
        let plain = |mean: f64| Series { mean, waves: Vec::new() };
        let hoop = |(u, r, z)| Hoop { u, r: plain(r), z: plain(z), sharp: false };
        let rings = [(0.0, 3.0, 0.0), (0.35, 6.0, 6.0), (0.7, 1.6, 15.0), (1.0, 2.2, 20.0)].map(hoop);
        Rings { a: 1.0, rings: rings.into(), foot: None, rim: None }
    }

    fn slopes(&self) -> impl Iterator<Item = &Slopes> {
        [&self.foot, &self.rim].into_iter().flatten()
    }

    #[inline]
    pub(super) fn series(&self) -> impl Iterator<Item = &Series> {
        let hoops = self.rings.iter().flat_map(|hoop| [&hoop.r, &hoop.z]);
        hoops.chain(self.slopes().flat_map(|slopes| [&slopes.r, &slopes.z]))
    }

    /// The different `n` of all radii, and of all heights.
    #[inline]
    pub(super) fn harmonics(&self) -> [Vec<f64>; 2] {
        let radii = self.rings.iter().map(|hoop| &hoop.r).chain(self.slopes().map(|slopes| &slopes.r));
        let heights = self.rings.iter().map(|hoop| &hoop.z).chain(self.slopes().map(|slopes| &slopes.z));
        [radii.collect::<Vec<_>>(), heights.collect()].map(|all: Vec<&Series>| {
            distinct(all.into_iter().flat_map(|series| series.waves.iter().map(|wave| wave.n)))
        })
    }

    /// The path begins at the list.
    #[inline]
    pub(super) fn lead_from_foot_to_rim(&self) -> Result<()> {
        let [first, inner @ .., last] = &self.rings[..] else { return Ok(()) };
        for (index, hoop, expected) in [(0, first, 0.0), (inner.len() + 1, last, 1.0)] {
            if hoop.u != expected {
                let end = if index == 0 { "foot" } else { "rim" };
                let message = format!("expected {}, the {end}, found {}", plain(expected), plain(hoop.u));
                let error = Error::new(Code::OutOfRange, "u", message).inside_item(index);
                return Err(error.with("expected", expected).with("found", hoop.u));
            }
        }
        ascending(inner.iter().map(|hoop| hoop.u), 1)
    }
}

impl Series {
    #[inline]
    pub(super) fn canonical(&mut self) {
        self.mean = rounded(self.mean);
        let mut waves: Vec<Wave> = Vec::with_capacity(self.waves.len());
        for wave in self.waves.drain(..) {
            let wave = Wave { n: rounded(wave.n), ..wave };
            match waves.binary_search_by(|earlier| earlier.n.total_cmp(&wave.n)) {
                Ok(same) => {
                    waves[same].cos += wave.cos;
                    waves[same].sin += wave.sin;
                }
                Err(place) => waves.insert(place, wave),
            }
        }
        for wave in &mut waves {
            (wave.cos, wave.sin) = (rounded(wave.cos), rounded(wave.sin));
        }
        waves.retain(|wave| wave.cos != 0.0 || wave.sin != 0.0);
        self.waves = waves;
    }

    /// No sum of parts of it is larger.
    #[inline]
    pub(super) fn size(&self) -> f64 {
        self.waves.iter().fold(self.mean.abs(), |size, wave| size + wave.cos.abs() + wave.sin.abs())
    }
}

impl Serialize for Rings {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Rings", 4)?;
        match self.a == 1.0 {
            true => fields.skip_field("a")?,
            false => fields.serialize_field("a", &self.a)?,
        }
        fields.serialize_field("rings", &self.rings)?;
        for (name, slopes) in [("foot", &self.foot), ("rim", &self.rim)] {
            match slopes {
                None => fields.skip_field(name)?,
                Some(slopes) => fields.serialize_field(name, slopes)?,
            }
        }
        fields.end()
    }
}

fn is_not(sharp: &bool) -> bool {
    !sharp
}

fn or_one<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<f64, D::Error> {
    struct Given(f64);

    impl Default for Given {
        fn default() -> Self {
            Given(1.0)
        }
    }

    impl<'de> Deserialize<'de> for Given {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
            any(deserializer).map(Given)
        }
    }

    or_default(deserializer).map(|Given(a)| a)
}

fn hoops<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Vec<Hoop>, D::Error> {
    let (expected, most) = (format!("a list of 2 to {MOST} rings"), format!("at most {MOST} rings"));
    let hoops: Vec<Hoop> = list::read(deserializer, &expected, Some((MOST, &most)))?;
    let found = match hoops.len() {
        0 => "an empty list",
        1 => "a list of 1",
        _ => return Ok(hoops),
    };
    Err(D::Error::invalid_value(Unexpected::Other(found), &expected.as_str()))
}

fn waves<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Vec<Wave>, D::Error> {
    #[derive(Default)]
    struct Waves(Vec<Wave>);

    impl<'de> Deserialize<'de> for Waves {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
            list::read(deserializer, "a list of waves", None).map(Waves)
        }
    }

    or_default(deserializer).map(|Waves(waves)| waves)
}

/// A whole number that is 1 or more.
fn count<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<f64, D::Error> {
    let n: f64 = any(deserializer)?;
    match n >= 1.0 && n == n.trunc() {
        true => Ok(n),
        false => Err(de::Error::invalid_value(Unexpected::Float(n), &"a whole number, 1 or greater")),
    }
}
