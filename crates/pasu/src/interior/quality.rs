//! How well shaped a cell is.

use glam::DVec3;

/// The corners next to each corner of a hexahedron, so that the edges to them are right-handed where it is well shaped.
const NEIGHBOURS: [[usize; 3]; 8] =
    [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]];

/// The corners of the two sides across each of the three directions of a hexahedron.
const ACROSS: [[[usize; 4]; 2]; 3] =
    [[[0, 3, 4, 7], [1, 2, 5, 6]], [[0, 1, 4, 5], [3, 2, 7, 6]], [[0, 1, 2, 3], [4, 5, 6, 7]]];

/// The least scaled Jacobian of a hexahedron over its corners and its middle (Knupp 2000, as Verdict has it): 1 of a box, 0 where an edge or a corner has collapsed, negative where it is turned inside out.
pub(super) fn of_hexahedron(corners: &[DVec3; 8]) -> f64 {
    let middle = ACROSS.map(|[from, to]| {
        let sum = |side: [usize; 4]| side.into_iter().map(|corner| corners[corner]).sum::<DVec3>();
        sum(to) - sum(from)
    });
    let at = |(corner, near): (usize, [usize; 3])| scaled(near.map(|other| corners[other] - corners[corner]));
    NEIGHBOURS.into_iter().enumerate().map(at).fold(scaled(middle), f64::min)
}

/// The same of a tetrahedron: the least over its corners of the determinant over the product of the three edges there, times the square root of 2, which makes 1 of a regular one.
pub(super) fn of_tetrahedron(corners: &[DVec3; 4]) -> f64 {
    let [a, b, c, d] = *corners;
    let determinant = (b - a).cross(c - a).dot(d - a);
    let lengths = [[b - a, c - a, d - a], [a - b, c - b, d - b], [a - c, b - c, d - c], [a - d, b - d, c - d]];
    let product = |edges: [DVec3; 3]| edges.into_iter().map(DVec3::length).product::<f64>();
    let largest = lengths.into_iter().map(product).fold(0.0, f64::max);
    if largest > 0.0 { core::f64::consts::SQRT_2 * determinant / largest } else { 0.0 }
}

/// The determinant of three vectors over the product of their lengths; 0 where one has no length.
fn scaled([a, b, c]: [DVec3; 3]) -> f64 {
    let product = a.length() * b.length() * c.length();
    if product > 0.0 { a.cross(b).dot(c) / product } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> [DVec3; 8] {
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
            .map(|p| DVec3::from_array(p.map(f64::from)))
    }

    #[test]
    fn a_box_is_1_and_a_collapsed_or_turned_one_is_told() {
        assert_eq!(of_hexahedron(&cube()), 1.0);
        assert!((of_hexahedron(&cube().map(|p| p * DVec3::new(5.0, 0.1, 2.0))) - 1.0).abs() < 1e-15);
        let mut wedge = cube();
        wedge[3] = wedge[0];
        assert_eq!(of_hexahedron(&wedge), 0.0);
        let mirrored = cube().map(|p| p * DVec3::new(1.0, 1.0, -1.0));
        assert_eq!(of_hexahedron(&mirrored), -1.0);
        // A parallelepiped leaning by 45 degrees.
        let leaning = cube().map(|p| p + DVec3::X * p.z);
        assert!((of_hexahedron(&leaning) - 0.5f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn a_regular_tetrahedron_is_1() {
        let regular = [[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]].map(DVec3::from_array);
        assert!((of_tetrahedron(&regular).abs() - 1.0).abs() < 1e-15);
        let [a, b, c, d] = regular;
        assert_eq!(of_tetrahedron(&[b, a, c, d]), -of_tetrahedron(&regular));
        assert_eq!(of_tetrahedron(&[a, b, c, c]), 0.0);
    }
}
