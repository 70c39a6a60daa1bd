//! Where the other side of a wall goes round a corner of the profile: mitred or rounded, never folded.
//!
//! On the inside of a turn the two offset surfaces run through each other. They are cut along the curve in which they meet, a mitre; what is left is nowhere nearer to the surface than the wall is thick. On the outside they part, and a
//! piece of a tube round the corner joins them. Where the turn changes sides along the ring, or is small, both are mitred all round: on the outside the closed form of either piece goes on beyond the corner, to where the two meet.
//!
//! Points of either side are found with the column of the corner in whose normal plane they are, so that both have them at the same `v`.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use glam::{DMat4, DVec3, DVec4};

use super::offset::{SheetJet, offset};
use super::skin::{Skin, SkinJet, SkinWalk};
use super::thickness::Thickness;
use super::told::{place, short};
use crate::design::{Wall, plain};
use crate::error::{Code, Error, Result};
use crate::face::FaceJet;
use crate::solution::Stretch;

/// The most columns whose meeting is remembered.
const REMEMBERED: usize = 1 << 16;

/// Turns between these, in radians, are rounded on their outside; below them a mitre is as good as round, and above the second it would stick out by more than the wall is thick.
const ROUNDED: [f64; 2] = [0.35, 2.0];

/// A turn that goes to the outside everywhere by more than this can be rounded.
const PARTED: f64 = 1e-6;

/// Below this turn the two surfaces are so nearly one that they meet where their tangents say.
const FLAT: f64 = 1e-5;

/// Newton's steps that a meeting takes at most, and what is left of the last as a part of the size.
const STEPS: usize = 24;
const LEFT: f64 = 1e-11;

/// Shifts and places along the surface that differ by no more than this are one.
const SAME: f64 = 1e-12;

/// The step of the difference that says how a meeting changes where the surfaces are nearly one.
const STEP: f64 = 1e-4;

/// How the two sides of a corner are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Join {
    Mitred,
    Rounded,
}

/// The corner of the profile between two stretches of a surface, on the other side of the wall.
#[derive(Debug)]
pub(crate) struct Crease {
    skin: Arc<Skin>,
    thickness: Arc<Thickness>,
    /// 1 for a wall outwards, -1 for one inwards.
    direction: f64,
    /// Below and above.
    stretches: [Stretch; 2],
    join: Join,
    /// The meeting of every column, where it is the same and in the column itself.
    common: Option<[f64; 2]>,
    /// Those that were asked for.
    known: Mutex<BTreeMap<u64, [Foot; 2]>>,
}

/// Where a column of one side of a corner ends or begins: along the surface, and by how much its own column lies beside that of the corner; how both change with the column.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Foot {
    pub(super) s: f64,
    pub(super) s_v: f64,
    pub(super) shift: f64,
    pub(super) shift_v: f64,
}

impl Foot {
    /// At a place of its own column.
    pub(super) fn at(s: f64) -> Foot {
        Foot { s, ..Foot::default() }
    }
}

/// What a corner is like at one column.
struct Corner {
    /// The surface below and above.
    jets: [SkinJet; 2],
    /// The unit tangent of the corner, and how it changes.
    tangent: DVec3,
    tangent_v: DVec3,
    /// The second derivative of the corner's curve.
    dvv: DVec3,
    /// By which angle the normal turns about the tangent.
    turn: f64,
    turn_v: f64,
    /// The thickness of the wall, towards its other side, and how it changes.
    thickness: f64,
    thickness_v: f64,
}

impl Corner {
    /// The middle of both normals, so long that a point at the thickness along it lies in both offset tangent planes.
    fn mitre(&self) -> DVec3 {
        let [below, above] = self.jets.map(|jet| jet.normal);
        (below + above) / (1.0 + below.dot(above))
    }
}

