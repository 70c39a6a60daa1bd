//! A design and its solution, part by part.

use std::sync::{Arc, OnceLock};

use super::kept::Kept;
use super::placed::Placed;
use super::solved::Solved;
use crate::design::{Design, Part, numbers_of};
use crate::error::{Code, Error, Result};

/// A design with the closed form of its parts. Each part is solved when something is first asked of it, and never again, however much is asked; so is the body that is made of it settled once.
///
/// Everything that can be asked of a [`Design`] can be asked of its solution, with the same answers: whoever asks several things of one design keeps this.
///
/// ```
/// use pasu::{Design, MeshOptions, Solution};
///
/// let solution = Solution::of(&Design::parse("#1/bloor-wilson?n1=5")?);
/// let mesh = solution.mesh(&MeshOptions::default())?;
/// assert_eq!(solution.fingerprint()?, pasu::fingerprint(solution.design())?);
/// assert!(mesh.n_triangles() > 0);
/// # Ok::<(), pasu::Error>(())
/// ```
#[derive(Debug)]
pub struct Solution {
    design: Design,
    parts: Vec<Slot>,
    /// What each part was in a design before, where that helps to solve it.
    before: Vec<Option<Arc<Solved>>>,
    /// What each part is made as, which others know: as a pot, and as a solid.
    bodies: Vec<[Kept; 2]>,
    /// What each part is in space, and all of them together, which the scene knows.
    spaces: Vec<Kept>,
    scene: Kept,
    /// The boxes round all of them, which may be known when they are not.
    scene_seen: Kept,
    /// The same of a design before.
    scene_before: Kept,
    scene_seen_before: Kept,
    /// What they are before they are turned and moved, and those of a design before.
    still: Kept,
    still_before: Kept,
    /// What its parts were joined to, which those who join them know.
    joined: Kept,
    /// What its parts were made as, which those who make them know, and those of a design before.
    made: Kept,
    made_before: Kept,
    /// What its parts measure, which those who measure them know, and those of a design before.
    measured: Kept,
    measured_before: Kept,
}

/// What a part has become, once something was asked of it.
type Slot = OnceLock<Result<Arc<Placed>>>;

impl Solution {
    /// The solution of a design, of which nothing is computed yet.
    pub fn of(design: &Design) -> Solution {
        let parts = design.parts();
        Solution {
            design: design.clone(),
            parts: parts.iter().map(|_| OnceLock::new()).collect(),
            before: parts.iter().map(|_| None).collect(),
            bodies: parts.iter().map(|_| Default::default()).collect(),
            spaces: parts.iter().map(|_| Kept::default()).collect(),
            scene: Kept::default(),
            scene_seen: Kept::default(),
            scene_before: Kept::default(),
            scene_seen_before: Kept::default(),
            still: Kept::default(),
            still_before: Kept::default(),
            joined: Kept::default(),
            made: Kept::default(),
            made_before: Kept::default(),
            measured: Kept::default(),
            measured_before: Kept::default(),
        }
    }

    /// The solution of a design much like this one's, of which nothing is computed yet that this one has not: parts of the same shape are not solved again, and of a network of patches whose points were moved only the strips on
    /// which they are. Every answer is to the bit that of [`Solution::of`].
    ///
    /// ```
    /// use pasu::{Design, MeshOptions, Solution};
    ///
    /// let before = Solution::of(&Design::parse("#1/bloor-wilson?n1=5")?);
    /// let design = Design::parse("#1/bloor-wilson?n1=6")?;
    /// assert_eq!(before.after(&design).fingerprint()?, pasu::fingerprint(&design)?);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    #[must_use]
    pub fn after(&self, design: &Design) -> Solution {
        let mut solution = Solution::of(design);
        // Drawing alone asks for nothing of this.
        if cfg!(feature = "patchwork") {
            solution.take_over(self);
        }
        for (index, part) in design.parts().iter().enumerate() {
            // At its own place first.
            let order = core::iter::once(index).chain(0..self.parts.len());
            let mut known = order.filter_map(|place| {
                let placed = self.parts.get(place)?.get()?.as_ref().ok()?;
                Some((self.design.parts().get(place)?, placed))
            });
            let is_same = |other: &Part| other.wall.is_some() == part.wall.is_some() && other.shape == part.shape;
            match known.clone().find(|(other, _)| is_same(other)) {
                Some((_, placed)) => {
                    let placed = Placed::of(placed.shared(), &part.place, index);
                    solution.parts[index] = OnceLock::from(Ok(Arc::new(placed)));
                }
                None => solution.before[index] = known.next().map(|(_, placed)| placed.shared()),
            }
        }
        solution
    }

