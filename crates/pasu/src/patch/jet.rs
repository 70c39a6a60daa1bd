//! Position and derivatives of a surface at one point.

use glam::DVec3;

/// Position and first and second derivatives of `X(u, v)`, in model units, before placement.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SurfaceJet {
    /// `X`.
    pub position: DVec3,
    /// `X_u`.
    pub du: DVec3,
    /// `X_v`.
    pub dv: DVec3,
    /// `X_uu`.
    pub duu: DVec3,
    /// `X_uv`.
    pub duv: DVec3,
    /// `X_vv`.
    pub dvv: DVec3,
}

impl SurfaceJet {
    /// Takes one component.
    pub(crate) fn set(&mut self, axis: usize, of: AxisJet) {
        let AxisJet { position, du, dv, duu, duv, dvv } = of;
        self.position[axis] = position;
        (self.du[axis], self.dv[axis]) = (du, dv);
        (self.duu[axis], self.duv[axis], self.dvv[axis]) = (duu, duv, dvv);
    }

    /// The same point in parameters that run `along` and `round` times as fast: each derivative is multiplied once for each time it is taken.
    pub(crate) fn stretched(&self, along: f64, round: f64) -> SurfaceJet {
        SurfaceJet {
            position: self.position,
            du: self.du * along,
            dv: self.dv * round,
            duu: self.duu * (along * along),
            duv: self.duv * (along * round),
            dvv: self.dvv * (round * round),
        }
    }
}

/// One component of it, which is summed by itself: six numbers stay where they are added up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct AxisJet {
    position: f64,
    du: f64,
    dv: f64,
    duu: f64,
    duv: f64,
    dvv: f64,
}

impl AxisJet {
    /// Adds `A(u) cos(k v) + B(u) sin(k v)`, from `A`, `A'`, `A''` and those of `B`.
    #[inline]
    pub(crate) fn add(&mut self, k: f64, a: &[f64; 3], b: &[f64; 3], (c, s): (f64, f64)) {
        self.position += a[0] * c + b[0] * s;
        self.du += a[1] * c + b[1] * s;
        self.duu += a[2] * c + b[2] * s;
        self.dv += k * (b[0] * c - a[0] * s);
        self.duv += k * (b[1] * c - a[1] * s);
        self.dvv -= k * k * (a[0] * c + b[0] * s);
    }
}
