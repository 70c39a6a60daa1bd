//! Pairs of triangles that cross, touch or overlap where they should not, decided exactly.
//!
//! Candidates come from a [tree of boxes](super::boxes). Two triangles without a common vertex must be apart; with a common vertex they may share that point, with a common edge that edge, and nothing
//! else. All of this is decided by the signs of volumes and areas without rounding error (J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast
//! robust geometric predicates*, 1997), on the single precision coordinates as they are.

use core::ops::ControlFlow;

use robust::{Coord, Coord3D, orient2d, orient3d};

use super::boxes::{Bounded, Boxes};
use super::plane::Plane;
use crate::watch;

type Point = [f32; 3];

/// How many triangles may be beside one, in the mean; of a pot that can be made there are some twelve.
const MOST_NEIGHBOURS: usize = 24;

/// So many pairs are looked at of any mesh.
const FEW_PAIRS: usize = 1 << 20;

/// The numbers of the triangles of some pair that crosses. Triangles of one group that has a number are known not to cross each other.
///
/// Of two bodies with a face in common every triangle there touches others, and to tell so exactly takes long: one pair is enough to know.
pub(crate) fn a_crossing(
    positions: &[Point],
    triangles: &[[u32; 3]],
    group: impl Fn(u32) -> Option<u32>,
) -> Option<[u32; 2]> {
    let limits = Limits { most: 1, enough: 1, most_pairs: usize::MAX };
    search(positions, triangles, group, limits).0.first().copied()
}

/// The numbers of the triangles of each pair that crosses, at most so many pairs, the lowest first; of a mesh in which tens of thousands cross, and some hundreds where one is asked for, the lowest of those that are found first. Triangles are grouped as for [`a_crossing`].
///
/// And the triangle at which the search was given up, if it was: in a mesh whose triangles lie so close together that each is beside many others it would take all day.
pub(crate) fn crossings_soon(
    positions: &[Point],
    triangles: &[[u32; 3]],
    group: impl Fn(u32) -> Option<u32>,
    most: usize,
) -> (Vec<[u32; 2]>, Option<u32>) {
    let most_pairs = FEW_PAIRS.saturating_add(MOST_NEIGHBOURS.saturating_mul(triangles.len()));
    let enough = if most == 1 { FEW_FOUND } else { MOST_FOUND };
    search(positions, triangles, group, Limits { most, enough, most_pairs })
}

/// A triangle that is held against others.
pub(crate) struct Against<'a> {
    positions: &'a [Point],
    triangle: [u32; 3],
    at: [Point; 3],
    plane: Plane,
    bounded: Bounded,
}

impl<'a> Against<'a> {
    pub(crate) fn of(positions: &'a [Point], triangle: [u32; 3]) -> Self {
        let at = triangle.map(|vertex| positions[vertex as usize]);
        Against { positions, triangle, at, plane: Plane::of(&at), bounded: Bounded::of(0, None, at) }
    }

    /// Whether another has more in common with it than vertices and edges that they share.
    pub(crate) fn crosses(&self, other: [u32; 3]) -> bool {
        let at = other.map(|vertex| self.positions[vertex as usize]);
        if !Bounded::of(1, None, at).touches(&self.bounded) {
            return false;
        }
        let face = Face { at: self.at, plane: &self.plane };
        // Most lie on one side.
        let [a, b, c] = at.map(|corner| face.volume(corner));
        if a > 0.0 && b > 0.0 && c > 0.0 || a < 0.0 && b < 0.0 && c < 0.0 {
            return false;
        }
        cross(&self.triangle, &other, &face, &Face { at, plane: &Plane::of(&at) })
    }
}

/// How many crossings are told, with how many found the search ends, and how many pairs are looked at.
struct Limits {
    most: usize,
    enough: usize,
    most_pairs: usize,
}

/// Nobody wants to know more of them.
const MOST_FOUND: usize = 1 << 16;

/// Whoever wants to know of one has it from so many: where two sides of a body lie in one another each pair is decided in many digits, and tens of thousands take ten seconds.
const FEW_FOUND: usize = 1 << 8;

