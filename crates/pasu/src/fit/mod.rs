//! A pot of rings that says what something else said: a pot of another kind, a drawn line, or a scan.

mod azimuth;
mod chords;
mod contract;
mod curves;
mod digits;
mod free;
mod hausdorff;
mod line;
mod normal;
mod profile;
mod scan;
mod sections;
mod series;

pub use contract::Ringed;
pub use free::free;
pub use profile::{Profile, fit};
pub use scan::{Apart, FittedLevels, Levels, Scan, Scanned, fit_levels, fit_scan, levels};
