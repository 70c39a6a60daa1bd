//! What of a body is glazed outside, what inside, and what is bare clay.

use std::borrow::Cow;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::check;
use crate::design::{Glaze, Look};
use crate::face::FaceKind;
use crate::watch;
use crate::weave::SolidMesh;

/// What a triangle is covered with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Coat {
    Outside,
    Inside,
    Bare,
}

impl Coat {
    /// The plain look of what is covered so.
    pub(super) fn of(self, look: Look) -> Look {
        match self {
            Coat::Outside => Look::new(look.glaze, look.clay),
            Coat::Inside => Look::new(look.within(), look.clay),
            Coat::Bare => Look::new(Glaze::Bare, look.clay),
        }
    }
}

/// What a face is covered with but for what the glaze line does to the outside, which is bare where the glaze begins above it all; `has_line` where it ends anywhere at all.
pub(super) fn coat_of(kind: FaceKind, has_line: bool, is_bare: bool) -> Coat {
    match kind {
        FaceKind::Lining | FaceKind::Floor | FaceKind::Drain => Coat::Inside,
        FaceKind::Underside | FaceKind::FootRing | FaceKind::Recess if has_line => Coat::Bare,
        _ if is_bare => Coat::Bare,
        _ => Coat::Outside,
    }
}

/// The triangles of a body, and what each is covered with; nothing where all are as the outside is.
pub(super) struct Coated<'a> {
    pub(super) positions: Cow<'a, [f32]>,
    pub(super) indices: Cow<'a, [u32]>,
    pub(super) faces: Vec<(FaceKind, usize, usize)>,
    pub(super) coats: Vec<Coat>,
}

/// The triangles of a mesh as they are: of formats without colours, and of looks that are the same everywhere.
pub(super) fn uncoated(mesh: &SolidMesh) -> Coated<'_> {
    Coated {
        positions: Cow::Borrowed(&mesh.positions),
        indices: Cow::Borrowed(&mesh.indices),
        faces: mesh.faces.iter().map(|(kind, first, count)| (*kind, *first as usize, *count as usize)).collect(),
        coats: Vec::new(),
    }
}

/// The triangles of a mesh with what covers each. Triangles of the outside that the glaze line runs through are divided along it; where that cannot be done without triangles that cross or have no area,
/// they stay whole, and each is what its middle is.
pub(super) fn coated(mesh: &SolidMesh, look: Look) -> Coated<'_> {
    let whole = uncoated(mesh);
    if look.inside.is_none() && look.line == 0.0 {
        return whole;
    }
    let covering = Covering::of(mesh, look);
    let divided = covering.line.filter(|_| look.line < 1.0).and_then(|line| divided(&whole, line));
    let mut coated = divided.unwrap_or(whole);
    coated.coats = coats(&coated, &covering);
    coated
}

/// What covers triangles of a body that are not divided, each being what its middle is.
#[derive(Default)]
pub(super) struct Covering {
    line: Option<f32>,
    is_bare: bool,
    /// Whether not all is as the outside is.
    is_varied: bool,
}

impl Covering {
    /// That of a mesh which looks so.
    pub(super) fn of(mesh: &SolidMesh, look: Look) -> Covering {
        let is_varied = look.inside.is_some() || look.line > 0.0;
        Covering { line: line_of(&uncoated(mesh), look.line), is_bare: look.line >= 1.0, is_varied }
    }

    /// What covers a triangle of a face whose corners are at these heights.
    pub(super) fn at(&self, kind: FaceKind, heights: [f32; 3]) -> Coat {
        let below = || {
            let sum: f64 = heights.into_iter().map(f64::from).sum();
            self.line.is_some_and(|line| sum < 3.0 * f64::from(line))
        };
        match coat_of(kind, self.line.is_some(), self.is_bare) {
            _ if !self.is_varied => Coat::Outside,
            Coat::Outside if below() => Coat::Bare,
            coat => coat,
        }
    }
}

/// At which height the glaze ends, in millimetres; none where it goes down to the foot.
fn line_of(body: &Coated, share: f64) -> Option<f32> {
    let outer = body.faces.iter().filter(|(kind, ..)| *kind == FaceKind::Outer);
    let heights = outer.flat_map(|(_, first, count)| &body.indices[*first..first + count]);
    let (low, high) = heights
        .map(|vertex| f64::from(body.positions[3 * *vertex as usize + 2]))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    (share > 0.0 && low < high).then_some((low + share * (high - low)) as f32)
}

fn coats(body: &Coated, covering: &Covering) -> Vec<Coat> {
    let height = |vertex: u32| body.positions[3 * vertex as usize + 2];
    let mut coats = Vec::with_capacity(body.indices.len() / 3);
    for &(kind, first, count) in &body.faces {
        for corners in body.indices[first..first + count].as_chunks::<3>().0 {
            watch::work(5);
            coats.push(covering.at(kind, corners.map(height)));
        }
    }
    coats
}

