//! Circles in a graph: what comes back to itself.

use std::collections::{BTreeMap, BTreeSet};

/// A graph: each node with those that it leads to.
pub(super) type Graph = BTreeMap<String, BTreeSet<String>>;

/// The nodes that lead to each other, group by group; a node by itself is none. (Strongly connected components, R. Tarjan, 1972.)
pub(super) fn circles(graph: &Graph) -> Vec<Vec<String>> {
    let mut search = Search { graph, numbers: BTreeMap::new(), stack: Vec::new(), groups: Vec::new() };
    for node in graph.keys() {
        if !search.numbers.contains_key(node.as_str()) {
            search.visit(node);
        }
    }
    let mut groups = search.groups;
    groups.iter_mut().for_each(|group| group.sort());
    groups.sort();
    groups
}

struct Search<'a> {
    graph: &'a Graph,
    /// When each node was met.
    numbers: BTreeMap<&'a str, usize>,
    /// Nodes whose group is not known yet.
    stack: Vec<&'a str>,
    groups: Vec<Vec<String>>,
}

impl<'a> Search<'a> {
    /// The least number that can be reached from a node among those whose group is not known.
    fn visit(&mut self, node: &'a str) -> usize {
        let number = self.numbers.len();
        self.numbers.insert(node, number);
        self.stack.push(node);
        let mut least = number;
        for next in self.graph.get(node).into_iter().flatten().filter(|next| self.graph.contains_key(*next)) {
            match self.numbers.get(next.as_str()) {
                None => least = least.min(self.visit(next)),
                Some(number) if self.stack.contains(&next.as_str()) => least = least.min(*number),
                Some(_) => {}
            }
        }
        if least == number {
            let from = self.stack.iter().position(|other| *other == node).unwrap_or(0);
            let group = self.stack.split_off(from);
            if group.len() > 1 {
                self.groups.push(group.into_iter().map(str::to_owned).collect());
            }
        }
        least
    }
}

/// A shortest way from a node of a circle back to itself, within the circle.
pub(super) fn shortest(graph: &Graph, circle: &[String]) -> Vec<String> {
    let ways = circle.iter().filter_map(|start| way_round(graph, circle, start));
    ways.min_by_key(Vec::len).unwrap_or_default()
}

fn way_round(graph: &Graph, circle: &[String], start: &String) -> Option<Vec<String>> {
    let mut ways = vec![vec![start.clone()]];
    let mut met = BTreeSet::new();
    while !ways.is_empty() {
        let mut longer = Vec::new();
        for way in ways {
            for next in way.last().and_then(|last| graph.get(last)).into_iter().flatten() {
                if next == start {
                    return Some([way, vec![start.clone()]].concat());
                }
                if circle.contains(next) && met.insert(next.clone()) {
                    longer.push([way.as_slice(), std::slice::from_ref(next)].concat());
                }
            }
        }
        ways = longer;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(edges: &[(&str, &str)]) -> Graph {
        let mut graph = Graph::new();
        for (from, to) in edges {
            graph.entry((*to).to_owned()).or_default();
            graph.entry((*from).to_owned()).or_default().insert((*to).to_owned());
        }
        graph
    }

    #[test]
    fn what_leads_to_each_other_is_a_circle() {
        let found =
            circles(&graph(&[("a", "b"), ("b", "c"), ("c", "a"), ("c", "d"), ("d", "e"), ("e", "d"), ("e", "f")]));
        assert_eq!(found, [vec!["a", "b", "c"], vec!["d", "e"]]);
    }

    #[test]
    fn what_comes_together_again_is_none() {
        assert!(circles(&graph(&[("a", "b"), ("a", "c"), ("b", "d"), ("c", "d")])).is_empty());
    }

    #[test]
    fn the_shortest_way_round_is_shown() {
        let graph = graph(&[("a", "b"), ("b", "c"), ("c", "a"), ("c", "d"), ("d", "c")]);
        let all = circles(&graph);
        assert_eq!(all.len(), 1);
        assert_eq!(shortest(&graph, &all[0]), ["c", "d", "c"]);
    }
}
