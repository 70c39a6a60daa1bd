//! The floors of the solver: which room may take something from which, and that nothing goes round in a circle, between files or between folders.

use std::collections::BTreeSet;

use anyhow::Result;

use super::circles::{Graph, circles, shortest};
use super::imports::{Imports, imports};
use super::modules::{Sources, modules};

/// The rooms from the ground up. Each takes from those above it in this list, which are below it in the house, and from no other.
const FLOORS: [&str; 24] = [
    "error",
    "watch",
    "answer",
    "numeric",
    "mode",
    "design",
    "patch",
    "surface",
    "frame",
    "blend",
    "octant",
    "solution",
    "evaluate",
    "mesh",
    "fingerprint",
    "face",
    "solid",
    "check",
    "weave",
    "measure",
    "make",
    "scene",
    "export",
    "lib",
];

/// Rooms that take from these alone, though there are others below them.
const ALONE: [(&str, &[&str]); 1] = [("check", &["mesh", "watch"])];

/// What is known to breach a rule and waits to be mended: which file takes from which. Once it does not any more, or nothing is wrong with it any more, its line is to be deleted.
const KNOWN: &[(&str, &str)] = &[];

/// Every breach in the solver, each with its file and line.
pub(super) fn breaches(sources: &Sources) -> Result<Vec<String>> {
    Ok(judged(&imports(&modules(sources)?), KNOWN))
}

/// Breaches but for those that are known, and what of these is out of date.
fn judged(imports: &Imports, known: &[(&str, &str)]) -> Vec<String> {
    let mut found = Vec::new();
    let all = wrong(imports);
    for (file, from) in known {
        if !imports.get(*file).is_some_and(|taken| taken.contains_key(*from)) {
            found.push(format!(
                "{file} takes nothing from {from} any more: delete that from the known breaches in tidy/floors.rs"
            ));
        } else if !all.contains(&((*file).to_owned(), (*from).to_owned())) {
            found.push(format!("nothing is wrong any more with what {file} takes from {from}: delete that from the known breaches in tidy/floors.rs"));
        }
    }
    let mut rest = imports.clone();
    for (file, from) in known {
        rest.get_mut(*file).and_then(|taken| taken.remove(*from));
    }
    found.extend(unknown_rooms(&rest));
    found.extend(climbs(&rest).into_iter().map(|climb| climb.1));
    let files = file_graph(&rest);
    found.extend(circles(&files).iter().map(|circle| told(&files, circle, "files", &rest)));
    for folder in folders(&rest) {
        let graph = folder_graph(&rest, &folder);
        found.extend(circles(&graph).iter().map(|circle| told(&graph, circle, "folders", &rest)));
    }
    found
}

/// Everything that has a part in some breach: which file takes from which.
fn wrong(imports: &Imports) -> BTreeSet<(String, String)> {
    let mut wrong: BTreeSet<(String, String)> = climbs(imports).into_iter().map(|climb| climb.0).collect();
    let files = circles(&file_graph(imports));
    let folders: Vec<(String, Vec<Vec<String>>)> =
        folders(imports).into_iter().map(|folder| (folder.clone(), circles(&folder_graph(imports, &folder)))).collect();
    for (file, from) in pairs(imports) {
        let is_round = |circle: &Vec<String>| circle.contains(file) && circle.contains(from);
        let is_round_folders = folders.iter().any(|(folder, circles)| {
            let [one, other] = [file, from].map(|file| child_of(folder, file));
            one != other
                && circles.iter().any(|circle| {
                    [one, other].iter().all(|end| end.is_some_and(|end| circle.iter().any(|node| node == end)))
                })
        });
        if files.iter().any(is_round) || is_round_folders {
            wrong.insert((file.clone(), from.clone()));
        }
    }
    wrong
}

fn pairs(imports: &Imports) -> impl Iterator<Item = (&String, &String)> {
    imports.iter().flat_map(|(file, taken)| taken.keys().map(move |from| (file, from)))
}

