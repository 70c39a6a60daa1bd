//! An open network with a thickness: what is beside it at a distance along its normals, and rims between the two where it ends.
//!
//! The other side is a network of the same frames, through the points that lie the thickness along the normal from those of the first. So it has its edges in common where that has, bounds of its own and a closed form; between its
//! points it keeps the thickness as far as patches follow each other, which is looked into, and refused with the place where it does not. At a crease a point goes where it has the thickness from every patch that meets there.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use super::four_sided::FourSided;
use super::network::SIDES;
use super::orientation::Lay;
use super::ruled::Ruled;
use super::solve::Frame;
use crate::design::VertexFrame;
use crate::error::Error;
use crate::patch::{Patch, Side};

/// The eight points of a frame in the unit square.
const PLACES: [(f64, f64); 8] =
    [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0), (0.5, 1.0), (0.0, 1.0), (0.0, 0.5)];

/// How far a point goes at a crease at most, in thicknesses: there the sides of the crease are at about 40 degrees to each other.
const LONGEST: f64 = 3.0;

/// Normals that lie nearer to a plane or a line than this part are taken for one that does: what they differ by says nothing of a direction.
const FLAT: f64 = 0.01;

/// Samples each way of a patch at which the thickness is looked into, and between which parts of what was asked for it has to be.
const SAMPLES: usize = 8;
const EVEN: [f64; 2] = [0.5, 2.0];

/// The patches of an open network on both sides of its clay, with the rims between.
#[derive(Debug)]
pub(crate) struct Shell {
    patches: Vec<Box<dyn Patch>>,
    is_outward: Vec<bool>,
    crease: f64,
    /// How many patches the network has.
    n_own: usize,
    /// Whether the clay is outside of the network.
    is_outside: bool,
    /// The thinnest of the places that were looked into, and where it is before the network is placed.
    thinnest: (f64, DVec3),
}

/// Where a patch of a shell lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Lie {
    /// Outside of the clay.
    Outer,
    /// On its inside.
    Inner,
    /// Between the two, along a free edge.
    Rim,
}

/// What is asked of a shell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Thick {
    /// The thickness where the network stands.
    pub(crate) thickness: f64,
    /// Whether the clay is outside of the network.
    pub(crate) is_outside: bool,
    /// What turns and stretches the network.
    pub(crate) matrix: DMat3,
}

/// Why a network cannot have a thickness; places are of the network before it is placed.
#[derive(Debug)]
pub(crate) enum NoShell {
    /// It has one side only.
    OneSided,
    /// There is no normal.
    NoNormal(DVec3),
    /// Patches meet at a crease so sharp that the other side is far away.
    Sharp(DVec3),
    /// It bends more sharply than the wall is thick: the other side is turned over.
    Folded(DVec3),
    /// So thick the wall would be.
    Uneven(DVec3, f64),
    /// Free edges touch in a point.
    Touching(DVec3),
    /// The other side is no network.
    Other(Error),
}

impl Frame {
    /// The shell of this network, the solution of `shape`, whose path in its design is `path`.
    ///
    /// # Errors
    /// See [`NoShell`].
    pub(crate) fn shell(&self, shape: &VertexFrame, asked: Thick, path: &str) -> core::result::Result<Shell, NoShell> {
        let Thick { thickness, is_outside, matrix } = asked;
        if !self.is_two_sided() {
            return Err(NoShell::OneSided);
        }
        let mirrored = if matrix.determinant() < 0.0 { -1.0 } else { 1.0 };
        let normals = self.normals(matrix, mirrored);
        let inverse = matrix.inverse();
        let towards = if is_outside { thickness } else { -thickness };
        let mut moved = shape.clone();
        for (vertex, of) in moved.vertices.iter_mut().zip(normals_of_vertices(shape, &normals)) {
            if !of.is_used {
                continue;
            }
            let at = DVec3::from_array(*vertex);
            let mitre = of.mitre().ok_or(NoShell::NoNormal(at))?;
            if !(mitre.length() <= LONGEST) {
                return Err(NoShell::Sharp(at));
            }
            *vertex = (at + inverse * (mitre * towards)).to_array();
        }
        let other = Frame::solve(&moved, path).map_err(NoShell::Other)?;
        let thinnest = self.refuse_uneven(&other, &normals, matrix, towards)?;
        let shell = self.joined(shape, &other, is_outside).map_err(NoShell::Touching)?;
        Ok(Shell { thinnest, ..shell })
    }

    /// The unit normals of every patch at its eight points, outwards where the network stands; none where there is none.
    fn normals(&self, matrix: DMat3, mirrored: f64) -> Vec<[Option<DVec3>; 8]> {
        let one = |(patch, is_outward): (&Arc<FourSided>, &bool)| {
            let sign = if *is_outward { mirrored } else { -mirrored };
            PLACES.map(|(u, v)| {
                let jet = patch.jet(u, v);
                (matrix * jet.du).cross(matrix * jet.dv).try_normalize().map(|normal| normal * sign)
            })
        };
        self.shared_patches().iter().zip(self.is_outward()).map(one).collect()
    }

