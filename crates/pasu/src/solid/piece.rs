//! One face of a pot.

use core::f64::consts::PI;
use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::crease::{Crease, Shoulder};
use super::curve::Curve;
use super::offset::SheetJet;
use super::sheet::{Sheet, SheetWalk, WallSide};
use super::skin::Skin;
use super::start::Start;
use super::thickness::Thickness;
use crate::face::{Face, FaceJet, FaceKind, FaceWalk, Sealed, Seams};
use crate::solution::Columns;

/// One smooth face of the boundary of a pot. Those of a pot follow on from each other: where one ends (`a = 1`) the next begins (`a = 0`).
#[derive(Debug, Clone)]
pub struct Piece {
    pub(crate) kind: FaceKind,
    pub(crate) form: Form,
    pub(crate) outward: f64,
    /// Whether all of it is in one plane across the axis.
    pub(crate) is_level: bool,
    pub(crate) is_exact: bool,
}

/// What a face is made of.
#[derive(Debug, Clone)]
pub(crate) enum Form {
    /// A side of the wall from where it begins to the rim or the next corner, or back.
    Sheet { sheet: Arc<Sheet>, is_back: bool },
    /// Straight lines from one curve to another.
    Ruled { from: Curve, to: Curve },
    /// Half circles over the strip from one end of two sheets to the other.
    Bead(Bead),
    /// Arcs round the foot of the surface, from beside it to where an offset sheet begins above it, or nothing where that begins no higher.
    Heel { sheet: Arc<Sheet> },
    /// Arcs round a corner of the profile, from the side below it to that above, or back.
    Shoulder { crease: Arc<Crease>, is_back: bool },
}

/// Into how many pieces a half circle is cut for rules of a few points.
const BEAD_PIECES: usize = 8;

/// A rounded rim: half circles from the end of one sheet to that of the other, in the planes of the wall's normal and the conormal of its edge.
#[derive(Debug, Clone)]
pub(crate) struct Bead {
    pub(crate) from: Arc<Sheet>,
    pub(crate) to: Arc<Sheet>,
    /// The end of the sheets: 0 or 1.
    pub(crate) at: f64,
}

/// What a face between two curves is at one `v`, whatever `a` is.
#[derive(Debug, Clone, Copy)]
enum Across {
    /// Straight from `(P, P_v)` to `(Q, Q_v)`.
    Ruled { from: (DVec3, DVec3), to: (DVec3, DVec3) },
    /// A half circle: its middle, the arm to where it begins and the outward bulge, each with its derivative.
    Bead { middle: DVec3, arm: DVec3, out: DVec3, dmiddle: DVec3, darm: DVec3, dout: DVec3 },
    /// An arc, or one that is run through backwards.
    Shoulder { shoulder: Shoulder, is_back: bool },
}

impl Across {
    fn jet(&self, a: f64) -> FaceJet {
        match *self {
            Across::Ruled { from: (p, dp), to: (q, dq) } => {
                FaceJet { position: p + (q - p) * a, da: q - p, dv: dp + (dq - dp) * a }
            }
            Across::Bead { middle, arm, out, dmiddle, darm, dout } => {
                let (c, s) = (libm::cos(PI * a), libm::sin(PI * a));
                FaceJet {
                    position: middle + arm * c + out * s,
                    da: (out * c - arm * s) * PI,
                    dv: dmiddle + darm * c + dout * s,
                }
            }
            Across::Shoulder { shoulder, is_back: false } => shoulder.jet(a),
            Across::Shoulder { shoulder, is_back: true } => {
                let jet = shoulder.jet(1.0 - a);
                FaceJet { da: -jet.da, ..jet }
            }
        }
    }
}

/// The most columns that a walk remembers.
const REMEMBERED: usize = 1 << 14;

/// A walk over a face between two curves, which remembers what it has met at each `v`.
struct AcrossWalk<'a> {
    piece: &'a Piece,
    known: BTreeMap<u64, Across>,
}

impl Sealed for AcrossWalk<'_> {}

impl FaceWalk for AcrossWalk<'_> {
    fn jet(&mut self, a: f64, v: f64) -> FaceJet {
        if let Some(across) = self.known.get(&v.to_bits()) {
            return across.jet(a);
        }
        let Some(across) = self.piece.form.across(v) else { return self.piece.jet(a, v) };
        if self.known.len() < REMEMBERED {
            self.known.insert(v.to_bits(), across);
        }
        across.jet(a)
    }
}

impl Form {
    /// What it is at one `v`; `None` for a side of the wall.
    fn across(&self, v: f64) -> Option<Across> {
        match self {
            Form::Sheet { .. } => None,
            Form::Ruled { from, to } => Some(Across::Ruled { from: from.at(v), to: to.at(v) }),
            Form::Bead(bead) => Some(bead.across(v)),
            Form::Heel { sheet } => Some(match sheet.heel(v) {
                Some(shoulder) => Across::Shoulder { shoulder, is_back: false },
                None => {
                    let start = Curve::Start(Arc::clone(sheet)).at(v);
                    Across::Ruled { from: start, to: start }
                }
            }),
            Form::Shoulder { crease, is_back } => {
                Some(Across::Shoulder { shoulder: crease.shoulder(v), is_back: *is_back })
            }
        }
    }
}

