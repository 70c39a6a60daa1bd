//! Measures of real designs against formulas, dense sums and each other.

mod support;

use pasu::{MeasureOptions, Measures, Quantity, measure, water};
use support::design;

fn measured(json: &str) -> Measures {
    measure(&design(json), &MeasureOptions::default()).unwrap_or_else(|e| panic!("{e}\n{json}"))
}

#[test]
#[ignore = "prints"]
fn print() {
    for exhibit in support::gallery() {
        let shape = serde_json::to_string(&exhibit.shape).unwrap();
        let bare = measured(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#));
        let t = 0.015 * bare.whole.height.value;
        for wall in [format!(r#", "wall": {{ "thickness": {t}, "base": {t}, "rim": "rounded" }}"#)] {
            let design = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}{wall} }}] }}"#));
            let start = std::time::Instant::now();
            let pot = pasu::Pot::new(&design, 0, pasu::Product::Pot);
            println!("pot {:?} {:?}", start.elapsed(), pot.ok().map(|p| p.thinned().map(|t| t.0)));
            let start = std::time::Instant::now();
            let measures = measure(&design, &MeasureOptions::default());
            let time = start.elapsed();
            match measures {
                Ok(m) => {
                    let w = &m.whole;
                    println!(
                        "{:20} {time:?} clay {:?} brim {:?} {:?} {:?}",
                        exhibit.name,
                        w.clay.map(|c| c.volume),
                        w.capacity.map(|c| c.brim),
                        m.parts[0].reason,
                        w.tipping_full
                    );
                    if exhibit.name == "own-jar" || exhibit.name == "own-dint" {
                        println!("{}", m.to_json());
                    }
                    if let Some(c) = w.capacity {
                        let start = std::time::Instant::now();
                        let wa = water(&design, 0.5 * (c.floor + c.spill_level.value)).unwrap();
                        println!("   water {:?} {} {} {}", start.elapsed(), wa.volume, wa.error, wa.indices.len() / 3);
                    }
                }
                Err(e) => println!("{:20} {time:?} {e}", exhibit.name),
            }
        }
    }
    let _: Option<Quantity> = None;
    let _ = measured;
}

#[test]
#[ignore = "prints"]
fn dense() {
    use pasu::{Face, FaceKind};
    for exhibit in support::gallery() {
        if !["own-bowl", "own-trumpet", "own-plate", "own-tulip"].contains(&exhibit.name.as_str()) { continue }
        let shape = serde_json::to_string(&exhibit.shape).unwrap();
        let bare = measured(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#));
        let t = 0.015 * bare.whole.height.value;
        for rim in ["flat", "rounded"] {
            let design = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": {t}, "base": {t}, "rim": "{rim}" }} }}] }}"#));
            let m = measure(&design, &MeasureOptions::default()).unwrap();
            let c = m.whole.capacity.unwrap();
            let pot = pasu::Pot::new(&design, 0, pasu::Product::Pot).unwrap();
            let level = c.spill_level.value;
            let (n, k) = (720, 1600);
            let mut sum = 0.0;
            for j in 0..n {
                let mut column: Vec<(f64, f64)> = vec![];
                for face in pot.faces().iter().rev() {
                    if !matches!(face.kind(), FaceKind::Floor | FaceKind::Lining | FaceKind::Rim) { continue }
                    for i in (0..k).rev() {
                        let jet = face.jet((i as f64 + 0.5) / k as f64, std::f64::consts::TAU * j as f64 / n as f64);
                        column.push((jet.position.z, jet.da.cross(jet.dv).z * face.outward()));
                    }
                }
                let crest = (0..column.len()).max_by(|&a, &b| column[a].0.total_cmp(&column[b].0)).unwrap();
                sum += column[..crest].iter().map(|(z, up)| (level - z).max(0.0) * up).sum::<f64>();
            }
            let parts = 0;
            println!("{} {rim} {:?} dense {} {parts:?} spill {} {:?} thinned {:?}", exhibit.name, c.brim, sum * std::f64::consts::TAU / (n * k) as f64, level, c.spill_at, pot.thinned());
        }
    }
}
