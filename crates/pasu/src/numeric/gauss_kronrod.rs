//! The Gauss-Kronrod rule: Gauss-Legendre with ten nodes, extended by Kronrod to twenty-one, so that the two tell the error of the longer.

/// Nodes on [-1, 1], from 1 down to 0, and their weights: of Kronrod's rule, and of Gauss's, which has every second node.
///
/// Gauss's rule is exact for polynomials of degree 19, Kronrod's for degree 31 (R. Piessens and others, *QUADPACK*, 1983, routine `QK21`).
const NODES: [(f64, f64, f64); 11] = [
    (0.995_657_163_025_808_1, 0.011_694_638_867_371_874, 0.0),
    (0.973_906_528_517_171_7, 0.032_558_162_307_964_725, 0.066_671_344_308_688_14),
    (0.930_157_491_355_708_2, 0.054_755_896_574_351_995, 0.0),
    (0.865_063_366_688_984_5, 0.075_039_674_810_919_96, 0.149_451_349_150_580_6),
    (0.780_817_726_586_416_9, 0.093_125_454_583_697_6, 0.0),
    (0.679_409_568_299_024_4, 0.109_387_158_802_297_64, 0.219_086_362_515_982_04),
    (0.562_757_134_668_604_7, 0.123_491_976_262_065_85, 0.0),
    (0.433_395_394_129_247_2, 0.134_709_217_311_473_34, 0.269_266_719_309_996_35),
    (0.294_392_862_701_460_2, 0.142_775_938_577_060_09, 0.0),
    (0.148_874_338_981_631_22, 0.147_739_104_901_338_49, 0.295_524_224_714_752_87),
    (0.0, 0.149_445_554_002_916_9, 0.0),
];

/// The nodes of both rules on an interval with their weights: place, Kronrod's weight, Gauss's weight or 0.
pub(crate) fn nodes(from: f64, to: f64) -> impl Iterator<Item = (f64, f64, f64)> {
    let (middle, half) = (0.5 * from + 0.5 * to, 0.5 * (to - from));
    let at = move |x: f64, kronrod: f64, gauss: f64| (middle + half * x, half * kronrod, half * gauss);
    let lower = NODES.iter().map(move |&(x, kronrod, gauss)| at(-x, kronrod, gauss));
    let upper = NODES[..10].iter().rev().map(move |&(x, kronrod, gauss)| at(x, kronrod, gauss));
    lower.chain(upper)
}

/// The error of Kronrod's sum, from its difference to Gauss's and from how much the integrand departs from its mean (QUADPACK's estimate: the
/// power 3/2 is for the twelve further degrees of the longer rule), and no more than the difference: the longer rule is not worse than the shorter.
pub(crate) fn error(difference: f64, departure: f64) -> f64 {
    let ratio = 200.0 * difference / departure;
    if difference == 0.0 || !(departure > 0.0) {
        difference
    } else {
        (departure * ratio * libm::sqrt(ratio)).min(difference)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_integrated_exactly() {
        for degree in 0..=31 {
            let exact = (2f64.powi(degree + 1) - (-1f64).powi(degree + 1)) / f64::from(degree + 1);
            let (mut kronrod, mut gauss) = (0.0, 0.0);
            for (x, k, g) in nodes(-1.0, 2.0) {
                kronrod += k * x.powi(degree);
                gauss += g * x.powi(degree);
            }
            assert!((kronrod - exact).abs() <= 1e-14 * exact.abs().max(1.0), "{degree}: {kronrod} {exact}");
            assert_eq!(
                (gauss - exact).abs() <= 1e-14 * exact.abs().max(1.0),
                degree <= 19,
                "{degree}: {gauss} {exact}"
            );
        }
    }
}
