//! Bisection: where something that can only be told apart, not measured, changes.

/// Narrows an interval at whose ends something differs, by halving it so many times: what is at each place is kept while it `is_low`, alike to the lower end.
///
/// Both ends come back with what was found there, so that a change is between them; they are `(high - low) / 2^halvings` apart, or neighbouring doubles. Where several changes lie
/// within the interval the one found is that after which nothing is alike to the lower end at the places that were looked at; `is_low` need not be monotone. The lower end is never
/// looked at again, and the upper one is taken as it is, whatever `is_low` says of it.
pub(crate) fn change<T>(
    low: (f64, T),
    high: (f64, T),
    halvings: usize,
    mut at: impl FnMut(f64) -> T,
    is_low: impl Fn(&T) -> bool,
) -> [(f64, T); 2] {
    let (mut low, mut high) = (low, high);
    for _ in 0..halvings {
        let middle = 0.5 * (low.0 + high.0);
        let found = at(middle);
        if is_low(&found) {
            low = (middle, found);
        } else {
            high = (middle, found);
        }
    }
    [low, high]
}

/// The least whole number above `too_few` that `is_enough`, of which `enough` is one: for a predicate that holds from some number on. Where it does not, one that holds and whose predecessor does not.
///
/// Takes the logarithm of the gap to base 2. Whole numbers are exact as doubles up to 2^53; beyond that the gap is closed as far as doubles go.
pub(crate) fn least_whole(too_few: f64, enough: f64, mut is_enough: impl FnMut(f64) -> bool) -> f64 {
    let (mut too_few, mut enough) = (too_few, enough);
    while enough - too_few > 1.0 {
        let middle = (0.5 * (too_few + enough)).floor();
        if !(too_few < middle && middle < enough) {
            break;
        }
        if is_enough(middle) { enough = middle } else { too_few = middle }
    }
    enough
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_beyond_whole_ones_come_to_an_end() {
        assert_eq!(least_whole(1e16, 1e16 + 2.0, |_| true), 1e16 + 2.0);
        assert!(least_whole(1e300, 3e300, |x| x >= 2e300) >= 2e300);
    }

    #[test]
    fn a_change_is_between_what_comes_back() {
        let kind = |x: f64| x >= core::f64::consts::FRAC_1_SQRT_2;
        let [low, high] = change((0.0, false), (1.0, true), 30, kind, |is_beyond| !is_beyond);
        assert_eq!((low.1, high.1), (false, true));
        assert_eq!(high.0 - low.0, 0.5f64.powi(30));
        assert!(low.0 < core::f64::consts::FRAC_1_SQRT_2 && core::f64::consts::FRAC_1_SQRT_2 <= high.0);
    }

    #[test]
    fn without_a_halving_the_ends_come_back() {
        let ends = change((2.0, 'a'), (5.0, 'b'), 0, |_| 'c', |_| true);
        assert_eq!(ends, [(2.0, 'a'), (5.0, 'b')]);
    }

    #[test]
    fn of_several_changes_one_is_found() {
        // Alike below 0.3 and between 0.6 and 0.7.
        let is_alike = |x: f64| x < 0.3 || (0.6..0.7).contains(&x);
        let [low, high] = change((0.0, true), (1.0, false), 40, is_alike, |alike| *alike);
        assert!(low.1 && !high.1 && high.0 - low.0 < 1e-11);
        assert!((low.0 - 0.3).abs() < 1e-10 || (low.0 - 0.7).abs() < 1e-10, "{low:?}");
    }

    #[test]
    fn whole_numbers() {
        for least in 4..=1000 {
            let mut asked = 0;
            let found = least_whole(3.0, 1000.0, |n| {
                asked += 1;
                n >= f64::from(least)
            });
            assert_eq!(found, f64::from(least));
            assert!(asked <= 10, "{least}: {asked}");
        }
        assert_eq!(least_whole(6.0, 7.0, |_| true), 7.0);
    }
}