/// Every so many triangles one is asked beforehand how many there are beside it: a prime, so that columns of a grid are met alike.
const SAMPLED: usize = 61;

/// Of a mesh of fewer triangles nobody asks beforehand.
const FEW_TRIANGLES: usize = 1 << 13;

fn search(
    positions: &[Point],
    triangles: &[[u32; 3]],
    group: impl Fn(u32) -> Option<u32>,
    Limits { most, enough, most_pairs }: Limits,
) -> (Vec<[u32; 2]>, Option<u32>) {
    let corners = |[a, b, c]: &[u32; 3]| [positions[*a as usize], positions[*b as usize], positions[*c as usize]];
    let bounded =
        triangles.iter().zip(0..).map(|(triangle, number)| Bounded::of(number, group(number), corners(triangle)));
    let bounded: Vec<Bounded> = bounded.collect();
    let planes: Vec<Plane> = triangles.iter().map(|triangle| Plane::of(&corners(triangle))).collect();
    let boxes = Boxes::new(bounded.clone());
    let does_cross = |p: u32, q: u32| {
        let [one, other] = [p, q].map(|number| &triangles[number as usize]);
        let face = |number: u32, triangle| Face { at: corners(triangle), plane: &planes[number as usize] };
        cross(one, other, &face(p, one), &face(q, other))
    };
    let mut found = Vec::new();
    let mut given_up = None;
    if most_pairs < usize::MAX && triangles.len() >= FEW_TRIANGLES {
        given_up = crowded(&bounded, &boxes, most_pairs);
    }
    let most_pairs = if given_up.is_some() { most_pairs / SAMPLED } else { most_pairs };
    let mut left = most_pairs;
    boxes.pairs(|p, q| {
        if does_cross(p, q) {
            found.push([p, q]);
        }
        let rest = left.checked_sub(1);
        left = rest.unwrap_or(0);
        if rest.is_none() || found.len() >= enough {
            given_up = given_up.or(rest.is_none().then_some(p));
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    found.sort_unstable();
    found.truncate(most);
    (found, given_up)
}

/// The triangle beside which there are most of every [`SAMPLED`]th, if there are more pairs than so many of a mesh: these few tell that in a small part of the time that it takes to look at all.
fn crowded(bounded: &[Bounded], boxes: &Boxes, most_pairs: usize) -> Option<u32> {
    let (mut n_beside, mut most) = (0, (0, 0));
    for one in bounded.iter().step_by(SAMPLED).take_while(|_| !watch::is_stopped()) {
        let beside = boxes.n_beside(one);
        n_beside += beside;
        most = most.max((beside, one.number));
    }
    // Every pair is seen from both of its triangles.
    (n_beside / 2 * SAMPLED > most_pairs).then_some(most.1)
}

/// The corners of a triangle, and its plane.
struct Face<'a> {
    at: [Point; 3],
    plane: &'a Plane,
}

impl Face<'_> {
    /// The sign of the volume of the triangle and a point, which is exact.
    fn volume(&self, point: Point) -> f64 {
        let [a, b, c] = self.at;
        self.plane.volume(a, point).unwrap_or_else(|| volume(a, b, c, point))
    }

    fn is_beside(&self, segment: [Point; 2]) -> bool {
        let [from, to] = segment.map(|point| self.volume(point));
        (from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)
    }

    /// Whether all of some points are on one side of it; no, where only exact arithmetic tells.
    fn is_plainly_beside(&self, points: &[Point]) -> bool {
        let side = |point: &Point| self.plane.volume(self.at[0], *point).unwrap_or_default();
        points.iter().all(|point| side(point) > 0.0) || points.iter().all(|point| side(point) < 0.0)
    }
}

/// Whether two triangles have more in common than vertices and edges that they share.
fn cross(p: &[u32; 3], q: &[u32; 3], of_p: &Face, of_q: &Face) -> bool {
    let mut shared = [(0, 0); 3];
    let mut n_shared = 0;
    for (i, vertex) in p.iter().enumerate() {
        if let Some(j) = q.iter().position(|other| other == vertex) {
            shared[n_shared] = (i, j);
            n_shared += 1;
        }
    }
    let (at_p, at_q) = (&of_p.at, &of_q.at);
    match shared[..n_shared] {
        [] => are_touching(of_p, of_q),
        [(i, j)] => {
            let far = |at: &[Point; 3], k: usize| [at[(k + 1) % 3], at[(k + 2) % 3]];
            let (far_p, far_q) = (far(at_p, i), far(at_q, j));
            if of_q.is_plainly_beside(&far_p) || of_p.is_plainly_beside(&far_q) {
                return false;
            }
            let axes = of_p.plane.axes();
            let is_parted = |[one, other]: [Point; 2], beyond: [Point; 2]| {
                let vertex = at_p[i];
                parts([vertex, one], other, &beyond, axes) || parts([vertex, other], one, &beyond, axes)
            };
            if is_parted(far_p, far_q) || is_parted(far_q, far_p) {
                return false;
            }
            // What they have in common begins at the vertex, is convex, and so reaches the far edge of one of them if it is more.
            !of_q.is_beside(far_p) && !of_p.is_beside(far_q) && (meets(far_p, of_q) || meets(far_q, of_p))
        }
        [(i, j), (k, l)] => {
            // Folded onto each other: in one plane, with both far corners on the same side of the edge.
            let (edge, apex, other) = ([at_p[i], at_p[k]], at_p[3 - i - k], at_q[3 - j - l]);
            if of_p.volume(other) != 0.0 {
                return false;
            }
            let axes = plane(&[edge[0], edge[1], apex]);
            let side = |corner| area(edge[0], edge[1], corner, axes);
            side(apex) * side(other) >= 0.0
        }
        _ => true,
    }
}

/// Whether the line through two corners of a triangle, seen along an axis, has the third on it or on one side, and all of some other points on the other side and none on it.
///
/// A triangle with these corners is apart from that one; with these and one on the line it shares that one point with it, if it is one of the two. What lies side by side in one plane is told so without asking for the plane, which takes
/// exact arithmetic: the flat sides of a body are fans of hundreds of triangles, each in the box of many others.
fn parts([from, to]: [Point; 2], own: Point, others: &[Point], axes: (usize, usize)) -> bool {
    let side = |point: &Point| area(from, to, *point, axes);
    let are_left = others.iter().all(|other| side(other) > 0.0);
    (are_left || others.iter().all(|other| side(other) < 0.0)) && side(&own) * if are_left { 1.0 } else { -1.0 } <= 0.0
}

/// Whether two triangles without a common vertex have a point in common.
fn are_touching(p: &Face, q: &Face) -> bool {
    if q.is_plainly_beside(&p.at) || p.is_plainly_beside(&q.at) {
        return false;
    }
    let axes = p.plane.axes();
    let is_parted = |one: &Face, other: &Face| {
        let [a, b, c] = one.at;
        [([a, b], c), ([b, c], a), ([c, a], b)].into_iter().any(|(edge, own)| parts(edge, own, &other.at, axes))
    };
    if is_parted(p, q) || is_parted(q, p) {
        return false;
    }
    for (one, other) in [(p, q), (q, p)] {
        let [a, b, c] = one.at;
        let first = other.volume(a);
        let is_beyond = |corner| other.volume(corner) * first.signum() > 0.0;
        if first != 0.0 && is_beyond(b) && is_beyond(c) {
            return false;
        }
    }
    // Where they meet, an edge of one meets the other.
    let edge = |of: &Face, i: usize| [of.at[i], of.at[(i + 1) % 3]];
    (0..3).any(|i| meets(edge(p, i), q) || meets(edge(q, i), p))
}

/// Whether a segment has a point in common with a triangle, its border included.
fn meets([a, b]: [Point; 2], face: &Face) -> bool {
    let (from, to) = (face.volume(a), face.volume(b));
    if (from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0) {
        return false;
    }
    let t = &face.at;
    if from == 0.0 && to == 0.0 {
        return meets_in_plane([a, b], t);
    }
    // The line through a and b passes the triangle on the same side of all its edges, or through one.
    let sides = [0, 1, 2].map(|i| volume(a, b, t[i], t[(i + 1) % 3]));
    !(sides.iter().any(|side| *side > 0.0) && sides.iter().any(|side| *side < 0.0))
}

/// As [`meets`], for a segment in the plane of the triangle.
fn meets_in_plane([a, b]: [Point; 2], t: &[Point; 3]) -> bool {
    let axes = plane(t);
    let sides = |p: Point| [0, 1, 2].map(|i| area(t[i], t[(i + 1) % 3], p, axes));
    let is_within = |p: Point| {
        let sides = sides(p);
        !(sides.iter().any(|side| *side > 0.0) && sides.iter().any(|side| *side < 0.0))
    };
    is_within(a)
        || is_within(b)
        || (0..3).any(|i| {
            let (c, d) = (t[i], t[(i + 1) % 3]);
            let (abc, abd, cda, cdb) =
                (area(a, b, c, axes), area(a, b, d, axes), area(c, d, a, axes), area(c, d, b, axes));
            let opposite = |x: f64, y: f64| (x >= 0.0 && y <= 0.0) || (x <= 0.0 && y >= 0.0);
            // A segment on the line of an edge without an end in the triangle does not touch that edge, or covers it and touches another.
            opposite(abc, abd) && opposite(cda, cdb) && !(abc == 0.0 && abd == 0.0)
        })
}

/// The two axes on which a triangle is projected with an area.
fn plane(t: &[Point; 3]) -> (usize, usize) {
    [(0, 1), (1, 2), (2, 0)].into_iter().find(|axes| area(t[0], t[1], t[2], *axes) != 0.0).unwrap_or((0, 1))
}

fn area(a: Point, b: Point, c: Point, (x, y): (usize, usize)) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| Coord { x: f64::from(p[x]), y: f64::from(p[y]) });
    orient2d(a, b, c)
}

