//! An octant that thins out towards edges and tips, with triangles that single precision can hold.
//!
//! With an exponent below 1 an octant is like a blade along an edge, and with two of them like a needle at a tip: thinner than a number of seven digits for a tenth of its size. Along the axes that is no harm, because zero is held exactly; of one that is turned or moved, rounding would put its
//! curved side beneath its flat ones. So where it is thinner than a least thickness it gets that: a place of the curved side or of an edge keeps this distance from every plane that it is not in. A blade becomes a plate, and a needle a square rod, of which all places between its edges
//! fall on one line. Those of a row, or round a corner of the grid, are one vertex there, and what has no area left is no triangle. Tips stay where they are.
//!
//! The flat sides need no places within: each is a fan of triangles from the origin, and where it is a needle a strip along its axis.

use glam::{DVec2, DVec3};

use crate::patch::{Lines, deviation_of};
use crate::solution::Placed;
use crate::watch;

/// How thick an octant is at least, in units of what rounding moves a point at most: beside an edge the blade is as much thinner as a point of the flat side is nearer to the edge.
const THICK: f64 = 32.0;

/// A triangle whose corners are moved by one unit keeps its side if it is so many times as high.
const HIGH: f64 = 8.0;

/// No more lines are taken away than this: of those between which triangles are too narrow.
const MOST: usize = 256;

/// Of a mesh of more vertices none is: all of it is made again for each line, and nobody waits for that.
const MOST_VERTICES: usize = 1 << 16;

/// What rounding to single precision moves a point of a placed octant at most.
fn rounding(placed: &Placed) -> f64 {
    let corners = (0..8).map(|k| placed.point(DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2))));
    0.5 * f64::from(f32::EPSILON) * libm::sqrt(3.0) * corners.fold(0.0, |most, at| at.abs().max_element().max(most))
}

/// The mesh, by patch, and how far from the octant it is at most.
pub(super) struct Bladed {
    pub(super) positions: Vec<DVec3>,
    /// Of each patch.
    pub(super) triangles: [Vec<[u32; 3]>; 4],
    pub(super) bound: f64,
}

/// An octant on some of the lines of its curved side, so many that no triangle is too narrow; `None` of what is no octant, of one that is as thin all over, and where lines are in the way that cannot be spared.
pub(super) fn bladed(placed: &Placed, lines: &[Lines]) -> Option<Bladed> {
    if !placed.solved().octant()?.has_blades() {
        return None;
    }
    let mut lines = lines.first()?.clone();
    let unit = rounding(placed);
    let m = placed.matrix();
    let lengths = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length);
    let stretch = DVec3::from_array(lengths);
    if lines.n_vertices() > MOST_VERTICES || !(stretch.min_element() > 4.0 * THICK * unit) {
        return None;
    }
    let curved = placed.solved().patch(0);
    let row = |u: &f64| lines.v.iter().map(|v| stretch * curved.position(*u, *v)).collect();
    let mut grid: Vec<Vec<DVec3>> = lines.u.iter().map(row).collect();
    let mut spared: [Vec<f64>; 3] = Default::default();
    for _ in 0..MOST {
        if watch::is_stopped() {
            return None;
        }
        watch::work(2 * lines.n_vertices() as u64);
        let mesh = Weaver::woven(&grid, &spared, stretch, THICK * unit)?;
        let place = |at: &DVec3| placed.point(*at / stretch);
        let positions: Vec<DVec3> = mesh.places.iter().map(place).collect();
        let narrow = mesh.triangles.iter().filter(|triangle| {
            let [a, b, c] = triangle.corners.map(|vertex| positions[vertex as usize]);
            !(height(a, b, c) >= HIGH * unit)
        });
        let narrow: Vec<&Triangle> = narrow.collect();
        if narrow.is_empty() {
            return Some(finished(placed, &lines, lengths, mesh, positions, unit));
        }
        // A place on an axis is of use to one of the two flat sides and may be in the way on the other.
        let of_axes: Vec<(usize, f64)> = narrow.iter().filter_map(|triangle| triangle.on_axis).collect();
        if !of_axes.is_empty() {
            of_axes.into_iter().for_each(|(axis, at)| spared[axis].push(at));
            continue;
        }
        let mut between = [vec![0usize; lines.u.len()], vec![0; lines.v.len()]];
        let all = narrow.iter().flat_map(|triangle| triangle.between);
        all.flatten().for_each(|(direction, k)| between[direction][k] += 1);
        match in_the_way(&lines, &between)? {
            (0, line) => {
                lines.u.remove(line);
                grid.remove(line);
            }
            (_, line) => {
                lines.v.remove(line);
                grid.iter_mut().for_each(|row| {
                    row.remove(line);
                });
            }
        }
    }
    None
}

