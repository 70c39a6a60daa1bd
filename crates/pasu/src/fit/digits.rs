//! Numbers with no more digits than a tolerance sees.

/// The largest power of ten that is not above this.
pub(super) fn decimal(at_most: f64) -> f64 {
    libm::pow(10.0, libm::floor(libm::log10(at_most)))
}

/// The multiple of a unit that is nearest.
pub(super) fn to_multiple(number: f64, unit: f64) -> f64 {
    let multiple = libm::round(number / unit) * unit;
    // Beyond what doubles can tell, and where the unit is no number, it stays as it is.
    if multiple.is_finite() { multiple } else { number }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_become_short() {
        assert_eq!((decimal(0.004), decimal(0.001), decimal(25.0)), (0.001, 0.001, 10.0));
        assert_eq!([2.34567, -0.0004, 7.0].map(|number| to_multiple(number, 0.001)), [2.346, -0.0, 7.0]);
        assert_eq!(to_multiple(1e300, 1e-300), 1e300);
    }
}