    /// Takes over what others know of the parts of a design before, as far as these stand.
    fn take_over(&mut self, before: &Solution) {
        let latest = |own: &Kept, before: &Kept| if own.is_empty() { before.clone() } else { own.clone() };
        self.still_before = latest(&before.still, &before.still_before);
        self.made_before = latest(&before.made, &before.made_before);
        self.measured_before = latest(&before.measured, &before.measured_before);
        // Whether a ring has room goes by millimetres.
        if self.design.unit() != before.design.unit() {
            return;
        }
        self.scene_before = latest(&before.scene, &before.scene_before);
        self.scene_seen_before = latest(&before.scene_seen, &before.scene_seen_before);
        for (index, (part, own)) in self.design.parts().iter().zip(before.design.parts()).enumerate() {
            if own.stands_as(part) {
                self.spaces[index] = before.spaces[index].clone();
                self.bodies[index] = before.bodies[index].clone();
            }
        }
    }

    /// The design.
    pub fn design(&self) -> &Design {
        &self.design
    }

    /// One part, solved and placed.
    ///
    /// # Errors
    /// `no-such-point` for a part that does not exist; what [`Surface::solve`](crate::Surface::solve) refuses.
    pub(crate) fn part(&self, index: usize) -> Result<&Arc<Placed>> {
        let (slot, part) = self.existing(index)?;
        let solve = || match self.before.get(index) {
            Some(Some(before)) => {
                let solved = Solved::after(part, index, before)?;
                Ok(Arc::new(Placed::of(Arc::new(solved), &part.place, index)))
            }
            _ => Placed::new(part, index).map(Arc::new),
        };
        slot.get_or_init(solve).as_ref().map_err(Error::clone)
    }

    /// A part and where its solution is kept.
    ///
    /// # Errors
    /// `no-such-point`.
    pub(crate) fn existing(&self, index: usize) -> Result<(&Slot, &Part)> {
        self.parts.get(index).zip(self.design.parts().get(index)).ok_or_else(|| self.no_such_part(index))
    }

    /// Where the bodies of a part are kept, of whoever knows them: as a pot, and as a solid.
    ///
    /// # Errors
    /// `no-such-point`.
    pub(crate) fn bodies(&self, index: usize) -> Result<&[Kept; 2]> {
        self.bodies.get(index).ok_or_else(|| self.no_such_part(index))
    }

    /// Where what a part is in space is kept, of whoever knows that.
    ///
    /// # Errors
    /// `no-such-point`.
    pub(crate) fn space(&self, index: usize) -> Result<&Kept> {
        self.spaces.get(index).ok_or_else(|| self.no_such_part(index))
    }

    /// Where what all parts are together is kept.
    pub(crate) fn scene(&self) -> &Kept {
        &self.scene
    }

    /// Where the boxes round all parts are kept.
    pub(crate) fn scene_seen(&self) -> &Kept {
        &self.scene_seen
    }

    /// Where the boxes round the parts of a design before were kept, if they were.
    pub(crate) fn scene_seen_before(&self) -> &Kept {
        &self.scene_seen_before
    }

    /// Where what the parts of a design before were together was kept, if anything was.
    pub(crate) fn scene_before(&self) -> &Kept {
        &self.scene_before
    }

    /// Where what parts are before they are turned and moved is kept, and where that of the parts of a design before was, if it was.
    pub(crate) fn still_parts(&self) -> [&Kept; 2] {
        [&self.still, &self.still_before]
    }

    /// A part by itself, scaled, but neither turned nor moved; its shape is not solved again.
    ///
    /// # Errors
    /// As [`Solution::part`].
    pub(crate) fn alone(&self, index: usize) -> Result<Solution> {
        let (placed, (_, part)) = (self.part(index)?, self.existing(index)?);
        let place = part.place.still();
        let mut alone = Solution::of(&self.design.of_one(Part { place, ..part.clone() }));
        alone.parts = vec![OnceLock::from(Ok(Arc::new(Placed::of(placed.shared(), &place, 0))))];
        Ok(alone)
    }

    /// Where what the parts were joined to is kept.
    #[cfg(feature = "patchwork")]
    pub(crate) fn joined(&self) -> &Kept {
        &self.joined
    }

    /// Where what the parts were made as is kept, and where that of the parts of a design before was, if it was.
    pub(crate) fn made_parts(&self) -> [&Kept; 2] {
        [&self.made, &self.made_before]
    }

    /// Where what the parts measure is kept, and where that of the parts of a design before was, if it was.
    pub(crate) fn measured_parts(&self) -> [&Kept; 2] {
        [&self.measured, &self.measured_before]
    }

    fn no_such_part(&self, index: usize) -> Error {
        let message = format!("expected the number of a part, {}, found {index}", numbers_of(self.parts.len()));
        let error = Error::new(Code::NoSuchPoint, "part", message).with("least", 0.0);
        error.with("greatest", self.parts.len() - 1).with("found", index)
    }

