//! Whole turns.

use core::f64::consts::TAU;

/// The same angle within the first turn, from 0 to 2 pi; what is below 0 by less than rounding comes to 2 pi itself.
pub(crate) fn within(angle: f64) -> f64 {
    angle - TAU * libm::floor(angle / TAU)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_are_taken_away() {
        assert_eq!(within(0.0), 0.0);
        assert_eq!(within(1.5), 1.5);
        assert_eq!(within(TAU), 0.0);
        assert!((within(-1.0) - (TAU - 1.0)).abs() < 1e-15);
        assert!((within(1.0 + 3.0 * TAU) - 1.0).abs() < 1e-14);
        assert_eq!(within(-1e-300), TAU);
    }
}
