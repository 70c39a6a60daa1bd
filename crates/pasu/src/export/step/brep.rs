//! The faces of a solid sewn together: vertices and edges that neighbours share.
//!
//! A face with few columns is one face of STEP with a seam; one with many is cut along columns into panels.

use std::f64::consts::TAU;

use glam::DVec3;

use super::exchange::{Entities, Id, integers, list, reals, settled, string};
use super::fit::{Boundary, Fitted, Net, Scaled, fit};
use super::narrow::{Joined, Narrow, cuts, is_wide};
use super::sewn::{Sewn, boolean};
use super::spline::multiplicities;
use crate::error::{Code, Error, Result};
use crate::face::Face;

/// Where ends of faces are compared, as parts of a turn.
const PLACES: [f64; 8] = [0.0, 0.11, 0.23, 0.37, 0.5, 0.61, 0.78, 0.93];
/// Ends that are no farther apart, as a part of the size of the solid, are one curve; smaller ones are one point.
const SAME: f64 = 1e-9;
/// The same where a face without width was left out between them.
const MEETS: f64 = 3.0 * SAME;
/// What is off a plane by no more than this is in it, millimetres.
const LEVEL: f64 = 2e-9;

/// At most so many intervals round a face are one panel. OpenCASCADE integrates along an edge with a fixed number of points, however many intervals it has: were a fluted face one
/// panel, its programs would show half of its volume.
const PANEL: usize = 32;

/// Writes one closed solid of the faces, within the tolerance.
///
/// # Errors
/// `bug` when the faces do not close, which is a fault of Pasu.
pub(super) fn sew(
    into: &mut Entities,
    name: &str,
    faces: &[&dyn Face],
    millimetres: f64,
    tolerance: f64,
    path: &str,
) -> Result<Sewn> {
    let faces: Vec<Scaled> = faces.iter().map(|face| Scaled { face: *face, millimetres }).collect();
    let faces = with_width(faces);
    let narrow: Vec<Narrow> = faces.iter().map(|face| Narrow::of(face, tolerance)).collect();
    let places: Vec<f64> =
        PLACES.iter().map(|part| part * TAU).chain(narrow.iter().flat_map(Narrow::middles)).collect();
    let boundaries = boundaries(&faces, &places, path)?;
    let cuts = cuts(&narrow);
    let fitted = fit(&faces, &boundaries, &cuts, tolerance)?;
    let panels = fitted.columns.panels(PANEL);
    let is_level = |face: usize| level_normal(&fitted.faces[face], faces[face].face.outward()).is_some();
    let joined = Joined::new(&narrow, &boundaries, &fitted, &panels, is_level);
    let mut sewing = Sewing {
        into,
        fitted: &fitted,
        faces: &faces,
        boundaries: &boundaries,
        panels,
        joined,
        ends: Vec::new(),
        moved: 0.0,
    };
    let mut advanced = Vec::new();
    for (index, face) in faces.iter().enumerate() {
        advanced.extend(sewing.face(index).into_iter().map(|id| (face.face.kind(), id)));
    }
    let moved = sewing.moved;
    let shell: Vec<Id> = advanced.iter().map(|(_, id)| *id).collect();
    let shell = into.add(&format!("CLOSED_SHELL('',{})", list(&shell)));
    let solid = into.add(&format!("MANIFOLD_SOLID_BREP({},{shell})", string(name)));
    Ok(Sewn {
        shape: solid,
        is_closed: true,
        faces: advanced,
        deviation: fitted.deviation + moved,
        bound: fitted.bound + moved,
        n_samples: fitted.n_samples,
    })
}

/// Leaves out faces that are nowhere wider than a curve, as the upright part of a lining that begins in the floor: neighbours on both sides then meet there.
fn with_width(faces: Vec<Scaled>) -> Vec<Scaled> {
    let start = |face: &Scaled| PLACES.map(|part| face.position(0.0, part * TAU));
    let points: Vec<DVec3> = faces.iter().flat_map(start).collect();
    let size = points.iter().map(|point| (*point - points[0]).length()).fold(0.0, f64::max);
    faces.into_iter().filter(|face| is_wide(face, SAME * size)).collect()
}