impl Bead {
    fn across(&self, v: f64) -> Across {
        let [from, to] = [&self.from, &self.to].map(|sheet| sheet.jet(self.at, v));
        let (middle, arm) = ((from.position + to.position) * 0.5, (from.position - to.position) * 0.5);
        let (dmiddle, darm) = ((from.dv + to.dv) * 0.5, (from.dv - to.dv) * 0.5);
        Across::Bead { middle, arm, out: self.bulge(v), dmiddle, darm, dout: self.bulge_v(v) }
    }

    /// Whether one of its sides is a surface of its own: then the way across the wall is not along the normal.
    fn is_lined(&self) -> bool {
        self.from.is_lining() || self.to.is_lining()
    }

    /// At right angles to the way across the wall and to its edge, half as long as the wall is thick; how it changes round the rim.
    fn bulge_across(&self, v: f64) -> [DVec3; 2] {
        let [from, to] = [&self.from, &self.to].map(|sheet| sheet.skin().second(self.at, v));
        let (arm, darm) = ((from.position - to.position) * 0.5, (from.dv - to.dv) * 0.5);
        let (edge, dedge) = ((from.dv + to.dv) * 0.5, (from.dvv + to.dvv) * 0.5);
        let (c, dc) = (arm.cross(edge), darm.cross(edge) + arm.cross(dedge));
        let (length, width) = (c.length(), arm.length());
        if !(length > 0.0 && width > 0.0) {
            return [DVec3::ZERO; 2];
        }
        let unit = c / length;
        let along = self.from.skin().second(self.at, v).du * (self.at - 0.5);
        let sign = if unit.dot(along) < 0.0 { -1.0 } else { 1.0 };
        let dunit = (dc - unit * unit.dot(dc)) / length;
        [unit * (sign * width), (dunit * width + unit * (arm.dot(darm) / width)) * sign]
    }

    /// The outward conormal times half the thickness.
    fn bulge(&self, v: f64) -> DVec3 {
        if self.is_lined() {
            return self.bulge_across(v)[0];
        }
        let [from, to] = [&self.from, &self.to].map(|sheet| sheet.jet(self.at, v).position);
        let jet = self.from.skin().jet(self.at, v);
        let conormal = jet.normal.cross(jet.dv).normalize_or_zero();
        let outward = if conormal.dot(jet.ds) * (self.at - 0.5) < 0.0 { -conormal } else { conormal };
        outward * (0.5 * (from - to).length())
    }

    fn bulge_v(&self, v: f64) -> DVec3 {
        if self.is_lined() {
            return self.bulge_across(v)[1];
        }
        let [from, to] = [&self.from, &self.to].map(|sheet| sheet.jet(self.at, v));
        let skin = self.from.skin();
        let (jet, second) = (skin.jet(self.at, v), skin.second(self.at, v));
        let (c, dc) = (jet.normal.cross(jet.dv), jet.normal_v.cross(jet.dv) + jet.normal.cross(second.dvv));
        let length = c.length();
        if !(length > 0.0) {
            return DVec3::ZERO;
        }
        let conormal = c / length;
        let sign = if conormal.dot(jet.ds) * (self.at - 0.5) < 0.0 { -1.0 } else { 1.0 };
        let dconormal = (dc - conormal * conormal.dot(dc)) / length;
        let across = from.position - to.position;
        let thickness = across.length();
        let dthickness = if thickness > 0.0 { across.dot(from.dv - to.dv) / thickness } else { 0.0 };
        (dconormal * thickness + conormal * dthickness) * (0.5 * sign)
    }
}

impl Piece {
    /// The surface of a design from foot to rim, as the outside.
    pub(crate) fn surface(skin: &Arc<Skin>) -> Piece {
        let form = Form::Sheet {
            sheet: Arc::new(Sheet::whole(skin, &Arc::new(Thickness::Even(0.0)), WallSide::Design)),
            is_back: false,
        };
        Piece { kind: FaceKind::Outer, form, outward: skin.outward(), is_level: false, is_exact: true }
    }

    /// Whether it is straight for every `v`.
    pub(crate) fn is_straight(&self) -> bool {
        matches!(self.form, Form::Ruled { .. })
    }
}

impl Sealed for Piece {}

impl Face for Piece {
    fn kind(&self) -> FaceKind {
        self.kind
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        match &self.form {
            Form::Sheet { sheet, is_back } => on_sheet(sheet, *is_back, a, v, |s, v| sheet.jet(s, v)),
            form => form.across(v).map(|across| across.jet(a)).unwrap_or_default(),
        }
    }

