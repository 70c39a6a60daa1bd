//! The place at which a basin runs over, to rounding.

use super::column::{Inside, LinkWalk};
use super::ground::{Ground, turn};
use crate::numeric::brent;

/// Into how many pieces each gap of the grid round a saddle is cut at a time.
const CUTS: usize = 4;

/// How often: every time what is left of the error falls to a sixteenth.
const ZOOMS: usize = 13;

/// The lowest way over between two sides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Saddle {
    /// The height.
    pub(super) z: f64,
    /// What the last zoom changed of it.
    pub(super) change: f64,
    /// Link, `s` and `v`.
    pub(super) at: ((usize, f64), f64),
}

/// Which side of the saddle a point is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bank {
    Basin,
    Beyond,
    Neither,
}

/// How often the window goes on to where the way falls beyond its edge.
const MOVES: usize = 12;

/// Points of a window.
const WIDTH: usize = 2 * CUTS + 1;

/// On which bank the points of a window are.
type Banks = [[Bank; WIDTH]; WIDTH];

/// Whether a vertex of the grid is on the bank to which the rows before a saddle lead (0), or those after it (1).
type Sides<'a> = dyn Fn(usize, usize) -> bool + 'a;

/// The faces of a body with their rows as one coordinate, in which whole numbers are the rows of the grid.
struct Chain<'a> {
    ground: &'a Ground,
    walks: Vec<LinkWalk<'a>>,
}

impl Chain<'_> {
    /// The link and `s` at a place along all faces; once round in a tube.
    fn place(&self, along: f64) -> (usize, f64) {
        let along = self.once_round(along);
        let after = (libm::ceil(along) as usize).clamp(1, self.ground.n_rows() - 1);
        let (link, end) = self.ground.row(after);
        let start = match self.ground.row(after - 1) {
            (before, s) if before == link => s,
            _ => 0.0,
        };
        (link, start + (end - start) * (along - (after - 1) as f64))
    }

    fn height(&mut self, along: f64, v: f64) -> f64 {
        let (link, s) = self.place(along);
        self.walks[link].jet(s.clamp(0.0, 1.0), v).position.z
    }

    /// The vertex of the grid next to a place whose row is a whole number.
    fn vertex(&self, row: f64, v: f64) -> usize {
        let column = libm::round(v / turn(1, self.ground.n_columns()));
        let column = column.rem_euclid(self.ground.n_columns() as f64);
        self.ground.vertex(self.once_round(row) as usize, column as usize)
    }

    /// The same place of a tube, which goes round, between its first row and its last.
    fn once_round(&self, along: f64) -> f64 {
        if self.ground.is_ring() { along.rem_euclid(self.last()) } else { along }
    }

    /// The place of the last row.
    fn last(&self) -> f64 {
        (self.ground.n_rows() - 1) as f64
    }

    /// Whether there is a place: everywhere in a tube, which goes round.
    fn is_there(&self, along: f64) -> bool {
        self.ground.is_ring() || (0.0..=self.last()).contains(&along)
    }

    /// The highest place of a column next to a row, and its height. What is beyond either bank is no crest of this ridge, however high: of a recess that is partly dry the middle is two rows away.
    fn crest(&mut self, row: f64, v: f64, banks: &Sides) -> (f64, f64) {
        let (mut top, mut z) = (row, self.height(row, v));
        for (way, step) in [-1.0, 1.0].into_iter().enumerate() {
            for by in 0..=BESIDE {
                let next = row + step * f64::from(by);
                if !self.is_there(next) {
                    break;
                }
                let here = self.height(next, v);
                if here > z {
                    (top, z) = (next, here);
                }
                if banks(way, self.vertex(next, v)) {
                    break;
                }
            }
        }
        let mut best = (top, z);
        // Between two rows it is smooth.
        for from in [top - 1.0, top] {
            let to = from + 1.0;
            if !self.is_there(from) || !self.is_there(to) {
                continue;
            }
            let (along, below) = brent::least(from, to, FLAT, |along| -self.height(along, v));
            if -below > best.1 {
                best = (along, -below);
            }
        }
        best
    }
}

/// Rows on either side of a saddle among which the crest of a column is looked for.
const BESIDE: u8 = 3;

