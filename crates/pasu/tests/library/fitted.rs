//! Rings and drains for which there is no room: the pot is made with the nearest for which there is, the same whatever is asked of it, and never without a word.
//!
//! What its time buys: everything that can be asked of a pot is asked of the same few, by which it is known that all of it is of one body.

use pasu::{
    Code, Design, Finding, Format, Making, Map, MeasureOptions, MeshOptions, Pot, Product, Severity, Size,
    SketchOptions, Solution, Wall, check, measure, open, paint, provenance, sketch, solid, water, write,
};

/// A cone that leans inwards by as much as it rises, so that a ring comes out of it where it is higher than wide.
fn cone(wall: &str) -> Design {
    parsed(&format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "second-order", "r": [1, 0, 4, 0], "t": [0, 0], "n": [1, 2], "height": 3 }}, "wall": {wall} }}] }}"#
    ))
}

/// A cylinder of radius 3 and height 4.
fn cylinder(wall: &str) -> Design {
    parsed(&format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 }}, "wall": {wall} }}] }}"#
    ))
}

/// A ring of 0.3 by 0.6 on the cone.
fn ringed() -> Design {
    cone(r#"{ "thickness": 0.2, "base": 0.3, "foot": [0.3, 0.6] }"#)
}

fn parsed(text: &str) -> Design {
    Design::parse(text).expect("a design")
}

#[track_caller]
fn warned(design: &Design, code: &str, tolerance: Option<f64>) -> Finding {
    let report = check(design, &Making { tolerance, ..Making::default() }).expect("a report");
    assert!(report.is_ok(), "{:?}", report.findings);
    let found: Vec<&Finding> = report.findings.iter().filter(|found| found.code == code).collect();
    assert_eq!(found.len(), 1, "{:?}", report.findings);
    assert_eq!(found[0].severity, Severity::Warning);
    found[0].clone()
}

fn wall(finding: &Finding) -> Wall {
    finding.remedy.as_ref().expect("a remedy").wall
}

/// The design that says what is made.
fn applied(design: &Design, finding: &Finding) -> Design {
    let mut document: serde_json::Value = serde_json::from_str(&design.to_json()).expect("a document");
    document["parts"][finding.part]["wall"] = serde_json::to_value(wall(finding)).expect("a wall");
    parsed(&document.to_string())
}

#[test]
fn a_ring_that_comes_out_of_the_wall_is_made_wider_or_lower_and_told() {
    let found = warned(&ringed(), "fitted-foot", None);
    assert_eq!(found.path.as_deref(), Some("parts[0].wall.foot"));
    let [width, height] = wall(&found).foot.expect("a ring");
    assert!(width > height && width <= 0.6 && height >= 0.2, "{width} {height}");
    // Nothing else of the wall is touched.
    let mut rest = wall(&found);
    rest.foot = Some([0.3, 0.6]);
    assert_eq!(rest, ringed().parts()[0].wall.expect("a wall"));
    for size in ["0.3", "0.6", &width.to_string(), &height.to_string()] {
        assert!(found.message.contains(size), "{}", found.message);
    }
    assert_eq!(found.remedy.expect("a remedy").path, "parts[0].wall");
}

#[test]
fn a_ring_that_has_room_stays_as_it_is() {
    let wall = r#"{ "thickness": 0.2, "base": 0.3, "foot": [0.6, 0.3] }"#;
    assert_eq!(
        check(&cone(wall), &Making::default())
            .expect("a report")
            .findings
            .iter()
            .filter(|found| found.remedy.is_some())
            .count(),
        0
    );
    let report = check(&cylinder(r#"{ "thickness": 0.2, "base": 0.3, "foot": [0.3, 2] }"#), &Making::default())
        .expect("a report");
    assert!(report.findings.iter().all(|found| !found.code.starts_with("fitted")), "{:?}", report.findings);
}

/// By the sizes alone: the foot has a radius of 3.
#[test]
fn a_ring_that_fills_the_foot_is_made_narrower() {
    let found = warned(&cylinder(r#"{ "thickness": 0.2, "base": 0.3, "foot": [3.5, 0.2] }"#), "fitted-foot", None);
    let [width, height] = wall(&found).foot.expect("a ring");
    assert!(width < 3.0 && height == 0.2, "{found:?}");
}

/// Of a size that nobody would ask for.
#[test]
fn a_ring_beyond_all_measure_is_sought_from_the_size_of_the_pot() {
    let found = warned(&cylinder(r#"{ "thickness": 0.2, "base": 0.3, "foot": [1e6, 1e6] }"#), "fitted-foot", None);
    let [width, height] = wall(&found).foot.expect("a ring");
    assert!(width < 3.0 && height < 3.5, "{found:?}");
}

#[test]
fn the_verdict_and_the_ring_are_the_same_at_every_tolerance_and_size() {
    let design = ringed();
    let ring = wall(&warned(&design, "fitted-foot", None));
    for tolerance in [0.2, 0.05, 0.01, 0.002] {
        assert_eq!(wall(&warned(&design, "fitted-foot", Some(tolerance))), ring, "{tolerance}");
    }
    for (size, shrinkage) in [(Size::Height(50.0), 0.0), (Size::Capacity(3.0), 12.0)] {
        let report = check(&design, &Making { size: Some(size), shrinkage, ..Making::default() }).expect("a report");
        let found = report.findings.iter().find(|found| found.code == "fitted-foot").expect("a warning");
        assert_eq!(wall(found), ring, "{size:?}");
    }
}

#[test]
fn whatever_is_asked_is_of_the_one_body_that_the_warning_tells() {
    let asked = ringed();
    let found = warned(&asked, "fitted-foot", None);
    let made = applied(&asked, &found);
    let report = check(&made, &Making::default()).expect("a report");
    assert!(report.findings.iter().all(|found| !found.code.starts_with("fitted")), "{:?}", report.findings);
    assert_eq!(check(&asked, &Making::default()).expect("a report").meshes, report.meshes);
    for tolerance in [None, Some(0.05), Some(0.004)] {
        let making = Making { tolerance, ..Making::default() };
        assert_eq!(solid(&asked, &making).expect("a mesh"), solid(&made, &making).expect("a mesh"));
    }
    let options = MeasureOptions::default();
    assert_eq!(measure(&asked, &options).expect("measures"), measure(&made, &options).expect("measures"));
    let faces = |design: &Design| Pot::new(design, 0, Product::Pot).expect("a pot").foot_level();
    assert_eq!(faces(&asked).to_bits(), faces(&made).to_bits());
    assert_eq!(water(&asked, 1.5).expect("water"), water(&made, 1.5).expect("water"));
    let grid = MeshOptions { rows: Some(9), columns: Some(17), ..MeshOptions::default() };
    let painted = |design: &Design| paint(design, Map::Thickness, &grid).expect("colours");
    assert_eq!(painted(&asked), painted(&made));
    let drawn = |design: &Design| pasu::drawn(design, &Making::default()).expect("triangles");
    assert_eq!(drawn(&asked), drawn(&made));
    // Only the design that they tell of differs in files; the triangles of an STL begin behind its title and their number.
    let stl = |design: &Design| write(design, Format::Stl, &Making::default()).expect("a file").split_off(80);
    assert_eq!(stl(&asked), stl(&made));
}

#[test]
fn a_sketch_has_the_ring_that_is_made() {
    let asked = ringed();
    let made = applied(&asked, &warned(&asked, "fitted-foot", None));
    for tolerance in [0.1, 0.02] {
        let options = SketchOptions { tolerance: Some(tolerance), fill: Some(0.5) };
        assert_eq!(sketch(&asked, &options).expect("a sketch"), sketch(&made, &options).expect("a sketch"));
    }
}

#[test]
fn a_file_says_that_its_ring_was_fitted_and_opens_as_what_was_asked_for() {
    let asked = ringed();
    let making = Making { size: Some(Size::Height(9.0)), ..Making::default() };
    let file = write(&asked, Format::Ply, &making).expect("a file");
    assert!(String::from_utf8_lossy(&file).contains("fitted-foot"));
    assert_eq!(open(&file).expect("a link"), asked.link());
    let told = provenance(&file).expect("notes").making.expect("a making");
    assert_eq!(write(&asked, Format::Ply, &told).expect("a file"), file);
    for format in Format::ALL {
        assert!(write(&asked, format, &Making::default()).is_ok(), "{format:?}");
    }
}

#[test]
fn nothing_depends_on_what_was_asked_before() {
    let design = ringed();
    let (first, second) = (Solution::of(&design), Solution::of(&design));
    let options = SketchOptions { tolerance: Some(0.05), fill: None };
    let of_first = (first.check(&Making::default()), first.measure(&MeasureOptions::default()), first.sketch(&options));
    let sketched = second.sketch(&options);
    assert_eq!(of_first, (second.check(&Making::default()), second.measure(&MeasureOptions::default()), sketched));
}

/// A drain of 5.2 in a foot of radius 3 leaves 0.4: a ring of 0.6 gives way, and the drain stays.
#[test]
fn a_ring_gives_way_to_a_drain() {
    let found = warned(
        &cylinder(r#"{ "thickness": 0.2, "base": 0.3, "foot": [0.6, 0.3], "drain": 5.2 }"#),
        "fitted-foot",
        None,
    );
    let wall = wall(&found);
    assert!(wall.drain == 5.2 && wall.foot.is_some_and(|[width, _]| width < 0.4), "{wall:?}");
}

#[test]
fn a_drain_that_has_no_room_is_made_smaller() {
    let design = cylinder(r#"{ "thickness": 0.2, "base": 0.3, "drain": 6.5 }"#);
    let found = warned(&design, "fitted-drain", None);
    assert_eq!(found.path.as_deref(), Some("parts[0].wall.drain"));
    let wall = wall(&found);
    assert!(wall.drain < 6.0 && wall.drain > 3.0, "{wall:?}");
    let made = applied(&design, &found);
    assert_eq!(solid(&design, &Making::default()), solid(&made, &Making::default()));
    let options = SketchOptions { tolerance: Some(0.05), fill: None };
    assert_eq!(sketch(&design, &options), sketch(&made, &options));
}

#[test]
fn a_ring_for_which_there_is_no_place_is_refused_with_a_remedy() {
    // A tube has no base.
    let tube = cylinder(r#"{ "thickness": 0.2, "base": 0, "foot": [0.3, 0.3] }"#);
    let report = check(&tube, &Making::default()).expect("a report");
    let refused = &report.findings[0];
    assert_eq!((refused.code, refused.severity), (Code::NoRoom.as_str(), Severity::Error));
    assert_eq!(refused.path.as_deref(), Some("parts[0].wall.foot"));
    assert_eq!(refused.remedy.as_ref().map(|remedy| remedy.wall.foot), Some(None));
    assert!(solid(&tube, &Making::default()).is_err());
}

#[test]
fn of_several_parts_each_has_its_own_ring() {
    let mut document: serde_json::Value = serde_json::from_str(&ringed().to_json()).expect("a document");
    let mut plain = document["parts"][0].clone();
    plain["wall"] = serde_json::json!({ "thickness": 0.2, "base": 0.3, "foot": [0.6, 0.3] });
    plain["place"] = serde_json::json!({ "shift": [20, 0, 0] });
    let parts = document["parts"].as_array_mut().expect("parts");
    parts.insert(0, plain);
    let design = parsed(&document.to_string());
    let found = warned(&design, "fitted-foot", None);
    assert_eq!((found.part, found.path.as_deref()), (1, Some("parts[1].wall.foot")));
    assert_eq!(wall(&found), wall(&warned(&ringed(), "fitted-foot", None)));
}