    /// Where the wall is thinnest of all samples. Refuses another side that is turned over against this one, or too near or too far along its normal: of all samples the one that is off by the most.
    ///
    /// # Errors
    /// `Folded` and `Uneven`.
    fn refuse_uneven(
        &self,
        other: &Frame,
        normals: &[[Option<DVec3>; 8]],
        matrix: DMat3,
        towards: f64,
    ) -> core::result::Result<(f64, DVec3), NoShell> {
        let mut worst: Option<(f64, f64, DVec3)> = None;
        let mut thinnest = (f64::INFINITY, DVec3::ZERO);
        for ((one, other), known) in self.shared_patches().iter().zip(other.shared_patches()).zip(normals) {
            // All of a patch lies as its first normal does.
            let Some((place, normal)) = known.iter().enumerate().find_map(|(k, normal)| Some((k, (*normal)?))) else {
                continue;
            };
            let across = |patch: &FourSided, u: f64, v: f64| {
                let jet = patch.jet(u, v);
                (jet.position, (matrix * jet.du).cross(matrix * jet.dv))
            };
            let (u, v) = PLACES[place];
            let sign = across(one, u, v).1.dot(normal).signum();
            for k in 0..(SAMPLES + 1) * (SAMPLES + 1) {
                let (u, v) = ((k / (SAMPLES + 1)) as f64 / SAMPLES as f64, (k % (SAMPLES + 1)) as f64 / SAMPLES as f64);
                let ((here, element), (there, other_element)) = (across(one, u, v), across(other, u, v));
                let Some(normal) = element.try_normalize() else { continue };
                if !(other_element.dot(normal) > 0.0) {
                    return Err(NoShell::Folded(here));
                }
                let thick = (matrix * (there - here)).dot(normal) * sign / towards;
                if thick * towards.abs() < thinnest.0 {
                    thinnest = (thick * towards.abs(), here);
                }
                let off = if thick > 1.0 { thick / EVEN[1] } else { EVEN[0] / thick.max(f64::MIN_POSITIVE) };
                if worst.is_none_or(|(most, ..)| off > most) {
                    worst = Some((off, thick * towards.abs(), here));
                }
            }
        }
        match worst {
            Some((off, thick, at)) if !(off <= 1.0) => Err(NoShell::Uneven(at, thick)),
            _ => Ok(thinnest),
        }
    }

    /// Both sides and the rims between their free edges.
    ///
    /// # Errors
    /// A vertex in which other than two free edges meet.
    fn joined(&self, shape: &VertexFrame, other: &Frame, is_outside: bool) -> core::result::Result<Shell, DVec3> {
        let n = self.n_patches();
        let mut sides: Vec<[Side; 4]> = self.shared_patches().iter().map(|patch| patch.sides()).collect();
        let second = sides.iter().map(|sides| sides.map(|side| beside(side, n)));
        let mut all: Vec<[Side; 4]> = sides.iter().copied().chain(second).collect();
        let free: Vec<(usize, usize)> =
            (0..4 * n).map(|k| (k / 4, k % 4)).filter(|(patch, side)| sides[*patch][*side] == Side::Free).collect();
        sides.clear();
        // Which rims end in a vertex, and at which of their ends.
        let mut ends: Vec<(u32, usize, usize)> = Vec::with_capacity(2 * free.len());
        for (rim, (patch, side)) in free.iter().enumerate() {
            let [from, _, to] = SIDES[*side].map(|place| shape.patches[*patch].frame[place]);
            ends.extend([(from, rim, 0), (to, rim, 1)]);
        }
        ends.sort_unstable();
        let mut rims = vec![[Side::Free; 4]; free.len()];
        for met in ends.chunk_by(|one, other| one.0 == other.0) {
            let [(_, one, end), (_, two, other_end)] = *met else {
                let vertex = met.first().and_then(|(vertex, ..)| shape.vertices.get(*vertex as usize));
                return Err(vertex.map_or(DVec3::ZERO, |at| DVec3::from_array(*at)));
            };
            let shared = |rim: usize, side: usize| Side::Shared { patch: 2 * n + rim, side, is_reversed: false };
            rims[one][end] = shared(two, other_end);
            rims[two][other_end] = shared(one, end);
        }
        for (rim, (patch, side)) in free.iter().enumerate() {
            let shared = |patch: usize, side: usize| Side::Shared { patch, side, is_reversed: false };
            all[*patch][*side] = shared(2 * n + rim, 2);
            all[n + patch][*side] = shared(2 * n + rim, 3);
            rims[rim][2] = shared(*patch, *side);
            rims[rim][3] = shared(n + patch, *side);
        }
        all.extend(rims);
        let lay = Lay::of(&all);
        let mut is_outward: Vec<bool> = self.is_outward().iter().map(|is_outward| *is_outward != is_outside).collect();
        is_outward.extend_from_within(..);
        is_outward[n..].iter_mut().for_each(|is_outward| *is_outward = !*is_outward);
        for (rim, (patch, _)) in free.iter().enumerate() {
            is_outward.push(is_outward[*patch] != (lay.is_against(*patch) != lay.is_against(2 * n + rim)));
        }
        let with_sides = |frame: &Frame, from: usize| -> Vec<Arc<FourSided>> {
            let numbered = frame.shared_patches().iter().enumerate();
            numbered.map(|(index, patch)| Arc::new(patch.between(all[from + index]))).collect()
        };
        let (one, two) = (with_sides(self, 0), with_sides(other, n));
        let rim = |(rim, (patch, side)): (usize, &(usize, usize))| {
            let edges = [Arc::clone(&one[*patch]), Arc::clone(&two[*patch])];
            Box::new(Ruled::between(edges, *side, all[2 * n + rim])) as Box<dyn Patch>
        };
        let rims: Vec<Box<dyn Patch>> = free.iter().enumerate().map(rim).collect();
        let both = one.iter().chain(&two).map(|patch| Box::new(FourSided::clone(patch)) as Box<dyn Patch>);
        let patches = both.chain(rims).collect();
        let thinnest = (f64::INFINITY, DVec3::ZERO);
        Ok(Shell { patches, is_outward, crease: self.crease(), n_own: n, is_outside, thinnest })
    }
}

