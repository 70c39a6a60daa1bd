//! Which frames one spline patch lies over.

use std::collections::BTreeMap;

use super::edges::{Edges, Link};

/// Frames in a rectangle, over which one patch can lie, and what its sides are.
#[derive(Debug)]
pub(super) struct Chart {
    /// `cells[i][j]`: along x, then along y.
    pub(super) cells: Vec<Vec<Cell>>,
    /// At x = 0, x = 1, y = 0, y = 1: the number of an arc, and whether the side runs against it.
    pub(super) sides: [Link; 4],
}

/// A frame as it lies in a chart: through which of its sides x and y leave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cell {
    pub(super) patch: usize,
    x: usize,
    y: usize,
}

/// Charts, and the arcs of edges that are between them.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) charts: Vec<Chart>,
    pub(super) arcs: Vec<Vec<Link>>,
}

impl Cell {
    /// Where in the chart's cell a point of the frame is.
    pub(super) fn place(self, [u, v]: [f64; 2]) -> [f64; 2] {
        [self.x, self.y].map(|out| {
            let t = if out < 2 { u } else { v };
            if out % 2 == 1 { t } else { 1.0 - t }
        })
    }

    /// Where in the frame a point of the chart's cell is.
    pub(super) fn point(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let turned = |out: usize, t: f64| if out % 2 == 1 { t } else { 1.0 - t };
        if self.x < 2 { [turned(self.x, x), turned(self.y, y)] } else { [turned(self.y, y), turned(self.x, x)] }
    }

    /// The edges of the cell at x = 0, x = 1, y = 0, y = 1, in the direction of the chart.
    pub(super) fn links(self, edges: &Edges) -> [Link; 4] {
        let link = |side: usize, along: usize| {
            let (edge, is_against) = edges.of_patch[self.patch][side];
            (edge, is_against ^ along.is_multiple_of(2))
        };
        [link(self.x ^ 1, self.y), link(self.x, self.y), link(self.y ^ 1, self.x), link(self.y, self.x)]
    }

    /// The cell beyond a side, by its number in the chart, unless a line is there.
    fn beyond(self, edges: &Edges, is_line: &[bool], side: usize) -> Option<Cell> {
        let out = [self.x ^ 1, self.x, self.y ^ 1, self.y][side];
        let (edge, is_against) = self.links(edges)[side];
        let (patch, entered) = *edges.patches[edge].iter().find(|other| **other != (self.patch, out))?;
        if is_line[edge] {
            return None;
        }
        let on = if side % 2 == 1 { entered ^ 1 } else { entered };
        // What runs along the edge runs on with it.
        let axis = if entered < 2 { 2 } else { 0 };
        let along = axis + usize::from(is_against == edges.of_patch[patch][entered].1);
        Some(if side < 2 { Cell { patch, x: on, y: along } } else { Cell { patch, x: along, y: on } })
    }
}

impl Layout {
    /// A chart for each frame.
    pub(super) fn of_each(edges: &Edges) -> Layout {
        Layout::between(edges, &vec![true; edges.len()]).unwrap_or_else(|edge| unreachable!("a line is at {edge}"))
    }

    /// As few charts as rectangles allow, when lines go on from wherever other than four patches meet, until they end or come to a rim.
    ///
    /// # Panics
    /// When frames between such lines are in no rectangle.
    pub(super) fn of_largest(edges: &Edges) -> Layout {
        let chains = edges.chains();
        let mut is_line = vec![false; edges.len()];
        for chain in &chains {
            let ends = [edges.start(chain.links[0]), edges.end(chain.links[chain.links.len() - 1])];
            if !chain.is_round && ends.iter().any(|end| !edges.is_regular(*end)) {
                chain.links.iter().for_each(|(edge, _)| is_line[*edge] = true);
            }
        }
        loop {
            match Layout::between(edges, &is_line) {
                Ok(layout) => return layout,
                // All round: a seam has to be somewhere.
                Err(edge) => {
                    let chain = chains.iter().find(|chain| chain.links.iter().any(|link| link.0 == edge));
                    chain.into_iter().flat_map(|chain| &chain.links).for_each(|(edge, _)| is_line[*edge] = true);
                }
            }
        }
    }

    /// The charts between lines, or an edge through which one would come back to itself.
    fn between(edges: &Edges, is_line: &[bool]) -> Result<Layout, usize> {
        let mut is_done = vec![false; edges.of_patch.len()];
        let mut layout = Layout { charts: Vec::new(), arcs: Vec::new() };
        let mut known = BTreeMap::new();
        for start in 0..is_done.len() {
            if is_done[start] {
                continue;
            }
            let mut corner = Cell { patch: start, x: 1, y: 3 };
            for side in [0, 2] {
                let first = corner.patch;
                while let Some(next) = corner.beyond(edges, is_line, side) {
                    if next.patch == first {
                        return Err(corner.links(edges)[side].0);
                    }
                    corner = next;
                }
            }
            let row = |from: Cell, side: usize| {
                let mut cells = vec![from];
                while let Some(next) = cells[cells.len() - 1].beyond(edges, is_line, side) {
                    cells.push(next);
                }
                cells
            };
            let cells: Vec<Vec<Cell>> = row(corner, 1).into_iter().map(|from| row(from, 3)).collect();
            for cell in cells.iter().flatten() {
                assert!(!std::mem::replace(&mut is_done[cell.patch], true), "patch {} is in two charts", cell.patch);
            }
            let (last, top) = (&cells[cells.len() - 1], cells[0].len() - 1);
            assert!(
                cells.iter().all(|column| column.len() == top + 1),
                "the chart round patch {start} is no rectangle"
            );
            let runs: [Vec<Link>; 4] = [
                cells[0].iter().map(|cell| cell.links(edges)[0]).collect(),
                last.iter().map(|cell| cell.links(edges)[1]).collect(),
                cells.iter().map(|column| column[0].links(edges)[2]).collect(),
                cells.iter().map(|column| column[top].links(edges)[3]).collect(),
            ];
            let sides = runs.map(|links| {
                let back: Vec<Link> = links.iter().rev().map(|(edge, is_against)| (*edge, !is_against)).collect();
                let is_against = back < links;
                let links = if is_against { back } else { links };
                let arc = *known.entry(links.clone()).or_insert_with(|| {
                    layout.arcs.push(links);
                    layout.arcs.len() - 1
                });
                (arc, is_against)
            });
            layout.charts.push(Chart { cells, sides });
        }
        Ok(layout)
    }
}
