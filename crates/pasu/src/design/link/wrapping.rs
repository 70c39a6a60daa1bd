//! What mail programs, messengers and people do to a link on its way, undone.

use super::damage::damaged;
use crate::error::Result;

/// The text after `#`, decoded, without what was put round it and into it.
///
/// Canonical links hold no character of those removed here, and once decoded no `%`: nothing that was meant is lost.
pub(super) fn remove(text: &str) -> Result<String> {
    let unwrapped = unwrap_lines(text.trim());
    let bare = unwrapped
        .trim_start_matches(|c: char| c.is_whitespace() || "<([\"'“‘«".contains(c))
        .trim_end_matches(|c: char| c.is_whitespace() || ">)]\"'”’».,;:!?".contains(c));
    let has_address = bare.contains('#');
    let mut link = after_hash(bare).replace("&amp;", "&");
    // Twice encoded at most: by a program that shows a link, and by one that sends what is shown.
    for _ in 0..3 {
        if !link.contains('%') {
            break;
        }
        link = decoded(&link)?;
    }
    if link.contains('%') {
        return Err(damaged("its % signs do not fit together"));
    }
    if !has_address {
        link = after_hash(&link).to_owned();
    }
    // As often as it may have been encoded: to repeat it until none is left would take the square of the length.
    for _ in 0..3 {
        link = link.replace("&amp;", "&");
    }
    Ok(link)
}

fn after_hash(text: &str) -> &str {
    text.split_once('#').map_or(text, |(_, link)| link).trim_start_matches('#')
}

/// Joins the lines of a wrapped link, with the `>` of a quoted mail, and drops characters that only mark where a line
/// may break. Other white space stays, so that two words never become one.
fn unwrap_lines(text: &str) -> String {
    let mut joined = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        if matches!(c, '\u{ad}' | '\u{200b}'..='\u{200d}' | '\u{2060}' | '\u{feff}') {
            continue;
        }
        if !c.is_whitespace() {
            joined.push(c);
            continue;
        }
        let mut space = c.to_string();
        let mut ends_line = matches!(c, '\n' | '\r');
        while let Some(next) = rest.next_if(|next| next.is_whitespace() || (*next == '>' && ends_line)) {
            space.push(next);
            ends_line |= matches!(next, '\n' | '\r');
        }
        if !ends_line {
            joined.push_str(&space);
        }
    }
    joined
}

/// One layer of percent-encoding.
fn decoded(text: &str) -> Result<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        match (hex(rest.next()), hex(rest.next())) {
            (Some(high), Some(low)) => bytes.push(16 * high + low),
            _ => return Err(damaged("a % sign without the two digits that belong to it")),
        }
    }
    String::from_utf8(bytes).map_err(|_| damaged("its % signs do not spell a text"))
}

fn hex(digit: Option<u8>) -> Option<u8> {
    char::from(digit?).to_digit(16).and_then(|value| u8::try_from(value).ok())
}

/// Percent-encodes everything but letters, digits, `-` and `_`: also the full stop, which a reader could take for the
/// end of a sentence.
pub(super) fn encoded(text: &str) -> String {
    let mut encoded = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_' {
            encoded.push(char::from(byte));
        } else {
            encoded.push_str(&format!("%{byte:02X}"));
        }
    }
    encoded
}
