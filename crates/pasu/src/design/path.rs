//! Where in a design a value stands: `parts[2].shape.s[0]`.

use std::fmt;

use crate::error::{Code, Error};

/// A path built on the stack while the reader descends, written out only when something is wrong.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Path<'a> {
    /// The path of the value that the reader was given; empty for a whole design.
    Start(&'a str),
    /// A field of a record.
    Field(&'a Path<'a>, &'a str),
    /// An item of a list.
    Item(&'a Path<'a>, usize),
}

impl<'a> Path<'a> {
    pub(crate) fn field(&'a self, name: &'a str) -> Path<'a> {
        Path::Field(self, name)
    }

    pub(crate) fn item(&'a self, index: usize) -> Path<'a> {
        Path::Item(self, index)
    }

    /// An error at this place.
    #[inline(never)]
    pub(crate) fn error(&self, code: Code, message: impl Into<String>) -> Error {
        Error::new(code, self.to_string(), message)
    }

    fn is_empty(&self) -> bool {
        matches!(self, Path::Start(""))
    }
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Path::Start(text) => f.write_str(text),
            Path::Field(parent, name) if is_word(name) => {
                let dot = if parent.is_empty() { "" } else { "." };
                write!(f, "{parent}{dot}{name}")
            }
            // A field that no design has; its name came from outside and may be anything.
            Path::Field(parent, name) => write!(f, "{parent}[{:?}]", shortened(name)),
            Path::Item(parent, index) => write!(f, "{parent}[{index}]"),
        }
    }
}

fn is_word(name: &str) -> bool {
    (1..=40).contains(&name.len()) && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

/// Foreign text short enough to stand inside a message.
pub(crate) fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_like_code() {
        let start = Path::Start("");
        let (parts, shape) = (start.field("parts"), "shape");
        let part = parts.item(2);
        let shape = part.field(shape);
        let s = shape.field("s");
        assert_eq!(s.item(0).to_string(), "parts[2].shape.s[0]");
        assert_eq!(start.to_string(), "");
        assert_eq!(shape.field("a b").to_string(), "parts[2].shape[\"a b\"]");
        assert!(start.field(&"x".repeat(1000)).to_string().len() < 60);
    }
}
