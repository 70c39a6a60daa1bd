//! Solids that flow from one section into another (ZY04): from two sections with their tangents to a closed form of the inside, and patches of the skin.
//!
//! The cubic between the sections meets all that is given. What it leaves of the equation is taken away by sines that vanish on the border ([`ripple`]), or is not there to begin with, where every harmonic is solved as the mode problem
//! that it is.

mod fading;
mod function;
mod inside;
mod outline;
mod ripple;
mod section;
mod sheet;
mod sines;
mod skin;
mod solved;
mod unseen;
mod volume;

pub use inside::{Inside, InsideMap};
pub(crate) use skin::flank_problem;
pub(crate) use solved::Blended;
pub(crate) use unseen::Unseen;
pub(crate) use volume::Volume;
