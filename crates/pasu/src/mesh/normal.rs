//! Normals where the surface has no tangent plane of its own.

use glam::DVec3;

use crate::surface::Surface;

/// `X_u x X_v` counts as vanished when it is this small against the lengths that the row's tangents have: what is left is rounding.
const VANISHED: f64 = 1e-12;

/// How far into the surface, as a part of `u`, the limit is looked for, in turn.
const STEPS_INWARD: [f64; 4] = [1e-6, 1e-4, 1e-3, 1e-2];

/// The unit normal along `X_u x X_v` if it can be told from rounding. `reach` is the size of the surface.
pub(super) fn regular(du: DVec3, dv: DVec3, reach: f64) -> Option<DVec3> {
    let normal = du.cross(dv);
    let length = normal.length();
    let size = du.length() * dv.length().max(VANISHED * reach);
    if length > VANISHED * size && length.is_finite() && length > 0.0 { Some(normal / length) } else { None }
}

/// The limit of the unit normal at a pole or cusp.
///
/// By Taylor's formula a step `h` into the surface turns `X_u x X_v = 0` into `h (X_uu x X_v + X_u x X_uv)`, which is the limit's direction. Where that vanishes
/// too, the normal a little further in is taken; where the surface is a curve or a point all over, the axis `z` is as good as any.
pub(super) fn limit(surface: &Surface, u: f64, v: f64, reach: f64) -> DVec3 {
    let inward = if u < 0.5 { 1.0 } else { -1.0 };
    let jet = surface.at(u, v);
    let turned = inward * (jet.duu.cross(jet.dv) + jet.du.cross(jet.duv));
    let size = jet.duu.length() * jet.dv.length() + jet.du.length() * jet.duv.length();
    let length = turned.length();
    if length.is_finite() && length > 1e-9 * size && jet.dv.length() <= 1e-9 * reach {
        return turned / length;
    }
    for step in STEPS_INWARD {
        for (u, v) in
            [(u + inward * step, v), (u, v + step * surface.span()), (u + inward * step, v + step * surface.span())]
        {
            let jet = surface.at(u, v);
            if let Some(normal) = regular(jet.du, jet.dv, reach) {
                return normal;
            }
        }
    }
    DVec3::Z
}
