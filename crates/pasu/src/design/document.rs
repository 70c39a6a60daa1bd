//! The whole design: checked, canonical, and never anything else.

use std::collections::BTreeMap;

use serde::ser::{Serialize, Serializer};

use super::limits::{BYTES, MODES, PARTS, VERSION};
use super::part::Part;
use super::path::Path;
use super::reader::{self, Record};
use super::table::{self, Entry, optional, required};
use super::unit::Unit;
use super::value::Value;
use super::{json, limits, link};
use crate::error::{Code, Result};

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
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    title: Option<String>,
    unit: Unit,
    parts: Vec<Part>,
}

pub(crate) const DESIGN: &[Entry] = &[
    required("pasu", "1", "The version of the format."),
    optional("title", "string", "At most 200 characters of plain text."),
    optional("unit", "Unit", "What 1 means; centimetres when left out."),
    required("parts", "readonly Part[]", "1 to 500 parts."),
];

impl Design {
    /// Reads a design from text: a JSON document, or a link as people send it: with or without `#`, inside its
    /// address, percent-encoded, wrapped by a mail program, with the full stop of a sentence behind it.
    ///
    /// ```
    /// use pasu::Design;
    ///
    /// let design = Design::parse("https://example.org/pots/#1/bloor-wilson?a=6&amp;n1=5.")?;
    /// assert_eq!(design.link(), "1/bloor-wilson?a=6&n1=5");
    ///
    /// let error = Design::parse("#2/bloor-wilson?a=6").unwrap_err();
    /// assert_eq!(error.code(), pasu::Code::UnknownVersion);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Design::from_value`]; `not-json` when a text that begins with `{` is not JSON; `damaged-link` when any
    /// other is no link, or was altered on its way; `unknown-version` for the link of a newer version.
    pub fn parse(text: &str) -> Result<Design> {
        // Some editors put a byte order mark at the start of a file.
        let text = text.trim_start_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
        if text.starts_with('{') { Design::from_json(text) } else { link::read(text) }
    }

    /// Reads a JSON document. A null in it is refused: no field may be null, and `JSON.stringify` writes one for NaN.
    pub(crate) fn from_json(text: &str) -> Result<Design> {
        let value = json::read(text)?;
        let design = Design::from_value(&value)?;
        reader::without_null(&value, &Path::Start(""))?;
        Ok(design)
    }

    /// The canonical link, without `#`: readable when the design is one part of a named family, packed otherwise.
    ///
    /// Readable links leave out what the shape's kind starts from, which never changes within a format version.
    ///
    /// ```
    /// let vase = pasu::Design::parse("https://example.org/#1/bloor-wilson?n1=5&a=.01")?;
    /// assert_eq!(vase.link(), "1/bloor-wilson?n1=5");
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn link(&self) -> String {
        link::write(self)
    }

    /// Reads a design from any tree of plain data. A field that is null counts as absent: that is how a JavaScript
    /// field arrives that is `undefined`.
    ///
    /// # Errors
    /// Every refusal names the path, the value and what was expected: `unknown-field`, `missing-field`, `duplicate`,
    /// `wrong-type`, `not-finite`, `out-of-range`, `unknown-name`, `unknown-version`, `unsupported-shape`,
    /// `too-large`, and `overflow` when parameters are so large that their products cannot be held.
    pub fn from_value(value: &Value) -> Result<Design> {
        let record = Record::open(value, Path::Start(""), "a design")?;
        check_version(&record)?;
        let record = record.only(&table::names(DESIGN))?;
        let title = match record.get("title") {
            Some(value) => reader::label(value, &record.path.field("title"))?,
            None => None,
        };
        let unit = Unit::read(&record, "unit")?;
        let parts = read_parts(&record)?;
        let design = Design { title, unit, parts };
        let length = design.to_json().len();
        if length > BYTES {
            let message = format!("expected a design of at most {BYTES} bytes of JSON, found {length}");
            return Err(record.path.error(Code::TooLarge, message));
        }
        Ok(design)
    }

    /// The canonical document, on one line.
    ///
    /// ```
    /// let vase = pasu::Design::parse(r#"{ "parts": [{ "shape": { "kind": "second-order", "r": [1, 0.1, 0.60, 6e-2] } }], "unit": "cm", "pasu": 1 }"#)?;
    /// assert_eq!(vase.to_json(), r#"{"pasu":1,"parts":[{"shape":{"kind":"second-order","r":[1,0.1,0.6,0.06]}}]}"#);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        json::write(&self.to_value())
    }

    /// The canonical document as a tree.
    pub fn to_value(&self) -> Value {
        let mut into = vec![("pasu".to_owned(), Value::Number(f64::from(VERSION)))];
        if let Some(title) = &self.title {
            into.push(("title".to_owned(), Value::Text(title.clone())));
        }
        self.unit.write("unit", &mut into);
        into.push(("parts".to_owned(), Value::List(self.parts.iter().map(Part::value).collect())));
        Value::Record(into)
    }

    /// The title, if it has one.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert_eq!(vase.title(), None);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// What 1 means.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert_eq!(vase.unit(), pasu::Unit::Cm);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// The parts, in the order of the document; at least one.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert!(matches!(vase.parts()[0].shape, pasu::Shape::BloorWilson(_)));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }
}

/// As the canonical document.
impl Serialize for Design {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        self.to_value().serialize(serializer)
    }
}

/// Comes before every other check: a newer document may differ in any way.
fn check_version(record: &Record) -> Result<()> {
    let path = record.path.field("pasu");
    let current = f64::from(VERSION);
    match record.require("pasu", &format!("{VERSION}, the version of the format"))? {
        Value::Number(version) if *version == current => Ok(()),
        Value::Number(version) if *version > current => {
            Err(path.error(Code::UnknownVersion, limits::newer("design", &super::number::plain(*version))))
        }
        value => {
            let message = format!("expected {VERSION}, the version of the format, found {}", value.described());
            Err(path.error(Code::UnknownVersion, message))
        }
    }
}

fn read_parts(record: &Record) -> Result<Vec<Part>> {
    let list = record.path.field("parts");
    let expected = format!("a list of 1 to {PARTS} parts");
    let items = reader::list(record.require("parts", &expected)?, &list, &expected)?;
    if items.is_empty() {
        return Err(list.error(Code::OutOfRange, format!("expected {expected}, found an empty list")));
    }
    if items.len() > PARTS {
        return Err(list.error(Code::TooLarge, format!("expected at most {PARTS} parts, found {}", items.len())));
    }
    let mut parts = Vec::with_capacity(items.len());
    let mut names = BTreeMap::new();
    let mut n_modes = 0;
    for (index, item) in items.iter().enumerate() {
        let path = list.item(index);
        let part = Part::read(item, path)?;
        n_modes += part.shape.problem().n_modes();
        if n_modes > MODES {
            let message = format!("expected at most {MODES} modes in the whole design; this part exceeds them");
            return Err(path.field("shape").error(Code::TooLarge, message));
        }
        if let Some(name) = &part.name
            && let Some(earlier) = names.insert(name.clone(), index)
        {
            let message = format!("expected a name of its own, found {name:?}, the name of parts[{earlier}]");
            return Err(path.field("name").error(Code::Duplicate, message));
        }
        parts.push(part.canonical(&path)?);
    }
    Ok(parts)
}
