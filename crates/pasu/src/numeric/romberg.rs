//! Romberg's extrapolation: from three approximations with errors in even powers of a step to one whose first two are gone.

/// What approximations with a step, half of it and a quarter of it tend to, if each lacks `c2 h^2 + c4 h^4 + ..`, without both; and what the first two and the last two tend to without the first. How much these
/// differ is far more than what the result is off.
///
/// Exact where there are no further powers.
pub(crate) fn romberg([coarse, middle, fine]: [f64; 3]) -> (f64, [f64; 2]) {
    let [before, after] = [(coarse, middle), (middle, fine)].map(|(a, b)| b + (b - a) / 3.0);
    (after + (after - before) / 15.0, [before, after])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_powers_are_taken_out() {
        let of = |h: f64| 7.0 + 3.0 * h * h - 2.0 * h * h * h * h;
        let (value, [before, after]) = romberg([of(1.0), of(0.5), of(0.25)]);
        assert!((value - 7.0).abs() < 2e-15 && (after - before).abs() > 0.1, "{value} {before} {after}");
    }

    #[test]
    fn polygons_of_a_circle() {
        // The area of a regular polygon in the unit circle is n sin(2 pi / n) / 2.
        let of = |n: f64| 0.5 * n * libm::sin(core::f64::consts::TAU / n);
        let (value, [before, after]) = romberg([of(32.0), of(64.0), of(128.0)]);
        let off = (value - core::f64::consts::PI).abs();
        assert!(off < 1e-9 && off < (after - before).abs(), "{off} {before} {after}");
    }
}
