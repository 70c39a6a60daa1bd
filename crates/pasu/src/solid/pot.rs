//! A pot or a closed solid as smooth faces, from a surface and its wall.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::curve::Curve;
use super::flank::{Flank, Untrimmed};
use super::lining::Lined;
use super::outline::Outline;
use super::piece::{Bead, Form, Piece};
use super::product::Product;
use super::sheet::{Sheet, Trim, WallSide};
use super::skin::Skin;
use super::thickness::{Thickness, Told};
use super::told::{place, short};
use crate::design::{RimForm, Side, Wall, plain};
use crate::error::{Code, Error, Result};
use crate::face::FaceKind;
use crate::solution::Solution;
use crate::watch;

/// A wall that somewhere takes up more than this part of the radius at which the surface bends is looked into more closely; it is to take up no more than 0.8.
const CROWDED: f64 = 0.9;

/// So many times as closely, or less where that is at too many places.
const CLOSER: [usize; 2] = [3, 2];

/// The most places at which a wall is looked into more closely. What bends at more is a folded cloth rather than a pot: its wall is as it was found, and refused where it folds.
const MOST_PLACES: usize = 250_000;

/// Columns that begin no further apart than this begin at the same place.
const SAME: f64 = 1e-9;

/// A curve no wider than this part of the size is a point.
const POINT: f64 = 1e-6;

/// One part of a design as a body of clay, bounded by smooth faces.
///
/// The pot's own axis is the placed local z axis. Its lower end is the foot, where the mean height along the axis is less; "level" is across the axis.
///
/// **Faces** follow on from each other as a meridian does, each beginning (`a = 0`) where the one before ended (`a = 1`): from the middle of the underside outwards, up the
/// outside, over the rim, down the lining, to the middle of the floor. A pot with a drain, and a tube, goes once round instead, and its last face ends where the first begins.
///
/// - **Wall.** The surface `P`, and `P - t N` (side inside) or `P + t N` (outside). `t` is the thickness asked for, or less where that would fold the clay: at most 0.8 of the largest ball
///   that touches the surface at `P` on that side and holds no other point of it.
/// - **Sharp rings.** Round a corner of the profile the other side of the wall is mitred where it turns inwards, and rounded where it turns outwards by more than a little: nowhere thinner than asked for, and never folded.
/// - **Base.** Inside: a level floor, `base` above the highest point of the foot or of the recess, down to which the lining is trimmed; where the lining begins above it, it is led straight down. Outside: the
///   foot of the surface bounds the floor, and the outside is trimmed or led down to a level `base` below the lowest point of the floor; where the wall leans inwards at the foot, and so begins above it, by way of an arc round the foot. A `base` of 0 makes a tube with two rims.
/// - **Round bottom.** Where the foot is a point, the level is `base` from that point. Where the other side of the wall is beyond it there is no floor, only the wall.
/// - **Foot that is not level.** Its disc is the cone from the curve to the middle of the area that it goes round, which must see the whole curve.
/// - **Solid.** The surface with a level disc at each open end. An end that is not level is first led straight along the axis to the level of its furthest point.
#[derive(Debug, Clone)]
pub struct Pot {
    part: usize,
    pieces: Vec<Piece>,
    is_ring: bool,
    skin: Arc<Skin>,
    thickness: Arc<Thickness>,
    /// The inside, where it is a surface of its own.
    lined: Option<Arc<Lined>>,
    /// By how much the wall is thinned where there is one.
    told: Option<Told>,
    foot_level: f64,
    wall: Option<Wall>,
}

impl Pot {
    /// The faces of a part whose skin is known: the one body that is measured, checked, meshed and written.
    ///
    /// The thickness is sought at the places of a mesh, and once more at closer ones where the surface bends between these so sharply that the wall would all but fold.
    pub(crate) fn of(skin: &Arc<Skin>, wall: Option<Wall>) -> Result<Pot> {
        Pot::looked_at(skin, wall, true)
    }

