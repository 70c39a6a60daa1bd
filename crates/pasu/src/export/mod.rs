//! Files: what slicers, CAD programs, viewers and potters accept, at the right size.

#[cfg(feature = "patchwork")]
mod cells;
mod coats;
mod contents;
mod crc32;
mod drawn;
mod glb;
#[cfg(feature = "patchwork")]
mod joined;
mod material;
mod numbers;
mod obj;
mod open;
mod ply;
mod png;
mod provenance;
mod shading;
mod sketch;
mod step;
mod stl;
mod template;
mod three_mf;
mod thumbnail;
mod write;
mod xml;
mod zip;

#[cfg(feature = "patchwork")]
pub use cells::{CellsFormat, cells_file};
pub use drawn::{Drawn, DrawnFace, drawn};
pub use obj::obj_materials;
pub use open::{open, provenance};
pub use provenance::Provenance;
pub use sketch::{Sketch, SketchOptions, sketch};
pub use write::write;

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Triangles in millimetres for any slicer, binary.
    Stl,
    /// For slicers: objects in millimetres with their colours, title and a thumbnail.
    ThreeMf,
    /// Binary glTF 2.0 for viewers: metres, y up, with a material.
    Glb,
    /// Wavefront OBJ: text, millimetres. It names the materials of [`obj_materials`].
    Obj,
    /// The same and its materials, together in a ZIP package.
    ObjZip,
    /// PLY, binary little-endian, millimetres.
    Ply,
    /// For CAD programs: ISO 10303-21, one closed solid of B-spline surfaces per part.
    Step,
    /// A template at true scale on one page: sections, height marks and the rim unrolled.
    Svg,
    /// The same on sheets of A4, one below the other, which overlap and have marks by which they are put together.
    SvgA4,
    /// The same on sheets of letter paper.
    SvgLetter,
}

impl Format {
    /// All of them.
    pub const ALL: [Format; 10] = [
        Format::Stl,
        Format::ThreeMf,
        Format::Glb,
        Format::Obj,
        Format::ObjZip,
        Format::Ply,
        Format::Step,
        Format::Svg,
        Format::SvgA4,
        Format::SvgLetter,
    ];

    /// The ending of its files, which is also its name: `stl`, `3mf`, `glb`, `obj`, `obj.zip`, `ply`, `step`, `svg`, `a4.svg`, `letter.svg`.
    ///
    /// ```
    /// assert_eq!(pasu::Format::ThreeMf.name(), "3mf");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Format::Stl => "stl",
            Format::ThreeMf => "3mf",
            Format::Glb => "glb",
            Format::Obj => "obj",
            Format::ObjZip => "obj.zip",
            Format::Ply => "ply",
            Format::Step => "step",
            Format::Svg => "svg",
            Format::SvgA4 => "a4.svg",
            Format::SvgLetter => "letter.svg",
        }
    }

    /// The format of a [name](Format::name); `None` if there is none.
    ///
    /// ```
    /// assert_eq!(pasu::Format::from_name("step"), Some(pasu::Format::Step));
    /// assert_eq!(pasu::Format::from_name("doc"), None);
    /// ```
    pub fn from_name(name: &str) -> Option<Format> {
        Format::ALL.into_iter().find(|format| format.name() == name)
    }
}

#[cfg(test)]
mod tests;
