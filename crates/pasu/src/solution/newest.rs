//! What was made last, for whoever makes the same again.

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::watch;

/// Values by what they were made of, the newest first to be found and last to be dropped. Whether one is kept changes nothing but how long an answer takes.
pub(crate) struct Newest<K, V> {
    kept: Mutex<Vec<(K, V, usize)>>,
    /// The most of all weights together; the newest value is kept whatever it has.
    most: usize,
}

impl<K: Clone, V: Clone> Newest<K, V> {
    pub(crate) fn new(most: usize) -> Newest<K, V> {
        Newest { kept: Mutex::default(), most }
    }

    /// The value that was made of this.
    pub(crate) fn find(&self, is_it: impl Fn(&K, &V) -> bool) -> Option<V> {
        self.kept().iter().rev().find(|(key, value, _)| is_it(key, value)).map(|(_, value, _)| value.clone())
    }

    /// Keeps a value of this weight, unless the call that made it was ended: that may be anything.
    pub(crate) fn keep(&self, key: K, value: &V, weight: usize) {
        if watch::is_stopped() {
            return;
        }
        let mut kept = self.kept();
        kept.push((key, value.clone(), weight));
        let mut all: usize = kept.iter().map(|(_, _, weight)| weight).sum();
        let n_old = kept.len() - 1;
        let is_over = |(_, _, weight): &(K, V, usize)| {
            let is_over = all > self.most;
            all -= if is_over { *weight } else { 0 };
            is_over
        };
        let n_dropped = kept[..n_old].iter().map(is_over).take_while(|is_over| *is_over).count();
        kept.drain(..n_dropped);
    }

    /// Those of it that are made of what is still there.
    pub(crate) fn of(&self, is_there: impl Fn(&K) -> bool) -> Newest<K, V> {
        let kept = self.kept().iter().filter(|(key, ..)| is_there(key)).cloned().collect();
        Newest { kept: Mutex::new(kept), most: self.most }
    }

    /// What a thread left that panicked holds whole values only.
    fn kept(&self) -> MutexGuard<'_, Vec<(K, V, usize)>> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// All that are kept.
    #[cfg(test)]
    pub(crate) fn values(&self) -> Vec<V> {
        self.kept().iter().map(|(_, value, _)| value.clone()).collect()
    }

    /// How many are kept.
    #[cfg(test)]
    pub(crate) fn n_kept(&self) -> usize {
        self.kept().len()
    }
}

#[cfg(test)]
mod tests {
    use core::ops::ControlFlow;
    use std::sync::Arc;

    use super::*;

    fn found(newest: &Newest<u32, char>, key: u32) -> Option<char> {
        newest.find(|of, _| *of == key)
    }

    #[test]
    fn the_oldest_go_first_and_the_newest_stays_whatever_it_weighs() {
        let newest = Newest::new(10);
        for (key, value, weight) in [(1, 'a', 4), (2, 'b', 4), (3, 'c', 2)] {
            newest.keep(key, &value, weight);
        }
        assert_eq!([1, 2, 3, 4].map(|key| found(&newest, key)), [Some('a'), Some('b'), Some('c'), None]);
        newest.keep(4, &'d', 5);
        assert_eq!([1, 2, 3, 4].map(|key| found(&newest, key)), [None, None, Some('c'), Some('d')]);
        newest.keep(5, &'e', 11);
        assert_eq!((newest.n_kept(), found(&newest, 5)), (1, Some('e')));
        newest.keep(6, &'f', 0);
        assert_eq!((newest.n_kept(), found(&newest, 6)), (1, Some('f')));
        newest.keep(6, &'g', 0);
        assert_eq!(found(&newest, 6), Some('g'));
    }

    #[test]
    fn what_is_still_there_is_taken_over() {
        let newest = Newest::new(10);
        (1..4).for_each(|key| newest.keep(key, &'a', 2));
        let next = newest.of(|key| *key != 2);
        assert_eq!([1, 2, 3].map(|key| found(&next, key).is_some()), [true, false, true]);
        assert_eq!(newest.n_kept(), 3);
    }

    #[test]
    fn what_was_ended_is_not_kept() {
        let newest = Arc::new(Newest::new(10));
        let inside = Arc::clone(&newest);
        let mut n_told = 0;
        let progress = move |_| {
            n_told += 1;
            if n_told > 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let ended = watch::watched(progress, || {
            inside.keep(1, &'a', 1);
            watch::work(1 << 20);
            inside.keep(2, &'b', 1);
            Ok(())
        });
        assert!(ended.is_err() && newest.n_kept() == 1);
        assert_eq!(found(&newest, 1), Some('a'));
    }
}
