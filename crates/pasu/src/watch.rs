//! How far a call is, told to whoever waits for it and may end it.
//!
//! The watcher belongs to the thread, not to a design: what takes long says here that it has done so much [`work`], and knows nothing of who listens. A call that is to end is not
//! torn out of its loops. Those that take long stop early, as if what they have were enough, and what they return goes nowhere: [`go_on`] refuses what would be made of it, and
//! [`watched`] whatever is left.
//!
//! Work that nobody would wait for ends by the same door: [`within`] gives a stretch so much of it and refuses what takes more. It is counted, not timed, so that the same is refused everywhere.

use core::cell::{Cell, RefCell};
use core::ops::ControlFlow;

use crate::error::{Code, Error, Result};

/// The work between two calls of a watcher: about a millisecond.
const BETWEEN: u64 = 1 << 17;

/// What a place of a surface counts for, in units of [`work`], and so many of the terms that it is the sum of for one more;
const PLACE: u64 = 13;
const TERMS_OF_PLACE: u64 = 3;

/// what a row counts for besides, of which a place is asked for the first time, and each two of its terms. As found on blends of 12 to 128 waves, on pots through rings of 6 to 24 and on those of the papers, give or take a fifth.
const ROW: u64 = 16;
const TWO_TERMS_OF_ROW: u64 = 9;

/// The work after which a stretch whose length nobody knows is taken to be half done: about a tenth of a second.
const HALF: f64 = 1e7;

thread_local! {
    static STATE: Cell<State> = const { Cell::new(State::Alone) };
    /// What is left of [`BETWEEN`].
    static LEFT: Cell<u64> = const { Cell::new(BETWEEN) };
    /// How much may still be done before [`within`] refuses; no end of it where nobody set one.
    static ALLOWED: Cell<u64> = const { Cell::new(u64::MAX) };
    static WATCHER: RefCell<Option<Watcher>> = const { RefCell::new(None) };
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    /// Nobody listens.
    Alone,
    /// Nobody listens either, but there is an end to what may be done.
    Counted,
    Watched,
    /// Whoever listened wants no more of it.
    Stopped,
    /// What may be done is done.
    Spent,
}

struct Watcher {
    progress: Box<dyn FnMut(f64) -> ControlFlow<()>>,
    /// What was told last.
    told: f64,
    stretch: Stretch,
}

/// What is being done, as a part of the whole.
#[derive(Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    /// Where the last [`share`] of it ended.
    at: f64,
    /// What was done since.
    work: f64,
}

impl Stretch {
    fn new(from: f64, to: f64) -> Stretch {
        Stretch { from, to, at: from, work: 0.0 }
    }

    fn done(&self) -> f64 {
        self.at + (self.to - self.at) * (self.work / (self.work + HALF))
    }
}

/// Calls Pasu and tells how far it is: `progress` is given a number that grows from 0 to 1, at first and at last and every few milliseconds in between, and ends the call by
/// `ControlFlow::Break`. A call that was ended leaves nothing behind: the next one answers as if it had not been.
///
/// What is told is an estimate. Whatever `progress` itself asks of Pasu is not watched; neither is what `call` does on other threads. What is refused is told as far as it came.
///
/// # Errors
/// What `call` refuses; `cancelled` where `progress` ended it.
///
/// ```
/// use std::ops::ControlFlow;
/// use std::time::{Duration, Instant};
///
/// use pasu::{Code, Design, MeasureOptions, Solution};
///
/// let vase = Solution::of(&Design::parse("#1/bloor-wilson?n1=5")?);
/// // No longer than ten seconds.
/// let begin = Instant::now();
/// let patience = move |_done| match begin.elapsed() < Duration::from_secs(10) {
///     true => ControlFlow::Continue(()),
///     false => ControlFlow::Break(()),
/// };
/// let measures = pasu::watched(patience, || vase.measure(&MeasureOptions::default()))?;
/// assert!(measures.whole.height.value > 0.0);
///
/// let ended = pasu::watched(|_done| ControlFlow::Break(()), || vase.measure(&MeasureOptions::default()));
/// assert_eq!(ended.unwrap_err().code(), Code::Cancelled);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn watched<T>(
    progress: impl FnMut(f64) -> ControlFlow<()> + 'static,
    call: impl FnOnce() -> Result<T>,
) -> Result<T> {
    let _outer = Outer::take();
    let stretch = Stretch::new(0.0, 1.0);
    WATCHER.set(Some(Watcher { progress: Box::new(progress), told: 0.0, stretch }));
    STATE.set(State::Watched);
    LEFT.set(BETWEEN);
    tell(|_| 0.0);
    go_on()?;
    let answer = call();
    if answer.is_ok() && STATE.get() == State::Watched {
        tell(|_| 1.0);
    }
    go_on().and(answer)
}