/// The room that a file is in: its first folder, or itself.
fn room(file: &str) -> &str {
    file.split('/').next().unwrap_or(file).trim_end_matches(".rs")
}

fn floor(room: &str) -> Option<usize> {
    FLOORS.iter().position(|floor| *floor == room)
}

fn unknown_rooms(imports: &Imports) -> Vec<String> {
    let rooms: BTreeSet<&str> = imports.keys().map(|file| room(file)).collect();
    let unknown = rooms.into_iter().filter(|room| floor(room).is_none());
    unknown.map(|room| format!("{room}: a room that is on no floor: give it one in tidy/floors.rs")).collect()
}

/// What is taken from above, or from where it may not be: which file takes from which, and how that is told.
fn climbs(imports: &Imports) -> Vec<((String, String), String)> {
    let mut climbs = Vec::new();
    for (file, taken) in imports {
        for (from, line) in taken {
            let (to, of) = (room(file), room(from));
            // A room without a floor is told of by itself.
            if to == of || floor(to).is_none() || floor(of).is_none() {
                continue;
            }
            let alone = ALONE.iter().find(|(room, _)| *room == to);
            let why = if floor(of) > floor(to) {
                format!("`{to}` is below `{of}`")
            } else if let Some((_, allowed)) = alone.filter(|(_, allowed)| !allowed.contains(&of)) {
                format!("`{to}` takes from `{}` alone", allowed.join("`, `"))
            } else {
                continue;
            };
            climbs.push(((file.clone(), from.clone()), format!("{file}:{line}: takes from {from}, but {why}")));
        }
    }
    climbs
}

fn file_graph(imports: &Imports) -> Graph {
    imports.iter().map(|(file, taken)| (file.clone(), taken.keys().cloned().collect())).collect()
}

/// Every folder with something in it, the root being empty.
fn folders(imports: &Imports) -> BTreeSet<String> {
    let mut folders = BTreeSet::from([String::new()]);
    for file in imports.keys() {
        folders.extend(file.match_indices('/').map(|(end, _)| file[..end].to_owned()));
    }
    folders
}

/// The folders within one folder; at the root, where a file is a room too, files also. What a folder and those within it take from each other is not their concern, but that of the files.
fn folder_graph(imports: &Imports, folder: &str) -> Graph {
    let mut graph = Graph::new();
    for (file, from) in pairs(imports) {
        if let [Some(one), Some(other)] = [file, from].map(|file| child_of(folder, file)) {
            graph.entry(other.to_owned()).or_default();
            let taken = graph.entry(one.to_owned()).or_default();
            if one != other {
                taken.insert(other.to_owned());
            }
        }
    }
    graph
}

/// The folder within a folder that a file is in; at the root, a file is in itself.
fn child_of<'a>(folder: &str, file: &'a str) -> Option<&'a str> {
    if folder.is_empty() {
        return Some(room(file));
    }
    let below = file.strip_prefix(folder)?.strip_prefix('/')?;
    let end = below.find('/')?;
    Some(&file[..folder.len() + 1 + end])
}

