//! Normals where the surface has no tangent plane of its own.

use glam::DVec3;

use super::jet::SurfaceJet;

/// `X_u x X_v` counts as vanished when it is this small against the lengths of both: then its direction is rounding.
const VANISHED: f64 = 1e-10;

/// A limit of first order counts as vanished when it is this small against its terms.
const FLAT: f64 = 1e-9;

/// How far into the surface, as a part of its parameters, the limit is looked for, in turn.
const STEPS_INWARD: [f64; 4] = [1e-6, 1e-4, 1e-3, 1e-2];

/// The limit of the unit normal at a pole or cusp, where the surface has this jet; `at` is the jet anywhere, `u` and `v` in [0, 1].
///
/// By Taylor's formula a step `h` into the surface turns `X_u x X_v = 0` into `h (X_uu x X_v + X_u x X_uv)`, which is the limit's direction. Where that vanishes
/// too, the normal a little further in is taken. There is none where the surface is a curve or a point all over.
pub(crate) fn normal_limit(jet: &SurfaceJet, (u, v): (f64, f64), at: impl Fn(f64, f64) -> SurfaceJet) -> Option<DVec3> {
    let inward = if u < 0.5 { 1.0 } else { -1.0 };
    let turned = inward * (jet.duu.cross(jet.dv) + jet.du.cross(jet.duv));
    let size = jet.duu.length() * jet.dv.length() + jet.du.length() * jet.duv.length();
    let length = turned.length();
    if length.is_finite() && length > FLAT * size {
        return Some(turned / length);
    }
    for step in STEPS_INWARD {
        for (u, v) in [(u + inward * step, v), (u, v + step), (u + inward * step, v + step)] {
            let jet = at(u, v);
            let normal = jet.du.cross(jet.dv);
            let squared = normal.length_squared();
            // A square beyond all numbers is no length either.
            let lengths = jet.du.length_squared() * jet.dv.length_squared();
            if squared > VANISHED * VANISHED * lengths && squared < f64::MAX {
                return Some(normal / squared.sqrt());
            }
        }
    }
    None
}
