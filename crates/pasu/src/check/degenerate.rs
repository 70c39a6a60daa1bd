//! Triangles without area, decided exactly.

use robust::{Coord, orient2d};

/// Whether a triangle has no area: its corners are on one line, or two of them are one point.
///
/// They are if and only if all three projections along the axes have no area, which is decided without rounding error.
pub(crate) fn is_degenerate([a, b, c]: [[f32; 3]; 3]) -> bool {
    [(0, 1), (1, 2), (2, 0)].iter().all(|&(x, y)| {
        let [a, b, c] = [a, b, c].map(|p| Coord { x: f64::from(p[x]), y: f64::from(p[y]) });
        orient2d(a, b, c) == 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_area_counts() {
        let thin = |height: f32| [[0.0, 0.0, 1.0], [1e6, 0.0, 1.0], [2e6, height, 1.0]];
        assert!(is_degenerate(thin(0.0)));
        assert!(!is_degenerate(thin(1e-30)));
        assert!(is_degenerate([[0.1, 0.2, 0.3]; 3]));
        assert!(is_degenerate([[0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [3.0, 6.0, 9.0]]));
    }
}
