//! Romberg's extrapolation: from three approximations with errors in even powers of a step to one whose first two are gone.

/// What approximations with a step, half of it and a quarter of it tend to, if each lacks `c2 h^2 + c4 h^4 + ..`, without both; and by how much what the first two tend to without the first differs from what the last two do, which is far more than the result is off.
///
/// Exact where there are no further powers. Where they do not draw together four times as near, other powers come first: then the last step is added to the error, and that is more than what is left as long as each is at least half of the one before.
pub(crate) fn romberg([coarse, middle, fine]: [f64; 3]) -> (f64, f64) {
    let [before, after] = [(coarse, middle), (middle, fine)].map(|(a, b)| b + (b - a) / 3.0);
    let (first, second) = (middle - coarse, fine - middle);
    let is_regular = (first - 4.0 * second).abs() <= second.abs();
    (after + (after - before) / 15.0, (after - before).abs() + if is_regular { 0.0 } else { second.abs() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_powers_are_taken_out() {
        let of = |h: f64| 7.0 + 3.0 * h * h - 2.0 * h * h * h * h;
        let (value, error) = romberg([of(1.0), of(0.5), of(0.25)]);
        assert!((value - 7.0).abs() < 2e-15 && error > 0.1, "{value} {error}");
    }

    #[test]
    fn polygons_of_a_circle() {
        // The area of a regular polygon in the unit circle is n sin(2 pi / n) / 2.
        let of = |n: f64| 0.5 * n * libm::sin(core::f64::consts::TAU / n);
        let (value, error) = romberg([of(32.0), of(64.0), of(128.0)]);
        let off = (value - core::f64::consts::PI).abs();
        assert!(off < 1e-9 && off < error && error < 1e-5, "{off} {error}");
    }

    #[test]
    fn where_other_powers_come_first_the_error_says_so() {
        for power in [1.0, 1.3, 1.7, 2.4, 3.0] {
            let of = |h: f64| 7.0 - libm::pow(h, power);
            let (value, error) = romberg([of(0.01), of(0.005), of(0.0025)]);
            assert!((value - 7.0).abs() < error, "{power}: {value} {error}");
        }
    }
}