/// Of the two lines on both sides of the interval between which most triangles are too narrow, that which is nearer to the one beyond; the first and the last stay.
fn in_the_way(lines: &Lines, between: &[Vec<usize>; 2]) -> Option<(usize, usize)> {
    let mut most: Option<(usize, usize, usize)> = None;
    for (direction, (own, counts)) in [&lines.u, &lines.v].into_iter().zip(between).enumerate() {
        let last = own.len() - 1;
        for (k, n) in counts.iter().copied().enumerate().filter(|(k, n)| *n > 0 && *k < last) {
            let gap = |from: usize| own[from + 1] - own[from];
            let inner = |line: usize| 0 < line && line < last;
            let before = inner(k).then(|| (gap(k - 1), k));
            let after = inner(k + 1).then(|| (gap(k + 1), k + 1));
            let nearer = [after, before].into_iter().flatten().min_by(|one, other| one.0.total_cmp(&other.0));
            if let Some((_, line)) = nearer.filter(|_| own.len() > 3 && most.is_none_or(|(most, ..)| n > most)) {
                most = Some((n, direction, line));
            }
        }
    }
    most.map(|(_, direction, line)| (direction, line))
}

fn finished(
    placed: &Placed,
    lines: &Lines,
    stretch: [f64; 3],
    mesh: Weaver,
    positions: Vec<DVec3>,
    unit: f64,
) -> Bladed {
    let is_turned = placed.matrix().determinant() < 0.0;
    let mut triangles: [Vec<[u32; 3]>; 4] = Default::default();
    for Triangle { corners: [a, b, c], patch, .. } in mesh.triangles {
        triangles[patch].push(if is_turned { [a, c, b] } else { [a, b, c] });
    }
    let across = |v: &[f64]| Lines { u: vec![0.0, 1.0], v: v.to_vec() };
    let all = [lines.clone(), across(&lines.u), across(&lines.u), across(&lines.v)];
    let grids = deviation_of(&placed.solved().patches(), &all, stretch);
    // A place is lifted off three planes at most; what falls on a rod was within twice its thickness of the axis both ways, and what slides within a blade stays in that; half a thickness is left to what is so near to its neighbour. Together that is less than six.
    let lift = if mesh.is_lifted { 6.0 * THICK * unit } else { 0.0 };
    Bladed { positions, triangles, bound: grids + lift + 2.0 * unit }
}

/// The least height of a triangle.
fn height(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    (b - a).cross(c - a).length() / libm::sqrt(longest)
}

/// A triangle seen from outside, with the intervals between lines that it is in: the direction, 0 along `u`, and the line before.
struct Triangle {
    corners: [u32; 3],
    patch: usize,
    between: [Option<(usize, usize)>; 2],
    /// A place on an axis that it has a corner in, with the axis.
    on_axis: Option<(usize, f64)>,
}

/// A vertex of an edge, its place along the axis of the tip to which the edge goes and along that of the other, and the line that it is on.
#[derive(Clone, Copy)]
struct OnEdge {
    vertex: u32,
    at: DVec2,
    line: usize,
}

