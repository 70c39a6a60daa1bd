//! The whole design: checked, canonical, and never anything else.

use std::collections::BTreeMap;

use serde::de::{Deserialize, Deserializer, Error as _, Unexpected};
use serde::ser::{Serialize, Serializer};

use super::limits::{BYTES, LINK_BYTES, MODES, PARTS, VERSION};
#[cfg(feature = "patchwork")]
use super::number::rounded;
use super::number::{numbers_of, plain};
use super::part::Part;
use super::placement::Placement;
use super::quantity::{is_default, or_default, whole};
use super::shape::Shape;
use super::unit::Unit;
use super::value::Value;
use super::{label, limits, list, reader, refusal, text};
use crate::error::{Code, Error, Result};

/// A design: what a person has chosen, from which everything else is computed.
///
/// A `Design` can only be made by reading one. It is therefore always within the stated limits and always in
/// canonical form: numbers of twelve significant digits, placements in their unique form, defaults dropped when it is
/// written. Two equal designs have equal documents and equal links, byte for byte.
///
/// ```
/// use pasu::Design;
///
/// let design = Design::parse(
///     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "height": 3.6 } }] }"#,
/// )?;
/// assert_eq!(
///     design.to_json(),
///     r#"{"pasu":1,"parts":[{"shape":{"kind":"second-order","r":[1,0.1,0.6,0.06]}}]}"#
/// );
/// # Ok::<(), pasu::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Design(Document, Extent);

/// Equal documents are equal designs.
impl PartialEq for Design {
    fn eq(&self, other: &Design) -> bool {
        self.0 == other.0
    }
}

/// How it is known that a document is not too long, so that a point that moves does not have all of it written.
#[derive(Debug, Clone, Copy)]
enum Extent {
    /// Nobody has looked since.
    Unknown,
    /// It is short enough with the longest numbers that there are, and so with any.
    Bounded,
    /// As long as it was written, in bytes, and so many of them are of networks.
    Written { length: usize, networks: usize },
}

/// The fields of a document.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(expecting = "a design")]
struct Document {
    #[serde(deserialize_with = "whole")]
    pasu: u32,
    #[serde(deserialize_with = "label::read", skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    unit: Unit,
    #[serde(deserialize_with = "parts")]
    parts: Vec<Part>,
}

impl Design {
    /// Reads a JSON document. A null in it is refused: no field may be null, and `JSON.stringify` writes one for NaN.
    #[inline]
    pub(crate) fn from_json(json: &str) -> Result<Design> {
        let value = text::read(json)?;
        let design = Design::from_value(&value)?;
        without_null(&value)?;
        Ok(design)
    }

    /// Reads a design from any plain data whose reader refuses with this crate's [`Error`]: JavaScript objects, for example. A field that is null counts as absent,
    /// which is how a JavaScript field arrives that is `undefined`. From other readers, [`Deserialize`] says the same in their errors.
    ///
    /// ```
    /// use pasu::{Design, Error};
    /// use serde::de::value::MapDeserializer;
    ///
    /// let fields = MapDeserializer::<_, Error>::new([("pasu", 2)].into_iter());
    /// assert_eq!(Design::read(fields).unwrap_err().path(), "pasu");
    /// ```
    ///
    /// # Errors
    /// Every refusal names the path, the value and what was expected: `unknown-field`, `missing-field`, `duplicate`,
    /// `wrong-type`, `not-finite`, `out-of-range`, `unknown-name`, `unknown-version`, `unsupported-shape`,
    /// `too-large`, and `overflow` when parameters are so large that their products cannot be held.
    pub fn read<'de, D: Deserializer<'de, Error = Error>>(source: D) -> Result<Design> {
        Design::from_value(&reader::buffered(source)?)
    }

    // Compiled where it is called, as all that leads to `serde`: the bindings are compiled for size, this crate for speed.
    #[inline]
    pub(crate) fn from_value(value: &Value) -> Result<Design> {
        check_version(value)?;
        let document: Document = reader::read(value)?;
        Document { parts: canonical(document.parts)?, ..document }.within_limit()
    }

    /// The same design with another shape of one of its parts.
    ///
    /// # Errors
    /// As [`Design::read`], of what the shape is too large for.
    pub(crate) fn with_shape(&self, part: usize, shape: Shape) -> Result<Design> {
        let mut document = self.0.clone();
        document.parts[part].shape = shape;
        Document { parts: canonical(document.parts)?, ..document }.within_limit()
    }

