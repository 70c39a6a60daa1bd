//! Local minima of values at even places round a circle: where searches begin.

/// The numbers of the values that are less than the one before and no more than the one after, the first following on the last: the least first, of equal ones the one with the smaller number.
///
/// Of equal neighbours the first counts, so that a level stretch has one minimum. Where all are equal there would be none, and the first is taken; there is always one unless there are no values.
pub(crate) fn round(values: &[f64]) -> Vec<usize> {
    let n = values.len();
    let mut minima: Vec<usize> =
        (0..n).filter(|&i| values[i] < values[(i + n - 1) % n] && values[i] <= values[(i + 1) % n]).collect();
    minima.sort_by(|&i, &j| values[i].total_cmp(&values[j]).then(i.cmp(&j)));
    if minima.is_empty() {
        minima.extend((0..n).min_by(|&i, &j| values[i].total_cmp(&values[j])));
    }
    minima
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_comes_first() {
        assert_eq!(round(&[3.0, 1.0, 2.0, 0.5, 4.0, 1.0, 5.0]), [3, 1, 5]);
    }

    #[test]
    fn the_last_is_beside_the_first() {
        assert_eq!(round(&[0.0, 1.0, 2.0, 1.0]), [0]);
        assert_eq!(round(&[1.0, 2.0, 1.0, 0.0]), [3]);
    }

    #[test]
    fn a_level_stretch_has_one() {
        assert_eq!(round(&[2.0, 1.0, 1.0, 1.0, 2.0]), [1]);
        assert_eq!(round(&[1.0, 2.0, 1.0]), [2]);
        assert_eq!(round(&[7.0; 4]), [0]);
        assert_eq!(round(&[7.0]), [0]);
        assert!(round(&[]).is_empty());
    }
}
