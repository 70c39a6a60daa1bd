//! What is answered of a design does not depend on what was asked before, of it or of the designs from which it came.

use crate::support::random::{Random, drawn};
use pasu::{Design, Format, Making, MeasureOptions, MeshOptions, Product, SketchOptions, Solution};
use serde_json::{Value, json};

fn part(random: &mut Random) -> Value {
    if random.chance(4) {
        let [a, b, c] = [0; 3].map(|_| random.between(0.5, 6.0));
        let shift = [random.between(-20.0, 20.0), random.between(-20.0, 20.0), 0.0];
        return json!({ "shape": { "kind": "octant", "exponents": [a, b, c] }, "place": { "scale": [4, 4, 5], "shift": shift } });
    }
    let design: Value = serde_json::from_str(&random.design()).expect("JSON");
    let mut part = design["parts"][0].clone();
    if random.chance(5) {
        part.as_object_mut().expect("a part").remove("wall");
    }
    part
}

/// A change as a hand makes it: of one part or of their list, of the unit, or of nothing that a body depends on.
fn changed(random: &mut Random, design: &mut Value) {
    let parts = design["parts"].as_array_mut().expect("parts");
    let which = random.whole(0, parts.len() as u64 - 1) as usize;
    match random.whole(0, 7) {
        0 => parts[which] = part(random),
        1 if parts[which].get("wall").is_some() => parts[which]["wall"]["thickness"] = json!(random.between(0.1, 0.5)),
        2 => parts[which]["place"]["shift"] = json!([random.between(-9.0, 9.0), random.between(-9.0, 9.0), 0.0]),
        3 => parts[which]["place"]["scale"] = json!([random.between(0.8, 1.2), 1.0, random.between(0.8, 1.2)]),
        4 if parts.len() > 1 => drop(parts.remove(which)),
        5 if parts.len() < 3 => parts.insert(which, part(random)),
        6 => design["unit"] = json!(["mm", "cm", "in"][random.whole(0, 2) as usize]),
        _ => parts.swap(0, which),
    }
}

/// What is answered to the last digit, refusals too.
type Answer = Box<dyn Fn(&Solution) -> String>;

/// A question by its name.
fn question(random: &mut Random) -> (String, Answer) {
    let making = Making {
        product: if random.chance(3) { Product::Solid } else { Product::Pot },
        tolerance: [None, Some(0.5), Some(0.05)][random.whole(0, 2) as usize],
        shrinkage: if random.chance(3) { 10.0 } else { 0.0 },
        ..Making::default()
    };
    let rough = MeshOptions { rows: Some(9), columns: Some(17), ..MeshOptions::default() };
    let sketch = SketchOptions { fill: Some(0.5), ..SketchOptions::default() };
    match random.whole(0, 6) {
        0 => (format!("solid {making:?}"), Box::new(move |of| format!("{:?}", of.solid(&making)))),
        1 => (format!("drawn {making:?}"), Box::new(move |of| format!("{:?}", of.drawn(&making)))),
        2 => (format!("check {making:?}"), Box::new(move |of| format!("{:?}", of.check(&making)))),
        3 => (format!("stl {making:?}"), Box::new(move |of| format!("{:?}", of.write(Format::Stl, &making)))),
        4 => ("measure".into(), Box::new(|of| format!("{:?}", of.measure(&MeasureOptions::default())))),
        5 => ("sketch".into(), Box::new(move |of| format!("{:?}", of.sketch(&sketch)))),
        _ => ("mesh".into(), Box::new(move |of| format!("{:?}", of.mesh(&rough)))),
    }
}

#[test]
fn every_answer_is_that_of_a_design_that_nobody_asked_before() {
    let (mut n_answers, mut n_made) = (0, 0);
    for seed in 0..drawn(2, 10) {
        let random = &mut Random::new(seed);
        let mut document = json!({ "pasu": 1, "parts": [part(random), part(random)] });
        let mut last: Option<Solution> = None;
        for step in 0..6 {
            let design = Design::parse(&document.to_string()).expect("a design");
            let solution = last.as_ref().map_or_else(|| Solution::of(&design), |last| last.after(&design));
            for _ in 0..2 {
                let (name, ask) = question(random);
                let (known, fresh) = (ask(&solution), ask(&Solution::of(&design)));
                assert!(known == fresh, "chain {seed}, step {step}: {name} of {document}");
                n_answers += 1;
                n_made += usize::from(known.starts_with("Ok"));
            }
            last = Some(solution);
            changed(random, &mut document);
        }
    }
    assert!(2 * n_made > n_answers, "only {n_made} of {n_answers} could be made");
}
