//! What rain meets: the whole boundary of a body on a grid, and how its points are connected below a level.

use core::f64::consts::TAU;

use glam::DVec3;

use super::column::Inside;

/// Heights that differ by less than this part of the largest coordinate are one, so that what is level has no hollows of rounding.
const STEP: f64 = 1e-12;

/// How far below a drip what it falls on is looked for, as a part of the largest coordinate: a wall without thickness has its other side right there.
const BENEATH: f64 = 1e-9;

/// A triangle is hit if a drip passes its sides by no more than this part of it: none is to fall between two.
const BESIDE: f64 = 1e-9;

/// The points of a closed body at the rows and columns of a grid: rows from the middle of the floor over the rim to the middle of the foot, or once round the wall of a tube. Rows of neighbouring faces that are one curve are one row.
pub(super) struct Ground {
    /// The link and the `s` of each row.
    rows: Vec<(usize, f64)>,
    /// For each link its rows.
    of_link: Vec<Vec<usize>>,
    columns: usize,
    points: Vec<DVec3>,
    keys: Vec<i64>,
    /// 1 where rows times columns points out of the clay, else -1; for each gap between two rows.
    signs: Vec<f64>,
    /// Rows that are a point.
    poles: Vec<bool>,
    /// Whether the last row is the first once more.
    is_ring: bool,
    /// Every vertex in ascending height, and the place of each in that order.
    order: Vec<u32>,
    ranks: Vec<u32>,
    size: f64,
}

/// Water that stays: what is below its spill and gets nowhere without rising above it.
#[derive(Debug, Clone)]
pub(super) struct Basin {
    /// The vertex at which it runs over.
    pub(super) spill: usize,
    /// Its lowest vertex.
    pub(super) lowest: usize,
    /// Every vertex in it.
    pub(super) members: Vec<usize>,
}

/// What a vertex is connected with by hand: a drip and what it falls on, a hollow of the grid alone and where it really runs to.
pub(super) type Shortcut = (usize, usize);

impl Ground {
    /// The faces of a chain that is the whole boundary of a body, seen on the grid by which its columns are searched.
    pub(super) fn new(whole: &Inside) -> Ground {
        let columns = whole.n_columns();
        let mut rows: Vec<(usize, f64)> = Vec::new();
        let mut of_link: Vec<Vec<usize>> = Vec::new();
        let mut signs: Vec<f64> = Vec::new();
        let mut points = Vec::new();
        for (number, link) in whole.links().iter().enumerate() {
            let cells = link.cells();
            let mut walk = link.walk();
            let mut own = Vec::with_capacity(cells + 1);
            for k in 0..=cells {
                if k > 0 || number == 0 {
                    let s = k as f64 / cells as f64;
                    rows.push((number, s));
                    points.extend((0..columns).map(|j| walk.jet(s, turn(j, columns)).position));
                    if k > 0 {
                        signs.push(link.outward());
                    }
                }
                own.push(rows.len() - 1);
            }
            of_link.push(own);
        }
        let size = points.iter().fold(f64::MIN_POSITIVE, |size: f64, p: &DVec3| size.max(p.abs().max_element()));
        let is_pole = |row: usize| {
            let first = points[row * columns];
            points[row * columns..(row + 1) * columns].iter().all(|p| p.distance(first) <= 1e-9 * size)
        };
        let poles: Vec<bool> = (0..rows.len()).map(is_pole).collect();
        let keys: Vec<i64> = points.iter().map(|p| libm::round(p.z / (STEP * size)) as i64).collect();
        let is_ring = whole.is_ring();
        let (order, ranks) = (Vec::new(), Vec::new());
        let mut ground = Ground { rows, of_link, columns, points, keys, signs, poles, is_ring, order, ranks, size };
        ground.sort();
        ground
    }

