//! Which file of a crate takes something from which other one.

use std::collections::BTreeMap;

use super::modules::{Module, Use};

/// For each file those that it takes something from, with the first line that does so.
pub(super) type Imports = BTreeMap<String, BTreeMap<String, usize>>;

/// Names may stand for names so many times before it is taken for a circle.
const MOST_STEPS: usize = 32;

/// Where a path leads.
#[derive(Debug, PartialEq)]
enum Found {
    /// To something that this module defines.
    Item(usize),
    /// To this module itself.
    Module(usize),
}

/// The files and what they take from each other. A name that is handed on counts for the file that defines it: a `mod.rs` or `lib.rs` that only declares and hands on takes nothing and gives nothing.
///
/// Methods are not seen, nor what a macro makes: who calls a method has named its type, or had it from someone who has.
pub(super) fn imports(modules: &[Module]) -> Imports {
    let mut imports = Imports::new();
    for (at, module) in modules.iter().enumerate().filter(|(_, module)| module.has_code) {
        imports.entry(module.file.clone()).or_default();
        let mut take = |path: &[String], line: usize| {
            if let Some(from) = giver(modules, at, path)
                && from != module.file
            {
                let lines = imports.entry(module.file.clone()).or_default();
                let first = lines.entry(from.to_owned()).or_insert(line);
                *first = line.min(*first);
            }
        };
        for Use { name, path, line, is_public } in &module.uses {
            // What is only handed on is not taken.
            if !is_public || module.words.contains(name) {
                take(path, *line);
            }
        }
        for mention in module.mentions.iter().chain(&module.globs) {
            take(&mention.path, mention.line);
        }
    }
    imports
}

/// The file that gives what a path names; of a path whose end is made by a macro, that of the module in which it should be.
fn giver<'a>(modules: &'a [Module], at: usize, path: &[String]) -> Option<&'a str> {
    (1..=path.len())
        .rev()
        .find_map(|length| match lookup(modules, at, &path[..length], 0)? {
            Found::Item(module) => Some(module),
            Found::Module(module) => modules[module].has_code.then_some(module),
        })
        .map(|module| modules[module].file.as_str())
}

/// Where a path leads from within a module.
fn lookup(modules: &[Module], at: usize, path: &[String], steps: usize) -> Option<Found> {
    match path.first()?.as_str() {
        "crate" => walk(modules, 0, &path[1..], steps),
        _ => walk(modules, at, path, steps),
    }
}

/// Where a path leads that begins with something in a module.
fn walk(modules: &[Module], at: usize, path: &[String], steps: usize) -> Option<Found> {
    let Some((first, rest)) = path.split_first() else { return Some(Found::Module(at)) };
    let module = &modules[at];
    if steps > MOST_STEPS {
        return None;
    }
    match first.as_str() {
        "self" => return walk(modules, at, rest, steps + 1),
        "super" => return walk(modules, module.parent?, rest, steps + 1),
        _ => {}
    }
    if let Some(child) = module.children.get(first) {
        return walk(modules, *child, rest, steps + 1);
    }
    if module.items.contains(first) {
        return Some(Found::Item(at));
    }
    let named = module.uses.iter().filter(|found| found.name == *first);
    let found = named.filter_map(|found| lookup(modules, at, &[&found.path, rest].concat(), steps + 1)).next();
    found.or_else(|| {
        module.globs.iter().find_map(|glob| match lookup(modules, at, &glob.path, steps + 1)? {
            Found::Module(all) if all != at => walk(modules, all, path, steps + 1),
            _ => None,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::super::modules::{Sources, modules};
    use super::*;

    fn found(sources: &[(&str, &str)]) -> Vec<String> {
        let imports = imports(&modules(&Sources::of(sources)).unwrap());
        imports
            .iter()
            .flat_map(|(file, taken)| taken.iter().map(move |(from, line)| format!("{file}:{line} {from}")))
            .collect()
    }

    #[test]
    fn a_name_that_is_handed_on_counts_for_who_defines_it() {
        let sources = [
            ("lib.rs", "mod a; mod b; pub use a::Thing;"),
            ("a/mod.rs", "mod thing; pub(crate) use thing::Thing;"),
            ("a/thing.rs", "pub(crate) struct Thing;"),
            ("b.rs", "\nuse crate::a::Thing;\nfn f(_: Thing) {}"),
        ];
        assert_eq!(found(&sources), ["b.rs:2 a/thing.rs"]);
        let sources = [sources[0], sources[1], sources[2], ("b.rs", "fn f(_: crate::Thing) {}")];
        assert_eq!(found(&sources), ["b.rs:1 a/thing.rs"]);
    }

    #[test]
    fn modules_and_what_is_in_them() {
        let sources = [
            ("lib.rs", "mod a; mod b;"),
            ("a/mod.rs", "pub(crate) mod deep; mod beside;"),
            ("a/deep.rs", "pub(crate) fn f() {} pub(crate) enum E { One }"),
            ("a/beside.rs", "fn g() { super::deep::f() }"),
            ("b.rs", "use crate::a;\nfn h() { a::deep::E::One; libm::sin(1.0); }"),
        ];
        assert_eq!(found(&sources), ["a/beside.rs:1 a/deep.rs", "b.rs:2 a/deep.rs"]);
    }

    #[test]
    fn a_folder_with_code_of_its_own_takes_what_it_uses() {
        let sources = [
            ("lib.rs", "mod a;"),
            ("a/mod.rs", "mod used; mod handed;\npub use handed::H;\npub use used::U;\npub fn f(u: U) {}"),
            ("a/used.rs", "pub struct U;"),
            ("a/handed.rs", "use super::f; pub struct H;"),
        ];
        assert_eq!(found(&sources), ["a/handed.rs:1 a/mod.rs", "a/mod.rs:3 a/used.rs"]);
    }

    #[test]
    fn all_names_of_a_module() {
        let sources = [
            ("lib.rs", "mod a; mod b;"),
            ("a/mod.rs", "mod x; pub(crate) use x::*;"),
            ("a/x.rs", "pub(crate) struct X;"),
            ("b.rs", "use crate::a::*; fn f(_: crate::a::X) {}"),
        ];
        assert_eq!(found(&sources), ["b.rs:1 a/x.rs"]);
    }

    #[test]
    fn names_of_each_other_come_to_an_end() {
        let sources = [
            ("lib.rs", "mod a; mod b;"),
            ("a.rs", "pub use crate::b::X; fn f(_: X) {}"),
            ("b.rs", "pub use crate::a::X;"),
        ];
        assert!(found(&sources).is_empty());
    }
}