fn volume(a: Point, b: Point, c: Point, d: Point) -> f64 {
    // In a plane of two axes, as the flat sides of a body often are: there the arithmetic without rounding, which takes a hundred times as long, would find the same.
    if (0..3).any(|axis| a[axis] == b[axis] && b[axis] == c[axis] && c[axis] == d[axis]) {
        return 0.0;
    }
    let [a, b, c, d] = [a, b, c, d].map(|p| Coord3D { x: f64::from(p[0]), y: f64::from(p[1]), z: f64::from(p[2]) });
    orient3d(a, b, c, d)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether two triangles with these vertices cross; equal points are equal vertices.
    fn crosses(p: [Point; 3], q: [Point; 3]) -> bool {
        let mut positions: Vec<Point> = Vec::new();
        let mut number = |point: Point| {
            positions.iter().position(|known| *known == point).unwrap_or_else(|| {
                positions.push(point);
                positions.len() - 1
            }) as u32
        };
        let triangles = [p, q].map(|triangle| triangle.map(&mut number));
        let (found, _) = crossings_soon(&positions, &triangles, |_| None, 9);
        let turned = triangles.map(|[a, b, c]| [c, a, b]);
        assert_eq!(found, crossings_soon(&positions, &turned, |_| None, 9).0);
        assert_eq!(found.first().copied(), a_crossing(&positions, &triangles, |_| None));
        !found.is_empty()
    }

    #[test]
    fn what_lies_all_in_one_place_is_given_up() {
        // Long triangles side by side, each in the box of every other.
        let n = 4000;
        let at = |i: u32| i as f32 / n as f32;
        let corners = |i: u32| [[0.0, 0.0, at(i)], [1.0, 1.0, at(i)], [1.0, 0.999, at(i) + 1.0]];
        let positions: Vec<Point> = (0..n).flat_map(corners).collect();
        let triangles: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let (found, given_up) = crossings_soon(&positions, &triangles, |_| None, 9);
        assert!(found.is_empty() && given_up.is_some(), "{given_up:?}");
        assert_eq!(crossings_soon(&positions[..300], &triangles[..100], |_| None, 9), (Vec::new(), None));
        // What is known not to cross is passed over.
        assert_eq!(crossings_soon(&positions, &triangles, |_| Some(1), 9), (Vec::new(), None));
    }

    #[test]
    fn a_mesh_of_many_is_asked_beforehand_how_close_its_triangles_lie() {
        let n = 20_000;
        let mesh = |far: f32| {
            let corners = |i: u32| {
                let at = far * i as f32;
                [[0.0, 0.0, at], [1.0, 1.0, at], [1.0, 0.999, at + 1.0]]
            };
            let positions: Vec<Point> = (0..n).flat_map(corners).collect();
            positions
        };
        let mut triangles: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let (crowd, queue) = (mesh(1e-4), mesh(0.25));
        let (found, given_up) = crossings_soon(&crowd, &triangles, |_| None, 9);
        // That in the middle of all has more beside it than any at the ends.
        assert!(found.is_empty() && given_up.is_some_and(|number| number > 0 && number < n - 1), "{given_up:?}");
        assert_eq!(crossings_soon(&queue, &triangles, |_| None, 9), (Vec::new(), None));
        // The lowest numbers come first, and no more than are asked for.
        for number in [7, 11_000, 19_000] {
            triangles[number + 1][0] = triangles[number][0];
            triangles[number + 1][1] = triangles[number][2];
            triangles[number + 1][2] = triangles[number][1];
        }
        let (found, given_up) = crossings_soon(&queue, &triangles, |_| None, 2);
        assert_eq!((found, given_up), (vec![[7, 8], [11_000, 11_001]], None));
    }

    const T: [Point; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

    #[test]
    fn triangles_without_a_common_vertex() {
        assert!(crosses(T, [[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [2.0, 2.0, 5.0]]));
        assert!(!crosses(T, [[1.0, 1.0, 1e-30], [1.0, 1.0, 1.0], [2.0, 2.0, 5.0]]));
        // A corner in the inside, a corner on an edge, an edge through an edge.
        assert!(crosses(T, [[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [2.0, 2.0, 5.0]]));
        assert!(crosses(T, [[2.0, 2.0, 0.0], [2.0, 2.0, 1.0], [3.0, 3.0, 5.0]]));
        assert!(crosses(T, [[2.0, -1.0, 0.0], [2.0, 1.0, 0.0], [9.0, 9.0, 5.0]]));
        // In one plane: overlapping, one within the other, side by side.
        assert!(crosses(T, [[1.0, 1.0, 0.0], [5.0, 1.0, 0.0], [1.0, 5.0, 0.0]]));
        assert!(crosses(T, [[1.0, 1.0, 0.0], [1.5, 1.0, 0.0], [1.0, 1.5, 0.0]]));
        assert!(!crosses(T, [[4.0, 4.0, 0.0], [5.0, 1.0, 0.0], [9.0, 5.0, 0.0]]));
        assert!(crosses(T, [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [2.0, -4.0, 0.0]]));
    }

    #[test]
    fn triangles_with_a_common_vertex() {
        let o = T[0];
        assert!(!crosses(T, [o, [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]));
        assert!(!crosses(T, [o, [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]]));
        assert!(crosses(T, [o, [3.0, 3.0, 1.0], [3.0, 3.0, -1.0]]));
        assert!(crosses(T, [o, [1.0, 1.0, 1.0], [1.0, 1.0, -1.0]]));
        // In one plane: overlapping, side by side, along an edge.
        assert!(crosses(T, [o, [1.0, 1.0, 0.0], [1.0, 2.0, 0.0]]));
        assert!(crosses(T, [o, [9.0, 1.0, 0.0], [1.0, 9.0, 0.0]]));
        assert!(!crosses(T, [o, [-1.0, 1.0, 0.0], [-1.0, 2.0, 0.0]]));
        assert!(crosses(T, [o, [2.0, 0.0, 0.0], [2.0, -2.0, 0.0]]));
        assert!(crosses(T, [o, [2.0, 0.0, 0.0], [2.0, 0.0, -2.0]]));
    }

    /// As [`cross`] for triangles with one common vertex and for those with none, by the planes of the two alone.
    fn has_more_in_common(p: &Face, q: &Face, n_shared: usize) -> bool {
        let edges = |of: &Face| [0, 1, 2].map(|i| [of.at[i], of.at[(i + 1) % 3]]);
        match n_shared {
            0 => edges(p).iter().any(|edge| meets(*edge, q)) || edges(q).iter().any(|edge| meets(*edge, p)),
            _ => meets([p.at[1], p.at[2]], q) || meets([q.at[1], q.at[2]], p),
        }
    }

    #[test]
    fn what_a_line_parts_has_nothing_else_in_common() {
        // Corners on a coarse grid: many lie in one plane, on one line, or in one place.
        let at = |number: u32| [0, 1, 2].map(|axis| (number / 3u32.pow(axis) % 3) as f32);
        let mut state = 88_172_645_463_325_252u64;
        let mut random = |n: u64| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 33) % n
        };
        let mut n_found = [[0usize; 2]; 2];
        for round in 0..200_000 {
            let n_places = if random(2) == 0 { 9 } else { 27 };
            let mut corners = [(); 6].map(|()| random(n_places) as u32);
            let n_shared = round % 2;
            if n_shared == 1 {
                corners[3] = corners[0];
            }
            let n_same = (0..6).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|(i, j)| corners[*i] == corners[*j]);
            let [p, q] = [[0, 1, 2], [3, 4, 5]].map(|of| of.map(|i: usize| at(corners[i])));
            let has_area = |t: &[Point; 3]| area(t[0], t[1], t[2], plane(t)) != 0.0;
            if n_same.count() != n_shared || !has_area(&p) || !has_area(&q) {
                continue;
            }
            let planes = [p, q].map(|at| Plane::of(&at));
            let [of_p, of_q] = [(p, &planes[0]), (q, &planes[1])].map(|(at, plane)| Face { at, plane });
            let [one, other] = [[0, 1, 2], [3, 4, 5]].map(|of| of.map(|i: usize| corners[i]));
            let found = cross(&one, &other, &of_p, &of_q);
            assert_eq!(found, has_more_in_common(&of_p, &of_q, n_shared), "{p:?} {q:?}");
            n_found[n_shared][usize::from(found)] += 1;
        }
        assert!(n_found.iter().flatten().all(|n| *n > 10_000), "{n_found:?}");
    }

    #[test]
    fn triangles_with_a_common_edge() {
        let [a, b, _] = T;
        assert!(!crosses(T, [b, a, [1.0, -1.0, 0.0]]));
        assert!(!crosses(T, [b, a, [1.0, 1.0, 1e-30]]));
        assert!(crosses(T, [b, a, [1.0, 1.0, 0.0]]));
        assert!(crosses(T, [b, a, T[2]]));
    }

    #[test]
    fn volumes_in_a_plane_of_two_axes_are_nothing_as_in_exact_arithmetic() {
        for axis in 0..3 {
            let at = |x: f32, y: f32| {
                core::array::from_fn(|k| {
                    if k == axis {
                        0.3
                    } else if (k + 1) % 3 == axis {
                        x
                    } else {
                        y
                    }
                })
            };
            let flat = [at(0.1, 0.7), at(1e-20, -3e8), at(0.3, 0.1), at(-0.0, 1e-3)];
            let [a, b, c, mut d]: [Point; 4] = flat;
            assert_eq!(volume(a, b, c, d), 0.0);
            d[axis] = 0.3f32.next_up();
            assert_ne!(volume(a, b, c, d), 0.0);
            assert_eq!(volume(a, b, c, d).signum(), -volume(b, a, c, d).signum());
        }
    }
}
