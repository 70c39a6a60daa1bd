//! Which body a part is: the one that is measured, checked, meshed, drawn and written.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use super::fit::{can_give_way, fitted, may_be_at_fault};
use super::meshed::{Made, grid, refuse_crossing};
#[cfg(feature = "patchwork")]
use crate::blend::flank_problem;
use crate::design::{Address, BoundaryValue, Design, Shape, Wall};
use crate::error::{Code, Error, Result};
use crate::solid::{Pot, Product, Skin};
use crate::solution::{Kept, Placed, Solution};
use crate::watch;

/// Pots whose meshes have more triangles are not judged beforehand: it would take longer than all else that is asked of them.
const MOST_JUDGED: usize = 1_000_000;

/// Pots whose meshes have more triangles are measured without being meshed: measuring them takes long by itself.
const MOST_SEEN: usize = 50_000;

/// A body of clay, settled whatever is asked of it: a ring or a drain for which there is no room has given way to one for which there is.
pub(crate) enum Settled {
    /// Its faces.
    Faces(Pot),
    /// The mesh by which it was judged besides, and how many millimetres a model unit has there.
    Meshed(Box<Made>, f64),
}

/// What is kept of a body.
struct Body {
    pot: Result<Pot>,
    /// Whether it passes every check on its usual mesh.
    verdict: OnceLock<Result<()>>,
}

impl Body {
    fn new(pot: Result<Pot>) -> Body {
        Body { pot, verdict: OnceLock::new() }
    }
}

impl Settled {
    fn pot(&self) -> &Pot {
        match self {
            Settled::Faces(pot) => pot,
            Settled::Meshed(made, _) => &made.pot,
        }
    }

    /// The faces alone.
    fn into_pot(self) -> Pot {
        match self {
            Settled::Faces(pot) => pot,
            Settled::Meshed(made, _) => made.pot,
        }
    }

    /// The mesh within a tolerance; `scale` is from model units to millimetres. One that is coarser than usual has to be made as usual too, by whoever asks for it.
    ///
    /// # Errors
    /// As [`solid`](crate::solid()).
    fn made(self, tolerance: Option<f64>, scale: f64) -> Result<Made> {
        match self {
            Settled::Meshed(made, judged) if tolerance.is_none() && judged == scale => Ok(*made),
            _ => Made::within(self.into_pot(), tolerance, scale),
        }
    }
}

impl Pot {
    /// The faces of part number `part`. A foot ring or a drain for which there is no room gives way to the nearest of those that are tried for which there is, of which [`check`](crate::check()) warns.
    ///
    /// # Errors
    /// `no-such-point` for a part that does not exist; what [`Surface::solve`](crate::Surface::solve) refuses; `no-wall`, `open-surface`, `pinched-surface`, `no-opening`, `no-room` with the
    /// field that asks too much and the place. That the faces do not cross is only known of a [mesh](crate::solid).
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// use pasu::{Pot, Product};
    ///
    /// let pot = Pot::new(&cup, 0, Product::Pot)?;
    /// assert_eq!(pot.thickness(), (0.5, 0.5));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn new(design: &Design, part: usize, product: Product) -> Result<Pot> {
        Solution::of(design).pot(part, product)
    }
}

impl Solution {
    /// As [`Pot::new`].
    ///
    /// # Errors
    /// As [`Pot::new`].
    pub fn pot(&self, part: usize, product: Product) -> Result<Pot> {
        self.settled(part, product).map(Settled::into_pot)
    }

