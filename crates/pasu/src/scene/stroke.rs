//! A piece of a meridian, with how far it is from the straight line between its ends.

use glam::DVec2;

use super::segment::Segment;

/// A piece of a curve of a meridian, over a part of its parameter, that is no further from its chord than it says, place by place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    /// The number of the curve.
    pub(super) course: usize,
    pub(super) t: [f64; 2],
    pub(super) chord: Segment,
    /// At a quarter, a half and three quarters of the parameter.
    pub(super) inner: [DVec2; 3],
    pub(super) deviation: f64,
    /// The corners at which it begins and ends, by their numbers; none where the meridian runs on without one.
    pub(super) joints: [Option<usize>; 2],
}

impl Stroke {
    /// A bound of the sine of the angle between the tangent, wherever it is taken, and the chord; 1 where none is known.
    ///
    /// In a parameter that runs from 0 to 1 the derivative is no further from the chord than half of the greatest second derivative, which is four times what the deviation is of.
    pub(super) fn slant(&self) -> f64 {
        let length = self.chord.length();
        if length > 0.0 { (4.0 * self.deviation / length).min(1.0) } else { 1.0 }
    }
}
