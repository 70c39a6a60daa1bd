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

/// The most of [`multiples`].
pub(crate) const MOST_MULTIPLES: usize = 1 << 12;

/// `(cos, sin)` of `0, 1, .., most` times `turns` turns, each as the product of those of two halves: as good as the rounding of `turns` lets them be, and a tenth of the time of as many cosines.
pub(crate) fn multiples(turns: f64, most: usize) -> Vec<(f64, f64)> {
    let mut all = Vec::with_capacity(most + 1);
    all.extend([(1.0, 0.0), of_turns(turns)]);
    for n in 2..=most {
        let ((a, b), (c, d)) = (all[n / 2], all[n - n / 2]);
        all.push((a * c - b * d, a * d + b * c));
    }
    all
}

/// Waves are found one from the other by [`multiples`] from so many on, and if they are not fewer than every so manieth there could be.
const MANY_WAVES: usize = 16;
const ONE_OF: usize = 4;

/// How often the fastest of these whole waves goes round, where they are so many that [`multiples`] pays.
pub(crate) fn most_of_many(turns: impl Iterator<Item = usize>) -> Option<usize> {
    let (n_waves, most) = turns.fold((0, 0), |(n, most), turns| (n + 1, most.max(turns)));
    (n_waves >= MANY_WAVES && most <= ONE_OF * n_waves).then_some(most)
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
