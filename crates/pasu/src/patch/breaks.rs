//! What has to be known of a patch along one parameter so that samples miss nothing of it.

/// How fine a patch is along one parameter.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Breaks {
    /// Places inside (0, 1), in ascending order, at which a derivative may jump: knots and creases. Between two of them the patch is smooth.
    pub(crate) knots: Vec<f64>,
    /// How many waves there are at most from 0 to 1: the highest harmonic of a Fourier series, half the degree of a polynomial. Eight samples for each wave miss none.
    pub(crate) waves: f64,
    /// How fast the patch may change next to its ends, where it may do so faster than anywhere else: as `exp(-rate u)`. 0 where nothing is known.
    pub(crate) rate: f64,
}

impl Breaks {
    /// Of a patch that is smooth all the way.
    pub(crate) fn smooth(waves: f64) -> Breaks {
        Breaks { knots: Vec::new(), waves, rate: 0.0 }
    }

    /// The knots with both ends.
    pub(crate) fn with_ends(&self) -> Vec<f64> {
        let inner = self.knots.iter().copied().filter(|knot| 0.0 < *knot && *knot < 1.0);
        core::iter::once(0.0).chain(inner).chain([1.0]).collect()
    }
}
