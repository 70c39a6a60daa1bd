//! The closed form of a network of vertex-frames.

use core::f64::consts::PI;
use std::sync::Arc;

use glam::DVec3;

use super::bump::Bump;
use super::four_sided::{FourSided, mixed};
use super::network::{refuse_coincident_corners, sides};
use super::orientation::{Lay, Orientation};
use super::region::pieces;
use super::strips::Strips;
use crate::design::{Force, FramePatch, FrameRule, VertexFrame, plain};
use crate::error::{Code, Error, Result};
use crate::patch::{Patch, Side};

/// The most pieces of forces that one network may have.
const MOST_PIECES: usize = 100_000;

/// A network of vertex-frames, solved: polynomial patches that have their edges in common.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame {
    patches: Vec<Arc<FourSided>>,
    orientation: Orientation,
    crease: f64,
    joints: Arc<Joints>,
    /// What acts on each patch.
    acting: Vec<Acting>,
}

/// What the frames of a network and its rule decide alone, wherever its points are.
#[derive(Debug, PartialEq)]
struct Joints {
    frames: Vec<[u32; 8]>,
    rule: FrameRule,
    sides: Vec<[Side; 4]>,
    strips: Strips,
    lay: Lay,
}

/// The parameters of a patch, and what sculpts it.
#[derive(Debug, Clone, PartialEq)]
struct Acting {
    a1: [f64; 3],
    a2: [f64; 3],
    forces: Vec<Force>,
}

#[cfg(test)]
std::thread_local! {
    /// How many patches were formed on this thread.
    pub(crate) static FORMED: core::cell::Cell<usize> = const { core::cell::Cell::new(0) };
}

/// A patch through eight points was formed: tests count how many were.
fn formed(patch: FourSided) -> Arc<FourSided> {
    #[cfg(test)]
    FORMED.set(FORMED.get() + 1);
    Arc::new(patch)
}

impl Frame {
    /// Solves a network. `path` is where the shape stands in its design, for the error.
    ///
    /// # Errors
    /// `pinched-surface` for a patch two corners of which are the same; `crosses-itself` for an edge of three patches; `out-of-range` where a parameter is 0 that a strip needs; `overflow` where coefficients leave the range of
    /// doubles. Of a force: `out-of-range` where `a1 + a2` is 0, or its rectangle does not meet its patch, `crosses-itself` where that cannot lie flat on the patches that it goes on to.
    pub(crate) fn solve(shape: &VertexFrame, path: &str) -> Result<Frame> {
        let inside = |error: Error| {
            let error = error.inside_field("patches");
            let place = format!("{path}.{}", error.path());
            error.at(place)
        };
        let numbers = 0..shape.patches.len();
        refuse_coincident_corners(numbers.clone().map(|index| (index, points(shape, index)))).map_err(inside)?;
        let sides = sides(&shape.patches).map_err(inside)?;
        let (strips, lay) = (Strips::of(&sides, shape.rule), Lay::of(&sides));
        let mixed = |patch: usize| mixed(&points(shape, patch));
        let cubic = strips.cubic(&shape.patches, mixed, |_| true).map_err(inside)?;
        let form = |index: usize| FourSided::new(points(shape, index), cubic[index], sides[index]);
        let mut patches: Vec<FourSided> = numbers.map(form).collect();
        sculpt(&shape.patches, &sides, &mut patches).map_err(inside)?;
        if let Some(index) = patches.iter().position(|patch| !patch.is_finite()) {
            let message = "these numbers are so large, or so small, that the patch cannot be computed";
            return Err(inside(Error::new(Code::Overflow, "", message).inside_item(index)));
        }
        let patches: Vec<Arc<FourSided>> = patches.into_iter().map(formed).collect();
        let frames = shape.patches.iter().map(|patch| patch.frame).collect();
        Ok(Frame {
            orientation: Orientation::of(&patches, &lay),
            patches,
            crease: shape.crease,
            joints: Arc::new(Joints { frames, rule: shape.rule, sides, strips, lay }),
            acting: shape.patches.iter().map(acting).collect(),
        })
    }

