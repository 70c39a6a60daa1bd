//! The steps of `cargo xtask test`: announced one by one, counted, summed up at the end.

use std::process::Command;
use std::time::Instant;

use anyhow::{Result, bail};

use crate::command;

/// What has been run so far.
#[derive(Default)]
pub(crate) struct Report {
    steps: Vec<Step>,
}

struct Step {
    name: &'static str,
    count: Count,
    seconds: f64,
    /// Its files with their seconds, where it says these.
    files: Vec<(String, f64)>,
}

/// How many steps and files the list of the slowest has. It informs whoever makes them faster; nothing is judged by it.
const SLOWEST: usize = 10;

/// Checks that passed and failed.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) passed: usize,
    pub(crate) failed: usize,
}

/// Reads the counts of a test program out of what it printed.
pub(crate) type Counter = fn(&str) -> Count;

impl Report {
    /// A step that succeeds or fails as one.
    pub(crate) fn check(&mut self, name: &'static str, step: impl FnOnce() -> Result<()>) {
        self.time(name, || match step() {
            Ok(()) => (Count { passed: 1, failed: 0 }, Vec::new()),
            Err(error) => {
                println!("{error:#}");
                (Count { passed: 0, failed: 1 }, Vec::new())
            }
        });
    }

    /// A program that runs many tests. Failing without a failed test (it did not compile, it crashed) counts as one.
    pub(crate) fn tests(&mut self, name: &'static str, counter: Counter, step: impl FnOnce() -> Result<Command>) {
        self.time(name, || match step().and_then(|mut command| command::run_and_read(&mut command)) {
            Ok((success, output)) => {
                let mut count = counter(&output);
                if !success && count.failed == 0 {
                    count.failed = 1;
                }
                if success && count.passed == 0 && count.failed == 0 {
                    println!("no test was run");
                    count.failed = 1;
                }
                (count, vitest_files(&output))
            }
            Err(error) => {
                println!("{error:#}");
                (Count { passed: 0, failed: 1 }, Vec::new())
            }
        });
    }

    fn time(&mut self, name: &'static str, step: impl FnOnce() -> (Count, Vec<(String, f64)>)) {
        println!("\n── {name}");
        let start = Instant::now();
        let (count, files) = step();
        self.steps.push(Step { name, count, seconds: start.elapsed().as_secs_f64(), files });
    }

    fn slowest(&self) -> Vec<(&str, f64)> {
        let steps = self.steps.iter().map(|step| (step.name, step.seconds));
        let files = self.steps.iter().flat_map(|step| &step.files).map(|(name, seconds)| (name.as_str(), *seconds));
        let mut all: Vec<(&str, f64)> = steps.chain(files).collect();
        all.sort_by(|one, other| other.1.total_cmp(&one.1));
        all.truncate(SLOWEST);
        all
    }

    /// Prints the table, what took the most time, and the closing line; any failure is an error.
    pub(crate) fn close(self) -> Result<()> {
        println!("\n── summary");
        for Step { name, count, seconds, .. } in &self.steps {
            let verdict = if count.failed == 0 { "ok    " } else { "FAILED" };
            println!("{verdict} {name:<28} {:>5} passed {:>4} failed {seconds:>7.1} s", count.passed, count.failed);
        }
        println!("\n── the slowest steps, and files of tests");
        for (name, seconds) in self.slowest() {
            println!("{seconds:>7.1} s  {name}");
        }
        let total = self.steps.iter().fold(Count::default(), |sum, step| Count {
            passed: sum.passed + step.count.passed,
            failed: sum.failed + step.count.failed,
        });
        let seconds = self.steps.iter().map(|step| step.seconds).sum();
        println!("\n{} passed, {} failed, in {}", total.passed, total.failed, minutes(seconds));
        let failed: Vec<&str> = self.steps.iter().filter(|step| step.count.failed > 0).map(|step| step.name).collect();
        if !failed.is_empty() {
            bail!("failed: {}", failed.join(", "));
        }
        Ok(())
    }
}

/// `9:07 min`.
fn minutes(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    format!("{}:{:02} min", whole / 60, whole % 60)
}

