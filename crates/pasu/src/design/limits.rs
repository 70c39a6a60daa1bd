//! The stated limits of a design; each is refused in words.

/// The format version that this program reads and writes.
pub(crate) const VERSION: u32 = 1;

/// The longest JSON text, given or canonical, in bytes.
pub(crate) const BYTES: usize = 1 << 20;

/// The most parts of a design.
pub(crate) const PARTS: usize = 500;

/// The most modes of all parts together, as given.
pub(crate) const MODES: usize = 4096;

/// The most coefficients of the force on one mode. Terms of its series stay above the least double up to twice this.
pub(crate) const FORCE: usize = 512;

/// The longest title or name, in characters.
pub(crate) const CHARACTERS: usize = 200;

/// What is said of a document or a link of a later version.
pub(crate) fn newer(what: &str, version: &str) -> String {
    format!("This {what} was made by a newer version of Pasu (format {version}); this page reads format {VERSION}.")
}