    /// Solves a network of the same frames as this one by the patches of the strips alone of which a point or a parameter is another; the others are those of this one. Every bit is that of [`Frame::solve`].
    ///
    /// `None` where it has to be solved as a whole: frames, the rule, forces or what they act on are others, or the network is refused.
    pub(crate) fn after(&self, shape: &VertexFrame) -> Option<Frame> {
        let joints = &*self.joints;
        let is_same = |(patch, (frame, acting)): (&FramePatch, (&[u32; 8], &Acting))| {
            let is_alike = (acting.a1, acting.a2) == (patch.a1, patch.a2);
            patch.frame == *frame && patch.forces == acting.forces && (is_alike || patch.forces.is_empty())
        };
        let n = self.patches.len();
        if shape.patches.len() != n
            || shape.rule != joints.rule
            || !shape.patches.iter().zip(joints.frames.iter().zip(&self.acting)).all(is_same)
        {
            return None;
        }
        let bits = |points: [DVec3; 8]| points.map(|point| point.to_array().map(f64::to_bits));
        let is_other = |index: &usize| {
            let (patch, acting) = (&shape.patches[*index], &self.acting[*index]);
            bits(points(shape, *index)) != bits(self.patches[*index].points())
                || (acting.a1, acting.a2) != (patch.a1, patch.a2)
        };
        let others: Vec<usize> = (0..n).filter(is_other).collect();
        let mut is_wanted = vec![false; 2 * n];
        for top in others.iter().flat_map(|patch| joints.strips.tops(*patch)) {
            is_wanted[top] = true;
        }
        refuse_coincident_corners(others.iter().map(|index| (*index, points(shape, *index)))).ok()?;
        let mixed = |patch: usize| mixed(&points(shape, patch));
        let cubic = joints.strips.cubic(&shape.patches, mixed, |top| is_wanted[top]).ok()?;
        let (mut patches, mut changed) = (self.patches.clone(), Vec::new());
        for (index, patch) in patches.iter_mut().enumerate() {
            let wanted = joints.strips.tops(index).map(|top| is_wanted[top]);
            if wanted == [false; 2] {
                continue;
            }
            let (old, new) = (patch.cubic(), cubic[index]);
            let cubic = [0, 1].map(|direction| if wanted[direction] { new[direction] } else { old[direction] });
            let moved = patch.moved(points(shape, index), cubic);
            if !moved.is_finite() {
                return None;
            }
            *patch = formed(moved);
            changed.push(index);
        }
        let orientation = self.orientation.after(&patches, &joints.lay, &changed);
        Some(Frame {
            orientation: orientation.unwrap_or_else(|| Orientation::of(&patches, &joints.lay)),
            patches,
            crease: shape.crease,
            joints: Arc::clone(&self.joints),
            acting: shape.patches.iter().map(acting).collect(),
        })
    }

    /// The patches that are others than those of a network before, ascending; `None` where this one was not solved after that one, or something else differs that is to be seen.
    pub(crate) fn changed_since(&self, before: &Frame) -> Option<Vec<usize>> {
        let is_after = Arc::ptr_eq(&self.joints, &before.joints) && self.crease == before.crease;
        if !is_after || self.is_outward() != before.is_outward() {
            return None;
        }
        let both = self.patches.iter().zip(&before.patches).enumerate();
        Some(both.filter(|(_, (now, before))| !Arc::ptr_eq(now, before)).map(|(index, _)| index).collect())
    }

    /// One of the patches; the first in place of one that there is not.
    pub(crate) fn patch(&self, index: usize) -> &dyn Patch {
        &**self.patches.get(index).unwrap_or(&self.patches[0])
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        self.patches.len()
    }

    /// All of them.
    pub(super) fn shared_patches(&self) -> &[Arc<FourSided>] {
        &self.patches
    }

    /// Whether it has two sides: a Moebius strip has one.
    pub(super) fn is_two_sided(&self) -> bool {
        self.joints.lay.is_two_sided
    }

    /// Whether it goes round a body: no side of a patch is free, and the network has an inside and an outside.
    pub(crate) fn is_closed(&self) -> bool {
        let mut sides = self.joints.sides.iter().flatten();
        self.joints.lay.is_two_sided && sides.all(|side| *side != Side::Free)
    }