    /// As [`Pot::of`]; without the closer look unless `is_closely`. It takes five times as long as all else, and without it a wall that would all but fold between the places is thinner than that of the body.
    pub(crate) fn looked_at(skin: &Arc<Skin>, wall: Option<Wall>, is_closely: bool) -> Result<Pot> {
        let Some(wall) = wall else { return Pot::with(skin, None, Arc::new(Thickness::Even(0.0)), None) };
        if let Some(lining) = wall.lining {
            watch::go_on()?;
            let even = Arc::new(Thickness::Even(wall.thickness));
            let floor = floor_of(skin, &even, &wall);
            let lined = Lined::of(skin, &wall, lining, floor, is_closely)?;
            return Pot::with(skin, Some(wall), even, Some(Arc::new(lined)));
        }
        let direction = if wall.side == Side::Inside { -1.0 } else { 1.0 };
        watch::go_on()?;
        let is_looked_into = is_closely && wall.thickness < skin.size();
        if skin.is_round()
            && let Some(sought) = Thickness::plain_on_a_meridian(skin, &wall, direction)?
        {
            let pot = Pot::with(skin, Some(wall), Arc::new(Thickness::Even(wall.thickness)), None)?;
            let starts = pot.starts(sought.columns);
            if !is_looked_into || !pot.thickness.is_crowded(skin, &sought, &starts, CROWDED) {
                return Ok(pot);
            }
        }
        let (thickness, mut sought) = Thickness::of(skin, &wall, direction, None)?;
        let mut pot = Pot::with(skin, Some(wall), Arc::new(thickness), None)?;
        let mut starts = pot.starts(sought.columns);
        // What is thicker than the pot is wide is thinned everywhere, however closely it is looked at.
        let closer = CLOSER.into_iter().find(|factor| factor * factor * sought.n_places() <= MOST_PLACES);
        if let Some(closer) = closer.filter(|_| is_looked_into)
            && pot.thickness.is_crowded(skin, &sought, &starts, CROWDED)
        {
            let (thickness, closer) = Thickness::of(skin, &wall, direction, Some((closer, &sought)))?;
            sought = closer;
            pot = Pot::with(skin, Some(wall), Arc::new(thickness), None)?;
            starts = pot.starts(sought.columns);
        }
        watch::go_on()?;
        pot.told = pot.thickness.told(skin, &sought, &starts);
        if pot.told.is_none() && !pot.thickness.is_even() {
            // Thinned only where there is no wall, beneath the floor: then it is as asked for all over.
            let even = Pot::with(skin, Some(wall), Arc::new(Thickness::Even(wall.thickness)), None)?;
            let is_same = even.starts(sought.columns).iter().zip(&starts).all(|(s, start)| (s - start).abs() <= SAME);
            if is_same {
                return Ok(even);
            }
        }
        Ok(pot)
    }

    /// The faces with a wall of a thickness that is known.
    fn with(skin: &Arc<Skin>, wall: Option<Wall>, thickness: Arc<Thickness>, lined: Option<Arc<Lined>>) -> Result<Pot> {
        let builder = Builder { skin, thickness: &thickness, lined: lined.as_deref(), pieces: Vec::new() };
        let (pieces, is_ring, foot_level) = match wall {
            Some(wall) => builder.pot(&wall)?,
            None => builder.solid()?,
        };
        let (part, skin) = (skin.placed().index(), Arc::clone(skin));
        Ok(Pot { part, pieces, is_ring, skin, thickness, lined, told: None, foot_level, wall })
    }

    /// The pot with another ring or drain: the thickness of its wall does not depend on these.
    ///
    /// # Errors
    /// As [`Pot::new`].
    pub(crate) fn with_foot_of(&self, wall: Wall) -> Result<Pot> {
        Pot::with(&self.skin, Some(wall), Arc::clone(&self.thickness), self.lined.clone())
    }

    /// Whether it is the same body wherever it is moved to. A wall that had to be thinned and a lining of its own are not: rounding decides where they are thin.
    pub(crate) fn is_movable(&self) -> bool {
        self.thickness.is_even() && self.lined.is_none()
    }

    /// A [movable](Pot::is_movable) body as it would stand if it were not moved.
    ///
    /// # Errors
    /// As [`Pot::of`], of which none is likely.
    pub(crate) fn unmoved(&self) -> Result<Pot> {
        Pot::with(&Arc::new(self.skin.unmoved()?), self.wall, Arc::clone(&self.thickness), None)
    }

