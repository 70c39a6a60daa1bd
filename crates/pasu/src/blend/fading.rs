//! The cubics by which what one section has fades towards the other.

use crate::numeric::cubic::through;

/// A unit of what the section at one end has, with a tangent of so much of it, fading to nothing at the other.
pub(super) fn fading(is_end: bool, taper: f64) -> [f64; 4] {
    if is_end { through([0.0, 1.0], [0.0, taper]) } else { through([1.0, 0.0], [taper, 0.0]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::horner;

    #[test]
    fn values_and_slopes_are_met() {
        let at = |cubic: [f64; 4], w: f64| horner::derivatives::<2>(cubic.into_iter().rev(), w);
        assert_eq!((at(fading(false, -0.5), 0.0), at(fading(false, -0.5), 1.0)), ([1.0, -0.5], [0.0, 0.0]));
        assert_eq!((at(fading(true, -0.5), 0.0), at(fading(true, -0.5), 1.0)), ([0.0, 0.0], [1.0, -0.5]));
        // (1 - 3 w^2 + 2 w^3) and (1 - 2 w + w^2) w, as ZY04 has them.
        assert_eq!(fading(false, 0.0), [1.0, 0.0, -3.0, 2.0]);
    }
}
