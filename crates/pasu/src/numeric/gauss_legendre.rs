//! Gauss-Legendre rules of a few nodes, and their spread over many short intervals.

/// Nodes on [0, 1] and weights, which add up to 1.
pub(crate) type Rule = &'static [(f64, f64)];

/// The rule with two nodes, exact for polynomials of degree 3.
pub(crate) const TWO: Rule = &[(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)];

/// With three, exact for degree 5.
pub(crate) const THREE: Rule = &[
    (0.112_701_665_379_258_31, 0.277_777_777_777_777_8),
    (0.5, 0.444_444_444_444_444_4),
    (0.887_298_334_620_741_7, 0.277_777_777_777_777_8),
];

/// With four, exact for degree 7.
pub(crate) const FOUR: Rule = &[
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// Places and weights of a rule between ascending breaks, each gap cut into so many equal pieces.
pub(crate) fn spread(breaks: &[f64], splits: usize, rule: Rule) -> (Vec<f64>, Vec<f64>) {
    let mut places = Vec::with_capacity(breaks.len() * splits * rule.len());
    let mut weights = Vec::with_capacity(places.capacity());
    for pair in breaks.windows(2) {
        let width = (pair[1] - pair[0]) / splits as f64;
        for piece in 0..splits {
            let from = pair[0] + piece as f64 * width;
            for &(node, weight) in rule {
                places.push(from + node * width);
                weights.push(weight * width);
            }
        }
    }
    (places, weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_for_their_degree_and_no_further() {
        for rule in [TWO, THREE, FOUR] {
            for degree in 0..=2 * rule.len() {
                let sum: f64 = rule.iter().map(|(node, weight)| weight * node.powi(degree as i32)).sum();
                let is_exact = (sum - 1.0 / (degree + 1) as f64).abs() < 1e-15;
                assert_eq!(is_exact, degree < 2 * rule.len(), "{} nodes, degree {degree}", rule.len());
            }
        }
    }

    #[test]
    fn a_spread_rule_integrates_piece_by_piece() {
        let (places, weights) = spread(&[0.0, 0.5, 2.0], 3, TWO);
        assert_eq!((places.len(), weights.len()), (12, 12));
        assert!(places.is_sorted());
        let sum: f64 = places.iter().zip(&weights).map(|(x, weight)| weight * x * x * x).sum();
        assert!((sum - 4.0).abs() < 1e-14, "{sum}");
        assert_eq!(spread(&[1.0], 3, TWO), (vec![], vec![]));
    }
}
