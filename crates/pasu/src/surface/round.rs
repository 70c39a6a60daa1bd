//! How far a surface is from one of revolution.

use super::solve::Surface;
use super::term::Term;

/// What a surface that goes round the z axis once, all but as a circle does, is like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Round {
    /// How far `X(u, v)` is at most from `X(u, 0)` turned about the z axis by a whole turn for each of `v`, either way, over all `u` and `v`, before placement.
    pub(crate) off: f64,
    /// The axis beside which `X(u, 0)` lies, to no more than that: 0 for `x`, 1 for `y`.
    pub(crate) axis: usize,
}

impl Surface {
    /// How round it is; `None` of what does not go round once.
    ///
    /// There is a circle `(w(u) cos v, w(u) sin v)`, or one that begins at `y`, where both of its modes have one equation and the same numbers, to the bit. All other modes across the axis, and those of `z` that depend on `v`, are added up by their suprema: 0 where there are none.
    pub(crate) fn round(&self) -> Option<Round> {
        let [x, y, z] = self.components();
        let once = |terms: &[Term]| terms.iter().position(|term| term.n == 1.0);
        let [first, second] = [once(x)?, once(y)?];
        let (one, other) = (&x[first], &y[second]);
        if !self.is_closed() || one.beam != other.beam {
            return None;
        }
        let most = |term: &Term| term.beam.suprema::<1, 2>([&term.cos, &term.sin], 0.0, 1.0).map(|[most]| most);
        let [[x_cos, x_sin], [y_cos, y_sin]] = [most(one), most(other)];
        let axis = usize::from(x_sin > x_cos);
        let (is_circle, aside) = match axis {
            0 => (one.cos == other.sin, x_sin + y_cos),
            _ => (one.sin == other.cos, x_cos + y_sin),
        };
        if !is_circle {
            return None;
        }
        let size = |term: &Term| most(term).into_iter().sum::<f64>();
        let others = |terms: &[Term], but: usize| {
            terms.iter().enumerate().filter(|(index, _)| *index != but).map(|(_, term)| size(term)).sum::<f64>()
        };
        let heights: f64 = z.iter().filter(|term| term.n != 0.0).map(size).sum();
        // X(u, 0) is off by as much as X(u, v) is.
        let off = 2.0 * (aside + others(x, first) + others(y, second) + heights);
        off.is_finite().then_some(Round { off, axis })
    }
}

#[cfg(test)]
mod tests {
    use crate::design::Design;
    use crate::solution::Solution;

    fn round(shape: &str) -> Option<(f64, usize)> {
        let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#)).unwrap();
        Solution::of(&design).part(0).unwrap().solved().round().map(|round| (round.off, round.axis))
    }

    #[test]
    fn what_is_round_is_so_to_nothing_and_petals_are_their_own_size() {
        assert_eq!(round(r#"{ "kind": "second-order", "r": [1, 0, 0.6, 0], "height": 2 }"#), Some((0.0, 0)));
        let rings = r#"{ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 4 }, "z": { "mean": 0 } }, { "u": 0.4, "r": { "mean": 6 }, "z": { "mean": 2 } }, { "u": 1, "r": { "mean": 3 }, "z": { "mean": 7 } }] }"#;
        assert_eq!(round(rings), Some((0.0, 0)));
        let petals =
            round(r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "n": [1, 5], "height": 2 }"#).unwrap();
        assert!((0.2..1.0).contains(&petals.0), "{petals:?}");
        // The equations of x and y are not the same.
        assert_eq!(round(r#"{ "kind": "second-order", "r": [1, 0, 0.6, 0], "s": [1, 3], "height": 2 }"#), None);
        assert_eq!(round(r#"{ "kind": "octant", "exponents": [2, 2, 2] }"#), None);
        let blend = |rx: f64, form: &str| {
            format!(
                r#"{{ "kind": "blend", "start": {{ "form": "{form}", "radius": [{rx}, 1], "z": 0, "taper": 0, "dz": 2 }}, "end": {{ "form": "{form}", "radius": [2, 2], "z": 3, "taper": 0, "dz": 2 }} }}"#
            )
        };
        assert_eq!(round(&blend(1.0, "disc")), Some((0.0, 1)));
        assert_eq!(round(&blend(1.5, "disc")), None);
        assert_eq!(round(&blend(1.0, "rectangle")), None);
    }
}