    /// Where the wall begins at even columns: its other side does, not the surface.
    fn starts(&self, columns: usize) -> Vec<f64> {
        let sheet = self.pieces.iter().find_map(|piece| match &piece.form {
            Form::Sheet { sheet, .. } if sheet.is_offset() => Some(sheet),
            _ => None,
        });
        (0..columns).map(|j| sheet.map_or(0.0, |sheet| sheet.start(TAU * j as f64 / columns as f64).s)).collect()
    }

    /// The number of the part.
    pub fn part(&self) -> usize {
        self.part
    }

    /// The faces, in order along a meridian.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// use pasu::{Face, FaceKind, Pot, Product};
    ///
    /// let pot = Pot::new(&cup, 0, Product::Pot)?;
    /// let kinds: Vec<FaceKind> = pot.faces().iter().map(|face| face.kind()).collect();
    /// assert!(kinds.contains(&FaceKind::Outer) && kinds.contains(&FaceKind::Lining) && kinds.contains(&FaceKind::Rim));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn faces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Whether the last face ends where the first begins: a tube, or a pot with a drain.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// use pasu::{Pot, Product};
    ///
    /// assert!(!Pot::new(&cup, 0, Product::Pot)?.is_ring());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn is_ring(&self) -> bool {
        self.is_ring
    }

    /// The unit vector along the pot's own axis, from foot to rim.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let pot = pasu::Pot::new(&cup, 0, pasu::Product::Pot)?;
    /// assert!((pot.axis().z - 1.0).abs() < 1e-12);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn axis(&self) -> DVec3 {
        self.skin.frame().axis()
    }

    /// A point of the axis: the middle of the foot of the surface.
    pub fn origin(&self) -> DVec3 {
        self.skin.frame().point(DVec2::ZERO, 0.0)
    }

    /// The lowest level of the pot's foot along its axis, measured from [`Pot::origin`].
    pub fn foot_level(&self) -> f64 {
        self.foot_level
    }

    /// The least and the greatest thickness of the wall; zeros for a solid. Of a wall with a lining of its own the least is what is proven of all of it.
    pub fn thickness(&self) -> (f64, f64) {
        if let Some(lined) = &self.lined {
            let apart = lined.apart();
            return (if apart.bound > 0.0 { apart.bound } else { apart.least.0 }, apart.greatest.0);
        }
        match (self.told, self.wall) {
            (Some(told), _) => (told.thinnest.0, told.thickest),
            (None, Some(wall)) => (wall.thickness, wall.thickness),
            (None, None) => (0.0, 0.0),
        }
    }

    /// The share of the wall that is thinner than asked for, from 0 to 1, and the place where it is thinnest; `None` where it is as asked for everywhere.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let pot = pasu::Pot::new(&cup, 0, pasu::Product::Pot)?;
    /// assert_eq!(pot.thinned(), None);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn thinned(&self) -> Option<(f64, DVec3)> {
        self.told.map(|told| (told.share, told.thinnest.1))
    }

    /// How far the least and the greatest thickness and the share that is thinned may be off.
    pub(crate) fn thickness_errors(&self) -> [f64; 3] {
        if let Some(lined) = &self.lined {
            let apart = lined.apart();
            return [apart.least.0 - apart.bound, apart.greatest.1, 0.0];
        }
        self.told.map_or([0.0; 3], |told| told.errors)
    }

    /// What the surface of the design is.
    pub(crate) fn surface_kind(&self) -> FaceKind {
        match self.wall {
            Some(Wall { side: Side::Outside, .. }) => FaceKind::Lining,
            _ => FaceKind::Outer,
        }
    }

    /// Whether this is a pot, not a solid.
    pub(crate) fn has_wall(&self) -> bool {
        self.wall.is_some()
    }

    /// The thickness of the base; `None` for a solid and a tube, which have none.
    pub(crate) fn base(&self) -> Option<f64> {
        self.wall.map(|wall| wall.base).filter(|base| *base > 0.0)
    }

    /// The thickness of the wall where the surface, run through from foot to rim, is at `(s, v)`; 0 for a solid.
    pub(crate) fn thickness_at(&self, s: f64, v: f64) -> f64 {
        match &self.lined {
            Some(lined) => lined.distance(self.skin.second(s, v).position),
            None => self.thickness.at(s, v)[0],
        }
    }

    /// Whether its lining is a surface of its own.
    pub(crate) fn is_lined(&self) -> bool {
        self.lined.is_some()
    }

    /// Where derivatives of a lining of its own jump between foot and rim.
    pub(crate) fn knots_of_lining(&self) -> Vec<f64> {
        self.lined.as_ref().map(|lined| lined.skin().knots()).unwrap_or_default()
    }

    pub(crate) fn skin(&self) -> &Skin {
        &self.skin
    }

    /// The surface, for another pot on it.
    pub(crate) fn shared_skin(&self) -> &Arc<Skin> {
        &self.skin
    }

    /// The wall with which it is made; `None` for a solid.
    pub(crate) fn wall(&self) -> Option<Wall> {
        self.wall
    }
}

