//! The rules of the house that a program can check: who may import what, and what must not appear.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::stamp::sorted_entries;

/// Something that only one folder of the front end may import.
struct OnlyUser {
    package: &'static str,
    folder: &'static str,
}

/// Each heavy or delicate dependency has one door: the solver draws with `pasu/drawing`, the maker has all of `pasu`.
const ONLY_USERS: [OnlyUser; 3] = [
    OnlyUser { package: "three", folder: "web/src/render/" },
    OnlyUser { package: "pasu/drawing", folder: "web/src/solver/" },
    OnlyUser { package: "pasu", folder: "web/src/maker/" },
];

/// Where the types of the package enter the page; what is imported as a type is gone once compiled.
const TYPES_OF_PACKAGE: &str = "web/src/document/types.ts";

/// Folders that are plain data and functions: no page, no components.
const PURE: [&str; 2] = ["web/src/document/", "web/src/state/"];

/// What a pure folder may not name.
const PAGE: [&str; 7] = [
    "document.querySelector",
    "document.createElement",
    "window.",
    "HTMLElement",
    "addEventListener(",
    "customElements",
    "navigator.",
];

/// What no file of the front end may contain, and why.
const FORBIDDEN: [(&str, &str); 8] = [
    ("innerHTML", "text from a document must never become markup"),
    ("outerHTML", "text from a document must never become markup"),
    ("insertAdjacentHTML", "text from a document must never become markup"),
    ("unsafeHTML", "text from a document must never become markup"),
    ("eval(", "the Content-Security-Policy forbids compiling text"),
    ("new Function(", "the Content-Security-Policy forbids compiling text"),
    ("styleMap", "it writes a style attribute, which the Content-Security-Policy forbids; set element.style"),
    (" style=", "the Content-Security-Policy forbids style attributes; use a class or set element.style"),
];

/// Checks the repository and names every breach with its file and line.
pub(crate) fn check(root: &Path) -> Result<()> {
    let mut breaches = Vec::new();
    for file in files_below(&root.join("crates"), "rs")? {
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        breaches.extend(rust_breaches(&relative(root, &file), &text));
    }
    for file in files_below(&root.join("web/src"), "ts")? {
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        breaches.extend(front_end_breaches(&relative(root, &file), &text));
    }
    if breaches.is_empty() {
        return Ok(());
    }
    bail!("{}", breaches.join("\n"))
}

fn rust_breaches(file: &str, text: &str) -> Vec<String> {
    let mut breaches = Vec::new();
    if !text.starts_with("//!") {
        breaches.push(format!("{file}:1: a module opens with `//!` and what it is for"));
    }
    let mathematics = file.starts_with("crates/pasu/src/");
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
        for unfinished in ["todo!(", "unimplemented!(", "dbg!("] {
            if line.contains(unfinished) && !file.ends_with("tidy.rs") {
                breaches.push(format!("{file}:{number}: `{unfinished}..)` is unfinished work"));
            }
        }
    }
    breaches
}

fn front_end_breaches(file: &str, text: &str) -> Vec<String> {
    let mut breaches = Vec::new();
    let test = file.ends_with(".test.ts");
    for (number, line) in code_lines(text) {
        if let Some(package) = imported_package(line) {
            for rule in &ONLY_USERS {
                let types = file == TYPES_OF_PACKAGE && line.starts_with("import type ");
                let allowed = file.starts_with(rule.folder) || package.starts_with("pasu") && (test || types);
                if package == rule.package && !allowed {
                    breaches.push(format!("{file}:{number}: only {} imports `{package}`", rule.folder));
                }
            }
            if package == "lit" && is_pure(file) {
                breaches.push(format!("{file}:{number}: this folder is plain data and functions; no components here"));
            }
        }
        if is_pure(file) && !test {
            for name in PAGE.iter().filter(|name| line.contains(*name)) {
                breaches.push(format!("{file}:{number}: `{name}` does not belong in plain data and functions"));
            }
        }
        for (name, why) in FORBIDDEN.iter().filter(|(name, _)| line.contains(name)) {
            breaches.push(format!("{file}:{number}: `{}`: {why}", name.trim()));
        }
    }
    breaches
}

