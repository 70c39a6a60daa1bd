//! Rows of a surface that were asked for lately: whoever goes from column to column asks for the same ones over and over.

use core::ops::Deref;
use std::sync::{Arc, Mutex, PoisonError};

use super::row_table::RowTable;
use crate::numeric::scattered::scattered;

/// The most rows that are kept, a power of two.
const MOST: usize = 1 << 10;

/// The most terms of all rows that are kept, of some seventy bytes each.
const MOST_TERMS: usize = 1 << 16;

/// A row and the bits of its `u`.
type Slot = Option<(u64, Arc<RowTable<3>>)>;

/// The coefficients of a row, wherever they are kept.
pub(super) enum KeptRow<'a> {
    End(&'a RowTable<3>),
    Recent(Arc<RowTable<3>>),
}

impl Deref for KeptRow<'_> {
    type Target = RowTable<3>;

    fn deref(&self) -> &RowTable<3> {
        match self {
            KeptRow::End(row) => row,
            KeptRow::Recent(row) => row,
        }
    }
}

/// Rows by the bits of their `u`, each in the one place that is its own, where the next with that place takes over. They follow from the surface, so that all of them count as equal.
#[derive(Debug, Default)]
pub(super) struct Recent(Mutex<Vec<Slot>>);

impl Clone for Recent {
    fn clone(&self) -> Recent {
        Recent::default()
    }
}

impl PartialEq for Recent {
    fn eq(&self, _: &Recent) -> bool {
        true
    }
}

impl Recent {
    /// The row at `u` of a surface of so many terms; `make` makes it where it is not kept.
    pub(super) fn at(&self, u: f64, n_terms: usize, make: impl FnOnce() -> RowTable<3>) -> Arc<RowTable<3>> {
        let bits = u.to_bits();
        // What a thread left that panicked holds whole rows only.
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if slots.is_empty() {
            // Whether rows are kept changes no bit of them, so that only time goes by how many.
            let n = (MOST_TERMS / n_terms.max(1)).clamp(1, MOST);
            slots.resize(1 << n.ilog2(), None);
        }
        let place = scattered(bits) as usize & (slots.len() - 1);
        if let Some((_, row)) = slots[place].as_ref().filter(|(known, _)| *known == bits) {
            return Arc::clone(row);
        }
        let row = Arc::new(make());
        slots[place] = Some((bits, Arc::clone(&row)));
        row
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::row_table::RowTerm;

    fn row(u: f64) -> RowTable<3> {
        let term = RowTerm { column: 0, k: u, cos: [u; 3], sin: [u; 3] };
        RowTable { components: [vec![term], Vec::new(), Vec::new()] }
    }

    #[test]
    fn a_row_is_made_once_while_it_is_kept_and_never_taken_for_another() {
        for n_terms in [1, 900, 1 << 20] {
            let recent = Recent::default();
            let mut n_made = 0;
            for i in 0..20_000 {
                // Ninety-seven rows again and again, and others in between.
                let u = if i % 4 == 0 { f64::from(i) / 20_011.0 } else { f64::from(i % 97) / 96.0 };
                let found = recent.at(u, n_terms, || {
                    n_made += 1;
                    row(u)
                });
                assert_eq!(found.components[0][0].k, u);
            }
            assert!(if n_terms == 1 { n_made < 8000 } else { n_made <= 20_000 }, "{n_terms}: {n_made}");
        }
    }

    #[test]
    fn zeros_of_either_sign_are_rows_of_their_own() {
        let recent = Recent::default();
        let signs = [0.0, -0.0].map(|u| recent.at(u, 1, || row(u)).components[0][0].k.is_sign_negative());
        assert_eq!(signs, [false, true]);
    }
}