/// A circle in words: the shortest way round, where each step is taken, and who else is in it.
fn told(graph: &Graph, circle: &[String], of: &str, imports: &Imports) -> String {
    let way = shortest(graph, circle);
    let start = way.first().cloned().unwrap_or_default();
    let others: Vec<&str> = circle.iter().filter(|node| !way.contains(node)).map(String::as_str).collect();
    let beside = if others.is_empty() { String::new() } else { format!("; as well in it: {}", others.join(", ")) };
    let at = |from: &str, to: &str| {
        let inside = |node: &str, file: &str| {
            file == node || file.strip_suffix(".rs") == Some(node) || file.starts_with(&format!("{node}/"))
        };
        let step = pairs(imports).find(|(file, taken)| inside(from, file) && inside(to, taken));
        step.map_or(String::new(), |(file, taken)| format!("{file}:{} takes from {taken}", imports[file][taken]))
    };
    let steps: Vec<String> = way.windows(2).map(|pair| at(&pair[0], &pair[1])).collect();
    format!("{start}: {} {of} in a circle, {} ({}){beside}", circle.len(), way.join(" -> "), steps.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn imports(edges: &[(&str, &str)]) -> Imports {
        let mut imports = Imports::new();
        for (file, from) in edges {
            imports.entry((*from).to_owned()).or_default();
            imports.entry((*file).to_owned()).or_default().insert((*from).to_owned(), 7);
        }
        imports
    }

    #[test]
    fn a_room_takes_from_below() {
        assert!(judged(&imports(&[("mesh/a.rs", "surface/b.rs"), ("lib.rs", "error.rs")]), &[]).is_empty());
        let found = judged(&imports(&[("mode/a.rs", "design/b.rs")]), &[]);
        assert_eq!(found, ["mode/a.rs:7: takes from design/b.rs, but `mode` is below `design`"]);
    }

    #[test]
    fn some_take_from_one_room_alone() {
        assert!(judged(&imports(&[("check/a.rs", "mesh/b.rs")]), &[]).is_empty());
        let found = judged(&imports(&[("check/a.rs", "design/b.rs")]), &[]);
        assert_eq!(found, ["check/a.rs:7: takes from design/b.rs, but `check` takes from `mesh`, `watch` alone"]);
    }

    #[test]
    fn every_room_has_a_floor() {
        let found = judged(&imports(&[("attic/a.rs", "error.rs")]), &[]);
        assert_eq!(found, ["attic: a room that is on no floor: give it one in tidy/floors.rs"]);
    }

    #[test]
    fn files_go_in_no_circle() {
        let found = judged(&imports(&[("mesh/a.rs", "mesh/b.rs"), ("mesh/b.rs", "mesh/a.rs")]), &[]);
        let way =
            "mesh/a.rs -> mesh/b.rs -> mesh/a.rs (mesh/a.rs:7 takes from mesh/b.rs, mesh/b.rs:7 takes from mesh/a.rs)";
        assert_eq!(found, [format!("mesh/a.rs: 2 files in a circle, {way}")]);
    }

    #[test]
    fn folders_go_in_no_circle() {
        let found = judged(&imports(&[("export/x/a.rs", "export/y/b.rs"), ("export/y/c.rs", "export/x/d.rs")]), &[]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("export/x: 2 folders in a circle, export/x -> export/y -> export/x"), "{found:?}");
        // What is in a folder and what is beside it may need each other.
        assert!(
            judged(&imports(&[("export/x/a.rs", "export/b.rs"), ("export/c.rs", "export/x/a.rs")]), &[]).is_empty()
        );
    }

    #[test]
    fn what_is_known_is_passed_over_until_it_is_mended() {
        let climbing = imports(&[("mode/a.rs", "design/b.rs")]);
        assert!(judged(&climbing, &[("mode/a.rs", "design/b.rs")]).is_empty());
        let mended = imports(&[("mode/a.rs", "error.rs"), ("design/b.rs", "error.rs")]);
        let found = judged(&mended, &[("mode/a.rs", "design/b.rs")]);
        assert!(found.len() == 1 && found[0].contains("takes nothing from design/b.rs any more"), "{found:?}");
        let found = judged(&mended, &[("mode/a.rs", "error.rs")]);
        assert!(found.len() == 1 && found[0].starts_with("nothing is wrong any more"), "{found:?}");
    }

    #[test]
    fn a_circle_is_passed_over_where_it_is_known_to_close() {
        let circle = imports(&[("mesh/a.rs", "mesh/b.rs"), ("mesh/b.rs", "mesh/c.rs"), ("mesh/c.rs", "mesh/a.rs")]);
        assert!(judged(&circle, &[("mesh/c.rs", "mesh/a.rs")]).is_empty());
    }
}
