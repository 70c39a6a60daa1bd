//! Open networks of patches with a wall: a thickness along the normals.

use std::sync::Arc;

use glam::DVec3;

use crate::design::{Part, RimForm, Shape, Side, Wall, plain};
use crate::error::{Code, Error, Result};
#[cfg(feature = "patchwork")]
use crate::frame::{NoShell, Thick};
use crate::solid::{Product, place, short};
use crate::solution::{Placed, Solution};

impl Solution {
    /// Whether a part is an open network with a wall.
    ///
    /// # Errors
    /// As [`Solution::workable`].
    pub(crate) fn has_shell(&self, part: usize, product: Product) -> Result<bool> {
        let (placed, (_, of)) = (self.workable(part)?, self.existing(part)?);
        Ok(is_open_network(placed) && of.wall.is_some() && product == Product::Pot)
    }

    /// A part as the patches that its body has where it is no pot: with a thickness, if it is an open network with a wall.
    ///
    /// # Errors
    /// As [`Solution::workable`]; `unsupported-shape` for a wall with what belongs to a foot; `no-room`, `open-surface`, `pinched-surface` and `crosses-itself` where the network cannot have the thickness, with the place.
    pub(crate) fn patched(&self, part: usize, product: Product) -> Result<Arc<Placed>> {
        let (placed, (_, of)) = (self.workable(part)?, self.existing(part)?);
        match &of.wall {
            Some(wall) if self.has_shell(part, product)? => self.shell_with(part, wall),
            _ => Ok(Arc::clone(placed)),
        }
    }

    /// An open network with this wall, whichever it has.
    ///
    /// # Errors
    /// As [`Solution::patched`].
    pub(crate) fn shell_with(&self, part: usize, wall: &Wall) -> Result<Arc<Placed>> {
        let (placed, (_, of)) = (self.workable(part)?, self.existing(part)?);
        #[cfg(feature = "patchwork")]
        return shelled(placed, of, wall);
        #[cfg(not(feature = "patchwork"))]
        {
            let _ = (of, wall);
            Ok(Arc::clone(placed))
        }
    }
}

fn is_open_network(placed: &Placed) -> bool {
    #[cfg(feature = "patchwork")]
    return placed.solved().frame().is_some_and(|frame| !frame.is_closed());
    #[cfg(not(feature = "patchwork"))]
    false
}

#[cfg(feature = "patchwork")]
fn shelled(placed: &Arc<Placed>, of: &Part, wall: &Wall) -> Result<Arc<Placed>> {
    let (Shape::VertexFrame(shape), Some(frame)) = (&of.shape, placed.solved().frame()) else {
        return Ok(Arc::clone(placed));
    };
    refuse_foot(placed, wall)?;
    let thick = Thick { thickness: wall.thickness, is_outside: wall.side == Side::Outside, matrix: placed.matrix() };
    match frame.shell(shape, thick, &placed.path("shape")) {
        Ok(shell) => Ok(Arc::new(placed.with(shell))),
        Err(why) => Err(refusal(placed, wall, why)),
    }
}

/// A network has no foot and no rim, so that nothing of a wall belongs to it but its thickness and its side.
#[cfg(feature = "patchwork")]
fn refuse_foot(placed: &Placed, wall: &Wall) -> Result<()> {
    let given = [
        ("base", wall.base != 0.0),
        ("rim", wall.rim != RimForm::Flat),
        ("foot", wall.foot.is_some()),
        ("drain", wall.drain != 0.0),
        ("lining", wall.lining.is_some()),
    ];
    let Some((field, _)) = given.into_iter().find(|(_, is_given)| *is_given) else { return Ok(()) };
    let message = "the wall of an open network of patches has a thickness and a side alone: expected a base of 0, a flat rim, no ring, no drain and no lining of its own";
    Err(Error::new(Code::UnsupportedShape, placed.path(&format!("wall.{field}")), message).with("what", "no-foot"))
}

#[cfg(feature = "patchwork")]
fn refusal(placed: &Placed, wall: &Wall, why: NoShell) -> Error {
    let asked = plain(wall.thickness);
    let error = |code: Code, what: &'static str, at: DVec3, message: &dyn Fn(&str) -> String| {
        let at = placed.point(at);
        let error = Error::new(code, placed.path("wall.thickness"), message(&place(at))).with("what", what);
        error.with("thickness", wall.thickness).near(at.to_array())
    };
    match why {
        NoShell::OneSided => {
            let message = "the surface has one side only, so that it has no inside: expected one with two";
            Error::new(Code::OpenSurface, placed.path("shape"), message).with("what", "one-sided")
        }
        NoShell::NoNormal(at) => error(Code::PinchedSurface, "no-normal", at, &|at| {
            format!("the surface has no normal at {at} along which a wall could go: expected one that is wide everywhere")
        }),
        NoShell::Sharp(at) => error(Code::NoRoom, "sharp-crease", at, &|at| {
            format!("patches meet at {at} at so sharp an angle that a wall of {asked} has no room there: expected a blunter one")
        }),
        NoShell::Folded(at) => error(Code::NoRoom, "turned-over", at, &|at| {
            format!("the surface bends more sharply at {at} than a wall of {asked} is thick: expected a thinner one")
        }),
        NoShell::Uneven(at, found) => error(Code::NoRoom, "uneven", at, &|at| {
            let found = short(found);
            format!("the wall would be {found} thick at {at} where {asked} was asked for: expected a thinner one, or smaller patches")
        })
        .with("found", found),
        NoShell::Touching(at) => error(Code::CrossesItself, "touching", at, &|at| {
            format!("free edges touch in the point {at}: expected them to have more in common, or nothing")
        }),
        NoShell::Other(other) => {
            let message = format!("the other side of a wall of {asked} cannot be computed: {}", other.message());
            let error = Error::new(other.code(), placed.path("wall.thickness"), message);
            match other.place() {
                Some(at) => error.near(placed.point(DVec3::from_array(at)).to_array()),
                None => error,
            }
        }
    }
}
