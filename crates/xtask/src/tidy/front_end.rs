//! What a file of the front end may import, and what must not appear in it.

use super::code_lines;

/// Something that only these folders of the front end may import.
struct OnlyUsers {
    package: &'static str,
    folders: &'static [&'static str],
}

/// Each heavy or delicate dependency has one door: the solver draws with `pasu/drawing`, the maker has all of `pasu`. Components are made where there is a page.
const ONLY_USERS: [OnlyUsers; 6] = [
    OnlyUsers { package: "twgl.js", folders: &["web/src/render/"] },
    OnlyUsers { package: "gl-matrix", folders: &["web/src/render/"] },
    OnlyUsers { package: "three", folders: &["web/src/app/scanning/"] },
    OnlyUsers { package: "pasu/drawing", folders: &["web/src/solver/"] },
    OnlyUsers { package: "pasu", folders: &["web/src/maker/"] },
    OnlyUsers { package: "lit", folders: &["web/src/ui/", "web/src/element/", "web/src/app/"] },
];

/// Where the types of the package enter the page; what is imported as a type is gone once compiled.
const TYPES_OF_PACKAGE: &str = "web/src/document/types.ts";

/// What is plain data and functions: it knows no page.
const PURE: [&str; 4] = ["web/src/number.ts", "web/src/document/", "web/src/state/", "web/src/words/"];

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

/// Every breach in one file.
pub(super) fn breaches(file: &str, text: &str) -> Vec<String> {
    let mut breaches = Vec::new();
    let test = file.ends_with(".test.ts");
    for (number, line) in code_lines(text) {
        if let Some(package) = imported_package(line) {
            for rule in &ONLY_USERS {
                let types = file == TYPES_OF_PACKAGE && line.starts_with("import type ");
                let inside = rule.folders.iter().any(|folder| file.starts_with(folder));
                let allowed = inside || package.starts_with("pasu") && (test || types);
                if package == rule.package && !allowed {
                    breaches.push(format!("{file}:{number}: only {} imports `{package}`", rule.folders.join(", ")));
                }
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

/// The package of an import: `lit` for `from "lit/decorators.js"`, nothing for a file of our own. `pasu/drawing` counts as one.
fn imported_package(line: &str) -> Option<&str> {
    let after = ["from \"", "import \"", "import(\""].iter().find_map(|word| line.split_once(word))?.1;
    let specifier = after.split('"').next()?;
    if specifier.starts_with('.') || specifier.contains(':') {
        return None;
    }
    if specifier == "pasu/drawing" { Some(specifier) } else { specifier.split('/').next() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_dependency_has_one_door() {
        let import = "import { mat4 } from \"gl-matrix/esm\";";
        assert!(breaches("web/src/render/stage.ts", import).is_empty());
        assert_eq!(
            breaches("web/src/app/page.ts", import),
            ["web/src/app/page.ts:1: only web/src/render/ imports `gl-matrix`"]
        );
        assert_eq!(breaches("web/src/app/page.ts", "await import(\"pasu\")").len(), 1);
        assert!(breaches("web/src/solver/worker.ts", "import init from \"pasu/drawing\";").is_empty());
        assert_eq!(breaches("web/src/solver/worker.ts", "import init from \"pasu\";").len(), 1);
        assert!(breaches("web/src/maker/worker.ts", "import init from \"pasu\";").is_empty());
        assert!(breaches(TYPES_OF_PACKAGE, "import type * as pasu from \"pasu\";").is_empty());
        assert_eq!(breaches(TYPES_OF_PACKAGE, "import init from \"pasu\";").len(), 1);
        assert!(breaches("web/src/app/page.ts", "import { Stage } from \"../render/stage\";").is_empty());
        let components = "import { customElement } from \"lit/decorators.js\";";
        for room in ["ui", "element", "app/panels"] {
            assert!(breaches(&format!("web/src/{room}/a.ts"), components).is_empty());
        }
        assert_eq!(
            breaches("web/src/work/a.ts", components),
            ["web/src/work/a.ts:1: only web/src/ui/, web/src/element/, web/src/app/ imports `lit`"]
        );
    }

    #[test]
    fn plain_folders_know_no_page() {
        assert_eq!(breaches("web/src/state/store.ts", "window.location.hash").len(), 1);
        assert_eq!(breaches("web/src/number.ts", "window.location.hash").len(), 1);
        assert!(breaches("web/src/app/page.ts", "window.location.hash").is_empty());
    }

    #[test]
    fn text_never_becomes_markup_or_code() {
        assert_eq!(breaches("web/src/app/page.ts", "x.innerHTML = y;").len(), 1);
        assert_eq!(breaches("web/src/app/page.ts", "html`<p style=\"x\">`").len(), 1);
        assert!(breaches("web/src/app/page.ts", "// never innerHTML").is_empty());
    }
}