impl Crease {
    /// The corner above stretch number `below` of a surface.
    ///
    /// # Errors
    /// `no-room` where the wall can neither be mitred nor rounded.
    pub(super) fn new(
        skin: &Arc<Skin>,
        thickness: &Arc<Thickness>,
        wall: &Wall,
        direction: f64,
        stretches: [Stretch; 2],
    ) -> Result<Crease> {
        let mut crease = Crease {
            skin: Arc::clone(skin),
            thickness: Arc::clone(thickness),
            direction,
            stretches,
            join: Join::Mitred,
            common: None,
            known: Mutex::default(),
        };
        let mut walks = crease.walks();
        // How far the two sides part.
        let outside: Vec<f64> = skin.round().map(|v| crease.opening(&crease.corner(&mut walks, v))).collect();
        drop(walks);
        let (least, most) =
            outside.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(*x), most.max(*x)));
        if most > ROUNDED[0] && (least > PARTED && (least > ROUNDED[0] || most > ROUNDED[1])) {
            crease.join = Join::Rounded;
            return Ok(crease);
        }
        if most > ROUNDED[1] {
            let v = skin
                .round()
                .zip(&outside)
                .fold((0.0, f64::MIN), |best, (v, x)| if *x > best.1 { (v, *x) } else { best })
                .0;
            return Err(crease.refused(wall, v));
        }
        let mut feet = Vec::with_capacity(outside.len());
        let mut walks = crease.walks();
        for v in skin.round() {
            match crease.meeting(&mut walks, v) {
                Some(met) if met.iter().all(|foot| foot.shift_v > -1.0) => feet.push(met),
                _ => return Err(crease.refused(wall, v)),
            }
        }
        drop(walks);
        let first = feet.first().copied().unwrap_or_default();
        let is_same = |foot: &Foot, first: &Foot| foot.shift.abs() <= SAME && (foot.s - first.s).abs() <= SAME;
        if feet.iter().all(|met| met.iter().zip(&first).all(|(foot, first)| is_same(foot, first))) {
            let n = feet.len() as f64;
            crease.common = Some([0, 1].map(|side| feet.iter().map(|met| met[side].s).sum::<f64>() / n));
        }
        Ok(crease)
    }

    /// That the wall has no room at a corner.
    pub(super) fn refused(&self, wall: &Wall, v: f64) -> Error {
        no_room(&self.skin, wall, &self.stretches[0], v)
    }

    /// Whether there is a piece between the two sides.
    pub(super) fn is_rounded(&self) -> bool {
        self.join == Join::Rounded
    }

    /// Whether either side ends in the column of the corner, at the same place all round.
    pub(super) fn is_even(&self) -> bool {
        self.is_rounded() || self.common.is_some()
    }

    /// Where the side below (0) or above (1) ends.
    pub(super) fn foot(&self, side: usize, v: f64) -> Foot {
        if self.is_rounded() {
            let [below, above] = &self.stretches;
            return Foot::at(if side == 0 { below.to } else { above.from });
        }
        if let Some(common) = self.common {
            return Foot::at(common[side]);
        }
        let key = v.to_bits();
        // What a thread left that panicked holds whole entries only.
        let known = self.known.lock().unwrap_or_else(PoisonError::into_inner).get(&key).copied();
        if let Some(feet) = known {
            return feet[side];
        }
        let mut walks = self.walks();
        // Columns between those at which it was found to be there.
        let feet = self.meeting(&mut walks, v).unwrap_or_else(|| self.by_tangents(&mut walks, v));
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if known.len() < REMEMBERED {
            known.insert(key, feet);
        }
        feet[side]
    }

    fn walks(&self) -> [SkinWalk<'_>; 2] {
        self.stretches.map(|stretch| self.skin.walk_on(stretch))
    }

    fn corner(&self, walks: &mut [SkinWalk; 2], v: f64) -> Corner {
        let [below, above] = walks;
        let (low, high) = (self.stretches[0].to, self.stretches[1].from);
        let jets = [below.jet(low, v), above.jet(high, v)];
        let (dv, dvv) = (jets[1].dv, above.second(high, v).dvv);
        let length = dv.length();
        let tangent = dv / length;
        let tangent_v = (dvv - tangent * tangent.dot(dvv)) / length;
        let [n, m] = jets.map(|jet| jet.normal);
        let [n_v, m_v] = jets.map(|jet| jet.normal_v);
        let [turn, turn_v] = turn([tangent, tangent_v], [n, n_v], [m, m_v]);
        let [thickness, _, thickness_v] = self.thickness.at(high, v).map(|t| t * self.direction);
        Corner { jets, tangent, tangent_v, dvv, turn, turn_v, thickness, thickness_v }
    }

    /// By which angle the two sides part; negative where they run through each other.
    fn opening(&self, corner: &Corner) -> f64 {
        // The tangent times the normal is the direction of the profile, or against it.
        self.direction * self.skin.outward() * corner.turn
    }

    /// Where tangent planes meet.
    fn guess(&self, walks: &mut [SkinWalk; 2], v: f64) -> [Foot; 2] {
        let corner = self.corner(walks, v);
        let mitre = corner.mitre();
        let places = [self.stretches[0].to, self.stretches[1].from];
        [0, 1].map(|side| {
            let jet = &corner.jets[side];
            // The way in the tangent plane, by its two derivatives.
            let way = (mitre - jet.normal) * corner.thickness;
            let across = jet.ds.cross(jet.dv);
            let area = across.length_squared();
            let [along, round] = [way.cross(jet.dv).dot(across) / area, jet.ds.cross(way).dot(across) / area];
            Foot { s: places[side] + along, shift: round, ..Foot::default() }
        })
    }

    /// The same, and how it changes.
    fn by_tangents(&self, walks: &mut [SkinWalk; 2], v: f64) -> [Foot; 2] {
        let here = self.guess(walks, v);
        let [before, after] = [v - STEP, v + STEP].map(|v| self.guess(walks, v));
        [0, 1].map(|side| Foot {
            s_v: (after[side].s - before[side].s) / (2.0 * STEP),
            shift_v: (after[side].shift - before[side].shift) / (2.0 * STEP),
            ..here[side]
        })
    }

    /// Where the two sides meet in the normal plane of the corner, by Newton's method from where their tangent planes do; `None` where that goes astray.
    fn meeting(&self, walks: &mut [SkinWalk; 2], v: f64) -> Option<[Foot; 2]> {
        let corner = self.corner(walks, v);
        if corner.turn.abs() < FLAT {
            return Some(self.by_tangents(walks, v));
        }
        let (at, along) = (corner.jets[1].position, corner.jets[1].dv);
        let mut feet = self.guess(walks, v);
        let mut least = f64::INFINITY;
        for _ in 0..STEPS {
            let jets = [0, 1].map(|side| self.offset(&mut walks[side], feet[side].s, v + feet[side].shift));
            let [below, above] = &jets;
            let (gap, arm) = (below.position - above.position, below.position - at);
            let column = |d: DVec3, last: f64| d.extend(last);
            let slopes = DMat4::from_cols(
                column(below.ds, below.ds.dot(along)),
                column(below.dv, below.dv.dot(along)),
                column(-above.ds, 0.0),
                column(-above.dv, 0.0),
            );
            let inverse = slopes.inverse();
            let step = inverse * -gap.extend(arm.dot(along));
            let length = (below.ds * step.x).length().max((below.dv * step.y).length());
            let length = length.max((above.ds * step.z).length()).max((above.dv * step.w).length());
            if !length.is_finite() {
                return None;
            }
            if length <= LEFT * self.skin.size() && length >= 0.5 * least {
                // Both are where their columns say; the plane turns with the column.
                let change = inverse * DVec4::new(0.0, 0.0, 0.0, along.length_squared() - arm.dot(corner.dvv));
                feet[0] = Foot { s_v: change.x, shift_v: change.y - 1.0, ..feet[0] };
                feet[1] = Foot { s_v: change.z, shift_v: change.w - 1.0, ..feet[1] };
                return Some(feet);
            }
            least = least.min(length);
            feet[0] = Foot { s: feet[0].s + step.x, shift: feet[0].shift + step.y, ..feet[0] };
            feet[1] = Foot { s: feet[1].s + step.z, shift: feet[1].shift + step.w, ..feet[1] };
        }
        None
    }

    fn offset(&self, walk: &mut SkinWalk, s: f64, v: f64) -> SheetJet {
        offset(&walk.jet(s, v), self.thickness.at(s, v).map(|t| t * self.direction))
    }

    /// What joins the two sides at one column of a corner that is rounded.
    pub(super) fn shoulder(&self, v: f64) -> Shoulder {
        let corner = self.corner(&mut self.walks(), v);
        let [SkinJet { position, dv, normal, normal_v, .. }, _] = corner.jets;
        let Corner { tangent, tangent_v, turn, turn_v, thickness, thickness_v, .. } = corner;
        let (tangent, arm) = ([tangent, tangent_v], [normal, normal_v]);
        Shoulder::new([position, dv], tangent, arm, [turn, turn_v], [thickness, thickness_v])
    }

    /// The greatest angle by which it turns.
    pub(crate) fn greatest_turn(&self) -> f64 {
        let mut walks = self.walks();
        self.skin.round().map(|v| self.corner(&mut walks, v).turn.abs()).fold(0.0, f64::max)
    }

    /// The greatest thickness of the wall round it.
    pub(crate) fn radius(&self) -> f64 {
        self.skin.round().map(|v| self.thickness.at(self.stretches[1].from, v)[0]).fold(0.0, f64::max)
    }

    /// The knots of a thickness that is interpolated: along, from 0 to 1, and round.
    pub(super) fn knots(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        self.thickness.knots()
    }
}