/// A vertex of an axis.
#[derive(Clone, Copy)]
struct OnAxis {
    vertex: u32,
    at: f64,
}

/// An octant as it was before it was turned and moved, scaled to its lengths.
struct Weaver {
    places: Vec<DVec3>,
    triangles: Vec<Triangle>,
    is_lifted: bool,
    least: f64,
}

/// The place of a vertex in the grid: places that fall on one line of a rod are one vertex.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Spot {
    Own(usize, usize),
    /// What is thin all round; the number is 1 plus that of the plane in which an edge is, 0 within.
    Core(usize),
    /// Of the rod along an axis: so far from its tip by lines.
    Rod(usize, usize),
}

impl Weaver {
    /// The mesh on a grid of the curved side; `None` of one of less than three rows or columns.
    fn woven(grid: &[Vec<DVec3>], spared: &[Vec<f64>; 3], stretch: DVec3, least: f64) -> Option<Weaver> {
        let (n, m) = (grid.len() - 1, grid.first()?.len() - 1);
        if n < 2 || m < 2 {
            return None;
        }
        let mut weaver = Weaver { places: Vec::new(), triangles: Vec::new(), is_lifted: false, least };
        let vertices = weaver.vertices(grid, n, m);
        weaver.curved(&vertices, n, m);
        // From the tip of the second axis to that of the first: the edge, and whether a triangle that goes round from the first axis to the second is seen from inside.
        let edges = [
            (1, [1, 2], true, (0..=n).map(|i| (i, 0, i)).collect::<Vec<_>>()),
            (2, [0, 2], false, (0..=n).map(|i| (i, m, i)).collect()),
            (3, [0, 1], true, (0..=m).map(|j| (n, j, j)).collect()),
        ];
        let chains: Vec<Vec<OnEdge>> = edges
            .iter()
            .map(|(_, [to, from], _, all)| {
                let mut chain: Vec<OnEdge> = Vec::new();
                for (i, j, line) in all {
                    let vertex = vertices[*i][*j];
                    let place = weaver.places[vertex as usize];
                    if chain.last().is_none_or(|last| last.vertex != vertex) {
                        chain.push(OnEdge { vertex, at: DVec2::new(place[*to], place[*from]), line: *line });
                    }
                }
                chain
            })
            .collect();
        if chains.iter().any(|chain| chain.len() < 3) {
            return None;
        }
        let origin = weaver.vertex(DVec3::ZERO);
        // Each axis has the places of the strips on both of its sides.
        let axes = [0, 1, 2].map(|axis| {
            let mut places: Vec<f64> = Vec::new();
            for ((_, [to, from], ..), chain) in edges.iter().zip(&chains) {
                let last = chain.len() - 1;
                if *to == axis {
                    places.extend(chain[strips(chain)[1].max(1)..last].iter().map(|own| own.at.x));
                } else if *from == axis {
                    places.extend(chain[1..(strips(chain)[0] + 1).min(last)].iter().map(|own| own.at.y));
                }
            }
            places.sort_by(f64::total_cmp);
            let mut kept: Vec<OnAxis> = vec![OnAxis { vertex: origin, at: 0.0 }];
            for at in places.into_iter().filter(|at| !spared[axis].contains(at)) {
                if at - kept[kept.len() - 1].at >= least && stretch[axis] - at >= least {
                    let mut place = DVec3::ZERO;
                    place[axis] = at;
                    kept.push(OnAxis { vertex: weaver.vertex(place), at });
                }
            }
            kept
        });
        for ((patch, [to, from], is_inward, _), chain) in edges.iter().zip(&chains) {
            let direction = usize::from(*patch == 3);
            let last = chain.len() - 1;
            let [before, after] = strips(chain).map(|k| k.clamp(1, last - 1));
            let mut flat = FlatSide { weaver: &mut weaver, patch: *patch, direction, is_inward: *is_inward };
            flat.strip(*to, &axes[*to], &chain[after..]);
            for k in before..after {
                flat.add([origin, chain[k + 1].vertex, chain[k].vertex], Some(chain[k].line.min(chain[k + 1].line)));
            }
            flat.is_inward = !is_inward;
            let backwards: Vec<OnEdge> = chain[..=before]
                .iter()
                .rev()
                .map(|own| OnEdge { at: DVec2::new(own.at.y, own.at.x), ..*own })
                .collect();
            flat.strip(*from, &axes[*from], &backwards);
        }
        Some(weaver)
    }