/// The watcher of a call round this one, put back at the end whatever happens.
struct Outer(State, Option<Watcher>, u64);

impl Outer {
    fn take() -> Outer {
        Outer(STATE.replace(State::Alone), WATCHER.take(), ALLOWED.replace(u64::MAX))
    }
}

impl Drop for Outer {
    fn drop(&mut self) {
        STATE.set(self.0);
        WATCHER.set(self.1.take());
        ALLOWED.set(self.2);
    }
}

/// Does what may take so much work, in the units of [`work`], and no more; `None` where it takes more. What else was asked of it, or of those who wait for it, makes no difference: the same work is
/// refused whoever listens, give or take what is between two calls of a watcher.
pub(crate) fn within<T>(units: u64, stretch: impl FnOnce() -> T) -> Option<T> {
    let limit = Limit::set(units);
    let done = stretch();
    let is_through = !is_stopped();
    drop(limit);
    is_through.then_some(done)
}

/// What may be done round a stretch, put back at its end whatever happens, less what was done in it.
struct Limit {
    outer: State,
    allowed: u64,
    given: u64,
}

impl Limit {
    fn set(units: u64) -> Limit {
        let (outer, allowed) = (STATE.get(), ALLOWED.get());
        let given = units.min(allowed);
        ALLOWED.set(given);
        LEFT.set(BETWEEN);
        if outer == State::Alone {
            STATE.set(State::Counted);
        }
        Limit { outer, allowed, given }
    }
}

impl Drop for Limit {
    fn drop(&mut self) {
        let left = ALLOWED.get();
        // A watcher that panics leaves no end of it.
        let done = self.given.saturating_sub(left);
        ALLOWED.set(if self.allowed == u64::MAX { u64::MAX } else { self.allowed.saturating_sub(done) });
        match STATE.get() {
            State::Stopped => {}
            // The limit round this one was met, too.
            State::Spent if ALLOWED.get() == 0 => {}
            _ => STATE.set(self.outer),
        }
    }
}

/// Says that so much was done, in units of about ten nanoseconds, of thirteen in WebAssembly.
#[inline]
pub(crate) fn work(units: u64) {
    if matches!(STATE.get(), State::Watched | State::Counted) {
        match LEFT.get().checked_sub(units) {
            Some(left) => LEFT.set(left),
            None => count(units.saturating_add(BETWEEN - LEFT.get())),
        }
    }
}

/// So much was done since the last time.
#[cold]
#[inline(never)]
fn count(done: u64) {
    LEFT.set(BETWEEN);
    tell(|stretch| {
        stretch.work += done as f64;
        stretch.done()
    });
    let allowed = ALLOWED.get();
    if allowed != u64::MAX {
        ALLOWED.set(allowed.saturating_sub(done));
        if allowed <= done && STATE.get() != State::Stopped {
            STATE.set(State::Spent);
        }
    }
}

/// Says that one place of a surface was computed, which is the sum of so many terms.
#[inline]
pub(crate) fn place(n_terms: usize) {
    work(PLACE + n_terms as u64 / TERMS_OF_PLACE);
}

/// Says that what a row of a surface has in common was computed, of so many terms.
#[inline]
pub(crate) fn row(n_terms: usize) {
    work(ROW + TWO_TERMS_OF_ROW * n_terms as u64 / 2);
}

/// Does part number `index` of `n` of what is at hand, which take about as long.
pub(crate) fn share<T>(index: usize, n: usize, part: impl FnOnce() -> T) -> T {
    between(index as f64 / n as f64, (index + 1) as f64 / n as f64, part)
}