/// `test result: ok. 12 passed; 0 failed; ..`, once for every test program of cargo.
pub(crate) fn cargo_count(output: &str) -> Count {
    let mut count = Count::default();
    for line in output.lines().filter(|line| line.starts_with("test result:")) {
        count.passed += number_before(line, " passed");
        count.failed += number_before(line, " failed");
    }
    count
}

/// `Tests  1 failed | 11 passed (12)`, and a test file that could not even be loaded: `Test Files  1 failed (1)`.
pub(crate) fn vitest_count(output: &str) -> Count {
    let mut count = Count::default();
    for line in output.lines().map(str::trim_start) {
        if line.starts_with("Tests ") {
            count.passed += number_before(line, " passed");
            count.failed += number_before(line, " failed");
        }
    }
    count
}

/// ` ✓  together  tests/e2e/host.test.ts (4 tests) 23456ms`: files and their seconds, in the order in which they ended.
fn vitest_files(output: &str) -> Vec<(String, f64)> {
    let file_of = |line: &str| {
        let (before, after) = line.split_once(".test.ts (")?;
        let milliseconds: f64 = after.trim_end().strip_suffix("ms")?.rsplit(' ').next()?.parse().ok()?;
        Some((format!("{}.test.ts", before.rsplit(' ').next()?), milliseconds / 1000.0))
    };
    output.lines().filter_map(file_of).collect()
}

/// `# pass 3` and `# fail 0` of Node's own test runner.
pub(crate) fn node_count(output: &str) -> Count {
    let after = |word: &str| {
        output.lines().filter_map(|line| line.strip_prefix(word)).filter_map(|n| n.trim().parse::<usize>().ok()).sum()
    };
    Count { passed: after("# pass "), failed: after("# fail ") }
}

fn number_before(line: &str, word: &str) -> usize {
    line.split(word)
        .next()
        .filter(|before| before.len() < line.len())
        .and_then(|before| before.rsplit(|c: char| !c.is_ascii_digit()).next())
        .and_then(|digits| digits.parse().ok())
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_what_test_programs_print() {
        let cargo = "test a ... ok\ntest result: ok. 12 passed; 0 failed; 1 ignored;\n\
                     test result: FAILED. 3 passed; 2 failed; 0 ignored;";
        assert_eq!(cargo_count(cargo), Count { passed: 15, failed: 2 });
        assert_eq!(vitest_count("      Tests  1 failed | 11 passed (12)\n"), Count { passed: 11, failed: 1 });
        assert_eq!(
            vitest_count(" Test Files  2 passed (2)\n      Tests  7 passed (7)\n"),
            Count { passed: 7, failed: 0 }
        );
        assert_eq!(node_count("# tests 4\n# pass 3\n# fail 1\n"), Count { passed: 3, failed: 1 });
        assert_eq!(vitest_count("nothing of the kind"), Count::default());
    }

    #[test]
    fn files_and_their_times_are_read_from_what_vitest_prints() {
        let output = " ✓  together  ../tests/e2e/host.test.ts (4 tests) 23456ms\n   ✓ the first picture comes soon  812ms\n \
                      ❯ src/a.test.ts (12 tests | 1 failed) 40ms\n      Tests  1 failed | 11 passed (12)\n";
        let expected = [("../tests/e2e/host.test.ts", 23.456), ("src/a.test.ts", 0.04)];
        assert_eq!(vitest_files(output), expected.map(|(name, seconds)| (name.to_owned(), seconds)));
    }

    #[test]
    fn a_time_is_written_in_minutes() {
        assert_eq!([3.4, 59.6, 547.2].map(minutes), ["0:03 min", "1:00 min", "9:07 min"]);
    }

    #[test]
    fn the_slowest_come_first() {
        let mut report = Report::default();
        for (name, seconds) in [("quick", 1.0), ("slow", 30.0)] {
            let files = vec![(format!("a file of {name}"), 0.5 * seconds)];
            report.steps.push(Step { name, count: Count::default(), seconds, files });
        }
        let names: Vec<&str> = report.slowest().into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, ["slow", "a file of slow", "quick", "a file of quick"]);
    }
}