    /// For each patch whether `X_u x X_v` points outwards.
    pub(crate) fn is_outward(&self) -> &[bool] {
        &self.orientation.is_outward
    }

    /// Edges at which the surface turns by less than this angle are shown as if it were smooth, in radians.
    pub(crate) fn crease(&self) -> f64 {
        self.crease
    }
}

/// The eight points of a patch.
fn points(shape: &VertexFrame, patch: usize) -> [DVec3; 8] {
    let point = |vertex: u32| shape.vertices.get(vertex as usize).map_or(DVec3::ZERO, |at| DVec3::from_array(*at));
    shape.patches[patch].frame.map(point)
}

fn acting(patch: &FramePatch) -> Acting {
    Acting { a1: patch.a1, a2: patch.a2, forces: patch.forces.clone() }
}

/// Adds to every patch what forces do there.
fn sculpt(given: &[FramePatch], sides: &[[Side; 4]], patches: &mut [FourSided]) -> Result<()> {
    let mut n_pieces = 0;
    for (index, FramePatch { a1, a2, forces, .. }) in given.iter().enumerate() {
        let inside = |place: usize, error: Error| error.inside_item(place).inside_field("forces").inside_item(index);
        for (place, Force { f0, u, v, falloff }) in forces.iter().enumerate() {
            let mut amplitude = DVec3::ZERO;
            for component in (0..3).filter(|component| f0[*component] != 0.0) {
                let sum = a1[component] + a2[component];
                if sum == 0.0 {
                    let axis = ["x", "y", "z"][component];
                    let message = format!(
                        "a force on {axis} acts on the sum of a1 and a2, which is 0 here: expected another number than {}, found {}",
                        plain(-a1[component]),
                        plain(a2[component])
                    );
                    let error = Error::new(Code::OutOfRange, "", message)
                        .inside_item(component)
                        .inside_field("a2")
                        .inside_item(index);
                    return Err(error.with("component", axis).with("not", -a1[component]).with("found", a2[component]));
                }
                amplitude[component] = -f0[component] / (PI * PI * sum);
            }
            let pieces = pieces(index, [*u, *v], sides).map_err(|error| inside(place, error))?;
            n_pieces += pieces.len();
            if n_pieces > MOST_PIECES {
                let message =
                    format!("expected forces over at most {MOST_PIECES} patches in all; this one exceeds them");
                return Err(inside(place, Error::new(Code::TooLarge, "", message).with("greatest", MOST_PIECES)));
            }
            for piece in pieces {
                if let Some(patch) = patches.get_mut(piece.patch) {
                    patch.add(Bump { amplitude, sides: piece.sides, falloff: *falloff });
                }
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{Design, Shape};

    /// Numbers from -1 to 1 that look random.
    fn dice(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// A sheet of `m x n` patches, or a tube that closes after `n` of them, as it stands or reversed; every third patch has a force.
    fn network(m: usize, n: usize, wrap: Option<bool>, rule: &str, seed: &mut u64) -> VertexFrame {
        let across = 2 * n + 1;
        let number = |i: usize, j: usize| match wrap {
            Some(is_reversed) if j == 2 * n => across * if is_reversed { 2 * m - i } else { i },
            _ => across * i + j,
        };
        let mut vertex = |k: usize| {
            let (i, j) = ((k / across) as f64, (k % across) as f64);
            let mut near = |x: f64| ((x + 0.2 * dice(seed)) * 1e6).round() / 1e6;
            format!("[{},{},{}]", near(i), near(j), near(0.3 * i * j))
        };
        let vertices: Vec<String> = (0..across * (2 * m + 1)).map(&mut vertex).collect();
        let patch = |k: usize| {
            let (i, j) = (2 * (k / n), 2 * (k % n));
            let round = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
            let frame = round.map(|(a, b)| number(i + a, j + b));
            let force = if k.is_multiple_of(3) { r#"{"f0":[0,1,2],"u":[0.2,0.9],"falloff":"smooth"}"# } else { "" };
            format!(r#"{{"frame":{frame:?},"a1":[1,2,{}],"forces":[{force}]}}"#, 1 + k % 4)
        };
        let patches: Vec<String> = (0..m * n).map(patch).collect();
        let (vertices, patches) = (vertices.join(","), patches.join(","));
        let shape = format!(r#"{{"kind":"vertex-frame","vertices":[{vertices}],"patches":[{patches}],"rule":{rule}}}"#);
        let design = Design::parse(&format!(r#"{{"pasu":1,"parts":[{{"shape":{shape}}}]}}"#)).unwrap();
        let Shape::VertexFrame(shape) = &design.parts()[0].shape else { panic!("a network") };
        shape.clone()
    }

    /// What comes out, and how many patches were formed for it.
    fn counted<T>(what: impl FnOnce() -> T) -> (T, usize) {
        let before = FORMED.get();
        let found = what();
        (found, FORMED.get() - before)
    }

    #[test]
    fn a_point_that_moves_has_its_strips_solved_and_no_others() {
        let (m, n, mut seed) = (6, 5, 3);
        let mut shape = network(m, n, None, "\"global\"", &mut seed);
        let (mut frame, formed) = counted(|| Frame::solve(&shape, "shape").unwrap());
        assert_eq!(formed, m * n);
        let across = 2 * n + 1;
        // A corner of four patches, so on two strips each way; the middle of an edge of two; a corner at the end; and a middle at the rim.
        for ((i, j), expected) in
            [((4, 6), 2 * m + 2 * n - 4), ((4, 5), m + 2 * n - 2), ((0, 0), m + n - 1), ((0, 3), m + n - 1)]
        {
            shape.vertices[across * i + j][2] += 0.125;
            let (next, formed) = counted(|| frame.after(&shape).expect("the same frames"));
            assert_eq!(formed, expected, "{i} {j}");
            let whole = Frame::solve(&shape, "shape").unwrap();
            assert_eq!(next.patches, whole.patches);
            assert_eq!(next.is_outward(), whole.is_outward());
            frame = next;
        }
        // What is where it was is not solved.
        assert_eq!(counted(|| frame.after(&shape).expect("the same network")).1, 0);
    }

    #[test]
    fn what_is_solved_after_another_has_the_bits_of_what_is_solved_by_itself() {
        let mut seed = 11;
        for round in 0..60 {
            let wrap = [None, Some(false), Some(true)][round % 3];
            let rule = ["\"global\"", "{\"seed\":4}"][round % 2];
            let mut shape = network(3 + round % 2, 4, wrap, rule, &mut seed);
            let mut frame = Frame::solve(&shape, "shape").unwrap();
            for step in 0..6 {
                let which = ((dice(&mut seed) + 1.0) * 0.5 * shape.vertices.len() as f64) as usize;
                shape.vertices[which][step % 3] += 0.3 * dice(&mut seed);
                // A patch without a force.
                shape.patches[1].a2[step % 3] += 0.1;
                frame = frame.after(&shape).expect("the same frames");
                let whole = Frame::solve(&shape, "shape").unwrap();
                assert_eq!(frame.patches, whole.patches, "{round} {step}");
                assert_eq!(frame.is_outward(), whole.is_outward(), "{round} {step}");
            }
        }
    }

    #[test]
    fn what_is_no_longer_the_same_network_is_solved_as_a_whole() {
        let mut seed = 5;
        let shape = network(3, 3, None, "\"global\"", &mut seed);
        let frame = Frame::solve(&shape, "shape").unwrap();
        let refused = |change: &dyn Fn(&mut VertexFrame)| {
            let mut other = shape.clone();
            change(&mut other);
            frame.after(&other).is_none()
        };
        assert!(refused(&|shape| shape.rule = FrameRule::Seed(2)));
        assert!(refused(&|shape| shape.patches.truncate(8)));
        assert!(refused(&|shape| shape.patches[4].frame.rotate_left(2)));
        assert!(refused(&|shape| shape.patches[0].forces[0].f0[0] = 1.0));
        assert!(refused(&|shape| shape.patches[3].a1[0] = 3.0));
        // Whatever is wrong is told by whoever solves all of it.
        assert!(refused(&|shape| shape.vertices[0] = shape.vertices[2]));
        assert!(refused(&|shape| shape.vertices[23] = [1e308; 3]));
        assert!(!refused(&|shape| shape.crease = 1.0));
    }
}
