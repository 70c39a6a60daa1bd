//! The rooms of the page, from the ground up, and which of its files takes something from which other one.

use std::collections::BTreeMap;

use super::code_lines;
use super::floors::House;
use super::imports::Imports;

const PAGE: House = House {
    rules: "tidy/page.rs",
    floors: &[
        "language", "number", "document", "equation", "state", "words", "worker", "solver", "maker", "work", "render",
        "ui", "element", "app", "sw", "main", "embed",
    ],
    // What draws knows neither documents nor a page, what a page is made of knows no pot but says what it says in the page's words, and what keeps a copy for later
    // knows no page.
    alone: &[("render", &[]), ("ui", &["number", "words"]), ("sw", &[])],
};

/// The files of the page with their text, by their path below its root.
pub(super) type Files = BTreeMap<String, String>;

/// Every breach in the page, each with its file and line.
pub(super) fn breaches(files: &Files) -> Vec<String> {
    PAGE.judged(&imports(files))
}

/// Which file takes something from which other one, types among it, and what is fetched later. A test may look at anything: nothing takes from it.
fn imports(files: &Files) -> Imports {
    let mut imports = Imports::new();
    for (file, text) in files.iter().filter(|(file, _)| !file.ends_with(".test.ts")) {
        let taken = imports.entry(file.clone()).or_default();
        for (line, code) in code_lines(text) {
            for from in specifiers(code).filter_map(|specifier| found(files, file, specifier)) {
                taken.entry(from).or_insert(line);
            }
        }
    }
    imports
}

/// What a line imports from files of our own.
fn specifiers(code: &str) -> impl Iterator<Item = &str> {
    ["from \"", "import \"", "import(\""]
        .into_iter()
        .flat_map(|word| code.split(word).skip(1))
        .filter_map(|after| after.split('"').next())
        .filter(|specifier| specifier.starts_with('.'))
}

/// The file that a relative specifier names.
fn found(files: &Files, importer: &str, specifier: &str) -> Option<String> {
    let mut path: Vec<&str> = importer.split('/').collect();
    path.pop();
    for step in specifier.split('/') {
        match step {
            "." => {}
            ".." => {
                path.pop()?;
            }
            name => path.push(name),
        }
    }
    let path = path.join("/");
    ["", ".ts", "/index.ts"].iter().map(|end| format!("{path}{end}")).find(|file| files.contains_key(file))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(texts: &[(&str, &str)]) -> Files {
        texts.iter().map(|(file, text)| ((*file).to_owned(), (*text).to_owned())).collect()
    }

    #[test]
    fn every_way_to_import_is_seen() {
        let importer = "/** What. */\n\nimport \"./b\";\nimport {\n  c,\n} from \"../state/c\";\nexport type { D } from \"./d.ts\";\nconst later = () => [import(\"./e\"), import(\"./f\")];\n// import \"./g\";\nimport \"lit\";\n";
        let all = ["app/b.ts", "state/c.ts", "app/d.ts", "app/e/index.ts", "app/f.ts", "app/g.ts"];
        let texts: Vec<_> = all.iter().map(|file| (*file, "")).chain([("app/a.ts", importer)]).collect();
        let found = imports(&files(&texts));
        let expected = [("app/b.ts", 3), ("app/d.ts", 7), ("app/e/index.ts", 8), ("app/f.ts", 8), ("state/c.ts", 6)];
        let taken: Vec<_> = found["app/a.ts"].iter().map(|(file, line)| (file.as_str(), *line)).collect();
        assert_eq!(taken, expected);
    }

    #[test]
    fn a_test_looks_at_anything() {
        let texts = [("document/a.test.ts", "import { b } from \"../solver/b\";"), ("solver/b.ts", "")];
        assert!(imports(&files(&texts)).values().all(BTreeMap::is_empty));
    }

    #[test]
    fn a_file_is_a_room_as_a_folder_is() {
        let judged = |texts: &[(&str, &str)]| PAGE.judged(&imports(&files(texts)));
        assert!(judged(&[("number.ts", ""), ("ui/field.ts", "import { n } from \"../number\";")]).is_empty());
        assert_eq!(
            judged(&[("document/types.ts", ""), ("ui/field.ts", "import type { T } from \"../document/types\";")]),
            ["ui/field.ts:1: takes from document/types.ts, but `ui` takes from `number`, `words` alone"]
        );
        assert_eq!(
            judged(&[("app/bar.ts", ""), ("element/stage.ts", "const later = import(\"../app/bar\");")]),
            ["element/stage.ts:1: takes from app/bar.ts, but `element` is below `app`"]
        );
    }

    #[test]
    fn what_a_type_is_taken_from_counts_in_a_circle() {
        let texts = [
            ("work/a.ts", "import type { B } from \"./b\";"),
            ("work/b.ts", "export class B {}\nconst a = () => import(\"./a\");"),
        ];
        let found = PAGE.judged(&imports(&files(&texts)));
        assert!(found.len() == 1 && found[0].starts_with("work/a.ts: 2 files in a circle"), "{found:?}");
    }
}
