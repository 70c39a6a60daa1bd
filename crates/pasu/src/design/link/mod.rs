//! The link: a whole design in the fragment of a URL.
//!
//! `1/bloor-wilson?a=6&n1=5` spells out one part of a named family; `1~` and base64url hold everything else. Both
//! begin with the format version.

mod packed;
mod readable;
mod wrapping;

use super::document::Design;
use super::limits::{BYTES, VERSION, newer};
use super::refusal::shortened;
use crate::error::{Code, Error, Result};

/// The canonical link, without `#`.
pub(crate) fn write(design: &Design) -> String {
    match readable::write(design) {
        Some(readable) => format!("{VERSION}/{readable}"),
        None => format!("{VERSION}~{}", packed::write(design)),
    }
}

/// Reads a link as people send it: with its address, wrapped, quoted, percent-encoded.
pub(crate) fn read(text: &str) -> Result<Design> {
    // Damage cannot make a link longer than its packed form, and decoding an endless text takes long.
    if text.len() > 2 * BYTES {
        let message = format!("expected a link of at most {} characters, found {}", 2 * BYTES, text.len());
        return Err(Error::new(Code::TooLarge, "", message));
    }
    let link = wrapping::remove(text)?;
    let digits = link.len() - link.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (version, rest) = link.split_at(digits);
    let known = VERSION.to_string();
    match (version, rest.chars().next()) {
        ("", _) | (_, None) => Err(not_a_link(text)),
        (version, Some('/')) if version == known => readable::read(&rest[1..]),
        (version, Some('~')) if version == known => packed::read(&rest[1..]),
        (version, Some('/' | '~')) if version.starts_with('0') => {
            let message = format!("expected a link of format {VERSION}, found format {}", shortened(version));
            Err(Error::new(Code::UnknownVersion, "", message))
        }
        (version, Some('/' | '~')) => Err(Error::new(Code::UnknownVersion, "", newer("link", &shortened(version)))),
        _ => Err(not_a_link(text)),
    }
}

fn not_a_link(text: &str) -> Error {
    let text = text.trim();
    let message = if text.is_empty() {
        "There is nothing here to open; expected a design or a link.".to_owned()
    } else if text.contains("://") && !text.contains('#') {
        "This address has no design in it; expected one after a #.".to_owned()
    } else {
        format!(
            "This is neither a design nor a link to one: {:?}; a link looks like #1/bloor-wilson?a=6, or #1~ and a long \
             row of letters and digits.",
            shortened(text)
        )
    };
    Error::new(Code::DamagedLink, "", message)
}

/// A link that was one of Pasu's and has been altered on its way.
fn damaged(what: &str) -> Error {
    let message =
        format!("This link is damaged or cut short ({what}); copy it once more, from its first to its last letter.");
    Error::new(Code::DamagedLink, "", message)
}
