//! The two sides of a wall: the design surface, and the surface at a distance from it.

use core::f64::consts::TAU;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use glam::DVec3;

use super::bridge::Bridge;
use super::crease::{Crease, Foot, Shoulder};
use super::offset::{SheetJet, offset};
use super::skin::{Skin, SkinJet, SkinWalk};
use super::start::Start;
use super::thickness::{SplineRow, Thickness};
use crate::numeric::scattered::Scatter;
use crate::numeric::{bisection, illinois};
use crate::patch::SurfaceJet;
use crate::solution::{Columns, Stretch};

/// The most columns whose beginning is remembered.
const REMEMBERED: usize = 1 << 16;

/// Rows at which a column is looked through for where it begins.
const ROWS: usize = 96;

/// Columns whose beginnings differ by no more than this begin together.
const COMMON: f64 = 1e-12;

/// Halvings of the gap between two knots until the place where a column passes one is known: what is left is far below rounding, because only second derivatives jump there.
const HALVINGS: usize = 20;

/// The most such places.
const MOST_CROSSINGS: usize = 1 << 14;

/// Jets of one place of a sheet after the other, which share what depends on `s` alone.
pub(crate) struct SheetWalk<'a> {
    sheet: &'a Sheet,
    walk: SkinWalk<'a>,
    row: Option<SplineRow>,
}

/// Which side of the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum WallSide {
    /// The surface of the design.
    Design,
    /// `X + direction t N`, with `direction` 1 for outwards and -1 for inwards.
    Offset { direction: f64 },
    /// A surface of its own.
    Lining,
}

/// Where the columns of a sheet begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Trim {
    /// At the foot.
    Foot,
    /// Above a level: the last place, seen from the foot, where the sheet rises above it; at the foot where all of a column is above.
    Level(f64),
    /// Outside a cylinder of this radius round the axis of the foot: the last place where the sheet leaves it.
    Cylinder(f64),
}

/// One side of a wall between two corners of the profile or ends: `S(s, v)` from where its columns begin to where they end.
///
/// At a corner that is [mitred](Crease) a column of the other side of the wall is led a little beside itself, in proportion to the way from one end to the other, so that it meets that of the neighbour.
#[derive(Debug)]
pub(crate) struct Sheet {
    skin: Arc<Skin>,
    thickness: Arc<Thickness>,
    face: WallSide,
    stretch: Stretch,
    /// The corners at which it begins and ends.
    creases: [Option<Arc<Crease>>; 2],
    /// Whether columns are led beside themselves.
    is_led: bool,
    trim: Trim,
    /// For even columns the numbers of the rows between which they begin; none for a column that is all above.
    brackets: Vec<Option<usize>>,
    /// Even columns that are above by more than neighbours differ: what is between two of them is all above, too.
    clear: Vec<bool>,
    /// Over where the beginning of columns leaps; only at a level, where straight lines lead down from a bridge.
    bridges: Vec<Bridge>,
    /// Where all columns begin, if they begin at the same place.
    common: Option<f64>,
    /// Columns that were asked for.
    starts: Mutex<HashMap<u64, Start, Scatter>>,
    crossings: OnceLock<Vec<f64>>,
}

impl Sheet {
    /// All of a side, from foot to rim, whatever corners it has.
    pub(crate) fn whole(skin: &Arc<Skin>, thickness: &Arc<Thickness>, face: WallSide) -> Sheet {
        Sheet {
            skin: Arc::clone(skin),
            thickness: Arc::clone(thickness),
            face,
            stretch: Stretch::WHOLE,
            creases: [None, None],
            is_led: false,
            trim: Trim::Foot,
            brackets: Vec::new(),
            clear: Vec::new(),
            bridges: Vec::new(),
            common: Some(0.0),
            starts: Mutex::default(),
            crossings: OnceLock::new(),
        }
    }

    /// What of a side lies between two corners or ends.
    pub(super) fn between(
        skin: &Arc<Skin>,
        thickness: &Arc<Thickness>,
        face: WallSide,
        stretch: Stretch,
        creases: [Option<Arc<Crease>>; 2],
    ) -> Sheet {
        let is_led = creases.iter().flatten().any(|crease| !crease.is_even());
        let common = match &creases[0] {
            Some(crease) if crease.is_even() => Some(crease.foot(1, 0.0).s),
            Some(_) => None,
            None => Some(stretch.from),
        };
        Sheet { stretch, creases, is_led, common, ..Sheet::whole(skin, thickness, face) }
    }