    /// As [`Solution::pot`], unless the body runs through itself on the mesh by which it is [checked](crate::check()), if its surface does not ask for more than 50,000 triangles.
    ///
    /// # Errors
    /// As [`solid`](crate::solid()).
    pub(crate) fn sound_pot(&self, part: usize, product: Product) -> Result<Pot> {
        let pot = self.pot(part, product)?;
        let scale = self.design().unit().millimetres();
        if !grid(pot.skin(), None, None).is_ok_and(|grid| grid.n_triangles() <= MOST_SEEN) {
            return Ok(pot);
        }
        let known = self.body(part, product)?.get::<Body>().and_then(|body| body.verdict.get());
        let verdict = match known {
            Some(verdict) => verdict.clone(),
            None => {
                let seen = refuse_crossing(pot.shared_skin(), None, scale)
                    .and_then(|()| Made::of(pot.clone(), None, scale).map(drop));
                self.judged(part, product, &seen)?;
                seen
            }
        };
        match verdict {
            Err(error) if is_of_the_body(&error) => Err(error),
            _ => Ok(pot),
        }
    }

    /// The mesh of a body; `scale` is from model units to millimetres. One that is coarser than usual has to be made as usual too, by whoever asks for it.
    ///
    /// # Errors
    /// As [`solid`](crate::solid()).
    pub(crate) fn made(&self, part: usize, product: Product, tolerance: Option<f64>, scale: f64) -> Result<Made> {
        let made = self.settled(part, product)?.made(tolerance, scale);
        if tolerance.is_none() && scale == self.design().unit().millimetres() {
            self.judged(part, product, &made)?;
        }
        made
    }

    /// Keeps whether there is a body on its usual mesh.
    fn judged<T>(&self, part: usize, product: Product, seen: &Result<T>) -> Result<()> {
        // What was found while a call was being ended is not known to be so.
        watch::go_on()?;
        if let Some(body) = self.body(part, product)?.get::<Body>() {
            body.verdict.get_or_init(|| seen.as_ref().map(drop).map_err(Error::clone));
        }
        Ok(())
    }

    /// The body of a part, sought once. Its ring and drain are judged once, on a mesh of the usual tolerance and without size or shrinkage, so that they are the same whatever is asked for.
    ///
    /// # Errors
    /// As [`Pot::new`].
    pub(crate) fn settled(&self, part: usize, product: Product) -> Result<Settled> {
        let kept = self.body(part, product)?;
        if let Some(body) = kept.get::<Body>() {
            return body.pot.clone().map(Settled::Faces);
        }
        let settled = self.sought(part, product);
        // What was found while a call was being ended is not known to be so.
        watch::go_on()?;
        kept.keep(Body::new(settled.as_ref().map(|settled| settled.pot().clone()).map_err(Error::clone)));
        settled
    }

    fn body(&self, part: usize, product: Product) -> Result<&Kept> {
        let [pot, solid] = self.bodies(part)?;
        Ok(if product == Product::Pot { pot } else { solid })
    }

    /// A part, unless it is to have a wall that its shape cannot carry.
    ///
    /// # Errors
    /// As [`Solution::workable`]; `unsupported-shape`.
    pub(crate) fn walled(&self, part: usize) -> Result<&Arc<Placed>> {
        let placed = self.workable(part)?;
        let (_, of) = self.existing(part)?;
        if of.wall.is_some() && placed.solved().wall().is_none() {
            let (what, message) = match of.shape.address() {
                Address::Volume => (
                    "open-sections",
                    "a wall goes round between two closed sections: expected a disc or an outline at both ends, or no wall; without one this is a solid",
                ),
                _ if placed.solved().is_closed() => (
                    "closes",
                    "patches that close are a solid as they are, and have no free edge for a wall to end at: expected no wall",
                ),
                _ => (
                    "no-ends",
                    "a network of patches has no foot and no rim, so that it is no pot: what is open has a wall along its normals",
                ),
            };
            return Err(Error::new(Code::UnsupportedShape, placed.path("wall"), message).with("what", what));
        }
        Ok(placed)
    }

    /// The surface of a part; for a wall with a lining of its own it says what it solves.
    pub(crate) fn skin(&self, part: usize, product: Product) -> Result<Skin> {
        let skin = Skin::new(self.walled(part)?)?;
        let (_, of) = self.existing(part)?;
        let is_lined = product == Product::Pot && of.wall.is_some_and(|wall| wall.lining.is_some());
        Ok(skin.solving(if is_lined { problem_of(&of.shape) } else { None }))
    }

