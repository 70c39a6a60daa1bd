//! How far a blend is from the equation that it is to solve, and whether its inside is turned over anywhere.

use super::volume::{Place, Volume};

/// What of the inside is told, as a number at each point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum InsideMap {
    /// The length of what the equation leaves, `a x_uuuu + b x_vvvv + c x_wwww`: 0 where it holds.
    Residual,
    /// The determinant of the first derivatives, positive where the inside is turned as most of it is: 0 or less where it is folded.
    Jacobian,
}

/// What samples say of the inside: estimates, and no bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Inside {
    /// The largest residual.
    pub residual: f64,
    /// Where it is: `u`, `v`, `w`.
    pub residual_at: [f64; 3],
    /// The root of the mean square of the residual.
    pub residual_rms: f64,
    /// The least Jacobian.
    pub jacobian: f64,
    /// Where it is: `u`, `v`, `w`.
    pub jacobian_at: [f64; 3],
    /// The mean of the Jacobian: the volume.
    pub jacobian_mean: f64,
}

impl InsideMap {
    /// All of them.
    pub const ALL: [InsideMap; 2] = [InsideMap::Residual, InsideMap::Jacobian];

    /// The word by which it is known: `residual` or `jacobian`.
    ///
    /// ```
    /// assert_eq!(pasu::InsideMap::Residual.name(), "residual");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            InsideMap::Residual => "residual",
            InsideMap::Jacobian => "jacobian",
        }
    }
}

impl Inside {
    /// Whether the inside is turned over somewhere, or has no room.
    pub fn is_folded(&self) -> bool {
        !(self.jacobian > 0.0)
    }
}

/// Samples along each parameter, in the middles of equal intervals: the border is left out, where a disc in a square has infinite derivatives and a pole no room.
const SAMPLES: usize = 12;

impl Volume {
    /// The values of a map at triples `(u, v, w)`. What all points of one `w` have in common is formed once, in whatever order they come.
    pub(crate) fn mapped(&self, map: InsideMap, at: &[f64]) -> Vec<f64> {
        let sign = if map == InsideMap::Jacobian { self.sign() } else { 1.0 };
        let points = at.as_chunks::<3>().0;
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_by(|one, other| points[*one][2].total_cmp(&points[*other][2]));
        let mut values = vec![0.0; points.len()];
        for level in order.chunk_by(|one, other| points[*one][2] == points[*other][2]) {
            let layer = self.layer(points[level[0]][2]);
            for index in level {
                let [u, v, _] = points[*index];
                let (along, across) = (self.place(0, u), self.place(1, v));
                values[*index] = match map {
                    InsideMap::Residual => layer.residual(&along, &across).length(),
                    InsideMap::Jacobian => sign * layer.jacobian(&along, &across),
                };
            }
        }
        values
    }

    /// 1, or -1 where most of the inside is turned against its parameters.
    fn sign(&self) -> f64 {
        let mut sum = 0.0;
        self.sample(|_, _, jacobian| sum += jacobian);
        if sum < 0.0 { -1.0 } else { 1.0 }
    }

    /// What samples say.
    pub(crate) fn inside(&self) -> Inside {
        let sign = self.sign();
        let middle = [0.5 / SAMPLES as f64; 3];
        let mut found = Inside {
            residual: 0.0,
            residual_at: middle,
            residual_rms: 0.0,
            jacobian: f64::INFINITY,
            jacobian_at: middle,
            jacobian_mean: 0.0,
        };
        let n = (SAMPLES * SAMPLES * SAMPLES) as f64;
        let mut squares = 0.0;
        self.sample(|at, residual, jacobian| {
            squares += residual * residual;
            found.jacobian_mean += sign * jacobian / n;
            if residual > found.residual {
                (found.residual, found.residual_at) = (residual, at);
            }
            if sign * jacobian < found.jacobian {
                (found.jacobian, found.jacobian_at) = (sign * jacobian, at);
            }
        });
        found.residual_rms = (squares / n).sqrt();
        found
    }

    /// Shows residual and Jacobian of every sample.
    fn sample(&self, mut show: impl FnMut([f64; 3], f64, f64)) {
        let middles: Vec<f64> = (0..SAMPLES).map(|i| (i as f64 + 0.5) / SAMPLES as f64).collect();
        let [us, vs]: [Vec<Place>; 2] =
            [0, 1].map(|parameter| middles.iter().map(|x| self.place(parameter, *x)).collect());
        for w in &middles {
            let layer = self.layer(*w);
            for (u, along) in middles.iter().zip(&us) {
                for (v, across) in middles.iter().zip(&vs) {
                    let (residual, jacobian) = (layer.residual(along, across).length(), layer.jacobian(along, across));
                    show([*u, *v, *w], residual, jacobian);
                }
            }
        }
    }
}
