//! How far a blend is from the equation that it is to solve.

use glam::DVec3;

use super::volume::Volume;

/// `a x_uuuu + b x_vvvv + c x_wwww` where it was looked at: an estimate from samples, and no bound. 0 but for rounding where a blend is exact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Residual {
    /// The largest length.
    pub(crate) largest: f64,
    /// Where it is: `u`, `v`, `w`.
    pub(crate) at: [f64; 3],
    /// The root of the mean square.
    pub(crate) rms: f64,
}

/// Samples along each parameter, in the middles of equal intervals: the border is left out, where a disc in a square has infinite derivatives.
const SAMPLES: usize = 12;

impl Volume {
    /// What the equation leaves at one point.
    pub(crate) fn residual_at(&self, u: f64, v: f64, w: f64) -> DVec3 {
        self.layer(w).residual(&self.place(0, u), &self.place(1, v))
    }

    /// What it leaves all over.
    pub(crate) fn residual(&self) -> Residual {
        let middles: Vec<f64> = (0..SAMPLES).map(|i| (i as f64 + 0.5) / SAMPLES as f64).collect();
        let [us, vs] = [0, 1].map(|parameter| {
            let places = middles.iter().map(|x| (*x, self.place(parameter, *x)));
            places.collect::<Vec<_>>()
        });
        let mut found = Residual { largest: 0.0, at: [middles[0]; 3], rms: 0.0 };
        let mut squares = 0.0;
        for w in &middles {
            let layer = self.layer(*w);
            for (u, along) in &us {
                for (v, across) in &vs {
                    let length = layer.residual(along, across).length();
                    squares += length * length;
                    if length > found.largest {
                        (found.largest, found.at) = (length, [*u, *v, *w]);
                    }
                }
            }
        }
        found.rms = (squares / (SAMPLES * SAMPLES * SAMPLES) as f64).sqrt();
        found
    }
}
