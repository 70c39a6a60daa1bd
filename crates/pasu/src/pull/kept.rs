//! What a hand leaves as it is.

use crate::error::{Code, Error, Result};

/// Which of these names are to be kept.
///
/// # Errors
/// `unknown-name` for any other.
pub(super) fn kept<const N: usize>(names: [&str; N], keep: &[String]) -> Result<[bool; N]> {
    let mut kept = [false; N];
    for (index, word) in keep.iter().enumerate() {
        let known = names.iter().position(|name| name == word).ok_or_else(|| {
            let message = format!("expected {}, found {word:?}", names.join(", "));
            let error = Error::new(Code::UnknownName, format!("keep[{index}]"), message);
            error.with("words", names.as_slice()).with("found", word.as_str())
        })?;
        kept[known] = true;
    }
    Ok(kept)
}
