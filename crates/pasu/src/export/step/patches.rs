//! The patches of a shape as faces that share their sides: a closed shell where no side is free, an open one otherwise.

use glam::DVec3;

use super::exchange::{Entities, Id, integers, list, reals, string};
use super::net::{Deviation, PatchNet};
use super::sewn::{Sewn, boolean};
use super::spline::multiplicities;
use crate::face::kind_of;
use crate::patch::{ENDS, Lines, Side, SurfaceJet, first_corners};
use crate::solution::Placed;

/// At most so many nodes in a direction: a patch that needs more has creases inside, which no spline of its kind follows.
const MOST_NODES: usize = 257;

/// The part of the tolerance that each direction may use.
const SHARE: f64 = 0.4;

/// Samples in each direction of every interval by which the deviation is told: an odd number, since a cubic is farthest off in the middle.
const SAMPLES: usize = 5;

/// A shape in millimetres, fitted.
struct Fitted {
    nets: Vec<PatchNet>,
    sides: Vec<[Side; 4]>,
    /// For every corner the first that is the same point.
    corners: Vec<usize>,
    deviation: Deviation,
}

fn fit(placed: &Placed, millimetres: f64, tolerance: f64) -> Fitted {
    let patches = placed.solved().patches();
    let jet = |patch: usize, u: f64, v: f64| {
        let jet = placed.place(&patches[patch].jet(u, v));
        let scaled = |vector: DVec3| millimetres * vector;
        SurfaceJet {
            position: scaled(jet.position),
            du: scaled(jet.du),
            dv: scaled(jet.dv),
            duu: scaled(jet.duu),
            duv: scaled(jet.duv),
            dvv: scaled(jet.dvv),
        }
    };
    let mut lines = Lines::fewest_of(&patches);
    loop {
        let nets: Vec<PatchNet> = lines
            .iter()
            .enumerate()
            .map(|(patch, lines)| PatchNet::through(&lines.u, &lines.v, &|u, v| jet(patch, u, v)))
            .collect();
        let mut is_done = true;
        for (patch, (net, lines)) in nets.iter().zip(&mut lines).enumerate() {
            let [rows, columns] = net.rough(&|u, v| jet(patch, u, v), SHARE * tolerance);
            let mut halve = |nodes: &mut Vec<f64>, rough: Vec<usize>| {
                let has_room = nodes.len() + rough.len() <= MOST_NODES;
                is_done &= rough.is_empty() || !has_room;
                if has_room {
                    Lines::halve(nodes, rough);
                }
            };
            halve(&mut lines.u, rows);
            halve(&mut lines.v, columns);
        }
        if is_done {
            let mut deviation = Deviation::default();
            for (patch, net) in nets.iter().enumerate() {
                let of = net.deviation(&|u, v| jet(patch, u, v), SAMPLES);
                deviation.greatest = deviation.greatest.max(of.greatest);
                deviation.bound = deviation.bound.max(of.bound);
                deviation.n_samples += of.n_samples;
            }
            let sides = patches.iter().map(|patch| patch.sides()).collect();
            return Fitted { nets, sides, corners: first_corners(&patches), deviation };
        }
        Lines::share(&patches, &mut lines);
    }
}

/// Writes one shell of all patches of a part within the tolerance.
pub(super) fn sew(into: &mut Entities, name: &str, placed: &Placed, millimetres: f64, tolerance: f64) -> Sewn {
    let fitted = fit(placed, millimetres, tolerance);
    let is_closed = placed.solved().is_closed();
    let n = fitted.nets.len();
    let mut sewing = Sewing { into, fitted: &fitted, corners: vec![None; 4 * n], edges: vec![None; 4 * n] };
    let faces: Vec<Id> = (0..n).map(|patch| sewing.face(patch, placed.is_forwards(patch))).collect();
    let shape = if is_closed {
        let shell = into.add(&format!("CLOSED_SHELL('',{})", list(&faces)));
        into.add(&format!("MANIFOLD_SOLID_BREP({},{shell})", string(name)))
    } else {
        let shell = into.add(&format!("OPEN_SHELL('',{})", list(&faces)));
        into.add(&format!("SHELL_BASED_SURFACE_MODEL({},({shell}))", string(name)))
    };
    let faces = faces.into_iter().enumerate().map(|(patch, id)| (kind_of(placed, patch), id)).collect();
    let Deviation { greatest, bound, n_samples } = fitted.deviation;
    Sewn { shape, is_closed, faces, deviation: greatest, bound, n_samples }
}

struct Sewing<'a> {
    into: &'a mut Entities,
    fitted: &'a Fitted,
    /// Vertices by patch and corner, and edges by patch and side, of those that stand for all that are the same.
    corners: Vec<Option<Id>>,
    edges: Vec<Option<Id>>,
}

