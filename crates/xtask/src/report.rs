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
}

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
            Ok(()) => Count { passed: 1, failed: 0 },
            Err(error) => {
                println!("{error:#}");
                Count { passed: 0, failed: 1 }
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
                count
            }
            Err(error) => {
                println!("{error:#}");
                Count { passed: 0, failed: 1 }
            }
        });
    }

    fn time(&mut self, name: &'static str, step: impl FnOnce() -> Count) {
        println!("\n── {name}");
        let start = Instant::now();
        let count = step();
        self.steps.push(Step { name, count, seconds: start.elapsed().as_secs_f64() });
    }

    /// Prints the table and the closing line; any failure is an error.
    pub(crate) fn close(self) -> Result<()> {
        println!("\n── summary");
        for Step { name, count, seconds } in &self.steps {
            let verdict = if count.failed == 0 { "ok    " } else { "FAILED" };
            println!("{verdict} {name:<28} {:>5} passed {:>4} failed {seconds:>7.1} s", count.passed, count.failed);
        }
        let total = self.steps.iter().fold(Count::default(), |sum, step| Count {
            passed: sum.passed + step.count.passed,
            failed: sum.failed + step.count.failed,
        });
        println!("\n{} passed, {} failed", total.passed, total.failed);
        let failed: Vec<&str> = self.steps.iter().filter(|step| step.count.failed > 0).map(|step| step.name).collect();
        if !failed.is_empty() {
            bail!("failed: {}", failed.join(", "));
        }
        Ok(())
    }
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
}
