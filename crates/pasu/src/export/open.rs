//! What a file that Pasu wrote says of itself: the link of its design, and how it was made.

use super::contents::line_of;
use super::provenance::{Provenance, making};
use super::{glb, obj, stl, three_mf, xml, zip};

/// Longer than any link, and the text that stands before it.
const MOST: usize = 2 << 20;

/// The link of the design in a file that [`write`](super::write) wrote, of any format; without `#`, as [`Design::parse`](crate::Design::parse) reads it.
///
/// `None` for every other file: no bytes make it fail. That a link is found does not make it whole: reading it says so if it is not. An STL file holds its link only
/// if it is short.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// let bytes = pasu::write(&cup, pasu::Format::ThreeMf, &pasu::Making::default())?;
/// assert_eq!(pasu::open(&bytes), Some(cup.link()));
/// assert_eq!(pasu::open(b"something else"), None);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn open(bytes: &[u8]) -> Option<String> {
    provenance(bytes).map(|found| found.link)
}

/// What [`open`] finds, and beside it what was made and how large: [`write`](super::write) makes the same file of both.
///
/// `None` as for [`open`]. The making is `None` where the file does not tell it, as files of versions that did not and an STL without room; and where any value of it is not understood
/// or out of its range, because what is left would be another body.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// use pasu::{Format, Making, Size};
///
/// let making = Making { size: Some(Size::Height(12.0)), shrinkage: 10.0, ..Making::default() };
/// let bytes = pasu::write(&cup, Format::ThreeMf, &making)?;
/// let found = pasu::provenance(&bytes).expect("a file of Pasu's");
/// assert_eq!((found.link, found.making), (cup.link(), Some(making)));
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn provenance(bytes: &[u8]) -> Option<Provenance> {
    let notes = Written::of(bytes)?;
    let link = notes.note("link")?;
    let is_link = !link.is_empty() && link.bytes().all(|byte| byte.is_ascii_graphic());
    is_link.then(|| Provenance { link, making: making(|name| notes.note(name)) })
}

/// The text in which a file says what it is, by the way in which it does.
enum Written {
    /// Elements that begin so, up to the name of the note and what ends it.
    Elements { text: String, before: &'static str, after: &'static str },
    /// Pairs of a JSON object.
    Extras { text: String },
    /// Lines of a header that begin so, up to `after` in each.
    Lines { text: String, before: &'static str, header_end: &'static str, after: &'static str },
    /// The header of an STL.
    Header { text: String },
}

impl Written {
    fn of(bytes: &[u8]) -> Option<Written> {
        if bytes.starts_with(b"PK\x03\x04") {
            if let Some(model) = zip::beginning_of(bytes, three_mf::MODEL, MOST) {
                return Some(Written::Elements { text: beginning(&model), before: three_mf::METADATA, after: "\"" });
            }
            let model = zip::beginning_of(bytes, obj::MODEL, MOST)?;
            return model.starts_with(obj::START).then(|| Written::of_obj(beginning(&model)));
        }
        if bytes.starts_with(b"glTF") {
            return Some(Written::Extras { text: beginning(bytes.get(20..)?) });
        }
        if let Some(text) = stl::text(bytes) {
            return Some(Written::Header { text: text.to_owned() });
        }
        let text = beginning(bytes);
        if text.starts_with("ply\n") {
            Some(Written::Lines { text, before: "comment ", header_end: "end_header", after: "" })
        } else if bytes.starts_with(obj::START) {
            Some(Written::of_obj(text))
        } else if text.starts_with("ISO-10303-21;") {
            Some(Written::Lines { text, before: "'", header_end: "ENDSEC;", after: "'" })
        } else if text.starts_with("<?xml") || text.starts_with("<svg") {
            Some(Written::Elements { text, before: "<pasu:", after: "" })
        } else {
            None
        }
    }

    fn of_obj(text: String) -> Written {
        Written::Lines { text, before: "# ", header_end: "o ", after: "" }
    }

    /// What is told by this name.
    fn note(&self, name: &str) -> Option<String> {
        match self {
            Written::Elements { text, before, after } => element(text, &format!("{before}{name}{after}")),
            Written::Extras { text } => extra(text, name),
            Written::Lines { text, before, header_end, after } => {
                pieces(text, &(before.to_string() + &line_of(name)), header_end, after)
            }
            Written::Header { text } => stl::note(text, name),
        }
    }
}

/// As much of a file as a link can be in, its text.
fn beginning(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(MOST)]).into_owned()
}

/// The pieces of a note, put together: what stands in the lines of a header that begin with `start`, up to `after` in each.
fn pieces(text: &str, start: &str, header_end: &str, after: &str) -> Option<String> {
    let mut note = None;
    for line in text.lines().take_while(|line| !line.starts_with(header_end)) {
        if let Some(piece) = line.strip_prefix(start) {
            let piece = if after.is_empty() { piece } else { piece.split(after).next().unwrap_or_default() };
            note.get_or_insert_with(String::new).push_str(piece.trim_end());
        }
    }
    note
}

/// The text of the first element that begins so.
fn element(text: &str, start: &str) -> Option<String> {
    let (_, rest) = text.split_once(start)?;
    let (_, rest) = rest.split_once('>')?;
    Some(xml::unescaped(rest.split_once('<')?.0.trim()))
}

/// The text of a name in the first extras. What has escapes, as a title can, ends the search.
fn extra(text: &str, name: &str) -> Option<String> {
    let (_, mut rest) = text.split_once(glb::EXTRAS)?;
    loop {
        let (found, after) = rest.strip_prefix('"')?.split_once("\":\"")?;
        let (value, after) = after.split_once('"')?;
        if found == name {
            return Some(value.to_owned());
        }
        rest = after.strip_prefix(',')?;
    }
}