/// The same side of patches whose numbers are so much larger.
fn beside(side: Side, n: usize) -> Side {
    match side {
        Side::Shared { patch, side, is_reversed } => Side::Shared { patch: patch + n, side, is_reversed },
        other => other,
    }
}

/// What the normals of the patches at a point add up to.
#[derive(Debug, Clone, Default)]
struct Gathered {
    is_used: bool,
    sum: DVec3,
    /// The sum of `N N^T`.
    squares: Matrix3<f64>,
}

impl Gathered {
    /// Where a point at distance 1 from all planes through the origin with these normals is: the least squares of `N m = 1`, the shortest of them, without directions that the normals hardly have.
    fn mitre(&self) -> Option<DVec3> {
        let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(self.squares);
        let largest = eigenvalues.max();
        let sum = Vector3::from(self.sum.to_array());
        let mut mitre = Vector3::zeros();
        for (value, axis) in eigenvalues.iter().zip(eigenvectors.column_iter()) {
            if *value > FLAT * largest {
                mitre += axis * (axis.dot(&sum) / value);
            }
        }
        (largest > 0.0 && mitre.norm() > 0.0).then(|| DVec3::new(mitre.x, mitre.y, mitre.z))
    }
}

fn normals_of_vertices(shape: &VertexFrame, normals: &[[Option<DVec3>; 8]]) -> Vec<Gathered> {
    let mut gathered = vec![Gathered::default(); shape.vertices.len()];
    for (patch, normals) in shape.patches.iter().zip(normals) {
        for (vertex, normal) in patch.frame.iter().zip(normals) {
            let Some(of) = gathered.get_mut(*vertex as usize) else { continue };
            of.is_used = true;
            if let Some(normal) = normal {
                of.sum += *normal;
                let column = Vector3::from(normal.to_array());
                of.squares += column * column.transpose();
            }
        }
    }
    gathered
}

impl Shell {
    /// One of the patches; the first in place of one that there is not: those of the network, as many on the other side, and the rims.
    pub(crate) fn patch(&self, index: usize) -> &dyn Patch {
        &**self.patches.get(index).unwrap_or(&self.patches[0])
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        self.patches.len()
    }

    /// Where one of the patches lies: the network is the outer side of clay that is laid inwards.
    pub(crate) fn lie(&self, index: usize) -> Lie {
        match index / self.n_own {
            0 if self.is_outside => Lie::Inner,
            1 if !self.is_outside => Lie::Inner,
            0 | 1 => Lie::Outer,
            _ => Lie::Rim,
        }
    }

    /// For each patch whether `X_u x X_v` points out of the clay.
    pub(crate) fn is_outward(&self) -> &[bool] {
        &self.is_outward
    }

    /// How thick it is where it is thinnest of the places that were looked into, and where that is before the network is placed.
    pub(crate) fn thinnest(&self) -> (f64, DVec3) {
        self.thinnest
    }

    /// As [`Frame::crease`].
    pub(crate) fn crease(&self) -> f64 {
        self.crease
    }
}
