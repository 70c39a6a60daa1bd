//! Text in XML, for attributes and elements alike.

/// Escapes what XML 1.0 gives a meaning; a character that it does not allow becomes U+FFFD.
pub(super) fn escaped(text: &str) -> String {
    let mut into = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => into.push_str("&amp;"),
            '<' => into.push_str("&lt;"),
            '>' => into.push_str("&gt;"),
            '"' => into.push_str("&quot;"),
            // As a reference, or a reader would make a space of it.
            '\t' | '\n' | '\r' => into.push_str(&format!("&#{};", u32::from(c))),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => into.push('\u{fffd}'),
            _ => into.push(c),
        }
    }
    into
}

/// Takes back what [`escaped`] and programs that write a file anew do to a link.
pub(super) fn unescaped(text: &str) -> String {
    let quotes = text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&apos;", "'");
    quotes.replace("&#38;", "&").replace("&#x26;", "&").replace("&amp;", "&")
}
