//! Cosine and sine of whole and broken turns.

use core::f64::consts::TAU;

use libm::{cos, round, sin};

/// `(cos, sin)` of `turns * 2 pi`.
///
/// The angle is first reduced to an eighth of a turn, which is exact, so that quarter turns give exact zeros and ones and
/// mirror images of a point of the circle have coordinates of the same digits.
pub(crate) fn of_turns(turns: f64) -> (f64, f64) {
    let turns = turns - round(turns);
    let quarter = round(4.0 * turns);
    let angle = TAU * (turns - 0.25 * quarter);
    let (c, s) = (cos(angle), sin(angle));
    match quarter as i32 {
        0 => (c, s),
        1 => (-s, c),
        -1 => (s, -c),
        _ => (-c, -s),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(of_turns(0.0), (1.0, 0.0));
        assert_eq!(of_turns(0.25), (0.0, 1.0));
        assert_eq!(of_turns(0.5), (-1.0, 0.0));
        assert_eq!(of_turns(-0.25), (0.0, -1.0));
        assert_eq!(of_turns(1e15), (1.0, 0.0));
    }

    #[test]
    fn agrees_with_radians() {
        for i in -1000..1000 {
            let turns = f64::from(i) / 313.0;
            let (c, s) = of_turns(turns);
            assert!((c - (TAU * turns).cos()).abs() < 1e-14 && (s - (TAU * turns).sin()).abs() < 1e-14);
        }
    }
}
