//! Blends against the reference, against the dense system of the paper, and against the equation itself.

use core::f64::consts::PI;

use super::*;
use crate::design::Shape;

fn blend_of_json(text: &str) -> Result<Blend> {
    let text = text.replacen('{', r#"{"kind": "blend", "#, 1);
    match Shape::parse(&text)? {
        Shape::Blend(blend) => Ok(blend),
        other => panic!("{other:?}"),
    }
}

fn solved(text: &str) -> Volume {
    Volume::solve(&blend_of_json(text).unwrap_or_else(|error| panic!("{error}: {text}")), "shape").unwrap()
}

const FORMS: [&str; 5] = [
    r#""form": "rectangle", "radius": [1.25, 0.75]"#,
    r#""form": "rectangle-reversed", "radius": [2, 1]"#,
    r#""form": "disc", "radius": [0.5, 3]"#,
    r#""form": "disc-in-square", "radius": [1.5, 1]"#,
    r#""form": "outline", "x": [{"n": 0, "cos": 0.3}, {"n": 1, "sin": 1, "cos": 0.2}, {"n": 5, "sin": 0.2}], "y": [{"n": 1, "cos": 1}, {"n": 4, "cos": -0.2, "sin": 0.1}]"#,
];

/// Every pair of forms in both orders, with tangents of both signs.
fn all(rest: &str) -> Vec<String> {
    let pairs = FORMS.iter().flat_map(|start| FORMS.iter().map(move |end| (start, end)));
    let text = |(start, end): (&&str, &&str)| {
        format!(
            r#"{{"start": {{{start}, "z": 4, "taper": -0.3, "dz": -2}}, "end": {{{end}, "z": 1.5, "taper": 0.7, "dz": -3.5}}, {rest}}}"#
        )
    };
    pairs.map(text).collect()
}

fn is_exact_possible(text: &str) -> bool {
    !text.contains("disc-in-square")
}

/// Each way of solving, with weights that are not 1 and terms that differ.
fn every_blend() -> Vec<String> {
    let mut texts = Vec::new();
    for weights in ["[1, 1, 1]", "[2, 0.5, 3]"] {
        for method in [r#""modal", "terms": [5, 3, 2]"#, r#""collocation", "terms": [3, 5, 4]"#, r#""exact""#] {
            let some = all(&format!(r#""method": {method}, "weights": {weights}"#)).into_iter();
            texts.extend(some.filter(|text| !method.contains("exact") || is_exact_possible(text)));
        }
    }
    texts
}

#[test]
fn positions_are_those_of_the_reference() {
    let text = include_str!("../../../tests/reference/blends.json");
    let cases: serde_json::Value = serde_json::from_str(text).unwrap();
    let mut checked = 0;
    for case in cases.as_array().unwrap() {
        let mut shape = case["shape"].clone();
        assert_eq!(shape.as_object_mut().unwrap().remove("kind"), Some("blend".into()));
        let within = if shape["method"] == "exact" { 1e-12 } else { 1e-9 };
        let volume = solved(&shape.to_string());
        for point in case["points"].as_array().unwrap() {
            let number = |value: &serde_json::Value| value.as_f64().unwrap();
            let [u, v, w] = ["u", "v", "w"].map(|name| number(&point[name]));
            let found = volume.position([u, v, w]).to_array();
            for (found, expected) in found.iter().zip(point["position"].as_array().unwrap()) {
                let error = (found - number(expected)).abs();
                assert!(error < within, "{}: {found}, not {expected}, off by {error:e}", case["name"]);
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 8 * 8 * 3);
}

impl Volume {
    fn partial(&self, [u, v, w]: [f64; 3], orders: [usize; 3]) -> DVec3 {
        self.layer(w).partial(&self.place(0, u), &self.place(1, v), orders)
    }

    fn residual_at(&self, u: f64, v: f64, w: f64) -> DVec3 {
        self.layer(w).residual(&self.place(0, u), &self.place(1, v))
    }
}

/// Each derivative that anything is made of is the slope of the one before it: the equation is judged by the fourth.
#[test]
fn derivatives_are_those_of_positions() {
    let h = 1e-4;
    for text in every_blend() {
        let volume = solved(&text);
        for at in [[0.3, 0.4, 0.2], [0.75, 0.15, 0.6]] {
            for lower in [
                [0, 0, 0],
                [1, 0, 0],
                [2, 0, 0],
                [3, 0, 0],
                [0, 1, 0],
                [0, 2, 0],
                [0, 3, 0],
                [0, 0, 1],
                [0, 0, 2],
                [0, 0, 3],
            ] {
                for parameter in 0..3 {
                    let mut higher = lower;
                    higher[parameter] += 1;
                    let moved = |by: f64| {
                        let mut at = at;
                        at[parameter] += by;
                        volume.partial(at, lower)
                    };
                    let (found, expected) = (volume.partial(at, higher), (moved(h) - moved(-h)) / (2.0 * h));
                    let scale = 1.0 + found.length() + moved(0.0).length();
                    assert!((found - expected).length() < 1e-4 * scale, "{text} {higher:?}: {found}, {expected}");
                }
            }
        }
    }
}

/// A section at one point, by the formulas of the paper.
fn section(section: &Section, u: f64, v: f64) -> DVec2 {
    let (s, c) = libm::sincos(2.0 * PI * v);
    let half = 2.0 * u - 1.0;
    match &section.form {
        crate::design::Form::Rectangle([x, y]) => DVec2::new(x * (1.0 - 2.0 * u), y * (1.0 - 2.0 * v)),
        crate::design::Form::RectangleReversed([x, y]) => DVec2::new(x * half, y * (2.0 * v - 1.0)),
        crate::design::Form::Disc([x, y]) => DVec2::new(x * u * s, y * u * c),
        crate::design::Form::DiscInSquare([x, y]) => {
            DVec2::new(x * half, y * (2.0 * v - 1.0) * (1.0 - half * half).max(0.0).sqrt())
        }
        crate::design::Form::Outline { x, y } => {
            let of = |waves: &[crate::design::Harmonic]| -> f64 {
                let wave = |h: &crate::design::Harmonic| {
                    let (s, c) = libm::sincos(2.0 * PI * h.n * v);
                    (h.cos * c + h.sin * s) * if h.n == 0.0 { 1.0 } else { u }
                };
                waves.iter().map(wave).sum()
            };
            DVec2::new(of(x), of(y))
        }
    }
}

#[test]
fn sections_and_tangents_are_met_whatever_the_method() {
    for text in every_blend() {
        let blend = blend_of_json(&text).unwrap();
        let volume = Volume::solve(&blend, "").unwrap();
        for (given, w) in [(&blend.start, 0.0), (&blend.end, 1.0)] {
            let layer = volume.layer(w);
            for [u, v] in [[0.0, 0.0], [1.0, 0.3], [0.4, 1.0], [0.7, 0.2], [0.25, 0.5]] {
                let (along, across) = (volume.place(0, u), volume.place(1, v));
                let position = layer.partial(&along, &across, [0, 0, 0]);
                let tangent = layer.partial(&along, &across, [0, 0, 1]);
                let expected = section(given, u, v);
                let error = (position - expected.extend(given.z)).length();
                assert!(error < 1e-13, "{text}: position at {u}, {v}, {w} off by {error:e}");
                let error = (tangent - (given.taper * expected).extend(given.dz)).length();
                assert!(error < 1e-12, "{text}: tangent at {u}, {v}, {w} off by {error:e}");
            }
        }
    }
}

/// How large the terms of the equation are that have to cancel.
fn size_of_terms(volume: &Volume, [u, v, w]: [f64; 3]) -> f64 {
    let (layer, along, across) = (volume.layer(w), volume.place(0, u), volume.place(1, v));
    let weights = volume.weights;
    let of = |(orders, weight): ([usize; 3], f64)| weight * layer.partial(&along, &across, orders).length();
    [[4, 0, 0], [0, 4, 0], [0, 0, 4]].into_iter().zip(weights).map(of).sum::<f64>() + 1.0
}

#[test]
fn an_exact_blend_keeps_the_equation_everywhere() {
    for text in every_blend().iter().filter(|text| text.contains("exact")) {
        let volume = solved(text);
        for at in [[0.3, 0.4, 0.2], [0.8, 0.1, 0.9], [1.0, 0.7, 0.5], [0.05, 0.95, 0.01]] {
            let [u, v, w] = at;
            let residual = volume.residual_at(u, v, w).length();
            assert!(residual < 1e-10 * size_of_terms(&volume, at), "{text}: {residual:e} at {at:?}");
        }
        let whole = volume.inside();
        assert!(whole.residual_rms <= whole.residual, "{text}");
        assert!(whole.residual < 1e-9 * size_of_terms(&volume, whole.residual_at), "{text}");
    }
}

#[test]
fn a_modal_blend_keeps_the_equation_at_its_points_for_every_w_and_collocation_at_those_of_w() {
    for text in every_blend().iter().filter(|text| !text.contains("exact")) {
        let blend = blend_of_json(text).unwrap();
        let volume = Volume::solve(&blend, "").unwrap();
        let [l, m, n] = blend.terms;
        let ws: Vec<f64> = match blend.method() {
            Method::Modal => vec![0.0, 0.1, 0.35, 0.5, 0.81, 1.0],
            _ => (1..=n).map(|k| f64::from(k) / f64::from(2 * n)).collect(),
        };
        for i in 1..=l {
            for j in 1..=m {
                for w in &ws {
                    let at = [f64::from(i) / f64::from(l + 1), f64::from(j) / f64::from(m + 1), *w];
                    let residual = volume.residual_at(at[0], at[1], at[2]).length();
                    assert!(residual < 1e-10 * size_of_terms(&volume, at), "{text}: {residual:e} at {at:?}");
                }
            }
        }
    }
}

/// The equations of ZY04 as they stand, all at once: one unknown for each product, one equation for each point.
#[test]
fn collocation_is_what_the_dense_system_gives() {
    let rest = r#""method": "collocation", "terms": [3, 2, 3], "weights": [2, 0.5, 3]"#;
    for text in all(rest) {
        let blend = blend_of_json(&text).unwrap();
        let volume = Volume::solve(&blend, "").unwrap();
        let [a, b, c] = blend.weights;
        let (l, m, n) = (3, 2, 3);
        let both = [&blend.start, &blend.end];
        // Fourth derivatives by the formulas.
        let fourth = |given: &Section, u: f64, v: f64| -> DVec2 {
            let position = section(given, u, v);
            match &given.form {
                crate::design::Form::Disc(_) => b * (2.0 * PI).powi(4) * position,
                crate::design::Form::DiscInSquare([_, y]) => {
                    let s = 2.0 * u - 1.0;
                    let root = -16.0 * (3.0 + 12.0 * s * s) / libm::pow(1.0 - s * s, 3.5);
                    a * DVec2::new(0.0, y * (2.0 * v - 1.0) * root)
                }
                crate::design::Form::Outline { x, y } => {
                    let of = |waves: &[crate::design::Harmonic]| -> f64 {
                        let wave = |h: &crate::design::Harmonic| {
                            let (s, c) = libm::sincos(2.0 * PI * h.n * v);
                            u * (2.0 * PI * h.n).powi(4) * (h.cos * c + h.sin * s)
                        };
                        waves.iter().map(wave).sum()
                    };
                    b * DVec2::new(of(x), of(y))
                }
                _ => DVec2::ZERO,
            }
        };
        let cubic = |index: usize, taper: f64, w: f64| match index {
            0 => 1.0 - 3.0 * w * w + 2.0 * w.powi(3) + taper * (1.0 - 2.0 * w + w * w) * w,
            _ => (3.0 - 2.0 * w) * w * w + taper * (w - 1.0) * w * w,
        };
        let size = l * m * n;
        let mut matrix = nalgebra::DMatrix::zeros(size, size);
        let mut sides = [nalgebra::DVector::zeros(size), nalgebra::DVector::zeros(size)];
        let numbers = |index: usize| ((index / (m * n)) + 1, (index / n % m) + 1, index % n + 1);
        for row in 0..size {
            let (i, j, k) = numbers(row);
            let (u, v) = (i as f64 / (l + 1) as f64, j as f64 / (m + 1) as f64);
            let w = k as f64 / (2 * n) as f64;
            for column in 0..size {
                let (l, m, n) = numbers(column);
                let [lf, mf, nf] = [l, m, n].map(|n| n as f64);
                let operator = (a * lf.powi(4) + b * mf.powi(4)) * libm::sin(nf * PI * w).powi(2)
                    - 8.0 * c * nf.powi(4) * libm::cos(2.0 * nf * PI * w);
                matrix[(row, column)] = PI.powi(4) * libm::sin(lf * PI * u) * libm::sin(mf * PI * v) * operator;
            }
            let left: DVec2 = (0..2).map(|index| fourth(both[index], u, v) * cubic(index, both[index].taper, w)).sum();
            (sides[0][row], sides[1][row]) = (-left.x, -left.y);
        }
        let factors = matrix.lu();
        let [x, y] = sides.map(|side| factors.solve(&side).unwrap());
        for [u, v, w] in [[0.3, 0.4, 0.2], [0.8, 0.1, 0.9], [0.55, 0.7, 0.5]] {
            let mut expected: DVec2 = (0..2).map(|i| section(both[i], u, v) * cubic(i, both[i].taper, w)).sum();
            for index in 0..size {
                let (l, m, n) = numbers(index);
                let [l, m, n] = [l, m, n].map(|n| n as f64 * PI);
                let product = libm::sin(l * u) * libm::sin(m * v) * libm::sin(n * w).powi(2);
                expected += product * DVec2::new(x[index], y[index]);
            }
            let found = volume.position([u, v, w]).truncate();
            assert!((found - expected).length() < 1e-10, "{text}: {found}, not {expected}");
        }
    }
}

/// Modal and exact solve the same equation of a disc, with other conditions along the seam; away from it more sines come nearer to what one harmonic is.
#[test]
fn collocation_comes_to_modal_as_terms_grow_along_w() {
    let text = |method: &str, n: usize| {
        format!(
            r#"{{"start": {{{}, "z": 0, "taper": 0, "dz": 1}}, "end": {{{}, "z": 2, "taper": 0, "dz": 1}}, "method": "{method}", "terms": [4, 4, {n}]}}"#,
            FORMS[2], FORMS[2]
        )
    };
    // The same section at both ends: what is asked is even in w, as the squares of sines are.
    let modal = solved(&text("modal", 1));
    let distance = |n: usize| {
        let collocation = solved(&text("collocation", n));
        let at = |[u, v, w]: [f64; 3]| collocation.position([u, v, w]).distance(modal.position([u, v, w]));
        [[0.3, 0.4, 0.2], [0.8, 0.1, 0.5], [0.55, 0.7, 0.35]].map(at).into_iter().fold(0.0, f64::max)
    };
    let distances = [4, 8, 16, 32].map(distance);
    for pair in distances.windows(2) {
        // Of the order 2 at least.
        assert!(pair[1] < 0.3 * pair[0], "{distances:?}");
    }
    assert!(distances[3] < 1e-4, "{distances:?}");
}

#[test]
fn sections_exchanged_give_the_same_solid_the_other_way_round() {
    for (start, end) in [(0, 1), (2, 2), (2, 4), (3, 1), (4, 0)] {
        for method in ["modal", "exact"] {
            if method == "exact" && [start, end].contains(&3) {
                continue;
            }
            let text = |first: (usize, f64, f64, f64), then: (usize, f64, f64, f64)| {
                let section = |(form, z, taper, dz): (usize, f64, f64, f64)| {
                    format!(r#"{{{}, "z": {z}, "taper": {taper}, "dz": {dz}}}"#, FORMS[form])
                };
                format!(
                    r#"{{"start": {}, "end": {}, "method": "{method}", "terms": [4, 5, 3]}}"#,
                    section(first),
                    section(then)
                )
            };
            // Walked backwards a tangent points the other way.
            let one = solved(&text((start, 4.0, -0.2, -2.0), (end, 1.0, 0.4, -1.0)));
            let other = solved(&text((end, 1.0, -0.4, 1.0), (start, 4.0, 0.2, 2.0)));
            for [u, v, w] in [[0.3, 0.4, 0.2], [0.8, 0.1, 0.9], [0.55, 0.7, 0.5]] {
                let error = one.position([u, v, w]).distance(other.position([u, v, 1.0 - w]));
                assert!(error < 1e-13, "{start} {end} {method}: {error:e}");
            }
        }
    }
}

#[test]
fn a_blend_of_stretched_sections_is_the_blend_stretched() {
    let text = |[x, y, z]: [f64; 3], method: &str| {
        let section = |rx: f64, ry: f64, height: f64, taper: f64, dz: f64| {
            format!(
                r#"{{"form": "disc-in-square", "radius": [{}, {}], "z": {}, "taper": {taper}, "dz": {}}}"#,
                rx * x,
                ry * y,
                height * z,
                dz * z
            )
        };
        format!(
            r#"{{"start": {}, "end": {}, "method": "{method}", "terms": [4, 3, 3], "weights": [1, 2, 0.5]}}"#,
            section(1.0, 2.0, 3.0, 0.5, -1.0),
            section(2.0, 1.0, 0.0, -0.5, -2.0)
        )
    };
    for method in ["modal", "collocation"] {
        let by = DVec3::new(2.0, 0.5, -3.0);
        let (plain, stretched) = (solved(&text([1.0; 3], method)), solved(&text(by.to_array(), method)));
        for [u, v, w] in [[0.3, 0.4, 0.2], [0.8, 0.1, 0.9], [0.55, 0.7, 0.5]] {
            let error = (plain.position([u, v, w]) * by).distance(stretched.position([u, v, w]));
            assert!(error < 1e-13, "{method}: {error:e}");
        }
    }
}

#[test]
fn what_has_no_closed_form_is_refused_with_its_path() {
    let text = all(r#""method": "exact""#).into_iter().find(|text| !is_exact_possible(text)).unwrap();
    let error = blend_of_json(&text).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::OutOfRange, "method"));
    // Were it not refused when it is read, it would be here.
    let mut blend = blend_of_json(&text.replace("exact", "modal")).unwrap();
    blend.method = Some(Method::Exact);
    let error = Volume::solve(&blend, "parts[0].shape").unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::OutOfRange, "parts[0].shape.method"));
}

#[test]
fn extreme_weights_stay_numbers() {
    for weights in ["[1e-9, 1, 1]", "[1, 1e9, 1]", "[1, 1, 1e-12]", "[1, 1, 1e12]", "[1e6, 1e-6, 1e3]"] {
        for text in all(&format!(r#""weights": {weights}"#)) {
            let volume = solved(&text);
            for [u, v, w] in [[0.3, 0.4, 0.001], [0.8, 0.1, 0.9], [1.0, 0.7, 0.5]] {
                let position = volume.position([u, v, w]);
                assert!(position.is_finite() && position.length() < 100.0, "{text}: {position}");
            }
        }
    }
}