    fn sought(&self, part: usize, product: Product) -> Result<Settled> {
        let skin = Arc::new(self.skin(part, product)?);
        match self.wall(part, product)? {
            Some(asked) if can_give_way(&asked) => settle(&skin, asked, self.design().unit().millimetres()),
            wall => Pot::of(&skin, wall).map(Settled::Faces),
        }
    }

    /// The pot of a part while a hand changes it, with the wall that was asked for: its thickness is sought at the places of a mesh and nowhere more closely.
    ///
    /// # Errors
    /// As [`Pot::new`].
    pub(crate) fn quick_pot(&self, part: usize) -> Result<Pot> {
        let skin = self.skin(part, Product::Pot)?;
        let wall = self.wall(part, Product::Pot)?;
        Pot::looked_at(&Arc::new(skin), wall, false)
    }

    /// The same with ring and drain as they were fitted; `None` where they are as asked for.
    ///
    /// # Errors
    /// As [`Pot::new`].
    pub(crate) fn quick_fitted_pot(&self, part: usize) -> Result<Option<Pot>> {
        let asked = self.wall(part, Product::Pot)?;
        let Some(pot) = self.settled(part, Product::Pot).map(Settled::into_pot).ok().filter(|pot| pot.wall() != asked)
        else {
            return Ok(None);
        };
        Pot::looked_at(pot.shared_skin(), pot.wall(), false).map(Some)
    }
}

/// What the surface between foot and rim of a shape solves.
fn problem_of(shape: &Shape) -> Option<BoundaryValue> {
    match shape {
        #[cfg(feature = "patchwork")]
        Shape::Blend(blend) => Some(flank_problem(blend)),
        _ => shape.problem().map(Cow::into_owned),
    }
}

/// Whether a refusal is of a body that there cannot be, and not of a mesh that would be too large, or of a call that was ended.
fn is_of_the_body(error: &Error) -> bool {
    matches!(error.code(), Code::CrossesItself | Code::NoRoom | Code::PinchedSurface)
}