    fn walk(&self) -> Box<dyn FaceWalk + '_> {
        let Form::Sheet { sheet, is_back } = &self.form else {
            return Box::new(AcrossWalk { piece: self, known: BTreeMap::new() });
        };
        Box::new(PieceWalk { sheet, walk: sheet.walk(), is_back: *is_back })
    }

    fn outward(&self) -> f64 {
        self.outward
    }

    fn is_level(&self) -> bool {
        self.is_level
    }

    fn seams(&self) -> Option<Seams> {
        match &self.form {
            Form::Sheet { sheet, .. } => {
                let (along, round) = sheet.knots()?;
                Some(Seams { along, round, crossings: sheet.crossings().to_vec(), rough: sheet.rough(), cost: 1 })
            }
            Form::Ruled { from, to } => {
                let ends = [from.seamed(), to.seamed()];
                let (_, mut round) = ends.iter().flatten().find_map(|(sheet, _)| sheet.knots())?;
                for (sheet, _) in ends.iter().flatten().filter(|(_, begins)| *begins) {
                    round.extend(sheet.crossings());
                }
                Some(Seams::across(1, round))
            }
            Form::Bead(Bead { from, to, .. }) => {
                let (_, round) = from.knots().or_else(|| to.knots())?;
                Some(Seams::across(BEAD_PIECES, round))
            }
            Form::Heel { sheet } => {
                let (_, mut round) = sheet.knots()?;
                round.extend(sheet.crossings());
                Some(Seams::across(BEAD_PIECES, round))
            }
            Form::Shoulder { crease, .. } => {
                let (_, round) = crease.knots()?;
                Some(Seams::across(BEAD_PIECES, round))
            }
        }
    }

    fn straight(&self, a: f64, v: f64) -> f64 {
        let Form::Sheet { sheet, is_back } = &self.form else { return a };
        let (start, end, share) = (sheet.start(v).s, sheet.end(v).s, if *is_back { 1.0 - a } else { a });
        if share == 1.0 { end } else { start + share * (end - start) }
    }

    fn straight_walk(&self) -> Box<dyn FaceWalk + '_> {
        match &self.form {
            Form::Sheet { sheet, is_back } => Box::new(StraightWalk { walk: sheet.walk(), is_back: *is_back }),
            _ => self.walk(),
        }
    }

    fn columns(&self, places: Vec<f64>) -> Columns {
        match &self.form {
            Form::Sheet { sheet, .. } => sheet.skin().columns_at(places),
            _ => Columns::plain(places),
        }
    }

    fn is_exact(&self) -> bool {
        self.is_exact
    }
}

/// The jet of the face that is a sheet from where it begins to where it ends, or back.
fn on_sheet(sheet: &Sheet, is_back: bool, a: f64, v: f64, jet: impl FnOnce(f64, f64) -> SheetJet) -> FaceJet {
    let (Start { s: start, dv }, Start { s: end, dv: end_dv }) = (sheet.start(v), sheet.end(v));
    let share = if is_back { 1.0 - a } else { a };
    let length = end - start;
    let jet = jet(if share == 1.0 { end } else { start + share * length }, v);
    let along = if is_back { -length } else { length };
    let mut turned = (1.0 - share) * dv;
    if end_dv != 0.0 {
        turned += share * end_dv;
    }
    FaceJet { position: jet.position, da: jet.ds * along, dv: jet.dv + jet.ds * turned }
}

/// A face that is a sheet, in its own coordinates.
struct PieceWalk<'a> {
    sheet: &'a Sheet,
    walk: SheetWalk<'a>,
    is_back: bool,
}

impl Sealed for PieceWalk<'_> {}

impl FaceWalk for PieceWalk<'_> {
    fn jet(&mut self, a: f64, v: f64) -> FaceJet {
        on_sheet(self.sheet, self.is_back, a, v, |s, v| self.walk.jet(s, v))
    }

    fn jet_at(&mut self, a: f64, columns: &Columns, column: usize) -> FaceJet {
        on_sheet(self.sheet, self.is_back, a, columns.v(column), |s, _| self.walk.jet_at(s, columns, column))
    }
}

/// A sheet in the coordinates of the whole.
struct StraightWalk<'a> {
    walk: SheetWalk<'a>,
    is_back: bool,
}

impl StraightWalk<'_> {
    fn turned(&self, jet: &SheetJet) -> FaceJet {
        FaceJet { position: jet.position, da: if self.is_back { -jet.ds } else { jet.ds }, dv: jet.dv }
    }
}

impl Sealed for StraightWalk<'_> {}

impl FaceWalk for StraightWalk<'_> {
    fn jet(&mut self, s: f64, v: f64) -> FaceJet {
        let jet = self.walk.jet(s, v);
        self.turned(&jet)
    }

    fn jet_at(&mut self, s: f64, columns: &Columns, column: usize) -> FaceJet {
        let jet = self.walk.jet_at(s, columns, column);
        self.turned(&jet)
    }
}
