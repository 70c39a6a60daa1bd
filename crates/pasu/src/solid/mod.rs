//! A placed surface and its wall, as smooth faces.

mod apart;
mod ball;
mod boxes;
mod bridge;
mod crease;
mod curve;
mod flank;
mod frame;
mod lining;
mod offset;
mod outline;
mod piece;
mod pot;
mod product;
mod samples;
mod sheet;
mod skin;
mod start;
mod thickness;
mod told;

pub(crate) use piece::Form;
pub use piece::Piece;
pub use pot::Pot;
pub use product::Product;
pub(crate) use sheet::{Sheet, SheetWalk};
pub(crate) use skin::Skin;
pub(crate) use told::{place, short, significant};
