//! Bodies a little larger than they are.
//!
//! Where faces lie within millionths of each other the numbers of a file do not tell them apart, and what is left of their triangles crosses. Of bodies that are larger, each by another width than those beside it, no two faces lie so: those that face each other run into each other, and of those that look the same way one is behind the other.

use glam::DVec3;

use super::boxes::{bounds, touch};
use super::labelled::Labelled;

/// Where the corners of bodies are that are larger.
pub(super) struct Swollen {
    pub(super) positions: Vec<Vec<f64>>,
    /// No corner is further from where it was.
    pub(super) moved: f64,
}

/// Each body with a box that is wider on every side by `step` or a multiple of it, no two alike that touch: the largest stays as it is.
pub(super) fn swollen(bodies: &[&Labelled], step: f64) -> Swollen {
    let boxes: Vec<[DVec3; 2]> = bodies.iter().map(|body| bounds(body.positions)).collect();
    let widths = widths(&boxes).into_iter().map(|width| step * f64::from(width));
    let moved = widths.clone().fold(0.0, f64::max) * libm::sqrt(3.0);
    let larger = |((body, [low, high]), width): ((&&Labelled, &[DVec3; 2]), f64)| {
        let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
        let further = |point: &[f32; 3]| {
            let point = DVec3::from_array(point.map(f64::from));
            (if width > 0.0 { point + (point - middle) * (width / half) } else { point }).to_array()
        };
        body.positions.as_chunks::<3>().0.iter().flat_map(further).collect()
    };
    Swollen { positions: bodies.iter().zip(&boxes).zip(widths).map(larger).collect(), moved }
}

/// The least numbers of which no two are equal whose boxes touch, the largest box having its own first.
fn widths(boxes: &[[DVec3; 2]]) -> Vec<u32> {
    let size = |[low, high]: &[DVec3; 2]| (high - low).element_product();
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|one, other| size(&boxes[*other]).total_cmp(&size(&boxes[*one])));
    let mut widths: Vec<Option<u32>> = vec![None; boxes.len()];
    for body in order {
        let beside = boxes.iter().zip(&widths).filter(|(other, _)| touch(boxes[body], **other));
        let mut taken: Vec<u32> = beside.filter_map(|(_, width)| *width).collect();
        taken.sort_unstable();
        taken.dedup();
        let least = taken.iter().zip(0..).take_while(|(taken, least)| *taken == least).count();
        widths[body] = Some(least as u32);
    }
    widths.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_that_touch_have_other_widths_and_the_largest_has_none() {
        let cube = |x: f64, side: f64| [DVec3::new(x, 0.0, 0.0), DVec3::new(x + side, side, side)];
        assert_eq!(
            widths(&[cube(0.0, 1.0), cube(1.0, 2.0), cube(3.0, 1.0), cube(3.5, 1.0), cube(9.0, 1.0)]),
            [1, 0, 1, 0, 0]
        );
        assert_eq!(widths(&[cube(0.0, 1.0); 4]), [0, 1, 2, 3]);
        assert!(widths(&[]).is_empty());
    }

    #[test]
    fn every_side_is_wider_by_the_width_of_its_body() {
        let positions = [1.0, 2.0, 3.0, 2.0, 4.0, 7.0, 1.5, 3.0, 5.0];
        let other = positions.map(|x| x - 0.5);
        let body = |positions| Labelled { name: "", positions, indices: &[0, 1, 2], labels: vec![0] };
        let Swollen { positions: found, moved } = swollen(&[&body(&positions), &body(&other)], 0.25);
        assert_eq!(found[0], positions.map(f64::from));
        assert_eq!(found[1], [0.25, 1.25, 2.25, 1.75, 3.75, 6.75, 1.0, 2.5, 4.5]);
        assert!((moved - 0.25 * 3f64.sqrt()).abs() < 1e-15);
    }
}