/// How closely a crest is found, in rows, and the lowest of crests, in columns: what is left of their height is rounding.
const FLAT: f64 = 1e-9;

/// How often the lowest of crests is looked for further on.
const FURTHER: usize = 12;

/// Refines the saddle at a vertex of the grid, of whose neighbours `bank` says on which side they are.
pub(super) fn saddle(whole: &Inside, ground: &Ground, vertex: usize, bank: impl Fn(usize) -> Bank) -> Saddle {
    let bank = |other: usize| if ground.is_below(other, vertex) { bank(other) } else { Bank::Neither };
    let mut chain = Chain { ground, walks: whole.links().iter().map(|link| link.walk()).collect() };
    let (row, column) = ground.place(vertex);
    // The first points below the saddle on either side of it along its column.
    let side = |mut rows: Box<dyn Iterator<Item = usize>>| {
        let beside = |row: usize| [0, 1, ground.n_columns() - 1].map(|more| bank(ground.vertex(row, column + more)));
        rows.find_map(|row| beside(row).into_iter().find(|bank| *bank != Bank::Neither))
    };
    let rows = ground.n_rows() as isize;
    let sides = [-1, 1].map(|way| side(Box::new((1..rows).map_while(move |by| ground.row_beyond(row, way * by)))));
    match sides {
        [Some(one), Some(other)] if one != other => {
            let banks = [one, other];
            let is_on = |way: usize, other: usize| bank(other) == banks[way];
            lowest_crest(&mut chain, row as f64, turn(column, ground.n_columns()), &is_on)
        }
        _ => narrowed(&mut chain, vertex, bank),
    }
}

/// The lowest crest of neighbouring columns, each of which goes over the ridge between both sides.
fn lowest_crest(chain: &mut Chain, row: f64, start: f64, banks: &Sides) -> Saddle {
    let step = turn(1, chain.ground.n_columns());
    let (mut row, mut v) = (row, start);
    let (along, z) = chain.crest(row, v, banks);
    let mut best = Saddle { z, change: 0.0, at: (chain.place(along), v) };
    for _ in 0..FURTHER {
        let (at, z) = brent::least(v - step, v + step, FLAT * step, |v| chain.crest(row, v, banks).1);
        let (along, _) = chain.crest(row, at, banks);
        let has_moved = (at - v).abs() > 0.9 * step;
        if z < best.z {
            best = Saddle { z, change: 0.0, at: (chain.place(along), at) };
        }
        if !has_moved {
            break;
        }
        (row, v) = (libm::round(along), at);
    }
    best
}

/// The saddle at a vertex, whatever it looks like: in a window that is drawn together round it the lowest way from the one side to the other is found again and again.
fn narrowed(chain: &mut Chain, vertex: usize, bank: impl Fn(usize) -> Bank) -> Saddle {
    let ground = chain.ground;
    let (row, column) = ground.place(vertex);
    let step = turn(1, ground.n_columns());
    let (mut along, mut v, mut half) = (row as f64, turn(column, ground.n_columns()), 1.0);
    let around =
        ground.neighbours(vertex).into_iter().map(|other| (ground.point(other).z - ground.point(vertex).z).abs());
    let change = around.fold(0.0, f64::max);
    let mut best = Saddle { z: ground.point(vertex).z, change, at: (chain.place(along), v) };
    // What is known of the points of the window: at first of the eight vertices round the middle.
    let mut banks: Banks = [[Bank::Neither; WIDTH]; WIDTH];
    for i in 0..3 {
        for j in 0..3 {
            let other = ground
                .row_beyond(row, i as isize - 1)
                .map(|row| ground.vertex(row, column + j + ground.n_columns() - 1));
            if let Some(other) = other {
                banks[CUTS * i][CUTS * j] = bank(other);
            }
        }
    }
    let (mut zooms, mut moves) = (0, 0);
    while zooms < ZOOMS {
        let cut = half / CUTS as f64;
        let at =
            |i: usize, j: usize| (along + (i as f64 - CUTS as f64) * cut, v + (j as f64 - CUTS as f64) * cut * step);
        let mut heights = [[f64::INFINITY; WIDTH]; WIDTH];
        for (i, row) in heights.iter_mut().enumerate() {
            for (j, z) in row.iter_mut().enumerate() {
                let (along, v) = at(i, j);
                if chain.is_there(along) {
                    *z = chain.height(along, v);
                }
            }
        }
        let Some((i, j, found)) = lowest_way(&heights, &banks) else { break };
        let z = heights[i][j];
        let is_inside = |k: usize| 0 < k && k < WIDTH - 1;
        // At the edge of the window the way may go on falling beyond it.
        let is_reached = moves == MOVES || is_inside(i) && is_inside(j);
        let stride = if is_reached { CUTS } else { 1 };
        let old = |k: usize, of: usize| (k / stride + of).checked_sub(CUTS / stride).filter(|old| *old < WIDTH);
        for (k, row) in banks.iter_mut().enumerate() {
            for (l, bank) in row.iter_mut().enumerate() {
                let is_known = k.is_multiple_of(stride) && l.is_multiple_of(stride);
                let place = old(k, i).zip(old(l, j)).filter(|_| is_known);
                *bank = place.map_or(Bank::Neither, |(k, l)| found[k][l]);
            }
        }
        (along, v) = at(i, j);
        best = Saddle { z, change: (z - best.z).abs(), at: (chain.place(along), v) };
        if is_reached {
            half = cut;
            (zooms, moves) = (zooms + 1, 0);
        } else {
            moves += 1;
        }
    }
    best
}