/// Finds for every end of every face whether it is a pole or which neighbour it is shared with.
///
/// Curves are compared at `places`, of which some are where faces that are narrow elsewhere are wide.
fn boundaries(faces: &[Scaled], places: &[f64], path: &str) -> Result<Vec<[Boundary; 2]>> {
    let ends: Vec<(usize, usize)> = (0..faces.len()).flat_map(|face| [(face, 0), (face, 1)]).collect();
    let curves: Vec<Vec<DVec3>> = ends
        .iter()
        .map(|(face, end)| {
            let mut walk = faces[*face].walk();
            places.iter().map(|v| walk.position(*end as f64, *v)).collect()
        })
        .collect();
    let size = curves.iter().flatten().map(|point| (*point - curves[0][0]).length()).fold(0.0, f64::max);
    let apart = |a: &[DVec3], b: &[DVec3]| a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max);
    let is_point = |curve: &[DVec3]| curve.iter().all(|point| (*point - curve[0]).length() <= SAME * size);
    let mut found: Vec<Option<Boundary>> = vec![None; ends.len()];
    for (index, (face, end)) in ends.iter().copied().enumerate() {
        if found[index].is_some() {
            continue;
        }
        if is_point(&curves[index]) {
            found[index] = Some(Boundary::Pole { face, end });
            continue;
        }
        let other = (index + 1..ends.len())
            .find(|other| found[*other].is_none() && apart(&curves[index], &curves[*other]) <= MEETS * size);
        let Some(other) = other else {
            let message = format!(
                "the {} of this part and the faces beside it are told apart too little in numbers of this size to be joined in a STEP file: expected a part that is less narrow somewhere for its size, or another format",
                faces[face].face.kind().name()
            );
            return Err(Error::new(Code::NoRoom, path, message));
        };
        let curve = Some(Boundary::Curve { face, end });
        (found[index], found[other]) = (curve, curve);
    }
    let found: Vec<Boundary> = found.into_iter().flatten().collect();
    Ok(found.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect())
}

struct Sewing<'a> {
    into: &'a mut Entities,
    fitted: &'a Fitted,
    faces: &'a [Scaled<'a>],
    boundaries: &'a [[Boundary; 2]],
    /// The columns at which panels begin and the last one ends.
    panels: Vec<usize>,
    joined: Joined,
    /// The boundaries written so far.
    ends: Vec<(Boundary, End)>,
    /// The farthest that a boundary was moved to one that it is joined with, millimetres.
    moved: f64,
}

/// Where a face ends.
#[derive(Clone)]
struct End {
    /// The pole, or the point of the curve at which each panel begins.
    vertices: Vec<Id>,
    /// The edge of each panel in the direction of `v`; none at a pole.
    edges: Vec<Id>,
}

