//! Normals in double precision, from the coefficients that the rows in single precision are rounded from.
//!
//! These are off by what [`Curves`](crate::surface::Curves) promise, some 3e-11: enough wherever `X_u` and `X_v` are not parallel to four digits, and no closed form is asked again.

use wide::f64x2;

use super::waves::Waves;
use crate::mesh::promise::NORMAL_ERROR;
use crate::surface::{Block, Turns};

/// Where `|X_u x X_v|^2` is less, beside tangents of about 1, nothing is known of it.
const LEAST_SQUARE: f64 = 1e-200;

/// Factors of cosine and sine of one harmonic in one component: of `X_u`, then of `X_v`.
type Strand = [f64x2; 2];

/// The normals of one row at a time, a column at a time.
#[derive(Debug, Default)]
pub(super) struct DoubleNormals {
    /// Column by column, cosine and sine of each harmonic; made when first needed.
    circles: Vec<f64x2>,
    /// Of each harmonic in each component, the tangents scaled to be about 1 where they are longest.
    strands: Vec<[Strand; 3]>,
    /// What of `X_u` does not depend on `v`.
    constant: [f64; 3],
    /// With these a normal is known to be held when `tilt_u |X_v|^2 + tilt_v |X_u|^2 < |X_u x X_v|^2`.
    tilt: [f64; 2],
    sign: f64,
}

impl DoubleNormals {
    /// Takes another surface, or another number of columns.
    pub(super) fn prepare(&mut self) {
        self.circles.clear();
    }

    /// Takes one of the four rows of `waves`, tangents times `scales`, normals times `sign`.
    #[inline(never)]
    pub(super) fn take(
        &mut self,
        waves: &Waves,
        turns: &Turns,
        n_columns: usize,
        scales: [f64; 2],
        row: usize,
        sign: f64,
    ) {
        let n = waves.harmonics.len();
        if self.circles.is_empty() {
            self.circles.resize(n * n_columns, f64x2::ZERO);
            for (index, harmonic) in waves.harmonics.iter().enumerate() {
                let column = self.circles.iter_mut().skip(index).step_by(n);
                for (circle, (cos, sin)) in column.zip(turns.walk(harmonic.n)) {
                    *circle = f64x2::new([cos, sin]);
                }
            }
        }
        self.sign = sign;
        self.constant = waves.constants.map(|[_, slope]| slope.to_array()[row] * scales[0]);
        let mut sizes = [self.constant.iter().map(|slope| slope.abs()).sum::<f64>(), 0.0];
        self.strands.clear();
        for (index, harmonic) in waves.harmonics.iter().enumerate() {
            let strands = core::array::from_fn(|axis| {
                strand_of(waves.data.each_ref().map(|wave| &wave[index][axis]), row, harmonic.k, scales, &mut sizes)
            });
            self.strands.push(strands);
        }
        // A sum of m terms is off by m half units of all of them, the rounding of these included.
        let rounding = (2 * n + 4) as f64 * f64::EPSILON;
        self.tilt = core::array::from_fn(|i| {
            let error = waves.noise[i] * scales[i] + rounding * sizes[i];
            // Of each of three components, and the square of a sum of two is no more than twice that of their squares.
            6.0 * (error / NORMAL_ERROR) * (error / NORMAL_ERROR)
        });
    }

    /// Writes the normal at a column; says whether it is held.
    #[inline(never)]
    pub(super) fn put(&self, column: usize, normals: &mut [f32]) -> bool {
        let n = self.strands.len();
        let Some(circles) = self.circles.get(n * column..n * (column + 1)) else { return false };
        let zero = f64x2::ZERO;
        let [mut x, mut y, mut z] = [[zero; 2]; 3];
        for ([of_x, of_y, of_z], circle) in self.strands.iter().zip(circles) {
            x = [x[0] + of_x[0] * *circle, x[1] + of_x[1] * *circle];
            y = [y[0] + of_y[0] * *circle, y[1] + of_y[1] * *circle];
            z = [z[0] + of_z[0] * *circle, z[1] + of_z[1] * *circle];
        }
        let sum = |lanes: f64x2| {
            let [a, b] = lanes.to_array();
            a + b
        };
        let [[ux, vx], [uy, vy], [uz, vz]] = [x, y, z].map(|sums| sums.map(sum));
        let [ux, uy, uz] = [ux + self.constant[0], uy + self.constant[1], uz + self.constant[2]];
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let tilted =
            self.tilt[0] * (vx * vx + vy * vy + vz * vz) + self.tilt[1] * (ux * ux + uy * uy + uz * uz) + LEAST_SQUARE;
        // What is not a number is not held.
        let is_held = tilted < squared && squared < f64::MAX;
        if let (true, Some(to)) = (is_held, normals.get_mut(3 * column..3 * column + 3)) {
            let inverse = self.sign / squared.sqrt();
            for (to, component) in to.iter_mut().zip(normal) {
                *to = (component * inverse) as f32;
            }
        }
        is_held
    }
}

/// The strand of value and slope of a cosine and of a sine; adds to the sizes of `X_u` and `X_v`.
#[inline(never)]
fn strand_of(data: [&[Block; 2]; 2], row: usize, k: f64, scales: [f64; 2], sizes: &mut [f64; 2]) -> Strand {
    let [[a, slope_of_a], [b, slope_of_b]] = data.map(|data| data.map(|block| block.as_array()[row]));
    let scale = scales[1] * k;
    let strand = [[slope_of_a * scales[0], slope_of_b * scales[0]], [b * scale, -a * scale]];
    for (size, [of_cos, of_sin]) in sizes.iter_mut().zip(strand) {
        *size += of_cos.abs() + of_sin.abs();
    }
    strand.map(f64x2::new)
}