    /// The same from where its columns rise, for the last time, above a level or out of a cylinder; what is below by no more than `slack` is not.
    pub(super) fn trimmed(self, trim: Trim, slack: f64) -> (Sheet, Trimmed) {
        let mut sheet = Sheet { trim, common: None, ..self };
        let columns = sheet.skin.columns(sheet.skin.round().count());
        let mut walk = sheet.walk();
        let all: Vec<[f64; 2]> = (0..columns.len()).map(|j| sheet.all(columns.v(j))).collect();
        // From the end down, row by row: the first row at which a column is below.
        let mut below = vec![None; columns.len()];
        // How far each stays above, and how far neighbours are apart at most.
        let (mut least, mut apart) = (vec![f64::INFINITY; columns.len()], 0.0f64);
        for i in (0..=ROWS).rev() {
            let mut before: Option<(usize, f64)> = None;
            for (j, below) in below.iter_mut().enumerate().filter(|(_, below)| below.is_none()) {
                let height = sheet.height(walk.position_at(sheet.row(i, all[j]), &columns, j));
                if height < -slack {
                    *below = Some(i);
                }
                least[j] = least[j].min(height);
                if let Some((_, beside)) = before.filter(|(left, _)| left + 1 == j) {
                    apart = apart.max((height - beside).abs());
                }
                before = Some((j, height));
            }
        }
        drop(walk);
        let column = |is_meant: &dyn Fn(&Option<usize>) -> bool| below.iter().position(is_meant).map(|j| columns.v(j));
        if let Some(under) = column(&|row| *row == Some(ROWS)) {
            let is_all = below.iter().all(|row| *row == Some(ROWS));
            return (sheet, if is_all { Trimmed::Away } else { Trimmed::Across(under) });
        }
        let (above, cut) = (column(&|row| row.is_none()), column(&|row| row.is_some()));
        sheet.clear = below.iter().zip(least).map(|(below, least)| below.is_none() && least > apart).collect();
        sheet.brackets = below;
        let starts: Vec<f64> = sheet.skin.round().map(|v| sheet.start(v).s).collect();
        let (least, most) = starts.iter().fold((1.0f64, 0.0f64), |(least, most), s| (least.min(*s), most.max(*s)));
        if most - least <= COMMON {
            sheet.common = Some(0.5 * (least + most));
        } else if let Trim::Level(_) = trim {
            let round: Vec<f64> = sheet.skin.round().collect();
            sheet.bridges = Bridge::all(&round, &mut |v| sheet.start(v));
            if !sheet.bridges.is_empty() {
                sheet.starts = Mutex::default();
            }
        }
        (sheet, Trimmed::There { above, cut })
    }

    /// From where to where a column goes that is not trimmed.
    fn all(&self, v: f64) -> [f64; 2] {
        self.feet(v).map(|foot| foot.s)
    }

    /// The place of one of so many rows of a column between two places.
    fn row(&self, index: usize, [from, to]: [f64; 2]) -> f64 {
        from + (to - from) * (index as f64 / ROWS as f64)
    }

    /// The corners or ends between which it lies, at one column.
    fn feet(&self, v: f64) -> [Foot; 2] {
        let [start, end] = &self.creases;
        [
            start.as_ref().map_or(Foot::at(self.stretch.from), |crease| crease.foot(1, v)),
            end.as_ref().map_or(Foot::at(self.stretch.to), |crease| crease.foot(0, v)),
        ]
    }

    /// Where the column at `v` ends.
    pub(crate) fn end(&self, v: f64) -> Start {
        let Foot { s, s_v: dv, .. } = self.feet(v)[1];
        Start { s, dv }
    }

    /// Where columns begin at the earliest, and end at the latest, where nothing is cut off.
    pub(crate) fn stretch(&self) -> Stretch {
        self.stretch
    }

    pub(crate) fn skin(&self) -> &Skin {
        &self.skin
    }

    /// Whether the jets are those of the true surface.
    pub(crate) fn is_exact(&self) -> bool {
        !self.is_offset() || self.thickness.is_even()
    }

