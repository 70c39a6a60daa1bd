//! The link in a file that Pasu wrote.

use super::contents::LINK_LINE;
use super::{glb, stl, three_mf, xml, zip};

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
    let link = if bytes.starts_with(b"PK\x03\x04") {
        let model = zip::beginning_of(bytes, three_mf::MODEL, MOST)?;
        element(&beginning(&model), &format!("<metadata name=\"{}\"", three_mf::LINK))?
    } else if bytes.starts_with(b"glTF") {
        let text = beginning(bytes.get(20..)?);
        text.split_once(glb::LINK)?.1.split('"').next()?.to_owned()
    } else if let Some(link) = stl::link(bytes) {
        link.to_owned()
    } else {
        let text = beginning(bytes);
        if text.starts_with("ply\n") {
            pieces(&text, "comment ", "end_header", "")
        } else if text.starts_with("# Pasu ") {
            pieces(&text, "# ", "o ", "")
        } else if text.starts_with("ISO-10303-21;") {
            pieces(&text, "'", "ENDSEC;", "'")
        } else if text.starts_with("<?xml") || text.starts_with("<svg") {
            element(&text, "<pasu:link")?
        } else {
            return None;
        }
    };
    let is_link = !link.is_empty() && link.bytes().all(|byte| byte.is_ascii_graphic());
    is_link.then_some(link)
}

/// As much of a file as a link can be in, its text.
fn beginning(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(MOST)]).into_owned()
}

/// The pieces of the link, put together: what stands in the lines of a header that begin with `before` and the name of the link, up to `after` in each.
fn pieces(text: &str, before: &str, header_end: &str, after: &str) -> String {
    let start = format!("{before}{LINK_LINE}");
    let mut link = String::new();
    for line in text.lines().take_while(|line| !line.starts_with(header_end)) {
        if let Some(piece) = line.strip_prefix(&start) {
            let piece = if after.is_empty() { piece } else { piece.split(after).next().unwrap_or_default() };
            link.push_str(piece.trim_end());
        }
    }
    link
}

/// The text of the first element that begins so.
fn element(text: &str, start: &str) -> Option<String> {
    let (_, rest) = text.split_once(start)?;
    let (_, rest) = rest.split_once('>')?;
    Some(xml::unescaped(rest.split_once('<')?.0.trim()))
}
