//! How far a call is, told to whoever waits for it and may end it.
//!
//! The watcher belongs to the thread, not to a design: what takes long says here that it has done so much [`work`], and knows nothing of who listens. A call that is to end is not
//! torn out of its loops. Those that take long stop early, as if what they have were enough, and what they return goes nowhere: [`go_on`] refuses what would be made of it, and
//! [`watched`] whatever is left.

use core::cell::{Cell, RefCell};
use core::ops::ControlFlow;

use crate::error::{Code, Error, Result};

/// The work between two calls of a watcher: about a millisecond.
const BETWEEN: u64 = 1 << 17;

/// What a place of a surface counts for, in units of [`work`].
const PLACE: u64 = 16;

/// The work after which a stretch whose length nobody knows is taken to be half done: about a tenth of a second.
const HALF: f64 = 1e7;

thread_local! {
    static STATE: Cell<State> = const { Cell::new(State::Alone) };
    /// What is left of [`BETWEEN`].
    static LEFT: Cell<u64> = const { Cell::new(BETWEEN) };
    static WATCHER: RefCell<Option<Watcher>> = const { RefCell::new(None) };
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    /// Nobody listens.
    Alone,
    Watched,
    /// Whoever listened wants no more of it.
    Stopped,
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
struct Outer(State, Option<Watcher>);

impl Outer {
    fn take() -> Outer {
        Outer(STATE.replace(State::Alone), WATCHER.take())
    }
}

impl Drop for Outer {
    fn drop(&mut self) {
        STATE.set(self.0);
        WATCHER.set(self.1.take());
    }
}

/// Says that so much was done, in units of about ten nanoseconds.
#[inline]
pub(crate) fn work(units: u64) {
    if STATE.get() == State::Watched {
        match LEFT.get().checked_sub(units) {
            Some(left) => LEFT.set(left),
            None => {
                let done = BETWEEN + units;
                LEFT.set(BETWEEN);
                tell(|stretch| {
                    stretch.work += done as f64;
                    stretch.done()
                });
            }
        }
    }
}

/// Says that one place of a surface was computed.
#[inline]
pub(crate) fn place() {
    work(PLACE);
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
    STATE.get() == State::Stopped
}

/// Refuses to go on where nobody wants the answer any more.
///
/// # Errors
/// `cancelled`.
#[inline]
pub(crate) fn go_on() -> Result<()> {
    if is_stopped() { Err(cancelled()) } else { Ok(()) }
}

#[cold]
fn cancelled() -> Error {
    Error::new(Code::Cancelled, "", "the call was ended by whoever watched it")
}

/// Tells the watcher how far it is. Meanwhile nobody is watched: it may call Pasu itself.
#[cold]
#[inline(never)]
fn tell(done: impl FnOnce(&mut Stretch) -> f64) {
    let Some(mut watcher) = WATCHER.take() else { return };
    STATE.set(State::Alone);
    watcher.told = watcher.told.max(done(&mut watcher.stretch)).min(1.0);
    let goes_on = (watcher.progress)(watcher.told);
    WATCHER.set(Some(watcher));
    STATE.set(if goes_on.is_break() { State::Stopped } else { State::Watched });
}
