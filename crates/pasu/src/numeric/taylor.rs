//! Bounds by Taylor's formula.

/// Lowers the bounds of a function and its derivatives on an interval of this half length to what follows from their values at its middle and from the bound of the last.
///
/// About the middle `|f| <= |f(m)| + h |f'(m)| + .. + h^n / n! sup |f^(n)|`. A part of the interval gives no more, because the formula about its own middle is the one about that of the whole, taken in two steps.
pub(crate) fn tighten<const N: usize>(bounds: &mut [f64; N], jet: &[f64; N], half: f64) {
    for order in 0..N.saturating_sub(1) {
        let (mut sum, mut factor) = (0.0, 1.0);
        for (step, derivative) in jet[order..N - 1].iter().enumerate() {
            sum += factor * derivative.abs();
            factor *= half / (step + 1) as f64;
        }
        // What is no number lowers nothing.
        bounds[order] = bounds[order].min(sum + factor * bounds[N - 1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// exp(3 x) on [a, b] with bounds that are a hundred times too large.
    fn bounds(a: f64, b: f64) -> [f64; 5] {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let powers = [1.0, 3.0, 9.0, 27.0, 81.0];
        let mut bounds = powers.map(|k| 100.0 * k * (3.0 * b).exp());
        tighten(&mut bounds, &powers.map(|k| k * (3.0 * middle).exp()), half);
        bounds
    }

    #[test]
    fn bounds_come_down_and_stay_bounds() {
        for (a, b) in [(0.0, 1.0), (0.2, 0.4), (0.5, 0.51)] {
            let found = bounds(a, b);
            let expected = [1.0, 3.0, 9.0, 27.0].map(|k| k * (3.0 * b).exp());
            for (order, (found, expected)) in found.iter().zip(expected).enumerate() {
                assert!(*found >= expected * (1.0 - 1e-15), "{a} {b}");
                // Each term that is known takes away a factor of the length.
                assert!(b - a > 0.3 || order > 1 || *found < 1.7 * expected, "{a} {b}: {found}, {expected}");
            }
            let [left, right] = [bounds(a, 0.5 * (a + b)), bounds(0.5 * (a + b), b)];
            assert!((0..5).all(|i| left[i] <= found[i] && right[i] <= found[i]), "{a} {b}");
        }
    }
}
