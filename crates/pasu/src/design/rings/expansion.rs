//! A pot of rings as Fourier data written out.

use std::collections::BTreeMap;

use super::pot::{Rings, Series};
use crate::design::boundary_value::{BoundaryValue, Component, Datum, Free, Mode, Order, Ring, Span};

/// Where the numbers of one series go: into which datum, of which curve.
#[derive(Clone, Copy)]
enum Curve {
    /// A ring by its number, foot and rim among them.
    Hoop(usize),
    Foot,
    Rim,
}

/// The data of one component by `n`, which is whole.
struct Modes {
    n_rings: usize,
    /// By the bits of `n`, which ascend with it. Cosine and sine.
    data: BTreeMap<u64, [Datum; 2]>,
}

/// Cosine and sine.
const COS: usize = 0;
const SIN: usize = 1;

impl Rings {
    /// The problem that these numbers stand for: `x = r cos v`, `y = r sin v` with products of waves written as sums.
    #[inline]
    pub(crate) fn boundary_value(&self) -> BoundaryValue {
        let n_rings = self.rings.len().saturating_sub(2);
        let [mut x, mut y, mut z] = [(); 3].map(|()| Modes { n_rings, data: BTreeMap::new() });
        let hoops = self.rings.iter().enumerate().map(|(index, hoop)| (Curve::Hoop(index), &hoop.r, &hoop.z));
        let foot = self.foot.iter().map(|slopes| (Curve::Foot, &slopes.r, &slopes.z));
        let rim = self.rim.iter().map(|slopes| (Curve::Rim, &slopes.r, &slopes.z));
        for (curve, r, height) in hoops.chain(foot).chain(rim) {
            add_turning(&mut x, &mut y, curve, r);
            z.add(0.0, COS, curve, height.mean);
            for wave in &height.waves {
                z.add(wave.n, COS, curve, wave.cos);
                z.add(wave.n, SIN, curve, wave.sin);
            }
        }
        let square = self.a * self.a;
        let free = Free { start: self.foot.is_none(), end: self.rim.is_none() };
        let component = |modes: Modes| Component {
            order: Order::Fourth,
            s: 1.0,
            t: 2.0 * square,
            w: square * square,
            free,
            modes: modes.written(),
        };
        let inner = self.rings.iter().skip(1).take(n_rings);
        let rings = inner.map(|hoop| Ring { u: hoop.u, sharp: hoop.sharp }).collect();
        BoundaryValue { span: Span::Tau, rings, x: component(x), y: component(y), z: component(z) }
    }
}

/// Adds `r cos v` to `x` and `r sin v` to `y`.
#[inline]
fn add_turning(x: &mut Modes, y: &mut Modes, curve: Curve, r: &Series) {
    x.add(1.0, COS, curve, r.mean);
    y.add(1.0, SIN, curve, r.mean);
    for wave in &r.waves {
        let (above, below) = (wave.n + 1.0, wave.n - 1.0);
        let (cos, sin) = (0.5 * wave.cos, 0.5 * wave.sin);
        // cos nv cos v, and sin nv cos v.
        x.add(above, COS, curve, cos);
        x.add(below, COS, curve, cos);
        x.add(above, SIN, curve, sin);
        x.add(below, SIN, curve, sin);
        // cos nv sin v, and sin nv sin v.
        y.add(above, SIN, curve, cos);
        y.add(below, SIN, curve, -cos);
        y.add(below, COS, curve, sin);
        y.add(above, COS, curve, -sin);
    }
}

impl Modes {
    #[inline]
    fn add(&mut self, n: f64, wave: usize, curve: Curve, value: f64) {
        // sin(0 v) is 0.
        if value == 0.0 || n == 0.0 && wave == SIN {
            return;
        }
        let n_rings = self.n_rings;
        let datum = &mut self.data.entry(n.to_bits()).or_default()[wave];
        let place = match curve {
            Curve::Hoop(0) => &mut datum.start,
            Curve::Hoop(index) if index <= n_rings => {
                datum.rings.resize(n_rings, 0.0);
                &mut datum.rings[index - 1]
            }
            Curve::Hoop(_) => &mut datum.end,
            Curve::Foot => &mut datum.start_u,
            Curve::Rim => &mut datum.end_u,
        };
        *place += value;
    }

    #[inline]
    fn written(self) -> Vec<Mode> {
        let modes = self.data.into_iter();
        modes.map(|(bits, [cos, sin])| Mode { n: f64::from_bits(bits), cos, sin }).collect()
    }
}