    /// Whether this is the surface of the design from one corner or end to the next.
    pub(crate) fn is_whole_design(&self) -> bool {
        self.face == WallSide::Design && self.trim == Trim::Foot
    }

    /// Whether this is the side at a distance from the surface of the design.
    pub(crate) fn is_offset(&self) -> bool {
        matches!(self.face, WallSide::Offset { .. })
    }

    /// Whether this is a lining of its own.
    pub(crate) fn is_lining(&self) -> bool {
        self.face == WallSide::Lining
    }

    /// Whether any column is all above the level.
    pub(crate) fn has_column_above(&self) -> bool {
        matches!(self.trim, Trim::Level(_)) && self.brackets.contains(&None)
    }

    /// Whether any column begins above the level because the next ones do.
    pub(crate) fn has_column_bridged(&self) -> bool {
        !self.bridges.is_empty()
    }

    /// Whether any column is cut.
    pub(crate) fn has_column_cut(&self) -> bool {
        self.brackets.iter().any(Option::is_some)
    }

    /// Position and derivatives with respect to `s` and `v`.
    pub(crate) fn jet(&self, s: f64, v: f64) -> SheetJet {
        self.walk().jet(s, v)
    }

    /// One place after the other.
    pub(crate) fn walk(&self) -> SheetWalk<'_> {
        SheetWalk { sheet: self, walk: self.skin.walk_on(self.stretch), row: None }
    }

    /// The knots of a thickness that is interpolated: along, from 0 to 1, and round.
    pub(crate) fn knots(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        if self.is_exact() { None } else { self.thickness.knots() }
    }

    /// Between which knots the thickness bends unevenly.
    pub(crate) fn rough(&self) -> Vec<bool> {
        if self.is_exact() { Vec::new() } else { self.thickness.rough() }
    }

    /// The values of `v` at which the beginning of a column passes a knot, in ascending order; none where all begin together or there are no knots.
    pub(crate) fn crossings(&self) -> &[f64] {
        self.crossings.get_or_init(|| {
            let is_trimmed = self.common.is_none() && self.trim != Trim::Foot;
            let Some((along, round)) = self.knots().filter(|_| is_trimmed) else { return Vec::new() };
            let before = |v: f64| {
                let start = self.start(v).s;
                along.partition_point(|knot| *knot < start)
            };
            let mut found = Vec::new();
            for (j, &from) in round.iter().enumerate() {
                let to = round.get(j + 1).copied().unwrap_or(TAU + round.first().copied().unwrap_or(0.0));
                let (mut v, mut here, end) = (from, before(from), before(to));
                // Several between two knots are found one after the other.
                while here != end && found.len() < MOST_CROSSINGS {
                    let [(low, _), (high, beyond)] =
                        bisection::change((v, here), (to, end), HALVINGS, before, |there| *there == here);
                    found.push(0.5 * (low + high));
                    (v, here) = (high, beyond);
                }
            }
            found
        })
    }

    /// The places round it next to `v` at which second derivatives jump, from 0 to a turn: knots and, for what `begins` there, [`Sheet::crossings`]; `None` where there are none.
    pub(crate) fn gap_round(&self, v: f64, begins: bool) -> Option<[f64; 2]> {
        if self.is_exact() {
            return None;
        }
        let [mut below, mut above] = self.thickness.gap_round(v)?;
        let crossings = if begins { self.crossings() } else { &[] };
        // Those between the last knot and the first are a turn on.
        for shift in [0.0, TAU] {
            let after = crossings.partition_point(|place| *place <= v + shift);
            if let Some(place) = after.checked_sub(1).and_then(|before| crossings.get(before)) {
                below = below.max(place - shift);
            }
            if let Some(place) = crossings.get(after) {
                above = above.min(place - shift);
            }
        }
        Some([below, above])
    }

    /// The way from the point that is level with the foot of the surface and to its side, `P + t M` with `M` the outward normal of the foot seen along the axis, to where an offset sheet's column begins above it: an arc about
    /// the foot, so that the wall is nowhere thinner than it is above; `None` where the column begins elsewhere, or no higher.
    pub(super) fn heel(&self, v: f64) -> Option<Shoulder> {
        let WallSide::Offset { direction } = self.face else { return None };
        if self.start(v).s != 0.0 {
            return None;
        }
        let frame = self.skin.frame();
        let (jet, SkinJet { normal, normal_v, .. }) = (self.skin.second(0.0, v), self.skin.jet(0.0, v));
        let [t, _, t_v] = self.thickness.at(0.0, v).map(|t| t * direction);
        // Outward of a curve that goes round as the foot does: to the right if it goes round anti-clockwise.
        let (tangent, dtangent) = (frame.turned(jet.dv), frame.turned(jet.dvv));
        let length = tangent.length();
        if !(length > 0.0 && frame.axis().dot(normal) * t > 0.0) {
            return None;
        }
        let turn = self.skin.turn();
        let unit = tangent / length;
        let dunit = (dtangent - unit * unit.dot(dtangent)) / length;
        let level = [frame.lifted(-unit.perp() * turn), frame.lifted(-dunit.perp() * turn)];
        Some(Shoulder::between([jet.position, jet.dv, jet.dvv], level, [normal, normal_v], [t, t_v]))
    }

    /// The greatest radius and the greatest angle of these arcs.
    pub(crate) fn greatest_heel(&self) -> [f64; 2] {
        let arcs = self.skin.round().filter_map(|v| self.heel(v));
        arcs.fold([0.0; 2], |[radius, turn], arc| [arc.radius().max(radius), arc.turn().max(turn)])
    }

    /// The derivative of `S_v` with respect to `v` at the foot of the design surface, which is known; elsewhere it is not.
    pub(crate) fn second_round(&self, v: f64) -> Option<DVec3> {
        let is_foot = self.trim == Trim::Foot && self.stretch.from == 0.0;
        (self.face == WallSide::Design && is_foot).then(|| self.skin.second(0.0, v).dvv)
    }

    /// Where the column at `v` begins.
    pub(crate) fn start(&self, v: f64) -> Start {
        if let Some(s) = self.common {
            return Start { s, dv: 0.0 };
        }
        if self.trim == Trim::Foot {
            let Foot { s, s_v: dv, .. } = self.feet(v)[0];
            return Start { s, dv };
        }
        let key = v.to_bits();
        // What a thread left that panicked holds whole entries only.
        let known = self.starts.lock().unwrap_or_else(PoisonError::into_inner).get(&key).copied();
        if let Some(start) = known {
            return start;
        }
        let found = self.find(v);
        let start = self.bridges.iter().find_map(|bridge| bridge.lead(v, found)).unwrap_or(found);
        let mut starts = self.starts.lock().unwrap_or_else(PoisonError::into_inner);
        if starts.len() < REMEMBERED {
            starts.insert(key, start);
        }
        start
    }

    fn find(&self, v: f64) -> Start {
        let mut walk = self.walk();
        let Some((low, high)) = self.bracket(&mut walk, v) else { return Start { s: self.all(v)[0], dv: 0.0 } };
        let s = illinois::rise(low, high, |s| self.above(&mut walk, s, v));
        // The root is where g = 0: by implicit differentiation s' = -g_v / g_s.
        let jet = self.jet(s, v);
        let frame = self.skin.frame();
        let [along, round] = match self.trim {
            Trim::Foot => [1.0, 0.0],
            Trim::Level(_) => [jet.ds, jet.dv].map(|d| frame.axis().dot(d)),
            Trim::Cylinder(_) => {
                let plan = frame.plan(jet.position);
                [jet.ds, jet.dv].map(|d| plan.dot(frame.turned(d)))
            }
        };
        let dv = -round / along;
        Start { s, dv: if dv.is_finite() { dv } else { 0.0 } }
    }

    /// Between which `s` the column at `v` begins; `None` where it is all above.
    fn bracket(&self, walk: &mut SheetWalk, v: f64) -> Option<(f64, f64)> {
        let n = self.brackets.len();
        let all = self.all(v);
        let at = v / TAU * n as f64;
        let (left, right) = (libm::floor(at) as usize % n, libm::ceil(at) as usize % n);
        let is_clear = |j: usize| self.clear.get(j).copied().unwrap_or(false);
        if is_clear(left) && is_clear(right) {
            return None;
        }
        let near = |j: usize| self.brackets.get(j).copied().flatten();
        if let (Some(a), Some(b)) = (near(left), near(right)) {
            let (low, high) = (a.min(b).saturating_sub(1), (a.max(b) + 2).min(ROWS));
            // Near a bracket there is no other crossing above: the rows of both neighbours are above there.
            let mut row = high;
            while row > low {
                let (below, above) = (self.row(row - 1, all), self.row(row, all));
                if self.above(walk, below, v) < 0.0 && self.above(walk, above, v) >= 0.0 {
                    return Some((below, above));
                }
                row -= 1;
            }
        }
        let row = (0..=ROWS).rev().find(|&i| self.above(walk, self.row(i, all), v) < 0.0)?;
        Some((self.row(row, all), self.row((row + 1).min(ROWS), all)))
    }

    /// How far a point is above the level, or outside the cylinder.
    fn above(&self, walk: &mut SheetWalk, s: f64, v: f64) -> f64 {
        self.height(walk.jet(s, v).position)
    }

    fn height(&self, position: DVec3) -> f64 {
        match self.trim {
            Trim::Foot => 0.0,
            Trim::Level(level) => self.skin.frame().level(position) - level,
            Trim::Cylinder(radius) => self.skin.frame().plan(position).length() - radius,
        }
    }
}