/// The body with the wall that is asked for, or with the nearest ring and drain that fit where those do not. Where none fit it is as asked for, to be refused with the reason when it is meshed.
fn settle(skin: &Arc<Skin>, asked: Wall, scale: f64) -> Result<Settled> {
    let pot = Pot::of(skin, Some(asked));
    if !grid(skin, None, None).is_ok_and(|grid| grid.n_triangles() <= MOST_JUDGED) {
        return pot.map(Settled::Faces);
    }
    let (pot, error) = match pot.map(|pot| Made::at_once(pot, scale)) {
        Ok(Ok(made)) => return Ok(Settled::Meshed(Box::new(made), scale)),
        Ok(Err(refused)) => {
            let (pot, error) = *refused;
            (Ok(pot), error)
        }
        Err(error) => (Err(error.clone()), error),
    };
    if may_be_at_fault(&asked, &error)
        && let Some(made) = fitted(skin, &asked, pot.as_ref().ok(), scale)
    {
        return Ok(Settled::Meshed(Box::new(made), scale));
    }
    pot.map(Settled::Faces)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::make::{Making, check};
    use crate::measure::MeasureOptions;

    /// A cone that leans inwards by as much as it rises, on a ring that would come out of it.
    const CONE: &str = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [1, 0, 4, 0], "t": [0, 0], "n": [1, 2], "height": 3 },
        "wall": { "thickness": 0.2, "base": 0.3, "foot": [0.3, 0.6] } }] }"#;

    /// The wall of the body that is kept.
    fn found(solution: &Solution, product: Product) -> Option<Wall> {
        let body = solution.body(0, product).unwrap().get::<Body>()?;
        body.pot.as_ref().unwrap().wall()
    }

    #[test]
    fn what_is_refused_is_refused_again_without_being_tried_again() {
        let design = Design::parse(&CONE.replace(r#""base": 0.3"#, r#""base": 30"#)).unwrap();
        let solution = Solution::of(&design);
        let error = solution.pot(0, Product::Pot).unwrap_err();
        let kept = solution.body(0, Product::Pot).unwrap().get::<Body>().unwrap();
        assert_eq!(kept.pot.as_ref().unwrap_err(), &error);
        assert_eq!(solution.pot(0, Product::Pot).unwrap_err(), error);
        solution.pot(0, Product::Solid).unwrap();
    }

    #[test]
    fn a_body_goes_along_with_a_part_that_stands_and_not_into_another_unit() {
        let text = |unit: &str, height: u8| {
            let cup = |height: u8| CONE.replace(r#""height": 3"#, &format!(r#""height": {height}"#));
            let parts = [cup(3), cup(height)].map(|cup| {
                let (from, to) = (cup.find('[').unwrap() + 1, cup.rfind(']').unwrap());
                cup[from..to].to_owned()
            });
            format!(r#"{{ "pasu": 1, "unit": "{unit}", "parts": [{}] }}"#, parts.join(", "))
        };
        let first = Solution::of(&Design::parse(&text("cm", 4)).unwrap());
        let kept =
            |solution: &Solution, part: usize| solution.bodies(part).unwrap()[0].get::<Body>().map(core::ptr::from_ref);
        (0..2).for_each(|part| drop(first.pot(part, Product::Pot).unwrap()));
        let next = |unit: &str, height: u8| first.after(&Design::parse(&text(unit, height)).unwrap());
        assert!(kept(&first, 0).is_some() && kept(&next("cm", 5), 0) == kept(&first, 0));
        assert_eq!(kept(&next("cm", 5), 1), None);
        assert_eq!(kept(&next("mm", 4), 0), None);
    }

    #[test]
    fn what_was_settled_is_kept_and_is_the_same_whatever_is_asked_first() {
        let design = Design::parse(CONE).unwrap();
        let kept = |ask: &dyn Fn(&Solution)| {
            let solution = Solution::of(&design);
            assert!(found(&solution, Product::Pot).is_none());
            ask(&solution);
            found(&solution, Product::Pot).unwrap()
        };
        let fine = Making { tolerance: Some(0.003), ..Making::default() };
        let walls = [
            kept(&|solution| drop(solution.check(&Making::default()).unwrap())),
            kept(&|solution| drop(solution.check(&fine).unwrap())),
            kept(&|solution| drop(solution.measure(&MeasureOptions::default()).unwrap())),
            kept(&|solution| drop(solution.pot(0, Product::Pot).unwrap())),
        ];
        let asked = design.parts()[0].wall.unwrap();
        assert!(walls.iter().all(|wall| *wall == walls[0] && wall.foot != asked.foot), "{walls:?}");
        let [width, height] = walls[0].foot.unwrap();
        assert!(width > height, "{walls:?}");
        // A solid has no wall and is another body.
        let solution = Solution::of(&design);
        assert_eq!(solution.pot(0, Product::Solid).unwrap().wall(), None);
        assert!(found(&solution, Product::Pot).is_none());
    }

    #[test]
    fn what_is_kept_is_not_sought_again() {
        let design = Design::parse(CONE).unwrap();
        let solution = Solution::of(&design);
        // What nobody would find, to be told from what is found.
        let known = Wall { foot: Some([0.7, 0.1]), ..design.parts()[0].wall.unwrap() };
        let skin = Arc::new(Skin::new(solution.workable(0).unwrap()).unwrap());
        solution.body(0, Product::Pot).unwrap().keep(Body::new(Pot::of(&skin, Some(known))));
        assert_eq!(solution.pot(0, Product::Pot).unwrap().wall(), Some(known));
        let report = solution.check(&Making::default()).unwrap();
        assert_eq!(report.findings[0].remedy.as_ref().map(|remedy| remedy.wall), Some(known));
        assert_ne!(check(&design, &Making::default()).unwrap().findings[0].remedy, report.findings[0].remedy);
    }
}