fn is_pure(file: &str) -> bool {
    PURE.iter().any(|folder| file.starts_with(folder))
}

/// The package of an import: `three` for `from "three/addons/.."`, nothing for a file of our own. `pasu/drawing` counts as one.
fn imported_package(line: &str) -> Option<&str> {
    let after = ["from \"", "import \"", "import(\""].iter().find_map(|word| line.split_once(word))?.1;
    let specifier = after.split('"').next()?;
    if specifier.starts_with('.') || specifier.contains(':') {
        return None;
    }
    if specifier == "pasu/drawing" { Some(specifier) } else { specifier.split('/').next() }
}

/// Lines with their numbers, without those that are only a comment.
fn code_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line))
        .filter(|(_, line)| !["//", "*", "/*"].iter().any(|comment| line.trim_start().starts_with(comment)))
}

fn files_below(folder: &Path, extension: &str) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in sorted_entries(folder)? {
        if entry.is_dir() {
            if !["node_modules", "target", "pkg"].iter().any(|name| entry.ends_with(name)) {
                files.extend(files_below(&entry, extension)?);
            }
        } else if entry.extension().is_some_and(|found| found == extension) {
            files.push(entry);
        }
    }
    Ok(files)
}

/// A path from the root with forward slashes on every system.
fn relative(root: &Path, file: &Path) -> String {
    let path = file.strip_prefix(root).unwrap_or(file);
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_dependency_has_one_door() {
        let import = "import { Mesh } from \"three/webgpu\";";
        assert!(front_end_breaches("web/src/render/stage.ts", import).is_empty());
        assert_eq!(
            front_end_breaches("web/src/app/page.ts", import),
            ["web/src/app/page.ts:1: only web/src/render/ imports `three`"]
        );
        assert_eq!(front_end_breaches("web/src/app/page.ts", "await import(\"pasu\")").len(), 1);
        assert!(front_end_breaches("web/src/solver/worker.ts", "import init from \"pasu/drawing\";").is_empty());
        assert_eq!(front_end_breaches("web/src/solver/worker.ts", "import init from \"pasu\";").len(), 1);
        assert!(front_end_breaches("web/src/maker/worker.ts", "import init from \"pasu\";").is_empty());
        assert!(front_end_breaches(TYPES_OF_PACKAGE, "import type * as pasu from \"pasu\";").is_empty());
        assert_eq!(front_end_breaches(TYPES_OF_PACKAGE, "import init from \"pasu\";").len(), 1);
        assert!(front_end_breaches("web/src/app/page.ts", "import { Stage } from \"../render/stage\";").is_empty());
    }

    #[test]
    fn plain_folders_know_no_page() {
        assert_eq!(front_end_breaches("web/src/state/store.ts", "window.location.hash").len(), 1);
        assert_eq!(front_end_breaches("web/src/document/design.ts", "import { html } from \"lit\";").len(), 1);
        assert!(front_end_breaches("web/src/app/page.ts", "window.location.hash").is_empty());
    }

    #[test]
    fn text_never_becomes_markup_or_code() {
        assert_eq!(front_end_breaches("web/src/app/page.ts", "x.innerHTML = y;").len(), 1);
        assert_eq!(front_end_breaches("web/src/app/page.ts", "html`<p style=\"x\">`").len(), 1);
        assert!(front_end_breaches("web/src/app/page.ts", "// never innerHTML").is_empty());
    }

    #[test]
    fn modules_say_what_they_are_for_and_use_the_same_functions_everywhere() {
        assert_eq!(rust_breaches("crates/pasu/src/a.rs", "use b;").len(), 1);
        assert_eq!(rust_breaches("crates/pasu/src/a.rs", "//! A.\nlet y = x.sin();").len(), 1);
        assert!(rust_breaches("crates/pasu/src/a.rs", "//! A.\nlet y = libm::sin(x);").is_empty());
        assert!(rust_breaches("crates/xtask/src/a.rs", "//! A.\nlet y = x.sin();").is_empty());
    }
}