    /// The number of parts.
    pub(crate) fn n_parts(&self) -> usize {
        self.parts.len()
    }

    /// Every part in order.
    pub(crate) fn parts(&self) -> impl Iterator<Item = Result<&Arc<Placed>>> {
        (0..self.parts.len()).map(|index| self.part(index))
    }
}

#[cfg(test)]
impl Solution {
    /// The parts of a design with other shapes in their place.
    pub(crate) fn with(design: &Design, solved: Vec<super::Solved>) -> Solution {
        let solution = Solution::of(design);
        for (index, solved) in solved.into_iter().enumerate() {
            let placed = Placed::of(Arc::new(solved), &design.parts()[index].place, index);
            assert!(solution.parts[index].set(Ok(Arc::new(placed))).is_ok());
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::Format;
    use crate::make::{Making, Size};
    use crate::measure::{Map, MeasureOptions};
    use crate::mesh::MeshOptions;
    use crate::solid::Product;
    use crate::surface::SOLVED;

    /// How many shapes were solved meanwhile.
    fn solved(what: impl FnOnce()) -> usize {
        let before = SOLVED.get();
        what();
        SOLVED.get() - before
    }

    fn two_pots() -> Design {
        let pot = |x: f64| {
            format!(
                r#"{{ "shape": {{ "kind": "fourth-order", "r0": 0.4, "r1": 0.3, "rm": 0.8, "h1": 2, "eta": [0.5, 0.5], "dz": [6, 6], "s": [1, 1], "t": [3, 3], "w": [1, 1] }},
                "place": {{ "shift": [{x}, 0, 0] }}, "wall": {{ "thickness": 0.08, "base": 0.1, "rim": "rounded" }} }}"#
            )
        };
        Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, pot(0.0), pot(3.0))).unwrap()
    }

    #[test]
    fn each_part_is_solved_once_whatever_is_asked() {
        let design = two_pots();
        let (mesh, measures) = (MeshOptions::default(), MeasureOptions::default());
        let by_capacity = Making { size: Some(Size::Capacity(100.0)), ..Making::default() };
        assert_eq!(solved(|| drop(crate::mesh::mesh(&design, &mesh).unwrap())), 2);
        assert_eq!(solved(|| drop(crate::measure::measure(&design, &measures).unwrap())), 2);
        assert_eq!(solved(|| drop(crate::make::check(&design, &by_capacity).unwrap())), 2);
        for format in [Format::Stl, Format::Step, Format::Svg] {
            assert_eq!(solved(|| drop(crate::export::write(&design, format, &by_capacity).unwrap())), 2);
        }
        assert_eq!(solved(|| drop(crate::evaluate::evaluate(&design, 1, &[0.5, 0.0]).unwrap())), 1);
        let solution = Solution::of(&design);
        let all = || {
            solution.mesh(&mesh).unwrap();
            solution.bound(&mesh).unwrap();
            solution.measure(&measures).unwrap();
            solution.check(&by_capacity).unwrap();
            solution.write(Format::Step, &by_capacity).unwrap();
            solution.drawn(&by_capacity).unwrap();
            solution.water(0.5).unwrap();
            solution.paint(Map::Thickness, &mesh).unwrap();
            solution.pot(1, Product::Pot).unwrap();
            solution.fingerprint().unwrap();
            solution.evaluate(0, &[0.5, 0.0]).unwrap();
        };
        assert_eq!(solved(all), 2);
        assert_eq!(solved(all), 0);
    }

    #[test]
    fn a_part_that_cannot_be_solved_is_refused_again_without_being_tried_again() {
        let text = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "t": [-0.25, 0.5] } }] }"#;
        let solution = Solution::of(&Design::parse(text).unwrap());
        let mut refused = Vec::new();
        let ask = || refused.extend([solution.fingerprint().unwrap_err(), solution.fingerprint().unwrap_err()]);
        assert_eq!(solved(ask), 1);
        assert_eq!(refused[0], refused[1]);
    }

    #[test]
    fn answers_do_not_depend_on_what_was_asked_before() {
        let design = two_pots();
        let (first, second) = (Solution::of(&design), Solution::of(&design));
        let making = Making::default();
        let report = first.check(&making).unwrap();
        let measures = first.measure(&MeasureOptions::default()).unwrap();
        let file = first.write(Format::Step, &making).unwrap();
        assert_eq!(second.write(Format::Step, &making).unwrap(), file);
        assert_eq!(second.measure(&MeasureOptions::default()).unwrap(), measures);
        assert_eq!(second.check(&making).unwrap(), report);
    }
}
