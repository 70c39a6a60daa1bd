//! What was asked for lately, for whoever asks for the same over and over.

use std::sync::{Mutex, PoisonError};

use super::scattered::scattered;

/// Numbers, by their bits, and what follows from them.
type Slot<V, const N: usize> = Option<([u64; N], V)>;

/// Values by the bits of the numbers that they follow from, each in the one place that is its own, where the next with that place takes over. Whether one is kept changes no bit of it, so that all of these count as equal, and a copy has none.
#[derive(Debug)]
pub(crate) struct Recent<V, const N: usize>(Mutex<Vec<Slot<V, N>>>);

impl<V, const N: usize> Default for Recent<V, N> {
    fn default() -> Recent<V, N> {
        Recent(Mutex::default())
    }
}

impl<V, const N: usize> Clone for Recent<V, N> {
    fn clone(&self) -> Recent<V, N> {
        Recent::default()
    }
}

impl<V, const N: usize> PartialEq for Recent<V, N> {
    fn eq(&self, _: &Recent<V, N>) -> bool {
        true
    }
}

impl<V: Clone, const N: usize> Recent<V, N> {
    /// The value for these numbers, among so many places, a power of two; `make` makes it where it is not kept.
    pub(crate) fn at(&self, of: [f64; N], n_places: usize, make: impl FnOnce() -> V) -> V {
        let bits = of.map(f64::to_bits);
        // What a thread left that panicked holds whole values only.
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if slots.is_empty() {
            slots.resize(n_places, None);
        }
        let place = bits.iter().fold(0, |mixed, bits| scattered(mixed ^ bits)) as usize & (slots.len() - 1);
        if let Some((_, value)) = slots[place].as_ref().filter(|(known, _)| *known == bits) {
            return value.clone();
        }
        let value = make();
        slots[place] = Some((bits, value.clone()));
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_made_once_while_it_is_kept_and_never_taken_for_another() {
        for (n_places, most_made) in [(1024, 8000), (64, 20_000), (1, 20_000)] {
            let recent = Recent::default();
            let mut n_made = 0;
            for i in 0..20_000 {
                // Ninety-seven again and again, and others in between.
                let u = if i % 4 == 0 { f64::from(i) / 20_011.0 } else { f64::from(i % 97) / 96.0 };
                let found = recent.at([u], n_places, || {
                    n_made += 1;
                    u
                });
                assert_eq!(found, u);
            }
            assert!(n_made <= most_made, "{n_places}: {n_made}");
        }
    }

    #[test]
    fn zeros_of_either_sign_and_numbers_in_another_order_are_others() {
        let recent = Recent::default();
        let signs = [0.0, -0.0].map(|u: f64| recent.at([u], 8, || u.is_sign_negative()));
        assert_eq!(signs, [false, true]);
        let recent = Recent::default();
        for pair in [[0.0, 1.0], [1.0, 0.0], [0.0, 1.0]] {
            assert_eq!(recent.at(pair, 1, || pair), pair);
        }
    }
}
