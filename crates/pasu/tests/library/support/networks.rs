//! Networks of vertex-frames of every topology.

use glam::DVec3;
use pasu::{Design, MeasureOptions, Product};
use serde_json::{Value, json};

/// The largest extent of the points of a network.
pub(crate) fn size(shape: &Value) -> f64 {
    let vertices: Vec<[f64; 3]> = serde_json::from_value(shape["vertices"].clone()).unwrap();
    let points = || vertices.iter().map(|at| DVec3::from_array(*at));
    let low = points().fold(DVec3::INFINITY, DVec3::min);
    let high = points().fold(DVec3::NEG_INFINITY, DVec3::max);
    (high - low).max_element()
}

/// A cube of side 2 of six frames, each begun at another corner and in another direction.
pub(crate) fn cube() -> Value {
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut number = |at: [f64; 3]| {
        vertices.iter().position(|known| *known == at).unwrap_or_else(|| {
            vertices.push(at);
            vertices.len() - 1
        })
    };
    let mut patches = Vec::new();
    for face in 0..6 {
        let (axis, end) = (face / 2, if face % 2 == 0 { -1.0 } else { 1.0 });
        let round =
            [[-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];
        let mut frame: Vec<usize> = round
            .iter()
            .map(|[a, b]| {
                let mut at = [end; 3];
                (at[(axis + 1) % 3], at[(axis + 2) % 3]) = (*a, *b);
                number(at)
            })
            .collect();
        frame.rotate_left(2 * (face % 4));
        if face % 3 == 0 {
            frame.reverse();
            // A corner first again.
            frame.rotate_left(1);
        }
        patches.push(json!({ "frame": frame }));
    }
    json!({ "kind": "vertex-frame", "vertices": vertices, "patches": patches })
}

/// A network on a grid of `m x n` patches, joined to itself or not along either direction, as it stands or reversed.
pub(crate) struct Net {
    pub(crate) vertices: Vec<[f64; 3]>,
    pub(crate) patches: Vec<Value>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Wrap {
    Free,
    Joined,
    Reversed,
}

/// Numbers that look random.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// From -1 to 1.
    pub(crate) fn number(&mut self) -> f64 {
        // Six digits, which every form of a document holds.
        (self.below(2_000_001) as f64 - 1e6) / 1e6
    }

    pub(crate) fn three(&mut self, of: impl Fn(f64) -> f64) -> [f64; 3] {
        [(); 3].map(|()| of(self.number()))
    }

    pub(crate) fn shuffled(&mut self, n: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, self.below(i + 1));
        }
        order
    }
}

impl Net {
    pub(crate) fn grid(m: usize, n: usize, along: Wrap, round: Wrap, dice: &mut Dice, has_forces: bool) -> Net {
        // The first of all places of the lattice that are one point.
        let first = |i: usize, j: usize| {
            let mut orbit = vec![(i, j)];
            let mut next = 0;
            while let Some(&(i, j)) = orbit.get(next) {
                next += 1;
                let mirror = |wrap: Wrap, x: usize, most: usize| if wrap == Wrap::Reversed { most - x } else { x };
                let mut same = Vec::new();
                if along != Wrap::Free && (i == 0 || i == 2 * m) {
                    same.push((2 * m - i, mirror(along, j, 2 * n)));
                }
                if round != Wrap::Free && (j == 0 || j == 2 * n) {
                    same.push((mirror(round, i, 2 * m), 2 * n - j));
                }
                for place in same {
                    if !orbit.contains(&place) {
                        orbit.push(place);
                    }
                }
            }
            orbit.into_iter().min().unwrap()
        };
        let mut number = std::collections::HashMap::new();
        let mut vertices = Vec::new();
        let mut patches = Vec::new();
        for i in 0..m {
            for j in 0..n {
                let places = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
                let frame = places.map(|(a, b)| {
                    let (x, y) = (2 * i + a, 2 * j + b);
                    *number.entry(first(x, y)).or_insert_with(|| {
                        let jitter = dice.three(|x| 0.2 * x);
                        let at = [x as f64, y as f64, (x * y % 5) as f64 * 0.3];
                        vertices.push([0, 1, 2].map(|k: usize| at[k] + jitter[k]));
                        vertices.len() - 1
                    })
                });
                let (a1, a2) = (dice.three(|x| 2.0 + x), dice.three(|x| 2.0 + x));
                let mut patch = json!({ "frame": frame, "a1": a1, "a2": a2 });
                if has_forces {
                    let side = |dice: &mut Dice| {
                        [0.25 + 0.2 * dice.number(), 0.75 + 0.2 * dice.number()].map(|x| (x * 1e6).round() / 1e6)
                    };
                    let (u, v) = (side(dice), side(dice));
                    let falloff = ["sine", "smooth"][dice.below(2)];
                    patch["forces"] = json!([{ "f0": dice.three(|x| 9.0 * x), "u": u, "v": v, "falloff": falloff }]);
                }
                patches.push(patch);
            }
        }
        Net { vertices, patches }
    }

    pub(crate) fn shape(&self, rule: &Value) -> Value {
        json!({ "kind": "vertex-frame", "vertices": self.vertices, "patches": self.patches, "rule": rule })
    }
}

