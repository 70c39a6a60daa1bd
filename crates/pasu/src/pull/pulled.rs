//! A design, one part of which is pulled.

use glam::DVec3;

use super::bump::{Bump, MOST_WAVES};
use super::contract::{Hand, Pulled};
use super::{named, ringed, written};
use crate::design::{Design, Shape, plain};
use crate::error::{Code, Error, Result};
use crate::evaluate::evaluate;
use crate::solution::Solution;

/// The design with the least change of part `part` that brings a point of it to where a hand pulls it.
///
/// Of `rings` and `boundary-value` the ring under the hand changes, and one is put there first where none is near: a bump as wide as is asked for is added to its radius and height, or to its `x`, `y` and `z`. Of a pot of `rings`, what the hand moves
/// round the axis moves the bump, and the point that arrives is that of the ring which is beneath `to`: [`Pulled::at`].
///
/// Of a named family the numbers change that are not kept, least in the sum of squares, lengths measured in the size of the vase and other numbers in what they were; the waves round the axis
/// stay, and what is equal for `x` and `y`. Where the family cannot follow, its point comes as near as its numbers can bring it, and [`Pulled::behind`] says how far that is off.
///
/// ```
/// use pasu::{Design, Hand, Shape, pull};
///
/// let vase = Design::parse("#1/fourth-order")?;
/// let belly = pasu::evaluate(&vase, 0, &[0.5, 0.0])?;
/// let pulled = pull(&vase, 0, &Hand::new([0.5, 0.0], [belly[0] + 0.3, belly[1], belly[2]]))?;
/// let moved = pasu::evaluate(&pulled.design, 0, &[0.5, 0.0])?;
/// assert!((moved[0] - belly[0] - 0.3).abs() < 1e-9 && pulled.behind < 1e-9);
/// # Ok::<(), pasu::Error>(())
/// ```
///
/// # Errors
/// `no-such-point` for a part or a point that does not exist, `not-finite` for a place that is none, `out-of-range` for a width or a number of petals that cannot be had, `unknown-name` for
/// something to be kept that the shape does not have; what [`Surface::solve`](crate::Surface::solve) and [`Design::read`] refuse.
pub fn pull(design: &Design, part: usize, hand: &Hand) -> Result<Pulled> {
    let solution = Solution::of(design);
    let (_, of) = solution.existing(part)?;
    if of.shape.problem().is_none() {
        let message = "only a surface between two ends can be pulled: the points of a network are moved one by one";
        return Err(Error::new(Code::UnsupportedShape, format!("parts[{part}].shape"), message).with("what", "no-ends"));
    }
    solution.check_points(part, &hand.at)?;
    let to = DVec3::from_array(hand.to);
    if !to.is_finite() {
        let place = hand.to.iter().position(|x| !x.is_finite()).unwrap_or_default();
        let message = format!("expected a finite number, found {}", plain(hand.to[place]));
        return Err(Error::new(Code::NotFinite, format!("to[{place}]"), message));
    }
    let bump = bump(hand)?;
    let shape = &design.parts()[part].shape;
    let inside =
        |error: Error| if error.path().starts_with("keep") { error } else { error.at(format!("parts[{part}].shape")) };
    let mut at = hand.at;
    let pulled = match shape {
        Shape::Rings(pot) => ringed::pull(pot, hand.at, to, bump, &hand.keep).map(|(pot, v)| {
            at[1] = v;
            Shape::Rings(pot)
        }),
        Shape::BoundaryValue(problem) => {
            written::pull(problem, hand.at, to, bump, &hand.keep).map(Shape::BoundaryValue)
        }
        _ if bump.is_round() => named::pull(shape, hand.at, to, &hand.keep),
        _ => {
            let message = "a named family follows as a whole: it has no numbers for one side of it";
            Err(Error::new(Code::UnsupportedShape, "", message))
        }
    };
    let design = design.with_shape(part, pulled.map_err(inside)?)?;
    let moved = match &design.parts()[part].shape {
        Shape::Rings(pot) => ringed::position(pot, at)?,
        Shape::BoundaryValue(problem) => written::position(problem, at)?,
        _ => DVec3::from_slice(&evaluate(&design, part, &at)?),
    };
    let behind = (to - moved).length();
    if !behind.is_finite() {
        return Err(Error::new(Code::Overflow, "to", "this place is too far away to be computed with"));
    }
    Ok(Pulled { design, at, behind })
}

/// How the pull is spread round the axis.
fn bump(hand: &Hand) -> Result<Bump> {
    let petals = hand.petals.unwrap_or(1);
    if !(1..=MOST_WAVES).contains(&petals) {
        let message = format!("expected a number of petals from 1 to {MOST_WAVES}, found {petals}");
        let error = Error::new(Code::OutOfRange, "petals", message).with("least", 1.0);
        return Err(error.with("greatest", MOST_WAVES as usize).with("found", petals as usize));
    }
    if let Some(width) = hand.width
        && !(width > 0.0)
    {
        let message = format!("expected a width in radians greater than 0, found {}", plain(width));
        return Err(Error::new(Code::OutOfRange, "width", message).with("above", 0.0).with("found", width));
    }
    Bump::of_width(hand.width, petals).ok_or_else(|| {
        let least = Bump::least_width(petals);
        let width = hand.width.unwrap_or_default();
        // Who takes the number that is told is not refused again.
        let told = libm::ceil(1e4 * least) / 1e4;
        let message = format!("expected a width of at least {} radians, found {}", plain(told), plain(width));
        Error::new(Code::OutOfRange, "width", message).with("least", least).with("found", width)
    })
}
