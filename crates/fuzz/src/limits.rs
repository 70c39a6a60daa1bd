//! How long an input may take, and how much memory.

use std::time::{Duration, Instant};

use allocation_counter::measure;

/// The most time of the processor: several times what the slowest of ordinary pots takes, on a slow machine. Counters at every branch and assertions make three times as much of it.
const LONGEST: Duration = Duration::from_secs(if cfg!(fuzzing) { 60 } else { 20 });

/// The most bytes at a time: twice the arrays of the largest mesh that may be asked for, of 16 million vertices and 32 million triangles.
const MOST: u64 = 2 << 30;

/// Runs what looks at an input, and panics where it took too much.
pub(crate) fn within(look: impl FnOnce() -> bool) -> bool {
    let mut outcome = false;
    let start = Clock::now();
    let taken = measure(|| outcome = look());
    let took = Clock::now().since(start);
    assert!(took <= LONGEST, "took {took:?} of {LONGEST:?}");
    assert!(taken.bytes_max <= MOST, "took {} bytes of {MOST}", taken.bytes_max);
    outcome
}

/// The time that this thread has run, so that other programs on the machine are not counted; where the system does not tell, the time that has passed.
#[derive(Clone, Copy)]
enum Clock {
    Ran(Duration),
    Passed(Instant),
}

impl Clock {
    fn now() -> Clock {
        // Linux: nanoseconds on the processor, nanoseconds waiting for it, slices of time.
        let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
        let ran = told.and_then(|text| text.split_whitespace().next()?.parse().ok());
        ran.map_or_else(|| Clock::Passed(Instant::now()), |nanoseconds| Clock::Ran(Duration::from_nanos(nanoseconds)))
    }

    fn since(self, start: Clock) -> Duration {
        match (start, self) {
            (Clock::Ran(start), Clock::Ran(end)) => end.saturating_sub(start),
            (Clock::Passed(start), Clock::Passed(end)) => end - start,
            _ => Duration::ZERO,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[should_panic(expected = "bytes of")]
    fn too_much_memory_is_noticed() {
        // Asked for and never written to, so that no page of it is ever there.
        within(|| Vec::<u8>::with_capacity(MOST as usize + 1).capacity() > 0);
    }

    #[test]
    fn time_runs() {
        let start = Clock::now();
        while Clock::now().since(start) < Duration::from_millis(20) {
            std::hint::black_box((0..10_000).sum::<u64>());
        }
    }
}
