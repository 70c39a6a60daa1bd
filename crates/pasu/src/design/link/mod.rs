//! The link: a whole design in the fragment of a URL.
//!
//! `1/bloor-wilson?a=6&n1=5` spells out one part of a named family; `1~` and base64url hold everything else. Both
//! begin with the format version.

mod damage;
mod packed;
mod readable;
mod wrapping;

use super::document::Design;
use super::limits::{LINK_BYTES, VERSION, newer};
use super::refusal::shortened;
use crate::error::{Code, Error, Result};

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
    /// As [`Design::read`]; `not-json` when a text that begins with `{` is not JSON; `damaged-link` when any
    /// other is no link, or was altered on its way; `unknown-version` for the link of a newer version.
    // Compiled where it is called, as all that leads to `serde`: the bindings are compiled for size, this crate for speed.
    #[inline]
    pub fn parse(text: &str) -> Result<Design> {
        // Some editors put a byte order mark at the start of a file.
        let text = text.trim_start_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
        if text.starts_with('{') { Design::from_json(text) } else { read(text) }
    }

    /// The canonical link, without `#`: readable when the design is one part of a named family, packed otherwise.
    ///
    /// Parts have no order there but one of their own ([`Design::ordered`]), so that equal scenes have equal links however they were put together.
    /// Readable links leave out what the shape's kind starts from, which never changes within a format version.
    ///
    /// ```
    /// let vase = pasu::Design::parse("https://example.org/#1/bloor-wilson?n1=5&a=.01")?;
    /// assert_eq!(vase.link(), "1/bloor-wilson?n1=5");
    /// # Ok::<(), pasu::Error>(())
    /// ```
    /// Empty for a design of more than 1 MiB as JSON, which only a large network of patches has: [`Design::try_link`] refuses it.
    #[inline]
    pub fn link(&self) -> String {
        self.try_link().unwrap_or_default()
    }

    /// As [`Design::link`].
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson?n1=5")?;
    /// assert_eq!(vase.try_link()?, vase.link());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    ///
    /// # Errors
    /// `too-large` for a design of more than 1 MiB as JSON, with `what` among its arguments `link`: it is kept as a file.
    #[inline]
    pub fn try_link(&self) -> Result<String> {
        let design = &self.ordered();
        match readable::write(design) {
            Some(readable) => Ok(format!("{VERSION}/{readable}")),
            None => Ok(format!("{VERSION}~{}", packed::write(design)?)),
        }
    }
}

/// Reads a link as people send it: with its address, wrapped, quoted, percent-encoded.
#[inline]
fn read(text: &str) -> Result<Design> {
    // Damage cannot make a link longer than its packed form, and decoding an endless text takes long.
    if text.len() > 2 * LINK_BYTES {
        let message = format!("expected a link of at most {} characters, found {}", 2 * LINK_BYTES, text.len());
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
