//! The four solutions of a slow equation of order 4 that begin as 1, `x`, `x^2 / 2` and `x^3 / 6`, as power series.

use super::series::{Quiet, falling};
use crate::numeric::horner;

/// Terms of one parity at most: a rate of 4 takes half of them, and beyond them nothing is left of it.
const MOST: usize = 40;

/// Functions.
const N: usize = 4;

/// Two even and two odd functions about `x = u - 1/2 = 0`. Of each only the powers are kept that it has: a beam through many rings has thousands of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fundamental {
    /// Those of all four, one behind the other, lowest power first.
    terms: Box<[f64]>,
    /// Where each of them ends.
    ends: [u8; N],
}

impl Fundamental {
    /// Those of `q'''' = b q'' - c q`, whose rates are small. The bits are those of [`continue_series`](super::series::continue_series), which also forms the powers that are 0.
    pub(super) fn of(b: f64, c: f64) -> Self {
        let mut terms = [0.0; N * MOST];
        let mut ends = [0; N];
        let mut end = 0;
        for (index, start) in [[1.0, 0.0], [0.0, 0.5], [1.0, 0.0], [0.0, 1.0 / 6.0]].into_iter().enumerate() {
            let parity = index / 2;
            end += continued(b, c, parity, start, &mut terms[end..][..MOST]);
            ends[index] = end as u8;
        }
        Fundamental { terms: terms[..end].into(), ends }
    }

    /// The powers of a function, lowest first.
    pub(super) fn powers(&self, index: usize) -> impl DoubleEndedIterator<Item = f64> + ExactSizeIterator {
        let from = index.checked_sub(1).map_or(0, |before| self.ends[before].into());
        let (terms, parity) = (&self.terms[from..self.ends[index].into()], index / 2);
        let n = if terms.is_empty() { 0 } else { 2 * terms.len() - 1 + parity };
        (0..n).map(move |power| if power % 2 == parity { terms[power / 2] } else { 0.0 })
    }

    /// The second derivatives of the functions at `u = 1`.
    pub(super) fn bent(&self) -> [f64; N] {
        let mut from = 0;
        core::array::from_fn(|index| {
            let (terms, parity) = (&self.terms[from..self.ends[index].into()], index / 2);
            from = self.ends[index].into();
            // By Horner's rule in x^2 = 1/4; the lowest power has none.
            let sum = (1..terms.len()).rev().fold(0.0, |sum, i| 0.25 * sum + falling(2 * i + parity, 2) * terms[i]);
            if parity == 0 { sum } else { 0.5 * sum }
        })
    }

    /// The functions at `u` with their derivatives up to order `M - 1`.
    pub(super) fn jets<const M: usize>(&self, u: f64) -> [[f64; M]; N] {
        [0, 1, 2, 3].map(|index| horner::derivatives(self.powers(index).rev(), u - 0.5))
    }
}

/// Writes the terms of one parity, of which the first two are given, and says how many there are.
fn continued(b: f64, c: f64, parity: usize, start: [f64; 2], terms: &mut [f64]) -> usize {
    terms[..2].copy_from_slice(&start);
    let mut quiet = Quiet::default();
    for (index, term) in start.into_iter().enumerate() {
        quiet.begin(term, 2 * index + parity);
    }
    let (mut n, mut power) = (2, N);
    while power < 2 * terms.len() && !quiet.has_ended(N) {
        if power % 2 == parity {
            let m = power - N;
            let sum = 0.0 + b * falling(m + 2, 2) * terms[n - 1] + -c * terms[n - 2];
            terms[n] = sum / falling(power, N);
            quiet.hear(terms[n], power);
            n += 1;
        } else {
            quiet.hear(0.0, power);
        }
        power += 1;
    }
    while n > 0 && terms[n - 1] == 0.0 {
        n -= 1;
    }
    n
}

#[cfg(test)]
mod tests {
    use super::super::series::continue_series;
    use super::*;

    /// Every regime with rates that are small enough.
    #[test]
    fn they_are_the_series_with_all_powers_to_the_bit() {
        let mut longest = 0;
        for (z, y) in [(0.0, 0.0), (16.0, 16.0), (-16.0, 16.0), (-16.0, -16.0), (1e-9, 1e-20), (9.0, -3.0), (0.3, 0.2)]
        {
            for (b, c) in [(z + y, z * y), (z, 256.0), (-31.0, 256.0), (0.0, 255.0), (z, 0.0)] {
                let fundamental = Fundamental::of(b, c);
                for (bent, jet) in fundamental.bent().into_iter().zip(fundamental.jets::<3>(1.0)) {
                    assert!((bent - jet[2]).abs() <= 1e-14 * (1.0 + bent.abs()), "{bent} {jet:?}");
                }
                for (index, start) in
                    [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.5, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0 / 6.0]]
                        .into_iter()
                        .enumerate()
                {
                    let all = continue_series(&start, &[(2, b), (0, -c)], &[]);
                    let found: Vec<f64> = fundamental.powers(index).collect();
                    assert_eq!(found, all, "b = {b}, c = {c}");
                    longest = longest.max(all.len());
                }
            }
        }
        assert!(longest > 20 && longest < 2 * MOST - 20, "{longest}");
    }
}