/// The angle from one unit vector to another about a third that is at right angles to both, each with its derivative.
fn turn([axis, axis_v]: [DVec3; 2], [from, from_v]: [DVec3; 2], [to, to_v]: [DVec3; 2]) -> [f64; 2] {
    let (sine, cosine) = (axis.dot(from.cross(to)), from.dot(to));
    let sine_v = axis_v.dot(from.cross(to)) + axis.dot(from_v.cross(to) + from.cross(to_v));
    let cosine_v = from_v.dot(to) + from.dot(to_v);
    [libm::atan2(sine, cosine), cosine * sine_v - sine * cosine_v]
}

/// An arc round a corner, from the side below to that above, with how it changes from column to column.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shoulder {
    middle: DVec3,
    middle_v: DVec3,
    arm: DVec3,
    arm_v: DVec3,
    across: DVec3,
    across_v: DVec3,
    turn: f64,
    turn_v: f64,
    radius: f64,
    radius_v: f64,
}

impl Shoulder {
    /// The arc about a point of a curve with this unit tangent, from where an arm at right angles to that points, by an angle; all with their derivatives.
    fn new(
        [middle, middle_v]: [DVec3; 2],
        [tangent, tangent_v]: [DVec3; 2],
        [arm, arm_v]: [DVec3; 2],
        [turn, turn_v]: [f64; 2],
        [radius, radius_v]: [f64; 2],
    ) -> Shoulder {
        let (across, across_v) = (tangent.cross(arm), tangent_v.cross(arm) + tangent.cross(arm_v));
        Shoulder { middle, middle_v, arm, arm_v, across, across_v, turn, turn_v, radius, radius_v }
    }

