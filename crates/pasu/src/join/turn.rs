//! Directions in which bodies are joined.

use std::borrow::Cow;

use glam::{DMat3, DQuat, DVec3};

/// Turns to directions that no axis, no face of a block and no seam of a pot is likely to have, as quaternions.
const TURNS: [[f64; 4]; 3] = [[0.27, -0.39, 0.31, 0.83], [-0.44, 0.29, 0.58, 0.67], [0.35, 0.62, -0.23, 0.71]];

/// What a turn there and back leaves of a coordinate that was 0, as a share of the largest, is less.
const DUST: f64 = 1e-14;

/// Bodies are joined by what their shadows along z have in common. Of faces that stand upright, as they do of everything that is turned about z, these are lines but for what rounding to the numbers of a file has moved, and where two of them coincide the corners in which they do are told wrongly. Turned elsewhere first they have width.
///
/// `None` is no turn.
#[derive(Clone, Copy)]
pub(super) struct Turn(Option<Turned>);

#[derive(Clone, Copy)]
struct Turned {
    there: DMat3,
    /// A coordinate that is less is 0.
    dust: f64,
}

impl Turn {
    /// Number 0 is none; `largest` is the largest coordinate of what is turned.
    pub(super) fn number(number: usize, largest: f64) -> Turn {
        let quaternion = number.checked_sub(1).and_then(|index| TURNS.get(index));
        Turn(
            quaternion
                .map(|of| Turned { there: DMat3::from_quat(DQuat::from_array(*of).normalize()), dust: DUST * largest }),
        )
    }

    /// Points, three coordinates each, turned there.
    pub(super) fn there(self, positions: &[f64]) -> Cow<'_, [f64]> {
        let Some(Turned { there, .. }) = self.0 else { return Cow::Borrowed(positions) };
        let turned = |point: &[f64; 3]| (there * DVec3::from_array(*point)).to_array();
        positions.as_chunks::<3>().0.iter().flat_map(turned).collect()
    }

    /// A point turned back.
    pub(super) fn back(self, point: [f64; 3]) -> [f64; 3] {
        let Some(Turned { there, dust }) = self.0 else { return point };
        let turned = there.transpose() * DVec3::from_array(point);
        turned.to_array().map(|x| if x.abs() < dust { 0.0 } else { x })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_turned_there_and_back_has_the_numbers_of_its_file() {
        let points = [0.0f32, 1.5, -0.1, 2.0e-4, 0.0, 3.3333333, -7.25, 1e-6, 0.0].map(f64::from);
        for number in 0..=TURNS.len() {
            let turn = Turn::number(number, 7.25);
            let there = turn.there(&points);
            assert_eq!(there[..] == points, number == 0);
            let back: Vec<f32> =
                there.as_chunks::<3>().0.iter().flat_map(|at| turn.back(*at)).map(|x| x as f32).collect();
            assert_eq!(back, points.map(|x| x as f32));
        }
    }
}