impl SheetWalk<'_> {
    /// As [`Sheet::jet`].
    pub(crate) fn jet(&mut self, s: f64, v: f64) -> SheetJet {
        let WallSide::Offset { direction } = self.sheet.face else {
            return whole(&self.walk.second(s, v));
        };
        if self.sheet.is_led {
            return self.led(direction, s, v);
        }
        let thickness = self.sheet.thickness.on_row(&mut self.row, s, v).map(|t| t * direction);
        offset(&self.walk.jet(s, v), thickness)
    }

    /// As [`Sheet::jet`], at a column.
    pub(crate) fn jet_at(&mut self, s: f64, columns: &Columns, column: usize) -> SheetJet {
        let WallSide::Offset { direction } = self.sheet.face else {
            return whole(&self.walk.second_at(s, columns, column));
        };
        if self.sheet.is_led {
            return self.led(direction, s, columns.v(column));
        }
        let thickness = self.sheet.thickness.on_row(&mut self.row, s, columns.v(column)).map(|t| t * direction);
        offset(&self.walk.jet_at(s, columns, column), thickness)
    }

    /// The position at a column.
    pub(crate) fn position_at(&mut self, s: f64, columns: &Columns, column: usize) -> DVec3 {
        let WallSide::Offset { direction } = self.sheet.face else {
            return self.walk.second_at(s, columns, column).position;
        };
        if self.sheet.is_led {
            return self.led(direction, s, columns.v(column)).position;
        }
        let jet = self.walk.jet_at(s, columns, column);
        let [t, ..] = self.sheet.thickness.on_row(&mut self.row, s, columns.v(column));
        jet.position + jet.normal * (t * direction)
    }

    /// The jet of a column that is led from one end to the other.
    fn led(&mut self, direction: f64, s: f64, v: f64) -> SheetJet {
        let [start, end] = self.sheet.feet(v);
        let (length, length_v) = (end.s - start.s, end.s_v - start.s_v);
        let (apart, apart_v) = (end.shift - start.shift, end.shift_v - start.shift_v);
        let share = (s - start.s) / length;
        let share_v = -(start.s_v + share * length_v) / length;
        let beside = v + start.shift + share * apart;
        let thickness = self.sheet.thickness.on_row(&mut self.row, s, beside).map(|t| t * direction);
        let jet = offset(&self.walk.jet(s, beside), thickness);
        let turned = 1.0 + start.shift_v + share * apart_v + share_v * apart;
        SheetJet { position: jet.position, ds: jet.ds + jet.dv * (apart / length), dv: jet.dv * turned }
    }
}

/// What became of a side of a wall that was trimmed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Trimmed {
    /// Something is left of every column: of one all, and one that is cut, if there are such.
    There { above: Option<f64>, cut: Option<f64> },
    /// Nothing is left.
    Away,
    /// Of this column nothing is left, but of others.
    Across(f64),
}

/// The jet of the surface of the design itself.
fn whole(jet: &SurfaceJet) -> SheetJet {
    SheetJet { position: jet.position, ds: jet.du, dv: jet.dv }
}