impl Sewing<'_> {
    /// The faces of STEP that make up one face of the pot: one if it is level and there all round, else one for each panel in which it is there.
    fn face(&mut self, index: usize) -> Vec<Id> {
        let net = &self.fitted.faces[index];
        let face = &self.faces[index];
        let outward = face.face.outward();
        let name = string(&format!("{:?}", face.face.kind()));
        // Walked so that the face lies to the left, seen from outside: up the far end and down the near one where F_a x F_v points out.
        let turned = outward < 0.0;
        if let (Some(normal), true) = (level_normal(net, outward), self.joined.is_whole(index)) {
            return vec![self.plane(&name, index, normal, turned)];
        }
        let ends = [self.end(index, 0), self.end(index, 1)];
        let n_panels = self.panels.len() - 1;
        let sides: Vec<Option<Id>> = (0..n_panels).map(|panel| self.side(index, panel, &ends)).collect();
        (0..n_panels)
            .filter(|panel| self.joined.is_wide(index, *panel))
            .collect::<Vec<_>>()
            .into_iter()
            .map(|panel| {
                let surface = self.surface(index, panel);
                let mut walk: Vec<(Id, bool)> = sides[panel].map(|side| (side, true)).into_iter().collect();
                walk.extend(ends[1].edges.get(panel).map(|edge| (*edge, true)));
                walk.extend(sides[(panel + 1) % n_panels].map(|side| (side, false)));
                walk.extend(ends[0].edges.get(panel).map(|edge| (*edge, false)));
                if turned {
                    walk.reverse();
                    for (_, forward) in &mut walk {
                        *forward = !*forward;
                    }
                }
                let bound = self.bound("FACE_OUTER_BOUND", &walk);
                self.into.add(&format!("ADVANCED_FACE({name},({bound}),{surface},{})", boolean(!turned)))
            })
            .collect()
    }

    /// A face in a plane, within its one or two boundary curves.
    fn plane(&mut self, name: &str, index: usize, normal: DVec3, turned: bool) -> Id {
        let control = &self.fitted.faces[index].control;
        let rows = [&control[0], &control[control.len() - 1]];
        let origin = self.into.point(rows[0][0]);
        let axis = self.into.direction(normal);
        let across = self.into.direction(normal.any_orthonormal_vector());
        let placement = self.into.add(&format!("AXIS2_PLACEMENT_3D('',{origin},{axis},{across})"));
        let plane = self.into.add(&format!("PLANE('',{placement})"));
        let outer = usize::from(area(rows[1]).length() > area(rows[0]).length());
        let mut bounds = Vec::new();
        for end in [outer, 1 - outer] {
            if matches!(self.boundaries[index][end], Boundary::Pole { .. }) {
                continue;
            }
            let forward = (end == 1) != turned;
            let mut walk: Vec<(Id, bool)> = self.end(index, end).edges.iter().map(|edge| (*edge, forward)).collect();
            if !forward {
                walk.reverse();
            }
            let entity = if end == outer { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
            bounds.push(self.bound(entity, &walk));
        }
        self.into.add(&format!("ADVANCED_FACE({name},{},{plane},.T.)", list(&bounds)))
    }

    fn bound(&mut self, entity: &str, walk: &[(Id, bool)]) -> Id {
        let edges: Vec<Id> = walk
            .iter()
            .map(|(edge, forward)| self.into.add(&format!("ORIENTED_EDGE('',*,*,{edge},{})", boolean(*forward))))
            .collect();
        let edge_loop = self.into.add(&format!("EDGE_LOOP('',{})", list(&edges)));
        self.into.add(&format!("{entity}('',{edge_loop},.T.)"))
    }

    /// Where a face ends, written once for the neighbours that share it.
    fn end(&mut self, face: usize, end: usize) -> End {
        let boundary = self.boundaries[face][end];
        if let Some((_, end)) = self.ends.iter().find(|(written, _)| *written == boundary) {
            return end.clone();
        }
        let written = match boundary {
            Boundary::Pole { .. } => {
                let row = self.row(boundary);
                End { vertices: vec![self.vertex(row[0])], edges: Vec::new() }
            }
            Boundary::Curve { .. } => self.closed_end(boundary),
        };
        self.ends.push((boundary, written.clone()));
        written
    }

    fn closed_end(&mut self, boundary: Boundary) -> End {
        let n_panels = self.panels.len() - 1;
        let arcs: Vec<Vec<DVec3>> = (0..n_panels).map(|panel| self.arc(boundary, panel)).collect();
        let mut vertices = Vec::new();
        for (panel, arc) in arcs.iter().enumerate() {
            let kept = self.joined.vertex(boundary, panel);
            vertices.push(if kept == boundary { self.vertex(arc[0]) } else { self.end_of(kept).vertices[panel] });
        }
        let mut edges = Vec::new();
        for (panel, arc) in arcs.iter().enumerate() {
            let kept = self.joined.edge(boundary, panel);
            if kept != boundary {
                edges.push(self.end_of(kept).edges[panel]);
                continue;
            }
            let nodes = &self.fitted.columns.nodes[self.panels[panel]..=self.panels[panel + 1]];
            let curve = self.curve(arc, nodes, n_panels == 1);
            let [from, to] = [panel, panel + 1].map(|panel| vertices[panel % n_panels]);
            edges.push(self.into.add(&format!("EDGE_CURVE('',{from},{to},{curve},.T.)")));
        }
        End { vertices, edges }
    }

    /// The end whose edges and vertices are kept where others are joined with it.
    fn end_of(&mut self, boundary: Boundary) -> End {
        let (Boundary::Curve { face, end } | Boundary::Pole { face, end }) = boundary;
        self.end(face, end)
    }

    /// The control points of a boundary.
    fn row(&self, boundary: Boundary) -> &[DVec3] {
        let (Boundary::Curve { face, end } | Boundary::Pole { face, end }) = boundary;
        let control = &self.fitted.faces[face].control;
        if end == 0 { &control[0] } else { &control[control.len() - 1] }
    }

    /// The control points of a boundary within a panel, as they are after it was joined with others.
    fn arc(&self, boundary: Boundary, panel: usize) -> Vec<DVec3> {
        let kept = self.joined.edge(boundary, panel);
        let mut arc = self.within(self.row(kept), panel);
        let [from, to] = [panel, panel + 1].map(|panel| self.joined.vertex(boundary, panel));
        let last = arc.len() - 1;
        if from != kept {
            arc[0] = self.within(self.row(from), panel)[0];
        }
        if to != kept {
            arc[last] = self.within(self.row(to), panel)[last];
        }
        arc
    }

    /// The rows of control points of a face within a panel.
    fn rows(&mut self, index: usize, panel: usize) -> Vec<Vec<DVec3>> {
        let control = &self.fitted.faces[index].control;
        let mut rows: Vec<Vec<DVec3>> = control.iter().map(|row| self.within(row, panel)).collect();
        let last = rows.len() - 1;
        for (boundary, row) in self.boundaries[index].into_iter().zip([0, last]) {
            if !matches!(boundary, Boundary::Curve { .. }) {
                continue;
            }
            let arc = self.arc(boundary, panel);
            let moved = arc.iter().zip(&rows[row]).map(|(to, from)| (*to - *from).length());
            self.moved = moved.fold(self.moved, f64::max);
            rows[row] = arc;
        }
        // Where a panel begins or ends in a point, so do all its rows.
        let n_columns = rows[0].len();
        for (vertex, column) in [(panel, 0), (panel + 1, n_columns - 1)] {
            let [near, far] = self.boundaries[index].map(|boundary| self.joined.vertex(boundary, vertex));
            if near != far {
                continue;
            }
            let point = rows[0][column];
            for row in &mut rows {
                self.moved = self.moved.max((row[column] - point).length());
                row[column] = point;
            }
        }
        rows
    }

    /// The curve of constant `v` at which a panel begins; of one panel alone the seam, along which it meets itself. None where the face is no wider than a point.
    fn side(&mut self, index: usize, panel: usize, ends: &[End; 2]) -> Option<Id> {
        let [start, end] = [0, 1].map(|end: usize| {
            let vertices = &ends[end].vertices;
            vertices[panel % vertices.len()]
        });
        if start == end {
            return None;
        }
        let column: Vec<DVec3> = self.rows(index, panel).iter().map(|row| row[0]).collect();
        let fitted = self.fitted;
        let curve = self.curve(&column, &fitted.faces[index].rows, false);
        Some(self.into.add(&format!("EDGE_CURVE('',{start},{end},{curve},.T.)")))
    }

    fn surface(&mut self, index: usize, panel: usize) -> Id {
        let fitted = self.fitted;
        let net = &fitted.faces[index];
        let columns = &fitted.columns.nodes[self.panels[panel]..=self.panels[panel + 1]];
        let control: Vec<String> = self
            .rows(index, panel)
            .into_iter()
            .map(|row| list(&row.into_iter().map(|point| self.into.point(point)).collect::<Vec<_>>()))
            .collect();
        self.into.add(&format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',3,3,({}),.UNSPECIFIED.,.F.,{},.F.,{},{},{},{},.UNSPECIFIED.)",
            control.join(","),
            boolean(self.panels.len() == 2),
            integers(&multiplicities(net.rows.len())),
            integers(&multiplicities(columns.len())),
            reals(&net.rows),
            reals(columns),
        ))
    }

    /// The control points of a row within a panel.
    fn within(&self, row: &[DVec3], panel: usize) -> Vec<DVec3> {
        let part = self.fitted.columns.within(row, self.panels[panel], self.panels[panel + 1]);
        part.into_iter().map(|point| DVec3::from_array(point.to_array().map(settled))).collect()
    }

    fn vertex(&mut self, point: DVec3) -> Id {
        let point = self.into.point(point);
        self.into.add(&format!("VERTEX_POINT('',{point})"))
    }

    fn curve(&mut self, control: &[DVec3], nodes: &[f64], is_closed: bool) -> Id {
        let points: Vec<Id> = control.iter().map(|point| self.into.point(*point)).collect();
        self.into.add(&format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,{},.F.,{},{},.UNSPECIFIED.)",
            list(&points),
            boolean(is_closed),
            integers(&multiplicities(nodes.len())),
            reals(nodes),
        ))
    }
}

/// The outward normal of a face all of whose control points are in one plane.
///
/// The integral of `F_a x F_v` over a face is that of `F x dF / 2` round its ends, so that it holds for a face that folds over itself within its plane.
fn level_normal(net: &Net, outward: f64) -> Option<DVec3> {
    let last = net.control.len() - 1;
    let normal = (outward * (area(&net.control[last]) - area(&net.control[0]))).try_normalize()?;
    let origin = net.control[0][0];
    let is_level = net.control.iter().flatten().all(|point| (*point - origin).dot(normal).abs() <= LEVEL);
    is_level.then_some(normal)
}

/// Twice the area within a closed row of points, as a vector.
fn area(row: &[DVec3]) -> DVec3 {
    row.windows(2).map(|pair| (pair[0] - row[0]).cross(pair[1] - row[0])).sum()
}