    fn vertex(&mut self, place: DVec3) -> u32 {
        self.places.push(place);
        self.places.len() as u32 - 1
    }

    /// The vertex of each place of the grid.
    fn vertices(&mut self, at: &[Vec<DVec3>], n: usize, m: usize) -> Vec<Vec<u32>> {
        let least = self.least;
        // Beyond twice as much a place is as far from the rod as that is thick.
        let thin = |at: DVec3| [0, 1, 2].map(|axis| at[axis] < 2.0 * least);
        let inner = || (1..n).flat_map(|i| (1..m).map(move |j| (i, j)));
        // From where on the lines round a corner of the grid go through what is thin all round.
        let mut cores = [usize::MAX; 2];
        for (i, j) in inner().filter(|(i, j)| thin(at[*i][*j]) == [true; 3]) {
            let round = [(n - i).max(m - j), (n - i).max(j)];
            cores = [0, 1].map(|k| cores[k].min(round[k]));
        }
        let spot = |i: usize, j: usize| {
            let [x, y, z] = thin(at[i][j]);
            let is_inner = 0 < i && i < n && 0 < j && j < m;
            let plane = if i == n { 2 } else { usize::from(j == m) };
            match (i, j) {
                (0, _) => Spot::Own(0, 0),
                (i, j) if i == n && (j == 0 || j == m) => Spot::Own(i, j),
                _ if !is_inner && x && y && z => Spot::Core(1 + plane),
                _ if !is_inner => Spot::Own(i, j),
                _ => match [x, y, z] {
                    [true, true, true] => Spot::Core(0),
                    [true, true, false] => Spot::Rod(2, i),
                    [false, true, true] => {
                        let round = (n - i).max(m - j);
                        if round >= cores[0] { Spot::Core(0) } else { Spot::Rod(0, round) }
                    }
                    [true, false, true] => {
                        let round = (n - i).max(j);
                        if round >= cores[1] { Spot::Core(0) } else { Spot::Rod(1, round) }
                    }
                    _ => Spot::Own(i, j),
                },
            }
        };
        let mut known: std::collections::HashMap<Spot, u32> = std::collections::HashMap::new();
        let mut vertices = vec![vec![0u32; m + 1]; n + 1];
        for (i, row) in at.iter().enumerate() {
            let mut before: Option<(DVec3, u32)> = None;
            for (j, own) in row.iter().enumerate() {
                let is_tip = i == 0 || (i == n && (j == 0 || j == m));
                // In which planes it is.
                let within = [j == 0, j == m, i == n];
                let kept: [f64; 3] = core::array::from_fn(|axis| match within[axis] || is_tip {
                    true => own[axis],
                    false => own[axis].max(least),
                });
                let place = DVec3::from_array(kept);
                self.is_lifted |= place != *own;
                let spot = spot(i, j);
                // Round a needle at the first tip the places of a row are closer and closer.
                let is_own = spot == Spot::Own(i, j) && 0 < i && i < n && 0 < j && j < m;
                let is_near = |last: DVec3| {
                    let step = last.distance(place);
                    // Within a blade it is of no matter where its places are.
                    let is_in_blade = |axis: usize| {
                        [at[i - 1][j], at[i][j - 1], *own, at[i + 1][j]].iter().all(|at| at[axis] < 2.0 * least)
                    };
                    let gap = || own.distance(at[i - 1][j]).min(own.distance(at[i + 1][j]));
                    step < 0.5 * least || ((0..3).any(is_in_blade) && step < 0.125 * gap())
                };
                if let Some((_, vertex)) = before.filter(|(last, _)| is_own && is_near(*last)) {
                    vertices[i][j] = vertex;
                    continue;
                }
                let vertex = *known.entry(spot).or_insert_with(|| {
                    self.places.push(place);
                    self.places.len() as u32 - 1
                });
                before = is_own.then_some((place, vertex));
                // Of all that fall on one place of a rod that which is furthest from its tip.
                let there = &mut self.places[vertex as usize];
                *there = there.min(place);
                vertices[i][j] = vertex;
            }
        }
        vertices
    }

