//! The floors of a house: which room may take something from which, and that nothing goes round in a circle, between files or between folders.

use std::collections::BTreeSet;

use super::circles::{Graph, circles, shortest};
use super::imports::Imports;

/// The rooms of a house and what holds between them.
pub(super) struct House {
    /// The file of these rules, to be named where they are to be changed.
    pub(super) rules: &'static str,
    /// The rooms from the ground up. Each takes from those above it in this list, which are below it in the house, and from no other.
    pub(super) floors: &'static [&'static str],
    /// Rooms that take from these alone, though there are others below them.
    pub(super) alone: &'static [(&'static str, &'static [&'static str])],
}

impl House {
    /// Every breach.
    pub(super) fn judged(&self, imports: &Imports) -> Vec<String> {
        let mut found = self.unknown_rooms(imports);
        found.extend(self.climbs(imports));
        let files = file_graph(imports);
        found.extend(circles(&files).iter().map(|circle| told(&files, circle, "files", imports)));
        for folder in folders(imports) {
            let graph = folder_graph(imports, &folder);
            found.extend(circles(&graph).iter().map(|circle| told(&graph, circle, "folders", imports)));
        }
        found
    }

    fn floor(&self, room: &str) -> Option<usize> {
        self.floors.iter().position(|floor| *floor == room)
    }

    fn unknown_rooms(&self, imports: &Imports) -> Vec<String> {
        let rooms: BTreeSet<&str> = imports.keys().map(|file| room(file)).collect();
        let unknown = rooms.into_iter().filter(|room| self.floor(room).is_none());
        unknown.map(|room| format!("{room}: a room that is on no floor: give it one in {}", self.rules)).collect()
    }

    /// What is taken from above, or from where it may not be.
    fn climbs(&self, imports: &Imports) -> Vec<String> {
        let mut climbs = Vec::new();
        for (file, taken) in imports {
            for (from, line) in taken {
                let (to, of) = (room(file), room(from));
                // A room without a floor is told of by itself.
                let (Some(height), Some(other)) = (self.floor(to), self.floor(of)) else { continue };
                if to == of {
                    continue;
                }
                let alone = self.alone.iter().find(|(room, _)| *room == to);
                let why = if other > height {
                    format!("`{to}` is below `{of}`")
                } else if let Some((_, allowed)) = alone.filter(|(_, allowed)| !allowed.contains(&of)) {
                    match allowed {
                        [] => format!("`{to}` takes from no other room"),
                        some => format!("`{to}` takes from `{}` alone", some.join("`, `")),
                    }
                } else {
                    continue;
                };
                climbs.push(format!("{file}:{line}: takes from {from}, but {why}"));
            }
        }
        climbs
    }
}

fn pairs(imports: &Imports) -> impl Iterator<Item = (&String, &String)> {
    imports.iter().flat_map(|(file, taken)| taken.keys().map(move |from| (file, from)))
}

/// The room that a file is in: its first folder, or itself.
fn room(file: &str) -> &str {
    let first = file.split('/').next().unwrap_or(file);
    first.split_once('.').map_or(first, |(name, _)| name)
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
            file == node || file.strip_prefix(node).is_some_and(|rest| rest.starts_with(['/', '.']))
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

    const HOUSE: House = House {
        rules: "rules.rs",
        floors: &["error", "mesh", "check", "surface", "export", "lib"],
        alone: &[("check", &["mesh"]), ("export", &[])],
    };

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
        assert!(HOUSE.judged(&imports(&[("surface/a.rs", "mesh/b.rs"), ("lib.rs", "error.rs")])).is_empty());
        let found = HOUSE.judged(&imports(&[("mesh/a.ts", "surface/b.ts")]));
        assert_eq!(found, ["mesh/a.ts:7: takes from surface/b.ts, but `mesh` is below `surface`"]);
        let found = HOUSE.judged(&imports(&[("error.ts", "mesh/b.ts")]));
        assert_eq!(found, ["error.ts:7: takes from mesh/b.ts, but `error` is below `mesh`"]);
    }

    #[test]
    fn some_take_from_one_room_alone() {
        assert!(HOUSE.judged(&imports(&[("check/a.rs", "mesh/b.rs")])).is_empty());
        let found = HOUSE.judged(&imports(&[("check/a.rs", "error.rs")]));
        assert_eq!(found, ["check/a.rs:7: takes from error.rs, but `check` takes from `mesh` alone"]);
    }

    #[test]
    fn some_take_from_no_room() {
        assert!(HOUSE.judged(&imports(&[("export/a.rs", "export/b.rs")])).is_empty());
        let found = HOUSE.judged(&imports(&[("export/a.rs", "error.rs")]));
        assert_eq!(found, ["export/a.rs:7: takes from error.rs, but `export` takes from no other room"]);
    }

    #[test]
    fn every_room_has_a_floor() {
        let found = HOUSE.judged(&imports(&[("attic/a.rs", "error.rs")]));
        assert_eq!(found, ["attic: a room that is on no floor: give it one in rules.rs"]);
    }

    #[test]
    fn files_go_in_no_circle() {
        let found = HOUSE.judged(&imports(&[("mesh/a.rs", "mesh/b.rs"), ("mesh/b.rs", "mesh/a.rs")]));
        let way =
            "mesh/a.rs -> mesh/b.rs -> mesh/a.rs (mesh/a.rs:7 takes from mesh/b.rs, mesh/b.rs:7 takes from mesh/a.rs)";
        assert_eq!(found, [format!("mesh/a.rs: 2 files in a circle, {way}")]);
    }

    #[test]
    fn folders_go_in_no_circle() {
        let found = HOUSE.judged(&imports(&[("export/x/a.rs", "export/y/b.rs"), ("export/y/c.rs", "export/x/d.rs")]));
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("export/x: 2 folders in a circle, export/x -> export/y -> export/x"), "{found:?}");
        // What is in a folder and what is beside it may need each other.
        assert!(
            HOUSE.judged(&imports(&[("export/x/a.rs", "export/b.rs"), ("export/c.rs", "export/x/a.rs")])).is_empty()
        );
    }
}