/// A torus of `m x n` patches through points of a true one.
pub(crate) fn torus(m: usize, n: usize) -> Value {
    let tau = std::f64::consts::TAU;
    let mut net = Net::grid(m, n, Wrap::Joined, Wrap::Joined, &mut Dice(7), false);
    let mut places = vec![None; net.vertices.len()];
    for (index, patch) in net.patches.iter_mut().enumerate() {
        let (i, j) = (index / n, index % n);
        let around = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        let frame: Vec<usize> = serde_json::from_value(patch["frame"].clone()).unwrap();
        for ((a, b), vertex) in around.into_iter().zip(frame) {
            places[vertex] = Some((2 * i + a, 2 * j + b));
        }
        *patch = json!({ "frame": patch["frame"] });
    }
    for (at, place) in net.vertices.iter_mut().zip(places) {
        let (i, j) = place.unwrap();
        let (p, q) = (tau * i as f64 / (2 * m) as f64, tau * j as f64 / (2 * n) as f64);
        let r = 3.0 + q.cos();
        *at = [r * p.cos(), r * p.sin(), q.sin()];
    }
    net.shape(&json!("global"))
}

pub(crate) fn measured(design: &Design) -> pasu::Measures {
    let options = MeasureOptions { product: Product::Solid, ..MeasureOptions::default() };
    pasu::measure(design, &options).unwrap()
}

/// How often each edge of a mesh is passed, edges told by the bits of their ends.
pub(crate) fn edges(mesh: &pasu::Mesh) -> Vec<usize> {
    let at = |vertex: u32| {
        let from = 3 * vertex as usize;
        [0, 1, 2].map(|axis| (mesh.positions[from + axis] + 0.0).to_bits())
    };
    let mut count = std::collections::HashMap::new();
    for triangle in mesh.indices.chunks_exact(3) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (at(triangle[a]), at(triangle[b]));
            assert_ne!(a, b, "a triangle without width");
            *count.entry((a.min(b), a.max(b))).or_insert(0) += 1;
        }
    }
    count.into_values().collect()
}

/// The largest distance between points of triangles and those of the surface with the same parameters.
pub(crate) fn farthest(design: &Design, mesh: &pasu::Mesh) -> f64 {
    // Each patch begins with its corner (0, 0), which no other vertex of it has.
    let corners: Vec<usize> = (0..mesh.n_vertices()).filter(|i| mesh.uvs[2 * i..2 * i + 2] == [0.0, 0.0]).collect();
    let (mut at, mut points) = (Vec::new(), Vec::new());
    for triangle in mesh.indices.chunks_exact(3) {
        let patch = corners.partition_point(|corner| *corner <= triangle[0] as usize) - 1;
        for weights in [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.3, 0.3, 0.4], [0.1, 0.2, 0.7]] {
            let mean = |array: &[f32], n: usize, k: usize| {
                triangle
                    .iter()
                    .zip(weights)
                    .map(|(vertex, weight)| f64::from(array[n * *vertex as usize + k]) * weight)
                    .sum::<f64>()
            };
            at.extend([patch as f64, mean(&mesh.uvs, 2, 0).min(1.0), mean(&mesh.uvs, 2, 1).min(1.0)]);
            points.push(DVec3::from_array([0, 1, 2].map(|k| mean(&mesh.positions, 3, k))));
        }
    }
    let exact = pasu::evaluate(design, 0, &at).unwrap();
    points
        .iter()
        .zip(exact.chunks_exact(3))
        .map(|(point, exact)| point.distance(DVec3::from_slice(exact)))
        .fold(0.0, f64::max)
}

/// The boundary of cubes of side 2 that stand face to face, at these places of a lattice: every visible face a frame, begun and run through in any way. Corners have three to six faces.
pub(crate) fn polycube(cubes: &[[i64; 3]], dice: &mut Dice) -> Net {
    let mut numbers = std::collections::HashMap::new();
    let mut net = Net { vertices: Vec::new(), patches: Vec::new() };
    for cube in cubes {
        for face in 0..6 {
            let (axis, end) = (face / 2, if face % 2 == 0 { -1 } else { 1 });
            let mut beside = *cube;
            beside[axis] += end;
            if cubes.contains(&beside) {
                continue;
            }
            let round = [[-1, -1], [0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]];
            let mut frame = round.map(|[a, b]| {
                let mut at = cube.map(|x| 2 * x);
                at[axis] += end;
                at[(axis + 1) % 3] += a;
                at[(axis + 2) % 3] += b;
                *numbers.entry(at).or_insert_with(|| {
                    net.vertices.push(at.map(|x| x as f64));
                    net.vertices.len() - 1
                })
            });
            frame.rotate_left(2 * dice.below(4));
            if dice.below(2) == 1 {
                frame.reverse();
                frame.rotate_left(1);
            }
            net.patches.push(json!({ "frame": frame }));
        }
    }
    net
}

/// So many cubes that hang together by faces.
pub(crate) fn cubes_at_random(n: usize, dice: &mut Dice) -> Vec<[i64; 3]> {
    let mut cubes = vec![[0; 3]];
    while cubes.len() < n {
        let mut next = cubes[dice.below(cubes.len())];
        next[dice.below(3)] += if dice.below(2) == 0 { 1 } else { -1 };
        if !cubes.contains(&next) {
            cubes.push(next);
        }
    }
    cubes
}