    fn curved(&mut self, vertices: &[Vec<u32>], n: usize, m: usize) {
        for i in 0..n {
            for j in 0..m {
                let [a, b, c, d] = [vertices[i][j], vertices[i + 1][j], vertices[i + 1][j + 1], vertices[i][j + 1]];
                // The diagonals at all four corners of the grid run through these.
                let is_turned = (i + 1 == n && j == 0) || (i == 0 && j + 1 == m);
                let both = if is_turned { [[a, d, b], [b, d, c]] } else { [[a, c, b], [a, d, c]] };
                for corners in both {
                    self.triangles.push(Triangle {
                        corners,
                        patch: 0,
                        between: [Some((0, i)), Some((1, j))],
                        on_axis: None,
                    });
                }
            }
        }
        self.triangles.retain(|Triangle { corners: [a, b, c], .. }| a != b && b != c && c != a);
    }
}

/// Where on an edge the strip along the other axis ends, and where that along its own begins: towards a tip where the edge is flatter than it is steep.
fn strips(chain: &[OnEdge]) -> [usize; 2] {
    let is_flat = |k: &usize| {
        let step = (chain[k + 1].at - chain[*k].at).abs();
        step.y < step.x
    };
    let n = chain.len() - 1;
    let after = n - (0..n).rev().take_while(is_flat).count();
    let before = (0..n).take_while(|k| !is_flat(k)).count();
    [before, after]
}

/// A flat side while it is made.
struct FlatSide<'a> {
    weaver: &'a mut Weaver,
    patch: usize,
    direction: usize,
    is_inward: bool,
}

impl FlatSide<'_> {
    fn add(&mut self, [a, b, c]: [u32; 3], line: Option<usize>) {
        let corners = if self.is_inward { [a, c, b] } else { [a, b, c] };
        let between = [line.map(|line| (self.direction, line)), None];
        self.weaver.triangles.push(Triangle { corners, patch: self.patch, between, on_axis: None });
    }

    /// Between the places of an axis, from the origin on, and those of an edge that goes down to its tip. An edge is seen from all places of the axis that are no further out than it is.
    fn strip(&mut self, number: usize, axis: &[OnAxis], edge: &[OnEdge]) {
        let (mut a, mut e) = (0, 0);
        let tip = edge.len() - 1;
        loop {
            let next = axis.get(a + 1).filter(|next| e + 1 == tip || next.at <= edge[e].at.x);
            if let Some(next) = next {
                self.add([axis[a].vertex, next.vertex, edge[e].vertex], None);
                if let Some(triangle) = self.weaver.triangles.last_mut() {
                    triangle.on_axis = Some((number, next.at));
                }
                a += 1;
            } else if e < tip {
                self.add(
                    [axis[a].vertex, edge[e + 1].vertex, edge[e].vertex],
                    Some(edge[e].line.min(edge[e + 1].line)),
                );
                // The last one is along the axis.
                if let (Some(triangle), true) = (self.weaver.triangles.last_mut(), e + 1 == tip && a > 0) {
                    triangle.on_axis = Some((number, axis[a].at));
                }
                e += 1;
            } else {
                return;
            }
        }
    }
}