impl Sewing<'_> {
    fn face(&mut self, patch: usize, is_forwards: bool) -> Id {
        // Round the unit square with the inside to the left: along v = 0, u = 1, and back along v = 1, u = 0.
        let mut walk: Vec<(Id, bool)> = Vec::new();
        for (side, is_along) in [(2, true), (1, true), (3, false), (0, false)] {
            if let Some((edge, is_reversed)) = self.edge(patch, side) {
                walk.push((edge, is_along != is_reversed));
            }
        }
        if !is_forwards {
            walk.reverse();
            walk.iter_mut().for_each(|(_, is_along)| *is_along = !*is_along);
        }
        let oriented: Vec<Id> = walk
            .iter()
            .map(|(edge, is_along)| self.into.add(&format!("ORIENTED_EDGE('',*,*,{edge},{})", boolean(*is_along))))
            .collect();
        let edges = self.into.add(&format!("EDGE_LOOP('',{})", list(&oriented)));
        let bound = self.into.add(&format!("FACE_OUTER_BOUND('',{edges},.T.)"));
        let surface = self.surface(patch);
        self.into.add(&format!("ADVANCED_FACE('',({bound}),{surface},{})", boolean(is_forwards)))
    }

    fn surface(&mut self, patch: usize) -> Id {
        let net = &self.fitted.nets[patch];
        let rows: Vec<String> = net
            .control
            .iter()
            .map(|row| list(&row.iter().map(|point| self.into.point(*point)).collect::<Vec<_>>()))
            .collect();
        let is_joined = |side: usize| boolean(self.fitted.sides[patch][side] == Side::Joined);
        self.into.add(&format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',3,3,({}),.UNSPECIFIED.,{},{},.F.,{},{},{},{},.UNSPECIFIED.)",
            rows.join(","),
            is_joined(0),
            is_joined(2),
            integers(&multiplicities(net.u.len())),
            integers(&multiplicities(net.v.len())),
            reals(&net.u),
            reals(&net.v),
        ))
    }

    /// The side that stands for one, and whether it runs the other way.
    fn first_side(&self, patch: usize, side: usize) -> (usize, usize, bool) {
        match self.fitted.sides[patch][side] {
            Side::Joined => (patch, side - side % 2, false),
            Side::Shared { patch: other, side: others, is_reversed } if (other, others) < (patch, side) => {
                (other, others, is_reversed)
            }
            _ => (patch, side, false),
        }
    }

    /// The edge of a side and whether the side runs against it; none at a pole.
    fn edge(&mut self, patch: usize, side: usize) -> Option<(Id, bool)> {
        if self.fitted.sides[patch][side] == Side::Pole {
            return None;
        }
        let (patch, side, is_reversed) = self.first_side(patch, side);
        if let Some(edge) = self.edges[4 * patch + side] {
            return Some((edge, is_reversed));
        }
        let net = &self.fitted.nets[patch];
        let (points, nodes): (Vec<DVec3>, &[f64]) = match side {
            0 => (net.control[0].clone(), &net.v),
            1 => (net.control[net.control.len() - 1].clone(), &net.v),
            2 => (net.control.iter().map(|row| row[0]).collect(), &net.u),
            _ => (net.control.iter().map(|row| row[row.len() - 1]).collect(), &net.u),
        };
        let [from, to] = ENDS[side].map(|corner| self.vertex(patch, corner));
        let control: Vec<Id> = points.iter().map(|point| self.into.point(*point)).collect();
        let curve = self.into.add(&format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,{},.F.,{},{},.UNSPECIFIED.)",
            list(&control),
            boolean(from == to),
            integers(&multiplicities(nodes.len())),
            reals(nodes),
        ));
        let edge = self.into.add(&format!("EDGE_CURVE('',{from},{to},{curve},.T.)"));
        self.edges[4 * patch + side] = Some(edge);
        Some((edge, is_reversed))
    }

    fn vertex(&mut self, patch: usize, corner: usize) -> Id {
        let first = self.fitted.corners[4 * patch + corner];
        let (patch, corner) = (first / 4, first % 4);
        if let Some(vertex) = self.corners[4 * patch + corner] {
            return vertex;
        }
        let net = &self.fitted.nets[patch];
        let row = if corner < 2 { &net.control[0] } else { &net.control[net.control.len() - 1] };
        let point = self.into.point(if corner % 2 == 0 { row[0] } else { row[row.len() - 1] });
        let vertex = self.into.add(&format!("VERTEX_POINT('',{point})"));
        self.corners[4 * patch + corner] = Some(vertex);
        vertex
    }
}