    /// The arc about a point of a curve from one arm to another, both at right angles to the curve, which is given with two derivatives and the rest with one.
    pub(super) fn between(curve: [DVec3; 3], from: [DVec3; 2], to: [DVec3; 2], radius: [f64; 2]) -> Shoulder {
        let [middle, dv, dvv] = curve;
        let length = dv.length();
        let tangent = dv / length;
        let tangent = [tangent, (dvv - tangent * tangent.dot(dvv)) / length];
        Shoulder::new([middle, dv], tangent, from, turn(tangent, from, to), radius)
    }

    pub(super) fn radius(&self) -> f64 {
        self.radius.abs()
    }

    /// By which angle it goes round.
    pub(super) fn turn(&self) -> f64 {
        self.turn.abs()
    }

    /// At a part of the way from below to above.
    pub(super) fn jet(&self, share: f64) -> FaceJet {
        let (sine, cosine) = libm::sincos(share * self.turn);
        let (out, on) = (self.arm * cosine + self.across * sine, self.across * cosine - self.arm * sine);
        let out_v = self.arm_v * cosine + self.across_v * sine + on * (share * self.turn_v);
        FaceJet {
            position: self.middle + out * self.radius,
            da: on * (self.radius * self.turn),
            dv: self.middle_v + out * self.radius_v + out_v * self.radius,
        }
    }
}

/// That a wall has no room at the corner at the end of a stretch.
pub(super) fn no_room(skin: &Skin, wall: &Wall, below: &Stretch, v: f64) -> Error {
    let at = skin.second(below.to, v).position;
    let ring = below.corner(true, skin.is_upward());
    let message = format!(
        "a wall {} thick has no room round the sharp ring u = {} at {}: expected a thinner wall, or a ring that turns less or is further from the next",
        short(wall.thickness),
        plain(ring),
        place(at)
    );
    let error = Error::new(Code::NoRoom, skin.placed().path("wall.thickness"), message).near(at.to_array());
    error.with("what", "sharp-ring").with("thickness", wall.thickness).with("ring", ring)
}