    /// The same design with points of a network elsewhere: each by its number with where it is. Only these are looked at, which of thousands is what a hand has time for.
    ///
    /// # Errors
    /// `no-such-point` for a part that does not exist, or a point; `unsupported-shape` for a part that is no network of patches; otherwise as [`Design::read`].
    ///
    /// ```
    /// use pasu::Design;
    ///
    /// let text = r#"{"pasu":1,"parts":[{"shape":{"kind":"vertex-frame","vertices":[[0,0,0],[1,0,0],[2,0,0],[2,1,0],[2,2,0],[1,2,0],[0,2,0],[0,1,0]],"patches":[{"frame":[0,1,2,3,4,5,6,7]}]}}]}"#;
    /// let design = Design::parse(text)?.with_points(0, &[(4, [2.0, 2.0, 0.5])])?;
    /// assert_eq!(design, Design::parse(&text.replace("[2,2,0]", "[2,2,0.5]"))?);
    /// assert_eq!(design.with_points(0, &[(8, [0.0; 3])]).unwrap_err().path(), "parts[0].shape.vertices[8]");
    /// # Ok::<(), pasu::Error>(())
    /// ```
    #[cfg(feature = "patchwork")]
    pub fn with_points(&self, part: usize, points: &[(usize, [f64; 3])]) -> Result<Design> {
        let mut document = self.0.clone();
        let n = document.parts.len();
        let Some(Part { shape, .. }) = document.parts.get_mut(part) else {
            let message = format!("expected the number of a part, {}, found {part}", numbers_of(n));
            let error = Error::new(Code::NoSuchPoint, "part", message).with("least", 0.0);
            return Err(error.with("greatest", n - 1).with("found", part));
        };
        let Shape::VertexFrame(network) = shape else {
            let message = "expected a network of patches, whose points can be elsewhere";
            return Err(Error::new(Code::UnsupportedShape, format!("parts[{part}].shape"), message));
        };
        let n = network.vertices.len();
        // What moves alone is written: of a hundred thousand patches all of it is some twenty megabytes.
        let mut extent = self.1;
        for (number, at) in points {
            let path = format!("parts[{part}].shape.vertices[{number}]");
            let Some(point) = network.vertices.get_mut(*number) else {
                let message = format!("expected the number of one of {n} points, found {number}");
                let error = Error::new(Code::NoSuchPoint, path, message).with("least", 0.0);
                return Err(error.with("greatest", n as f64 - 1.0).with("found", *number));
            };
            if let Some(axis) = at.iter().position(|x| !x.is_finite()) {
                let message = format!("expected a number, found {}", plain(at[axis]));
                return Err(Error::new(Code::NotFinite, format!("{path}[{axis}]"), message));
            }
            let to = at.map(rounded);
            if let Extent::Written { length, networks } = &mut extent {
                let (before, after) = (text::write(&*point).len(), text::write(&to).len());
                *length = *length + after - before;
                *networks = *networks + after - before;
            }
            *point = to;
        }
        match extent {
            Extent::Unknown => document.within_limit(),
            Extent::Bounded => Ok(Design(document, extent)),
            Extent::Written { length, networks } => {
                not_too_long(length, networks)?;
                Ok(Design(document, extent))
            }
        }
    }

    /// The same design with a part in another place.
    pub(crate) fn placed(&self, part: usize, place: Placement) -> Result<Design> {
        let mut document = self.0.clone();
        document.parts[part].place = place;
        Document { parts: canonical(document.parts)?, ..document }.within_limit()
    }

    /// The same design with its parts in another way.
    pub(super) fn with_parts(&self, parts: Vec<Part>) -> Design {
        Design(Document { parts, ..self.0.clone() }, Extent::Unknown)
    }

    /// A design of one part in the unit of this one.
    pub(crate) fn of_one(&self, part: Part) -> Design {
        Design(Document { pasu: VERSION, title: None, unit: self.0.unit, parts: vec![part] }, Extent::Unknown)
    }

    /// The design of these parts, of which there are no more than may be.
    ///
    /// # Errors
    /// As [`Design::read`].
    #[cfg(feature = "patchwork")]
    pub(crate) fn of_parts(title: Option<String>, unit: Unit, parts: Vec<Part>) -> Result<Design> {
        Document { pasu: VERSION, title, unit, parts: canonical(parts)? }.within_limit()
    }