    fn sort(&mut self) {
        let all = 0..self.points.len();
        let mut order: Vec<u32> =
            all.filter(|&index| self.canonical(index) == index).map(|index| index as u32).collect();
        order.sort_by_key(|&index| (self.keys[index as usize], index));
        self.ranks = vec![u32::MAX; self.points.len()];
        for (rank, &index) in order.iter().enumerate() {
            self.ranks[index as usize] = rank as u32;
        }
        self.order = order;
    }

    /// The largest coordinate.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    pub(super) fn n_rows(&self) -> usize {
        self.rows.len()
    }

    pub(super) fn n_columns(&self) -> usize {
        self.columns
    }

    pub(super) fn n_links(&self) -> usize {
        self.of_link.len()
    }

    /// The rows of a link, from its beginning to its end.
    pub(super) fn rows_of(&self, link: usize) -> &[usize] {
        self.of_link.get(link).map_or(&[], Vec::as_slice)
    }

    /// The link and the `s` of a row.
    pub(super) fn row(&self, row: usize) -> (usize, f64) {
        self.rows[row]
    }

    /// Whether the last row is the first once more.
    pub(super) fn is_ring(&self) -> bool {
        self.is_ring
    }

    /// The row so many further on, or back: once round in a tube. `None` beyond either end of a body that is none.
    pub(super) fn row_beyond(&self, row: usize, by: isize) -> Option<usize> {
        let last = self.rows.len() - 1;
        let beyond = row as isize + by;
        if self.is_ring {
            Some(beyond.rem_euclid(last as isize) as usize)
        } else {
            usize::try_from(beyond).ok().filter(|row| *row <= last)
        }
    }

    /// The vertex at a row and a column.
    pub(super) fn vertex(&self, row: usize, column: usize) -> usize {
        let row = if self.is_ring && row + 1 == self.rows.len() { 0 } else { row };
        row * self.columns + if self.poles[row] { 0 } else { column % self.columns }
    }

    /// Row and column of a vertex.
    pub(super) fn place(&self, vertex: usize) -> (usize, usize) {
        (vertex / self.columns, vertex % self.columns)
    }

    pub(super) fn point(&self, vertex: usize) -> DVec3 {
        self.points[vertex]
    }

    pub(super) fn n_points(&self) -> usize {
        self.points.len()
    }

    fn canonical(&self, index: usize) -> usize {
        let (row, column) = self.place(index);
        self.vertex(row, column)
    }

    /// Whether one vertex comes before another in ascending height.
    pub(super) fn is_below(&self, one: usize, other: usize) -> bool {
        self.ranks[one] < self.ranks[other]
    }

    /// The vertices that have an edge with one.
    pub(super) fn neighbours(&self, vertex: usize) -> Vec<usize> {
        let (row, column) = self.place(vertex);
        let n = self.columns;
        let (before, after) = (self.row_beyond(row, -1), self.row_beyond(row, 1));
        let mut found = Vec::with_capacity(8);
        let mut add = |row: usize, column: usize| found.push(self.vertex(row, column));
        if self.poles[row] {
            for other in [before, after].into_iter().flatten() {
                (0..n).for_each(|column| add(other, column));
            }
        } else {
            add(row, column + 1);
            add(row, column + n - 1);
            if let Some(before) = before {
                add(before, column);
                add(before, column + n - 1);
            }
            if let Some(after) = after {
                add(after, column);
                add(after, column + 1);
            }
        }
        found
    }

    /// The two triangles of the cell beyond a row and a column, each with its normal out of the clay, twice its area long.
    fn triangles(&self, row: usize, column: usize) -> [([usize; 3], DVec3); 2] {
        let [a, b] = [self.vertex(row, column), self.vertex(row + 1, column)];
        let [c, d] = [self.vertex(row + 1, column + 1), self.vertex(row, column + 1)];
        [[a, b, c], [a, c, d]].map(|corners| {
            let [p, q, r] = corners.map(|corner| self.points[corner]);
            (corners, (q - p).cross(r - p) * self.signs[row])
        })
    }

    fn all_triangles(&self) -> impl Iterator<Item = ([usize; 3], DVec3)> + '_ {
        let rows = self.rows.len() - 1;
        (0..rows).flat_map(move |row| (0..self.columns).flat_map(move |column| self.triangles(row, column)))
    }

    /// Whether the clay is right beneath a vertex that has no lower neighbour: by the normal of its triangles, each weighed by its angle there
    /// (J. A. Baerentzen and H. Aanaes, *Signed distance computation using the angle weighted pseudonormal*, 2005).
    fn is_bottom(&self, vertex: usize) -> bool {
        let (row, column) = self.place(vertex);
        let rows = [self.row_beyond(row, -1), (row + 1 < self.rows.len()).then_some(row)];
        let columns = if self.poles[row] {
            (0..self.columns).collect()
        } else {
            vec![column, (column + self.columns - 1) % self.columns]
        };
        let mut up = 0.0;
        for row in rows.into_iter().flatten() {
            for (corners, normal) in columns.iter().flat_map(|&column| self.triangles(row, column)) {
                let Some(at) = corners.iter().position(|&corner| corner == vertex) else { continue };
                let [p, q] = [1, 2].map(|next| self.points[corners[(at + next) % 3]] - self.points[vertex]);
                let (length, sides) = (normal.length(), p.length() * q.length());
                if length > 0.0 && sides > 0.0 {
                    up += libm::atan2(length, p.dot(q)) * normal.z / length;
                }
            }
        }
        up > BESIDE
    }

    /// The vertex that what drips from one runs to: the lowest of the triangle that it falls on. `None` where it falls beside the body.
    fn beneath(&self, vertex: usize) -> Option<usize> {
        let from = self.points[vertex];
        let mut best: Option<(f64, usize)> = None;
        for (corners, normal) in self.all_triangles() {
            let [p, q, r] = corners.map(|corner| self.points[corner]);
            // The first face beneath faces up.
            if !(normal.z > 0.0) || p.z.min(q.z).min(r.z) >= from.z {
                continue;
            }
            let at = from.truncate();
            let [p2, q2, r2] = [p, q, r].map(DVec3::truncate);
            let area = (q2 - p2).perp_dot(r2 - p2).abs();
            let shares = [(r2 - q2).perp_dot(at - q2), (p2 - r2).perp_dot(at - r2), (q2 - p2).perp_dot(at - p2)];
            let sign = if (q2 - p2).perp_dot(r2 - p2) < 0.0 { -1.0 } else { 1.0 };
            let shares = shares.map(|share| sign * share / area);
            if !shares.iter().all(|share| *share >= -BESIDE) {
                continue;
            }
            let z = shares[0] * p.z + shares[1] * q.z + shares[2] * r.z;
            if z < from.z - BENEATH * self.size && best.is_none_or(|best| z > best.0) {
                let lowest = corners.into_iter().min_by_key(|&corner| self.ranks[corner]).unwrap_or(vertex);
                best = Some((z, lowest));
            }
        }
        best.map(|best| best.1)
    }

    /// Every basin, of whatever size.
    ///
    /// Vertices are taken in ascending height, and those that are connected are one class (as in R. Barnes, C. Lehman and D. Mulla, *Priority-flood*, 2014). A class begins where a vertex has no lower neighbour:
    /// on clay it is the bottom of a new hollow, above air it drips, and belongs to what the drip falls on or, if that is nothing, to the outside. Below a level two points of the surface are connected by these edges and drips just as they
    /// are through the air, since the air between has no hills of its own. A class is a basin up to the vertex at which it meets the outside.
    pub(super) fn basins(&self, shortcuts: &[Shortcut], barred: &[usize]) -> Vec<Basin> {
        const NONE: u32 = u32::MAX;
        let n = self.points.len();
        let mut parent: Vec<u32> = (0..n as u32).collect();
        let mut is_outside = vec![false; n];
        // Members of a class in a ring, and its lowest vertex.
        let mut next: Vec<u32> = (0..n as u32).collect();
        let mut lowest: Vec<u32> = (0..n as u32).collect();
        let mut basins = Vec::new();
        let mut is_barred = vec![false; n];
        barred.iter().for_each(|&vertex| is_barred[vertex] = true);
        let order = self.order.iter().copied().filter(|&v| !is_barred[v as usize]);
        let order: Vec<u32> = order.chain(barred.iter().map(|&v| v as u32)).collect();
        let mut is_done = vec![false; n];
        let mut is_first = true;
        for vertex in order {
            let here = vertex as usize;
            let mut classes: Vec<u32> = Vec::with_capacity(4);
            let put = |root: u32, classes: &mut Vec<u32>| {
                if !classes.contains(&root) {
                    classes.push(root);
                }
            };
            for other in self.neighbours(here) {
                if is_done[other] && other != here {
                    put(find(&mut parent, other as u32), &mut classes);
                }
            }
            if classes.is_empty() {
                let by_hand = shortcuts.iter().find(|(from, _)| *from == here).map(|(_, to)| *to);
                if is_first {
                    is_outside[here] = true;
                } else if let Some(to) = by_hand.filter(|&to| is_done[to]) {
                    put(find(&mut parent, to as u32), &mut classes);
                } else if !self.is_bottom(here) {
                    match self.beneath(here).filter(|&to| is_done[to]) {
                        Some(to) => put(find(&mut parent, to as u32), &mut classes),
                        None => is_outside[here] = true,
                    }
                }
                is_first = false;
            }
            is_done[here] = true;
            let outside = classes.iter().any(|&class| is_outside[class as usize]);
            if outside {
                for &class in classes.iter().filter(|&&class| !is_outside[class as usize]) {
                    let mut members = vec![class as usize];
                    let mut at = next[class as usize];
                    while at != class && at != NONE {
                        members.push(at as usize);
                        at = next[at as usize];
                    }
                    basins.push(Basin { spill: here, lowest: lowest[class as usize] as usize, members });
                }
            }
            for class in classes {
                let root = find(&mut parent, vertex);
                let (root, class) = (root as usize, class as usize);
                if root == class {
                    continue;
                }
                parent[root] = class as u32;
                // Two rings become one where each goes on with the other's next.
                next.swap(root, class);
                if self.ranks[lowest[root] as usize] < self.ranks[lowest[class] as usize] {
                    lowest[class] = lowest[root];
                }
                is_outside[class] |= is_outside[root] || outside;
            }
        }
        basins
    }

    /// About how much each of several waters holds: `of` says in which a vertex is, and `levels` how high each stands.
    pub(super) fn volumes(&self, levels: &[f64], of: &[Option<usize>]) -> Vec<f64> {
        let mut volumes = vec![0.0; levels.len()];
        for (corners, normal) in self.all_triangles() {
            for corner in corners {
                if let Some(water) = of[corner] {
                    volumes[water] += (levels[water] - self.points[corner].z).max(0.0) / 6.0 * normal.z;
                }
            }
        }
        volumes
    }

    /// Which vertices are in a basin.
    pub(super) fn members(&self, basin: &Basin) -> Vec<bool> {
        let mut is_member = vec![false; self.points.len()];
        basin.members.iter().for_each(|&member| is_member[member] = true);
        is_member
    }
}

/// `v` of a column.
pub(super) fn turn(column: usize, columns: usize) -> f64 {
    TAU * column as f64 / columns as f64
}

/// The root of a class, with the way to it halved.
fn find(parent: &mut [u32], mut vertex: u32) -> u32 {
    while parent[vertex as usize] != vertex {
        parent[vertex as usize] = parent[parent[vertex as usize] as usize];
        vertex = parent[vertex as usize];
    }
    vertex
}
