//! The stated limits of a design; each is refused in words.

/// The format version that this program reads and writes.
pub(crate) const VERSION: u32 = 1;

/// The longest JSON text of what goes into a link, in bytes; of no design is more than that anything but networks of patches.
pub(crate) const LINK_BYTES: usize = 1 << 20;

/// The longest JSON text, given or canonical, in bytes: 100,000 patches take some 17 MB with all twelve digits and parameters of their own, and some forces beside.
pub(crate) const BYTES: usize = 1 << 25;

/// How many values the tree of a document may have. 100,000 patches take three million; each takes some tens of bytes of memory while it is read.
pub(crate) const VALUES: usize = 1 << 22;

/// The most parts of a design.
pub(crate) const PARTS: usize = 500;

/// The most modes of all parts together, as given.
pub(crate) const MODES: usize = 4096;

/// The most coefficients of the force on one mode. Terms of its series stay above the least double up to twice this.
pub(crate) const FORCE: usize = 512;

/// The most rings between the two ends of a shape.
pub(crate) const RINGS: usize = 64;

/// The most waves round a pot of which anything is measured or made. Drawn is any number: links that are out in the world stay readable.
///
/// On a pot of 10 cm these are grooves of 2.5 mm, about as fine as a line of printed clay; and what searches and sums over such a surface takes is still done while one waits.
pub(crate) const WAVES: f64 = 128.0;

/// The fastest rate at which a mode of what is measured or made may fall off from a boundary, `exp(-RATE u)`: a layer of a ten-thousandth of the profile.
pub(crate) const RATE: f64 = 1e4;

/// The same of a mode that swings between the boundaries, in radians: some thirty waves from foot to rim.
pub(crate) const SWING: f64 = 200.0;

/// The most patches of a network of vertex-frames.
pub(crate) const PATCHES: usize = 100_000;

/// The most vertices of one.
pub(crate) const VERTICES: usize = 800_000;

/// The most forces on one patch.
pub(crate) const FORCES: usize = 64;

/// The most harmonics of one coordinate of a closed section.
pub(crate) const HARMONICS: usize = 512;

/// The longest title or name, in characters.
pub(crate) const CHARACTERS: usize = 200;

/// What is said of a document or a link of a later version.
pub(crate) fn newer(what: &str, version: &str) -> String {
    format!("This {what} was made by a newer version of Pasu (format {version}); this page reads format {VERSION}.")
}