    /// The canonical document, on one line.
    ///
    /// ```
    /// let vase = pasu::Design::parse(r#"{ "parts": [{ "shape": { "kind": "second-order", "r": [1, 0.1, 0.60, 6e-2] } }], "unit": "cm", "pasu": 1 }"#)?;
    /// assert_eq!(vase.to_json(), r#"{"pasu":1,"parts":[{"shape":{"kind":"second-order","r":[1,0.1,0.6,0.06]}}]}"#);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    #[inline]
    pub fn to_json(&self) -> String {
        text::write(&self.0)
    }

    /// The title, if it has one.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert_eq!(vase.title(), None);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn title(&self) -> Option<&str> {
        self.0.title.as_deref()
    }

    /// What 1 means.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert_eq!(vase.unit(), pasu::Unit::Cm);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn unit(&self) -> Unit {
        self.0.unit
    }

    /// The parts, in the order of the document; at least one.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert!(matches!(vase.parts()[0].shape, pasu::Shape::BloorWilson(_)));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    #[inline]
    pub fn parts(&self) -> &[Part] {
        &self.0.parts
    }
}

impl Document {
    /// Refuses a design whose document is too long.
    fn within_limit(self) -> Result<Design> {
        // Nearly every design is shorter by far, which is known without writing its numbers.
        if text::longest(&self) <= LINK_BYTES {
            return Ok(Design(self, Extent::Bounded));
        }
        let length = text::write(&self).len();
        let lengths = self.parts.iter().map(|part| match part.shape {
            #[cfg(feature = "patchwork")]
            Shape::VertexFrame(_) => text::write(&part.shape).len(),
            _ => 0,
        });
        let networks: usize = lengths.sum();
        not_too_long(length, networks)?;
        Ok(Design(self, Extent::Written { length, networks }))
    }
}

/// Refuses a document of so many bytes, as a whole or without its networks: what these cost is in proportion to their length, and of other shapes a megabyte says more than anybody waits for.
fn not_too_long(length: usize, networks: usize) -> Result<()> {
    let beside = if networks > 0 { " beside networks of patches" } else { "" };
    for (found, most, what) in [(length - networks, LINK_BYTES, beside), (length, BYTES, "")] {
        if found > most {
            let message = format!("expected a design of at most {most} bytes of JSON{what}, found {found}");
            let error = Error::new(Code::TooLarge, "", message);
            return Err(error.with("greatest", most as f64).with("found", found as f64));
        }
    }
    Ok(())
}

