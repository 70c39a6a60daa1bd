//! How a Rust file opens, and what must not appear in it.

use super::code_lines;

/// It names what it forbids.
const THIS_FILE: &str = "crates/xtask/src/tidy/rust.rs";

/// Every breach in one file.
pub(super) fn breaches(file: &str, text: &str) -> Vec<String> {
    let mut breaches = Vec::new();
    if !text.starts_with("//!") {
        breaches.push(format!("{file}:1: a module opens with `//!` and what it is for"));
    }
    let mathematics = file.starts_with("crates/pasu/src/");
    // It compares files of the repository, and is in no package.
    let crate_itself = file.starts_with("crates/pasu/") && file != "crates/pasu/tests/typescript.rs";
    let tests_from = text.lines().position(|line| line == "#[cfg(test)]").unwrap_or(usize::MAX);
    for (number, line) in code_lines(text) {
        if mathematics && number <= tests_from {
            for elementary in
                [".sin()", ".cos()", ".sin_cos()", ".exp()", ".ln()", ".powf(", ".sinh()", ".cosh()", ".tanh()"]
            {
                if line.contains(elementary) {
                    breaches.push(format!(
                        "{file}:{number}: `{elementary}` differs between machines; use libm, which gives the same bits everywhere"
                    ));
                }
            }
        }
        for reading in ["fs::read", "File::open"] {
            if crate_itself && line.contains(reading) {
                breaches.push(format!(
                    "{file}:{number}: `{reading}` finds no file in another place; `include_str!` has what a package lacks noticed when it is compiled"
                ));
            }
        }
        for unfinished in ["todo!(", "unimplemented!(", "dbg!("] {
            if line.contains(unfinished) && file != THIS_FILE {
                breaches.push(format!("{file}:{number}: `{unfinished}..)` is unfinished work"));
            }
        }
    }
    breaches
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_say_what_they_are_for_and_use_the_same_functions_everywhere() {
        assert_eq!(breaches("crates/pasu/src/a.rs", "use b;").len(), 1);
        assert_eq!(breaches("crates/pasu/src/a.rs", "//! A.\nlet y = x.sin();").len(), 1);
        assert!(breaches("crates/pasu/src/a.rs", "//! A.\nlet y = libm::sin(x);").is_empty());
        assert!(breaches("crates/xtask/src/a.rs", "//! A.\nlet y = x.sin();").is_empty());
    }

    #[test]
    fn the_crate_looks_for_no_file() {
        let reading = "//! A.\nlet text = std::fs::read_to_string(path);";
        assert_eq!(breaches("crates/pasu/tests/library/a.rs", reading).len(), 1);
        assert!(breaches("crates/pasu/tests/typescript.rs", reading).is_empty());
        assert!(breaches("crates/xtask/src/a.rs", reading).is_empty());
    }
}