impl Solution {
    /// The wall that a product of a part takes; `None` for a solid, which has none.
    ///
    /// # Errors
    /// `no-wall`.
    pub(crate) fn wall(&self, part: usize, product: Product) -> Result<Option<Wall>> {
        if product == Product::Solid {
            return Ok(None);
        }
        let wall = self.design().parts().get(part).and_then(|part| part.wall);
        wall.map(Some).ok_or_else(|| {
            let message =
                "this part has no wall: expected one with thickness and base to make it a pot, or the solid as product";
            Error::new(Code::NoWall, format!("parts[{part}].wall"), message)
        })
    }
}

/// The level of the floor of a pot without a ring, above which there is a lining: so one that was fitted moves no lining.
fn floor_of(skin: &Arc<Skin>, thickness: &Arc<Thickness>, wall: &Wall) -> f64 {
    if wall.base == 0.0 {
        return f64::NEG_INFINITY;
    }
    let surface = Arc::new(Sheet::whole(skin, thickness, WallSide::Design));
    Outline::of(&Curve::Start(surface), skin).highest + wall.base
}

/// What faces are put together from.
struct Builder<'a> {
    skin: &'a Arc<Skin>,
    thickness: &'a Arc<Thickness>,
    lined: Option<&'a Lined>,
    pieces: Vec<Piece>,
}

type Parts = (Vec<Piece>, bool, f64);

