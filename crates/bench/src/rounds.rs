//! Contenders that take turns, so that whatever else the machine does meets all of them alike.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// A batch of one contender lasts at least so long: much longer than a clock's step.
const BATCH: Duration = Duration::from_millis(10);

/// One contender and what it took.
pub struct Contender<'a> {
    /// What it is called in the table.
    pub name: &'static str,
    /// Does the work so many times.
    pub run: Box<dyn FnMut(usize) + 'a>,
    /// Seconds for doing it once, in every round.
    pub samples: Vec<f64>,
}

impl<'a> Contender<'a> {
    /// A contender that does its work once when called.
    pub fn new<T>(name: &'static str, mut once: impl FnMut() -> T + 'a) -> Self {
        let run = move |times| {
            for _ in 0..times {
                black_box(once());
            }
        };
        Contender { name, run: Box::new(run), samples: Vec::new() }
    }
}

/// Lets all contenders take so many turns, after a turn that does not count.
pub fn take_turns(contenders: &mut [Contender], rounds: usize) {
    let times: Vec<usize> = contenders.iter_mut().map(|contender| times(&mut contender.run)).collect();
    for round in 0..rounds {
        for turn in 0..contenders.len() {
            // Nobody always runs after the same neighbour's leavings in the cache.
            let which = (turn + round) % contenders.len();
            let contender = &mut contenders[which];
            let start = Instant::now();
            (contender.run)(times[which]);
            contender.samples.push(start.elapsed().as_secs_f64() / times[which] as f64);
        }
    }
}

/// How many times make a batch.
fn times(run: &mut dyn FnMut(usize)) -> usize {
    let mut times = 1;
    loop {
        let start = Instant::now();
        run(times);
        let taken = start.elapsed();
        if taken >= BATCH {
            return times;
        }
        times = (times * 2)
            .max((times as f64 * 1.1 * BATCH.as_secs_f64() / taken.as_secs_f64().max(1e-9)) as usize)
            .min(times * 16);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everybody_gets_as_many_turns() {
        let sleep = |micros| move || std::thread::sleep(Duration::from_micros(micros));
        let mut contenders = [Contender::new("short", sleep(300)), Contender::new("long", sleep(3000))];
        take_turns(&mut contenders, 3);
        let [short, long] = contenders.map(|contender| contender.samples);
        assert!(short.len() == 3 && long.len() == 3);
        assert!(short.iter().all(|seconds| *seconds >= 3e-4) && long.iter().all(|seconds| *seconds >= 3e-3));
    }
}