/// The same body with every edge of the outside divided where it goes through a height. `None` if what comes of it does not pass the checks.
fn divided(body: &Coated, line: f32) -> Option<Coated<'static>> {
    let mut positions = body.positions.to_vec();
    let height = |vertex: u32| body.positions[3 * vertex as usize + 2];
    let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
    for &(_, first, count) in body.faces.iter().filter(|(kind, ..)| *kind == FaceKind::Outer) {
        for corners in body.indices[first..first + count].chunks_exact(3) {
            watch::work(10);
            for edge in edges(corners) {
                let [a, b] = edge.map(height);
                // An edge that begins or ends at the line is not divided.
                if (a - line) * (b - line) < 0.0
                    && let Entry::Vacant(place) = middles.entry(edge)
                {
                    place.insert(positions.len() as u32 / 3);
                    positions.extend(between(&body.positions, edge, line));
                }
            }
        }
    }
    let mut indices = Vec::with_capacity(body.indices.len());
    let mut faces = Vec::with_capacity(body.faces.len());
    for &(kind, first, count) in &body.faces {
        let start = indices.len();
        for corners in body.indices[first..first + count].chunks_exact(3) {
            let middle = edges(corners).map(|edge| middles.get(&edge).copied());
            push_divided(&mut indices, corners, middle);
        }
        faces.push((kind, start, indices.len() - start));
    }
    let divided = Coated { positions: positions.into(), indices: indices.into(), faces, coats: Vec::new() };
    passes(&divided).then_some(divided)
}

/// The ends of each edge, the lower number first: the edge after each corner.
fn edges(corners: &[u32]) -> [[u32; 2]; 3] {
    [[0, 1], [1, 2], [2, 0]].map(|[i, j]| [corners[i].min(corners[j]), corners[i].max(corners[j])])
}

/// Where an edge goes through a height.
fn between(positions: &[f32], [a, b]: [u32; 2], line: f32) -> [f32; 3] {
    let at = |vertex: u32, axis: usize| f64::from(positions[3 * vertex as usize + axis]);
    let t = (f64::from(line) - at(a, 2)) / (at(b, 2) - at(a, 2));
    let along = |axis: usize| (at(a, axis) + t * (at(b, axis) - at(a, axis))) as f32;
    [along(0), along(1), line]
}

/// A triangle, divided at the middles that its edges have: one for each edge, from each corner to the next.
fn push_divided(into: &mut Vec<u32>, corners: &[u32], middles: [Option<u32>; 3]) {
    let [a, b, c] = [corners[0], corners[1], corners[2]];
    match middles {
        [None, None, None] => into.extend([a, b, c]),
        // One edge: turned so that it is the first.
        [Some(p), None, None] => into.extend([a, p, c, p, b, c]),
        [None, Some(p), None] => into.extend([b, p, a, p, c, a]),
        [None, None, Some(p)] => into.extend([c, p, b, p, a, b]),
        // Two: the corner between them, and what is left.
        [Some(p), Some(q), None] => into.extend([p, b, q, a, p, q, a, q, c]),
        [None, Some(p), Some(q)] => into.extend([p, c, q, b, p, q, b, q, a]),
        [Some(q), None, Some(p)] => into.extend([p, a, q, c, p, q, c, q, b]),
        [Some(p), Some(q), Some(r)] => into.extend([a, p, r, p, b, q, r, q, c, p, q, r]),
    }
}

/// What every file must: closed, without triangles that cross or have no area.
fn passes(body: &Coated) -> bool {
    let points: Vec<[f32; 3]> = body.positions.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    let triangles: Vec<[u32; 3]> = body.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect();
    let at = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
    // Level faces have passed, and are divided along their edges at most.
    let of_level = |triangle: u32| {
        let is_here =
            |(_, first, count): &&(FaceKind, usize, usize)| (*first..first + count).contains(&(3 * triangle as usize));
        let (face, (kind, ..)) = body.faces.iter().enumerate().find(|(_, face)| is_here(face))?;
        (!matches!(kind, FaceKind::Outer | FaceKind::Lining | FaceKind::Rim)).then_some(face as u32)
    };
    !triangles.iter().any(|triangle| check::is_degenerate(at(triangle)))
        && check::closed(&triangles, points.len()).is_ok()
        && check::crossings_soon(&points, &triangles, of_level, 1) == (Vec::new(), None)
}

/// Every plain look of a body, in the order in which they first come, and which each triangle has.
pub(super) fn looks(look: Look, coats: &[Coat]) -> (Vec<Look>, Vec<usize>) {
    let (mut looks, numbers) = numbered(coats.iter().map(|coat| coat.of(look)));
    if coats.is_empty() {
        looks.push(Coat::Outside.of(look));
    }
    (looks, numbers)
}

/// Looks, each once in the order in which they first come, and which of them each is.
pub(super) fn numbered(all: impl Iterator<Item = Look>) -> (Vec<Look>, Vec<usize>) {
    let mut looks: Vec<Look> = Vec::new();
    let number = |plain: Look| {
        looks.iter().position(|each| *each == plain).unwrap_or_else(|| {
            looks.push(plain);
            looks.len() - 1
        })
    };
    let numbers = all.map(number).collect();
    (looks, numbers)
}