/// The point of a window at which the two banks meet first when points are taken in ascending height, and on which bank the points are that came before.
fn lowest_way(heights: &[[f64; WIDTH]; WIDTH], known: &Banks) -> Option<(usize, usize, Banks)> {
    let mut order: Vec<(usize, usize)> = (0..WIDTH * WIDTH).map(|k| (k / WIDTH, k % WIDTH)).collect();
    order.retain(|&(i, j)| heights[i][j].is_finite());
    order.sort_by(|&(i, j), &(k, l)| heights[i][j].total_cmp(&heights[k][l]).then((i, j).cmp(&(k, l))));
    let mut parent: Vec<usize> = (0..WIDTH * WIDTH).collect();
    let mut banks = [[false; 2]; WIDTH * WIDTH];
    let mut is_done = [false; WIDTH * WIDTH];
    let find = |parent: &[usize], mut at: usize| {
        while parent[at] != at {
            at = parent[at];
        }
        at
    };
    for (i, j) in order {
        let here = i * WIDTH + j;
        let mut joined = match known[i][j] {
            Bank::Basin => [true, false],
            Bank::Beyond => [false, true],
            Bank::Neither => [false; 2],
        };
        let around = neighbours(i, j);
        for &(k, l) in around.iter().filter(|(k, l)| is_done[k * WIDTH + l]) {
            let root = banks[find(&parent, k * WIDTH + l)];
            joined = [joined[0] || root[0], joined[1] || root[1]];
        }
        if joined == [true; 2] {
            let mut found: Banks = [[Bank::Neither; WIDTH]; WIDTH];
            for (k, row) in found.iter_mut().enumerate() {
                for (l, bank) in row.iter_mut().enumerate().filter(|(l, _)| is_done[k * WIDTH + l]) {
                    *bank = match banks[find(&parent, k * WIDTH + l)] {
                        [true, false] => Bank::Basin,
                        [false, true] => Bank::Beyond,
                        _ => Bank::Neither,
                    };
                }
            }
            return Some((i, j, found));
        }
        is_done[here] = true;
        banks[here] = joined;
        for (k, l) in around {
            if is_done[k * WIDTH + l] {
                let (root, other) = (find(&parent, here), find(&parent, k * WIDTH + l));
                parent[other] = root;
                banks[root] = joined;
            }
        }
    }
    None
}

/// The points of a window that have an edge with one, as on the grid.
fn neighbours(i: usize, j: usize) -> Vec<(usize, usize)> {
    let steps: [(isize, isize); 6] = [(0, 1), (0, -1), (-1, 0), (-1, -1), (1, 0), (1, 1)];
    let inside = |x: Option<usize>| x.filter(|x| *x < WIDTH);
    steps
        .into_iter()
        .filter_map(|(a, b)| Some((inside(i.checked_add_signed(a))?, inside(j.checked_add_signed(b))?)))
        .collect()
}
