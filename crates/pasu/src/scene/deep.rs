//! A place of one of two bodies that are nearly of revolution about one axis, deep in the other.

use std::collections::VecDeque;

use glam::DVec3;

use super::budget::Steps;
use super::section::Section;

/// The most places of each of two that are asked for how deep they are.
const MOST_ASKED: usize = 128;

/// A place of one of two that is deeper in the other than the slack, with both borders so far off in all, and how deep it is at least; the outer `None` where work is at its end.
///
/// Long stretches are asked before short ones, so that places are soon all along.
pub(super) fn deep(
    sections: &mut [Section; 2],
    slack: f64,
    off: f64,
    steps: &mut Steps,
) -> Option<Option<(DVec3, f64)>> {
    for part in 0..2 {
        let [one, other] = &mut *sections;
        let (of, against) = if part == 0 { (one, other) } else { (other, one) };
        if against.inside == 0.0 {
            continue;
        }
        let mut n_asked = 0;
        let mut open = VecDeque::from([of.root()]);
        while let Some(index) = open.pop_front() {
            let stretch = *of.stretch(index);
            if against.is_far(&stretch, off, steps)? && against.is_without(stretch.start, off, steps)? {
                continue;
            }
            if let Some(stroke) = stretch.stroke {
                if n_asked >= MOST_ASKED {
                    break;
                }
                n_asked += 1;
                let [from, to] = stroke.t;
                if let Some(depth) = against.depth(stroke.inner[1], off, slack, steps)? {
                    return Some(Some((of.place(&stroke, 0.5 * from + 0.5 * to), depth)));
                }
            }
            open.extend(of.halves(index, steps)?.into_iter().flatten());
        }
    }
    Some(None)
}
