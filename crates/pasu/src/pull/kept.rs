//! What a hand leaves as it is.

use crate::design::unknown_name;
use crate::error::Result;

/// Which of these names are to be kept.
///
/// # Errors
/// `unknown-name` for any other.
pub(super) fn kept<const N: usize>(names: [&str; N], keep: &[String]) -> Result<[bool; N]> {
    let mut kept = [false; N];
    for (index, word) in keep.iter().enumerate() {
        let known = names.iter().position(|name| name == word);
        kept[known.ok_or_else(|| unknown_name(word, &names).at(format!("keep[{index}]")))?] = true;
    }
    Ok(kept)
}
