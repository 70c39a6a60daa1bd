//! The mode problem against values computed with hundreds of digits (`tests/reference/modes.json`, made by `mode_reference.py`):
//! values within 1e-13 of their scale, derivatives within 1e-12 of theirs.

use pasu::{Equation, ModeData, Order};
use serde::Deserialize;

#[derive(Deserialize)]
struct Case {
    why: String,
    order: u8,
    s: f64,
    t: f64,
    w: f64,
    k: f64,
    start: f64,
    end: f64,
    start_u: f64,
    end_u: f64,
    force: Vec<f64>,
    u: Vec<f64>,
    q: Vec<[f64; 3]>,
}

#[test]
fn agrees_with_the_reference() {
    let cases: Vec<Case> = serde_json::from_str(include_str!("../reference/modes.json")).unwrap();
    let (mut worst, mut failures) = ([0.0f64; 3], Vec::new());
    for case in &cases {
        let name = format!(
            "{} order {} s {} t {} w {} k {} force of {}",
            case.why,
            case.order,
            case.s,
            case.t,
            case.w,
            case.k,
            case.force.len()
        );
        let order = if case.order == 2 { Order::Second } else { Order::Fourth };
        let equation = Equation::new(order, case.s, case.t, case.w, case.k).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let &Case { start, end, start_u, end_u, ref force, .. } = case;
        let solution = equation.solve(&ModeData { start, end, start_u, end_u, force }).unwrap();
        // The solution may be larger than its boundary data where a force or a near resonance drives it.
        let data = start.abs().max(end.abs()).max(start_u.abs()).max(end_u.abs());
        let scale = case.q.iter().map(|q| q[0].abs()).fold(data, f64::max);
        let rate = equation.largest_rate().max(1.0);
        // What one rounding of the rate does near a resonance, where the solution is larger than all that drives it.
        let forced = force.iter().fold(data, |largest, f| largest.max(f.abs()));
        let rounding = f64::EPSILON * rate * scale / forced;
        for (&u, q) in case.u.iter().zip(&case.q) {
            let [jet] = equation.jets::<3, 1>([&solution], u);
            for d in 0..3 {
                let size = scale * libm::pow(rate, d as f64);
                let error = (jet[d] - q[d]).abs() / size;
                let bound = [1e-13f64, 1e-12, 1e-12][d].max(rounding);
                if !(error <= bound) {
                    failures.push(format!("{name}: u {u}, derivative {d}: {} is not {} ({error:.1e})", jet[d], q[d]));
                }
                worst[d] = worst[d].max(error);
            }
        }
    }
    println!("{} cases, worst errors {worst:?}", cases.len());
    assert!(
        failures.is_empty(),
        "{} failures of {}:\n{}",
        failures.len(),
        cases.len(),
        failures.iter().take(30).cloned().collect::<Vec<_>>().join("\n")
    );
}

/// Between powers far above the rate and far below it no digits are lost: the equation holds for forces of any degree.
#[test]
fn forces_of_high_degree() {
    for n_coefficients in [65, 129, 300, 512] {
        // Signs without a pattern, sizes up to 1.
        let force: Vec<f64> = (0..n_coefficients).map(|i| f64::sin(1.0 + 7.3 * f64::from(i) * f64::from(i))).collect();
        for k in [0.0, 0.5, 5.0, 7.0, 31.0, 60.0, 300.0, 1000.0] {
            for (order, s, t, w) in [
                (Order::Second, 2.0, 1.0, 0.0),
                (Order::Fourth, 1.0, 2.0, 1.0),
                (Order::Fourth, 1.0, 0.5, 1.0),
                (Order::Fourth, 1.0, 1.0, 1e-6),
                (Order::Fourth, 1.0, 1.0, 0.0),
            ] {
                let name = format!("{n_coefficients} coefficients, k {k}, {order:?}, t {t}, w {w}");
                let equation = Equation::new(order, s, t, w, k).unwrap();
                let data = ModeData { start: 0.3, start_u: -1.0, end: -0.7, end_u: 2.0, force: &force };
                let solution = equation.solve(&data).unwrap();
                let rate = equation.largest_rate().max(1.0);
                for u in [0.0, 1e-3, 0.1, 0.5, 0.83, 0.99, 0.9999, 1.0] {
                    let [q] = equation.jets::<5, 1>([&solution], u);
                    let p = force.iter().rev().fold(0.0, |sum, f| sum * u + f);
                    let (residual, size) = match order {
                        Order::Second => (s * q[2] - t * k * k * q[0] - p, s * rate * rate),
                        Order::Fourth => (s * q[4] - t * k * k * q[2] + w * k.powi(4) * q[0] - p, s * rate.powi(4)),
                    };
                    // What a force of size 1 does next to data of size 1.
                    let bound = 1e-10 * size + 1e-9 * (1.0 + p.abs());
                    assert!(residual.abs() <= bound, "{name}, u {u}: {residual:e} of {size:e}");
                }
            }
        }
    }
}
