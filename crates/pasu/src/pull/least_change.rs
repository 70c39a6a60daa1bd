//! The least change of some numbers that brings a point to a place.

use glam::DVec3;
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Gauss-Newton steps at most; three or four suffice where the point depends on the numbers nearly linearly.
const MOST_STEPS: usize = 40;

/// How often a step is halved that leads to numbers without a surface, or further from the place.
const MOST_HALVINGS: i32 = 24;

/// A direction in which the point moves by less than this part of that in which it moves most is one in which it cannot be moved.
const UNMOVED: f64 = 1e-6;

/// A step towards the least change may lead the point astray by this part of the way that it had to go.
const ASTRAY: f64 = 1e-10;

/// The change is the least when a step is this part of it: Gauss-Newton steps shrink by a factor each, and the last brings the point there to rounding.
const SHORTEST: f64 = 1e-12;

/// What moves a point: `n` numbers, each measured in a unit of its own.
pub(super) trait Mover {
    /// The point for these changes, in units; `None` where they leave no surface.
    fn point(&self, changes: &[f64]) -> Option<DVec3>;

    /// The derivatives of the point by the changes.
    fn slopes(&self, changes: &[f64]) -> Option<Vec<DVec3>>;
}

/// The changes, in units, least in the sum of their squares, that bring the point to `to`, or as near as their linear change can bring it.
///
/// At every step the least change from where everything began, not from the step before, is found that brings the linearised point there (Gauss-Newton for a problem with
/// constraints; J. Nocedal, S. J. Wright, *Numerical Optimization*, 2006, section 18.1). It is shortened until the point comes nearer.
pub(super) fn least_change(mover: &impl Mover, n: usize, to: DVec3) -> Option<Vec<f64>> {
    let mut changes = vec![0.0; n];
    let mut behind = to - mover.point(&changes)?;
    let allowed = ASTRAY * behind.length();
    for _ in 0..MOST_STEPS {
        let slopes = mover.slopes(&changes)?;
        let (mut moved, mut square) = (behind, Matrix3::zeros());
        for (slope, change) in slopes.iter().zip(&changes) {
            moved += *slope * *change;
            let slope = Vector3::from(slope.to_array());
            square += slope * slope.transpose();
        }
        let force = against(square, moved);
        let step: Vec<f64> = slopes.iter().zip(&changes).map(|(slope, change)| slope.dot(force) - change).collect();
        // Once the point is there, steps go on towards the least change, and may lead it a little away.
        let nearer = (0..MOST_HALVINGS).find_map(|halvings| {
            let part = libm::ldexp(1.0, -halvings);
            let candidate: Vec<f64> = changes.iter().zip(&step).map(|(change, step)| change + part * step).collect();
            let left = to - mover.point(&candidate)?;
            (left.length() < behind.length() + allowed).then_some((candidate, left))
        });
        let Some((candidate, left)) = nearer else { break };
        let size = |numbers: &[f64]| numbers.iter().fold(0.0f64, |most, number| most.max(number.abs()));
        let is_last = size(&step) <= SHORTEST * size(&candidate);
        (changes, behind) = (candidate, left);
        if is_last {
            break;
        }
    }
    Some(changes)
}

/// The least `x` for which `matrix x` is as near as can be to `wanted`, for a matrix `J J^T`.
fn against(matrix: Matrix3<f64>, wanted: DVec3) -> DVec3 {
    let SymmetricEigen { eigenvalues, eigenvectors } = matrix.symmetric_eigen();
    let least = UNMOVED * UNMOVED * eigenvalues.amax();
    let parts = eigenvectors.transpose() * Vector3::from(wanted.to_array());
    let divided = parts.zip_map(&eigenvalues, |part, value| if value > least { part / value } else { 0.0 });
    DVec3::from_array((eigenvectors * divided).into())
}
