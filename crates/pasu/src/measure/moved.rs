//! What is measured of a part at the origin, where the part was moved to.

use glam::{DVec2, DVec3};

use super::capacity::{Capacity, Fill, Spill};
use super::curvature::{Curvature, CurvatureRange, Located};
use super::measures::{Body, Centre, LeastThickness, Overhang, PartMeasures, ThicknessRange};
use super::moments::Moments;
use super::quantity::{Quantity, ROUNDING};
use super::share::Share;
use super::standing::Footprint;
use crate::face::{Face, FaceJet, FaceKind, FaceWalk, Sealed, Seams};
use crate::solution::Columns;

/// A face that was moved.
pub(super) struct Moved<'a> {
    face: &'a dyn Face,
    by: DVec3,
}

impl<'a> Moved<'a> {
    pub(super) fn new(face: &'a dyn Face, by: DVec3) -> Moved<'a> {
        Moved { face, by }
    }
}

fn moved(jet: FaceJet, by: DVec3) -> FaceJet {
    FaceJet { position: jet.position + by, ..jet }
}

impl Sealed for Moved<'_> {}

impl Face for Moved<'_> {
    fn kind(&self) -> FaceKind {
        self.face.kind()
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        moved(self.face.jet(a, v), self.by)
    }

    fn walk(&self) -> Box<dyn FaceWalk + '_> {
        Box::new(MovedWalk { walk: self.face.walk(), by: self.by })
    }

    fn outward(&self) -> f64 {
        self.face.outward()
    }

    fn is_closed(&self) -> bool {
        self.face.is_closed()
    }

    fn goes_back(&self, v: f64) -> bool {
        self.face.goes_back(v)
    }

    fn passed_once(&self) -> Option<&dyn Face> {
        self.face.passed_once()
    }

    fn is_level(&self) -> bool {
        self.face.is_level()
    }

    fn is_exact(&self) -> bool {
        self.face.is_exact()
    }

    fn seams(&self) -> Option<Seams> {
        self.face.seams()
    }

    fn straight(&self, a: f64, v: f64) -> f64 {
        self.face.straight(a, v)
    }

    fn straight_walk(&self) -> Box<dyn FaceWalk + '_> {
        Box::new(MovedWalk { walk: self.face.straight_walk(), by: self.by })
    }

    fn columns(&self, places: Vec<f64>) -> Columns {
        self.face.columns(places)
    }
}

struct MovedWalk<'a> {
    walk: Box<dyn FaceWalk + 'a>,
    by: DVec3,
}

impl Sealed for MovedWalk<'_> {}

impl FaceWalk for MovedWalk<'_> {
    fn jet(&mut self, a: f64, v: f64) -> FaceJet {
        moved(self.walk.jet(a, v), self.by)
    }

    fn jet_at(&mut self, a: f64, columns: &Columns, column: usize) -> FaceJet {
        moved(self.walk.jet_at(a, columns, column), self.by)
    }
}

/// A coordinate that is found within an error, and what rounding adds to that where it is moved.
fn along(coordinate: Quantity, by: f64) -> Quantity {
    Quantity::new(coordinate.value + by, coordinate.error + ROUNDING * by.abs())
}

fn to(at: [f64; 3], by: DVec3) -> [f64; 3] {
    (DVec3::from_array(at) + by).to_array()
}

impl Moments {
    /// Of the same solid, moved.
    pub(super) fn moved(&self, by: DVec3) -> Moments {
        let first = core::array::from_fn(|i| {
            let beside = self.volume * by[i];
            self.first[i] + Quantity::new(beside.value, beside.error + ROUNDING * beside.value.abs())
        });
        Moments { volume: self.volume, first }
    }
}

impl Share {
    /// Of the same part, moved.
    pub(super) fn moved(self, by: DVec3) -> Share {
        Share { clay: self.clay.map(|clay| clay.moved(by)), water: self.water.map(|water| water.moved(by)) }
    }
}

impl PartMeasures {
    /// Of the same part, moved; `level` is where it is filled to after that.
    pub(super) fn moved(self, by: DVec3, level: Option<f64>) -> PartMeasures {
        let overhang = |leaning: Option<Overhang>| leaning.map(|found| Overhang { at: to(found.at, by), ..found });
        PartMeasures {
            body: self.body.moved(by, level),
            thickness: self.thickness.map(|found| ThicknessRange {
                least: LeastThickness { at: found.least.at.map(|at| to(at, by)), ..found.least },
                ..found
            }),
            overhang: overhang(self.overhang),
            overhang_inside: overhang(self.overhang_inside),
            curvature: self.curvature.moved(by),
            ..self
        }
    }
}

impl Body {
    fn moved(self, by: DVec3, level: Option<f64>) -> Body {
        let off = ROUNDING * by.abs().max_element();
        let mut centre = self.centre;
        for centre in [&mut centre.empty, &mut centre.full].into_iter().flatten() {
            *centre = Centre { at: to(centre.at, by), error: centre.error + off };
        }
        Body {
            bottom: self.bottom + by.z,
            top: self.top + by.z,
            capacity: self.capacity.map(|capacity| capacity.moved(by, level)),
            centre,
            footprint: self.footprint.map(|found| Footprint {
                level: found.level + by.z,
                hull: found.hull.into_iter().map(|p| (DVec2::from_array(p) + by.truncate()).to_array()).collect(),
                ..found
            }),
            ..self
        }
    }
}

impl Capacity {
    fn moved(self, by: DVec3, level: Option<f64>) -> Capacity {
        let Spill { level: spill, at } = self.spill;
        let spill = Spill { level: along(spill, by.z), at: to(at, by) };
        let fill = self.fill.map(|fill| {
            // What is asked for is told as it was asked for.
            let asked = level.filter(|level| level - by.z == fill.level);
            Fill { level: asked.unwrap_or(fill.level + by.z), ..fill }
        });
        Capacity { spill, floor: self.floor + by.z, fill, ..self }
    }
}

impl Curvature {
    fn moved(self, by: DVec3) -> Curvature {
        let located = |found: Option<Located>| found.map(|found| Located { at: to(found.at, by), ..found });
        let range =
            |CurvatureRange { least, greatest }| CurvatureRange { least: located(least), greatest: located(greatest) };
        Curvature { mean: range(self.mean), gaussian: range(self.gaussian) }
    }
}