/// Does what takes what is at hand from one place between 0 and 1 to another.
pub(crate) fn between<T>(from: f64, to: f64, part: impl FnOnce() -> T) -> T {
    let enter = |watcher: &mut Watcher| {
        let whole = watcher.stretch;
        let at = |share: f64| whole.from + (whole.to - whole.from) * share;
        watcher.stretch = Stretch::new(at(from), at(to));
        whole
    };
    let whole = WATCHER.with_borrow_mut(|watcher| watcher.as_mut().map(enter));
    let done = part();
    if let Some(whole) = whole {
        WATCHER.with_borrow_mut(|watcher| {
            if let Some(watcher) = watcher {
                watcher.stretch = Stretch { at: watcher.stretch.to, work: 0.0, ..whole };
            }
        });
    }
    done
}

/// Whether what is being done goes nowhere: loops that take long stop as if they were through.
#[inline]
pub(crate) fn is_stopped() -> bool {
    matches!(STATE.get(), State::Stopped | State::Spent)
}

/// Refuses to go on where nobody wants the answer any more, or where it takes more than it may: whoever set that limit says so in other words.
///
/// # Errors
/// `cancelled`; `too-large`.
#[inline]
pub(crate) fn go_on() -> Result<()> {
    if is_stopped() { Err(ended()) } else { Ok(()) }
}

#[cold]
fn ended() -> Error {
    match STATE.get() {
        State::Spent => Error::new(Code::TooLarge, "", "it takes longer than anybody would wait"),
        _ => Error::new(Code::Cancelled, "", "the call was ended by whoever watched it"),
    }
}

/// Tells the watcher how far it is. Meanwhile nobody is watched: it may call Pasu itself.
#[cold]
#[inline(never)]
fn tell(done: impl FnOnce(&mut Stretch) -> f64) {
    let Some(mut watcher) = WATCHER.take() else { return };
    STATE.set(State::Alone);
    let allowed = ALLOWED.replace(u64::MAX);
    watcher.told = watcher.told.max(done(&mut watcher.stretch)).min(1.0);
    let goes_on = (watcher.progress)(watcher.told);
    WATCHER.set(Some(watcher));
    ALLOWED.set(allowed);
    STATE.set(if goes_on.is_break() { State::Stopped } else { State::Watched });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is refused of two stretches, of which one does so many chunks of work, and what was told meanwhile.
    fn refused(limit: u64, chunks: u64) -> bool {
        let stretch = || (0..chunks).take_while(|_| !is_stopped()).for_each(|_| work(BETWEEN));
        within(limit * BETWEEN, stretch).is_none()
    }

    #[test]
    fn what_takes_more_than_it_may_is_refused_whoever_listens() {
        for (limit, chunks, expected) in [(100, 10, false), (100, 49, false), (100, 1000, true), (1, 100, true)] {
            assert_eq!(refused(limit, chunks), expected, "{limit} {chunks}");
            let watched = watched(|_| ControlFlow::Continue(()), || Ok(refused(limit, chunks)));
            assert_eq!(watched.unwrap(), expected, "{limit} {chunks}");
        }
        assert!(STATE.get() == State::Alone && ALLOWED.get() == u64::MAX && go_on().is_ok());
    }

    #[test]
    fn a_stretch_that_is_refused_ends_neither_the_next_nor_the_one_round_it() {
        let round = || {
            let inner = [refused(4, 1000), refused(400, 3)];
            (inner, go_on().is_ok())
        };
        assert_eq!(within(1 << 40, round), Some(([true, false], true)));
        // But what was done in it counts.
        let twice = || [refused(40, 1000), refused(40, 1000)];
        assert_eq!(within(60 * BETWEEN, twice), None);
        assert!(go_on().is_ok());
    }

    #[test]
    fn what_is_ended_within_a_limit_is_cancelled() {
        let ended = watched(
            |done| if done > 0.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) },
            || {
                within(1 << 40, || (0..10).for_each(|_| work(BETWEEN)));
                go_on()
            },
        );
        assert_eq!(ended.unwrap_err().code(), Code::Cancelled);
        let spent = within(BETWEEN, || {
            (0..10).for_each(|_| work(BETWEEN));
            go_on()
        });
        assert!(spent.is_none() && go_on().is_ok());
    }
}