/// As the canonical document.
impl Serialize for Design {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

/// As [`Design::read`].
impl<'de> Deserialize<'de> for Design {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        Design::from_value(&Value::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// Comes before every other check: a newer document may differ in any way.
pub(crate) fn check_version(value: &Value) -> Result<()> {
    let Value::Record(fields) = value else { return Ok(()) };
    let given = fields.iter().find(|(name, _)| name == "pasu").map_or(&Value::Null, |(_, value)| value);
    let current = f64::from(VERSION);
    let code = match given {
        Value::Number(version) if *version == current => return Ok(()),
        Value::Number(version) if *version > current => {
            return Err(Error::new(Code::UnknownVersion, "pasu", limits::newer("design", &plain(*version))));
        }
        Value::Null => Code::MissingField,
        _ => Code::UnknownVersion,
    };
    let expected = format!("{VERSION}, the version of the format");
    Err(refusal::refused(code, &expected, &given.described()).at("pasu"))
}

#[inline]
fn parts<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Vec<Part>, D::Error> {
    let (expected, most) = (format!("a list of 1 to {PARTS} parts"), format!("at most {PARTS} parts"));
    let parts = list::read(deserializer, &expected, Some((PARTS, &most)))?;
    match parts.is_empty() {
        true => Err(D::Error::invalid_value(Unexpected::Other("an empty list"), &expected.as_str())),
        false => Ok(parts),
    }
}

/// The parts in canonical form, within the limits that all of them have together.
#[inline]
fn canonical(given: Vec<Part>) -> Result<Vec<Part>> {
    let mut parts = Vec::with_capacity(given.len());
    let mut names = BTreeMap::new();
    let mut cost = 0;
    for (index, part) in given.into_iter().enumerate() {
        let refused = |error: Error| error.inside_item(index).inside_field("parts");
        let part = Part { shape: part.shape.finite().map_err(|error| refused(error.inside_field("shape")))?, ..part };
        cost += part.shape.cost();
        if cost > MODES {
            let message = format!("expected at most {MODES} modes in the whole design; this part exceeds them");
            return Err(refused(Error::new(Code::TooLarge, "shape", message).with("greatest", MODES as f64)));
        }
        if let Some(name) = &part.name
            && let Some(earlier) = names.insert(name.clone(), index)
        {
            return Err(refused(name_taken(name, &format!("parts[{earlier}]"))));
        }
        parts.push(part.canonical().map_err(refused)?);
    }
    Ok(parts)
}

/// The refusal of a name that something else has, which is at `earlier`.
pub(crate) fn name_taken(name: &str, earlier: &str) -> Error {
    let message = format!("expected a name that no other part has, found {name:?}, which is that of {earlier}");
    Error::new(Code::Duplicate, "name", message).with("earlier", earlier)
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Design, "Design");

/// Refuses a tree with a null in it.
pub(crate) fn without_null(value: &Value) -> Result<()> {
    match value {
        Value::Null => Err(Error::new(Code::WrongType, "", "expected a value, found null")),
        Value::List(items) => {
            let mut items = items.iter().enumerate();
            items.try_for_each(|(index, item)| without_null(item).map_err(|error| error.inside_item(index)))
        }
        Value::Record(fields) => {
            let mut fields = fields.iter();
            fields.try_for_each(|(name, value)| without_null(value).map_err(|error| error.inside_field(name)))
        }
        Value::Bool(_) | Value::Number(_) | Value::Text(_) => Ok(()),
    }
}

#[cfg(all(test, feature = "patchwork"))]
mod tests {
    use super::*;

    /// A design of one patch and of so many points that nothing uses.
    fn points(n: usize) -> Design {
        let points: Vec<_> = (0..n).map(|i| format!("[{}.123456789,{i},0.1]", i as f64)).collect();
        let text = format!(
            r#"{{"pasu":1,"parts":[{{"shape":{{"kind":"vertex-frame","vertices":[[0,0,0],[1,0,0],[2,0,0],[2,1,0],[2,2,0],[1,2,0],[0,2,0],[0,1,0]{}{}],"patches":[{{"frame":[0,1,2,3,4,5,6,7]}}]}}}}]}}"#,
            if n > 0 { "," } else { "" },
            points.join(",")
        );
        Design::parse(&text).unwrap()
    }

    #[test]
    fn a_moved_point_leaves_known_how_long_the_document_is() {
        let mut design = points(16_000);
        let moves = [(3, [2.5, -1.0 / 3.0, 1e-7]), (9_000, [0.0, 1e21, -0.0]), (3, [2.0, 1.0, 0.0]), (9_000, [0.1; 3])];
        for (number, at) in moves {
            design = design.with_points(0, &[(number, at), (number + 1, [7.0; 3]), (number, at)]).unwrap();
            let Extent::Written { length, networks } = design.1 else { panic!("{:?}", design.1) };
            assert_eq!((length, networks), (design.to_json().len(), text::write(&design.0.parts[0].shape).len()));
        }
    }

    #[test]
    fn of_a_short_document_nothing_has_to_be_written_to_move_a_point() {
        let design = points(0).with_points(0, &[(4, [1.0 / 3.0; 3])]).unwrap();
        assert!(matches!(design.1, Extent::Bounded));
    }

    #[test]
    fn a_point_that_makes_the_document_too_long_is_refused() {
        let Design(document, _) = points(0);
        let full = Design(document, Extent::Written { length: BYTES, networks: BYTES - 100 });
        assert!(full.with_points(0, &[(4, [3.0, 2.0, 0.0])]).is_ok());
        let refused = full.with_points(0, &[(4, [3.5, 2.0, 0.0])]).unwrap_err();
        assert_eq!(refused.code(), Code::TooLarge);
        // One point takes the room that another one gives.
        let long = full.with_points(0, &[(4, [3.0, 2.0, 0.0]), (4, [33.0, 2.0, 0.0]), (4, [3.0, 2.0, 0.0])]);
        assert!(long.is_ok());
    }
}