impl Builder<'_> {
    fn whole(&self, face: WallSide) -> Arc<Sheet> {
        Arc::new(Sheet::whole(self.skin, self.thickness, face))
    }

    fn push(&mut self, kind: FaceKind, form: Form, is_level: bool, is_exact: bool) {
        self.pieces.push(Piece { kind, form, outward: self.skin.outward(), is_level, is_exact });
    }

    /// The faces of one side of the wall, from foot to rim or back.
    fn flank(&mut self, kind: FaceKind, flank: &Flank, is_back: bool) {
        let mut forms = Vec::with_capacity(2 * flank.sheets.len());
        for (number, sheet) in flank.sheets.iter().enumerate() {
            if let Some(crease) =
                number.checked_sub(1).and_then(|below| flank.creases.get(below)).filter(|crease| crease.is_rounded())
            {
                forms.push(Form::Shoulder { crease: Arc::clone(crease), is_back });
            }
            forms.push(Form::Sheet { sheet: Arc::clone(sheet), is_back });
        }
        if is_back {
            forms.reverse();
        }
        let is_exact = flank.first().is_exact();
        forms.into_iter().for_each(|form| self.push(kind, form, false, is_exact));
    }

    fn ruled(&mut self, kind: FaceKind, from: &Curve, to: &Curve, is_level: bool, is_exact: bool) {
        self.push(kind, Form::Ruled { from: from.clone(), to: to.clone() }, is_level, is_exact);
    }

    fn error(&self, code: Code, field: &str, message: String) -> Error {
        Error::new(code, self.skin.placed().path(field), message)
    }

    /// The surface between a level disc at each of its open ends.
    fn solid(mut self) -> Result<Parts> {
        let sheet = self.whole(WallSide::Design);
        let poles = self.skin.poles();
        let ends = [Curve::Start(Arc::clone(&sheet)), Curve::End(Arc::clone(&sheet))];
        let outlines = ends.each_ref().map(|curve| Outline::of(curve, self.skin));
        let levels = [outlines[0].lowest, outlines[1].highest];
        // An end that is not level is first led straight to the level of its furthest point.
        let led = [0, 1].map(|end| {
            if outlines[end].is_level {
                return ends[end].clone();
            }
            Curve::Level { curve: Arc::new(ends[end].clone()), sheet: Arc::clone(&sheet), level: levels[end] }
        });
        let mut middles = [const { None }; 2];
        for (end, name) in ["foot", "rim"].into_iter().enumerate().filter(|(end, _)| !poles[*end]) {
            middles[end] = Some(Curve::Point(self.disc(&Outline::of(&led[end], self.skin), "shape", name)?));
        }
        let [foot, rim] = middles;
        if let Some(middle) = foot {
            self.ruled(FaceKind::Underside, &middle, &led[0], true, true);
            if !outlines[0].is_level {
                self.ruled(FaceKind::Outer, &led[0], &ends[0], false, true);
            }
        }
        self.flank(FaceKind::Outer, &Flank::design(self.skin, self.thickness), false);
        if let Some(middle) = rim {
            if !outlines[1].is_level {
                self.ruled(FaceKind::Lid, &ends[1], &led[1], false, true);
            }
            self.ruled(FaceKind::Lid, &led[1], &middle, true, true);
        }
        Ok((self.pieces, false, levels[0]))
    }

    /// The middle of a disc or cone over a curve.
    fn disc(&self, outline: &Outline, field: &str, name: &str) -> Result<DVec3> {
        let Some(middle) = outline.middle else {
            let message =
                format!("the {name} encloses no area at {}: expected a curve with an inside", place(outline.mean));
            let error = self.error(Code::PinchedSurface, field, message).near(outline.mean.to_array());
            return Err(error.with("what", "no-area").with("end", name));
        };
        if !outline.is_level && !outline.is_star {
            let message = format!(
                "the {name} is neither level nor seen as a whole from its middle at {}, so no disc closes it; expected a level {name}, or one that bends less",
                place(middle)
            );
            let error = self.error(Code::NoRoom, field, message).near(middle.to_array());
            return Err(error.with("what", "no-disc").with("end", name));
        }
        Ok(middle)
    }

    fn pot(self, wall: &Wall) -> Result<Parts> {
        let poles = self.skin.poles();
        if poles[1] {
            let at = self.skin.second(1.0, 0.0).position;
            let message = format!(
                "the surface closes to a point at {}, where the opening of a pot is: expected a rim with a width, or the solid as product",
                place(at)
            );
            return Err(self.error(Code::NoOpening, "shape", message).near(at.to_array()));
        }
        if wall.base == 0.0 && !poles[0] { self.tube(wall) } else { self.cup(wall) }
    }

    /// A wall with a rim at both ends.
    fn tube(mut self, wall: &Wall) -> Result<Parts> {
        for (field, is_there) in [("wall.foot", wall.foot.is_some()), ("wall.drain", wall.drain > 0.0)] {
            if is_there {
                let message =
                    "a pot without a base has nothing to carry this: expected a base greater than 0".to_owned();
                return Err(self.error(Code::NoRoom, field, message).with("what", "no-base"));
            }
        }
        let [outer, lining] = self.sides(wall, Trim::Foot, Trim::Foot)?;
        self.flank(FaceKind::Outer, &outer, false);
        self.rim(wall, outer.last(), lining.last(), 1.0);
        self.flank(FaceKind::Lining, &lining, true);
        self.rim(wall, lining.first(), outer.first(), 0.0);
        let lowest =
            [&outer, &lining].map(|flank| Outline::of(&Curve::Start(Arc::clone(flank.first())), self.skin).lowest);
        Ok((self.pieces, true, lowest[0].min(lowest[1])))
    }

    /// The sides outside and inside; the trims are those of the design's surface and of the other.
    fn sides(&self, wall: &Wall, design: Trim, offset: Trim) -> Result<[Flank; 2]> {
        let untrimmed = |why: Untrimmed, field: &str| match why {
            Untrimmed::NoRoom => {
                let message = "the rim is lower than what is to lie within it: expected less".to_owned();
                self.error(Code::NoRoom, field, message).with("what", "above-rim")
            }
            Untrimmed::Refused(error) => error,
        };
        let direction = if wall.side == Side::Inside { -1.0 } else { 1.0 };
        let (skin, thickness) = (self.skin, self.thickness);
        let trimmed = |flank: Flank, face: WallSide, trim: Trim| flank.trimmed(skin, thickness, face, trim);
        let surface = trimmed(Flank::design(skin, thickness), WallSide::Design, design);
        let surface = surface.map_err(|why| untrimmed(why, "wall.drain"))?;
        if let Some(lined) = self.lined {
            let flank = Flank::lining(lined.skin(), thickness);
            let other = flank.trimmed(lined.skin(), thickness, WallSide::Lining, offset);
            return Ok([surface, other.map_err(|why| untrimmed(why, "wall.base"))?]);
        }
        let field = if matches!(offset, Trim::Cylinder(_)) { "wall.drain" } else { "wall.base" };
        let other = Flank::offset(skin, thickness, wall, direction)?;
        let other = trimmed(other, WallSide::Offset { direction }, offset).map_err(|why| untrimmed(why, field))?;
        Ok(if wall.side == Side::Inside { [surface, other] } else { [other, surface] })
    }

    fn rim(&mut self, wall: &Wall, from: &Arc<Sheet>, to: &Arc<Sheet>, at: f64) {
        let is_exact = from.is_exact() && to.is_exact();
        let form = match wall.rim {
            RimForm::Rounded => Form::Bead(Bead { from: Arc::clone(from), to: Arc::clone(to), at }),
            _ => {
                let end = |sheet: &Arc<Sheet>| {
                    let sheet = Arc::clone(sheet);
                    if at == 0.0 { Curve::Start(sheet) } else { Curve::End(sheet) }
                };
                Form::Ruled { from: end(from), to: end(to) }
            }
        };
        self.push(FaceKind::Rim, form, false, is_exact);
    }

    /// A wall with a floor, or with a round bottom.
    fn cup(mut self, wall: &Wall) -> Result<Parts> {
        let inside = wall.side == Side::Inside;
        let is_pole = self.skin.poles()[0];
        let [ring_width, ring_height] = wall.foot.unwrap_or([0.0; 2]);
        let radius = wall.drain / 2.0;
        let surface = self.whole(WallSide::Design);
        let foot = Arc::new(Curve::Start(Arc::clone(&surface)));
        let outline = Outline::of(&foot, self.skin);
        if is_pole && wall.foot.is_some() {
            let message =
                "a round bottom has no edge under which a ring could stand: expected a surface with a foot, or no ring"
                    .to_owned();
            return Err(self.error(Code::NoRoom, "wall.foot", message).with("what", "round-bottom"));
        }
        // The level on the other side of the base, to which the other side of the wall is cut.
        let cut =
            if inside { outline.highest + ring_height + wall.base } else { outline.lowest - wall.base - ring_height };
        let design_trim = if is_pole && radius > 0.0 { Trim::Cylinder(radius) } else { Trim::Foot };
        // Without a base a round bottom is all wall.
        let offset_trim = if is_pole && wall.base == 0.0 { Trim::Foot } else { Trim::Level(cut) };
        let [mut outer, mut lining] = self.sides(wall, design_trim, offset_trim)?;
        let offset = if inside { lining.first() } else { outer.first() };
        // A round bottom may be all wall; over a tip the other side of the wall does not close.
        let (is_cut, is_above) = (offset.has_column_cut(), offset.has_column_above());
        let is_bridged = offset.has_column_bridged();
        let is_tip = is_pole && !is_cut && {
            let edge = Outline::of(&Curve::Start(Arc::clone(offset)), self.skin);
            edge.widest > POINT * self.skin.size()
        };
        if is_pole && (if is_tip { inside || wall.base == 0.0 } else { is_cut && is_above }) {
            let message = format!(
                "the bottom ends in a tip at {}, too sharp for a wall above a base of {}: expected a thicker base",
                place(outline.mean),
                plain(wall.base)
            );
            let error = self.error(Code::NoRoom, "wall.base", message).near(outline.mean.to_array());
            return Err(error.with("what", "tip").with("base", wall.base));
        }
        let has_level = !is_pole || is_cut || is_tip;
        if is_pole && !has_level && radius > 0.0 {
            [outer, lining] = self.sides(wall, design_trim, Trim::Cylinder(radius))?;
        }
        let offset = Arc::clone(if inside { lining.first() } else { outer.first() });
        let is_exact = offset.is_exact();
        let is_led = has_level && (is_above || is_tip || is_bridged);

        // The edge of the clay at the design's side of the base, and at the other.
        let middle = if is_pole { outline.mean } else { self.disc(&outline, "shape", "foot")? };
        let edge = Arc::new(Curve::Start(Arc::clone(&offset)));
        // Outside, straight down from above the foot would be through it: first round it, to its side.
        let beside =
            Arc::new(if is_led && !inside { Curve::Beside { sheet: Arc::clone(&offset) } } else { (*edge).clone() });
        let level_edge = Arc::new(if is_led {
            Curve::Level { curve: Arc::clone(&beside), sheet: Arc::clone(&surface), level: cut }
        } else {
            (*edge).clone()
        });
        let across = Outline::of(&level_edge, self.skin);
        let across_middle = match has_level {
            true => Some(self.disc(&across, "wall.base", if inside { "floor" } else { "underside" })?),
            false => None,
        };

        // The hole.
        let hole = (radius > 0.0).then(|| {
            let near = Arc::new(if is_pole {
                Curve::Start(Arc::clone(if inside { outer.first() } else { lining.first() }))
            } else if outline.is_star {
                Curve::Cylinder { curve: Arc::clone(&foot), sheet: Arc::clone(&surface), centre: middle, radius }
            } else {
                outline.circle(&surface, radius)
            });
            let far = match has_level {
                true => Curve::Level { curve: Arc::clone(&near), sheet: Arc::clone(&surface), level: cut },
                false => (*edge).clone(),
            };
            (near, Arc::new(far))
        });
        if let Some((near, far)) = &hole {
            if !is_pole {
                self.hole_fits(near, &outline, wall)?;
            }
            if has_level {
                self.hole_fits(far, &across, wall)?;
            }
        }

        // From the middle of the underside to the outside.
        let (under_hole, floor_hole) = match &hole {
            Some((near, far)) if inside => (Some(near), Some(far)),
            Some((near, far)) => (Some(far), Some(near)),
            None => (None, None),
        };
        let (under_edge, under_middle) =
            if inside { (&foot, Some(middle).filter(|_| !is_pole)) } else { (&level_edge, across_middle) };
        let under_is_exact = inside || is_exact;
        if let Some(middle) = under_middle {
            let start = under_hole.map_or(Curve::Point(middle), |hole| (**hole).clone());
            let is_level = if inside { outline.is_level } else { true };
            match wall.foot {
                None => self.ruled(FaceKind::Underside, &start, under_edge, is_level, under_is_exact),
                Some(_) => {
                    self.foot_ring(&start, under_edge, [ring_width, ring_height], &surface, under_is_exact, wall)?
                }
            }
        }
        if !inside && is_led {
            self.ruled(FaceKind::Outer, &level_edge, &beside, false, is_exact);
            self.push(FaceKind::Outer, Form::Heel { sheet: Arc::clone(&offset) }, false, is_exact);
        }
        self.flank(FaceKind::Outer, &outer, false);
        self.rim(wall, outer.last(), lining.last(), 1.0);
        self.flank(FaceKind::Lining, &lining, true);
        if inside && is_led {
            self.ruled(FaceKind::Lining, &edge, &level_edge, false, is_exact);
        }
        let (floor_edge, floor_middle) =
            if inside { (&level_edge, across_middle) } else { (&foot, Some(middle).filter(|_| !is_pole)) };
        if let Some(middle) = floor_middle {
            let end = floor_hole.map_or(Curve::Point(middle), |hole| (**hole).clone());
            let is_level = if inside { true } else { outline.is_level };
            self.ruled(FaceKind::Floor, floor_edge, &end, is_level, !inside || is_exact);
        }
        if let (Some(under), Some(floor)) = (under_hole, floor_hole) {
            let under = match wall.foot {
                Some(_) => self.raised(under, ring_height, &surface),
                None => (**under).clone(),
            };
            self.ruled(FaceKind::Drain, floor, &under, false, true);
        }
        let lowest = if inside || !has_level { outline.lowest } else { cut };
        Ok((self.pieces, hole.is_some(), lowest))
    }

    /// A level curve, so much higher.
    fn raised(&self, curve: &Arc<Curve>, height: f64, surface: &Arc<Sheet>) -> Curve {
        let level = self.skin.frame().level(curve.at(0.0).0) + height;
        Curve::Level { curve: Arc::clone(curve), sheet: Arc::clone(surface), level }
    }

    /// The recess, its wall and the ring on which the pot stands, from a curve or point at the level of the foot.
    fn foot_ring(
        &mut self,
        start: &Curve,
        edge: &Arc<Curve>,
        [width, height]: [f64; 2],
        surface: &Arc<Sheet>,
        is_exact: bool,
        wall: &Wall,
    ) -> Result<()> {
        let outline = Outline::of(edge, self.skin);
        if !outline.is_level {
            let message = "a ring needs a level foot to stand on: expected one, or no ring".to_owned();
            return Err(self.error(Code::NoRoom, "wall.foot", message).with("what", "foot-not-level"));
        }
        let inner =
            Arc::new(Curve::Inset { curve: Arc::clone(edge), sheet: Arc::clone(surface), width: width * outline.turn });
        // Where the ring is as wide as the foot bends, its inner edge turns back.
        for v in self.skin.round() {
            let ((_, outer), (at, inner)) = (edge.at(v), inner.at(v));
            if !(outer.dot(inner) > 0.0) {
                let message = format!(
                    "a ring {} wide has no room within the foot at {}: expected a narrower one",
                    short(width),
                    place(at)
                );
                let error = self.error(Code::NoRoom, "wall.foot", message).near(at.to_array());
                return Err(error.with("what", "ring-too-wide").with("width", width));
            }
        }
        let room = Outline::of(&inner, self.skin);
        if room.middle.is_none() || room.turn != outline.turn {
            let message = format!("a ring {} wide fills the foot: expected a narrower one", short(width));
            return Err(self
                .error(Code::NoRoom, "wall.foot", message)
                .with("what", "ring-fills-foot")
                .with("width", width));
        }
        let top = Arc::new(self.raised(&inner, height, surface));
        let start = match start {
            Curve::Point(point) => Curve::Point(*point + self.skin.frame().axis() * height),
            hole => {
                let hole = Arc::new(hole.clone());
                self.hole_fits(&hole, &room, wall)?;
                self.raised(&hole, height, surface)
            }
        };
        self.ruled(FaceKind::Recess, &start, &top, true, is_exact);
        self.ruled(FaceKind::FootRing, &top, &inner, false, is_exact);
        self.ruled(FaceKind::Underside, &inner, edge, true, is_exact);
        Ok(())
    }

    /// Whether the edge of a drain hole is within an outline.
    fn hole_fits(&self, hole: &Curve, outline: &Outline, wall: &Wall) -> Result<()> {
        let frame = self.skin.frame();
        let middle = frame.plan(outline.middle.unwrap_or(outline.mean));
        if !outline.goes_round_middle {
            let at = outline.middle.unwrap_or(outline.mean);
            let message = format!("the middle of the base at {} is outside of it, so no drain can be there", place(at));
            let error = self.error(Code::NoRoom, "wall.drain", message).near(at.to_array());
            return Err(error.with("what", "middle-outside"));
        }
        let reach = self.skin.round().map(|v| (frame.plan(hole.at(v).0) - middle).length()).fold(0.0, f64::max);
        if reach < outline.narrowest {
            return Ok(());
        }
        let message = format!(
            "a drain of {} has no room in the base, which is only {} wide there: expected a smaller one",
            plain(wall.drain),
            short(2.0 * outline.narrowest)
        );
        let error = self.error(Code::NoRoom, "wall.drain", message).with("what", "drain-too-wide");
        Err(error.with("drain", wall.drain).with("room", 2.0 * outline.narrowest))
    }
}
