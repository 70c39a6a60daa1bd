//! Files of bodies made by hand: awkward titles, long links, damage. What files of real designs hold is tested in `tests/export.rs`.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use proptest::prelude::*;

use super::contents::{Body, Notes};
use super::step::{Boundary, Part};
use super::template::{Frame, Stand};
use super::{glb, obj, open, ply, provenance, step, stl, template, three_mf};
use crate::design::{Look, Unit};
use crate::face::{Face, FaceJet, FaceKind, Sealed};
use crate::make::{Craft, Making, Size};
use crate::solid::Product;

const COLUMNS: u32 = 24;

/// A cup: a cylinder of radius 20 and height 30 with a hole of radius 15 and depth 25, millimetres. Its meridian is a line through six points.
const MERIDIAN: [(f64, f64); 6] = [(0.0, 0.0), (20.0, 0.0), (20.0, 30.0), (15.0, 30.0), (15.0, 5.0), (0.0, 5.0)];
const KINDS: [FaceKind; 5] = [FaceKind::Underside, FaceKind::Outer, FaceKind::Rim, FaceKind::Lining, FaceKind::Floor];

struct Cup {
    positions: Vec<f32>,
    indices: Vec<u32>,
    faces: Vec<(FaceKind, usize, usize)>,
}

fn cup() -> Cup {
    let mut positions = vec![0.0, 0.0, 0.0];
    for (radius, z) in &MERIDIAN[1..5] {
        for j in 0..COLUMNS {
            let angle = TAU * f64::from(j) / f64::from(COLUMNS);
            positions.extend([radius * libm::cos(angle), radius * libm::sin(angle), *z].map(|x| x as f32));
        }
    }
    positions.extend([0.0, 0.0, 5.0]);
    let (mut indices, mut faces) = (Vec::new(), Vec::new());
    let ring = |row: u32, j: u32| 1 + (row - 1) * COLUMNS + j % COLUMNS;
    for (row, kind) in (0..5).zip(KINDS) {
        let first = indices.len();
        for j in 0..COLUMNS {
            match row {
                0 => indices.extend([0, ring(1, j + 1), ring(1, j)]),
                4 => indices.extend([ring(4, j), ring(4, j + 1), 1 + 4 * COLUMNS]),
                _ => {
                    indices.extend([ring(row, j), ring(row, j + 1), ring(row + 1, j + 1)]);
                    indices.extend([ring(row, j), ring(row + 1, j + 1), ring(row + 1, j)]);
                }
            }
        }
        faces.push((kind, first, indices.len() - first));
    }
    Cup { positions, indices, faces }
}

impl Cup {
    fn body(&self) -> Body<'_> {
        Body {
            name: "bödy <1> &\u{2028} 'x'".into(),
            look: Look::default(),
            positions: &self.positions,
            indices: &self.indices,
            faces: self.faces.clone(),
        }
    }
}

/// A face of the cup, in model units of 10 mm.
struct Turned(usize);

impl Sealed for Turned {}

impl Face for Turned {
    fn kind(&self) -> FaceKind {
        KINDS[self.0]
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        let ((r0, z0), (r1, z1)) = (MERIDIAN[self.0], MERIDIAN[self.0 + 1]);
        let out = DVec3::new(libm::cos(v), libm::sin(v), 0.0) / 10.0;
        let round = DVec3::new(-libm::sin(v), libm::cos(v), 0.0) / 10.0;
        let radius = r0 + a * (r1 - r0);
        FaceJet {
            position: radius * out + DVec3::Z * (z0 + a * (z1 - z0)) / 10.0,
            da: (r1 - r0) * out + DVec3::Z * (z1 - z0) / 10.0,
            dv: radius * round,
        }
    }

    fn outward(&self) -> f64 {
        -1.0
    }
}

/// Short enough for the header of an STL.
const MADE: Making = Making { product: Product::Pot, size: None, shrinkage: 5.0, tolerance: None, craft: None };

fn notes(title: &str, link: &str) -> Notes {
    Notes {
        title: title.into(),
        link: link.into(),
        fingerprint: "0123456789abcdef".into(),
        verdict: "passed with warnings: thinned".into(),
        scale: "1 cm of the design is 10 mm here".into(),
        making: MADE,
        unit: Unit::Cm,
    }
}

fn files(notes: &Notes) -> Vec<(&'static str, Vec<u8>)> {
    let cup = cup();
    let bodies = [cup.body()];
    let faces: Vec<Turned> = (0..5).map(Turned).collect();
    let part = Part {
        name: bodies[0].name.clone(),
        look: Look::default(),
        boundary: Boundary::Faces(faces.iter().map(|face| face as &dyn Face).collect()),
        tolerance: 1e-3,
        path: String::new(),
    };
    let rim = (0..90).map(|i| 10.0 * Turned(1).jet(1.0, TAU * f64::from(i) / 90.0).position).collect();
    let stand = Stand { frame: Frame { origin: DVec3::ZERO, axis: DVec3::Z, across: DVec3::X }, rim };
    vec![
        ("stl", stl::write(notes, &bodies)),
        ("3mf", three_mf::write(notes, &bodies)),
        ("glb", glb::write(notes, &bodies)),
        ("obj", obj::write(notes, &bodies)),
        ("ply", ply::write(notes, &bodies)),
        ("step", step::write(notes, &[part], 10.0).unwrap()),
        ("svg", template::write(notes, &bodies, &[stand])),
    ]
}

#[test]
fn links_are_found_again_whatever_the_title() {
    let long = format!("1~{}", "abcdefghijklmnopqrstuvwxyz0123456789-_".repeat(30));
    for title in [
        "Vase",
        "pasu-link: 1/evil",
        "' pasu-link: x \\X2\\ \"}]; ENDSEC;",
        "</metadata><metadata name=\"pasu:link\">",
        "\"extras\":{\"link\":\"1/evil\"",
        "é 🏺 \u{2028} end_header",
        "<pasu:link>1/evil</pasu:link>",
        "pasu-product: solid",
        "\",\"product\":\"solid",
        "<pasu:shrinkage>1</pasu:shrinkage>",
    ] {
        for link in ["1/bloor-wilson?a=6&n1=5", "1/second-order?r=1,.1,.6,.06&title=A%20%3Cpot%3E", long.as_str()] {
            for (format, bytes) in files(&notes(title, link)) {
                let expected = (format != "stl" || link == "1/bloor-wilson?a=6&n1=5").then_some(link);
                assert_eq!(open(&bytes).as_deref(), expected, "{title} {format}");
                let making = provenance(&bytes).and_then(|found| found.making);
                // The header of an STL has room for the link, and not for the making beside it.
                assert_eq!(making, (format != "stl").then_some(MADE), "{title} {format}");
            }
        }
    }
}

#[test]
fn an_stl_says_what_fits() {
    let cup = cup();
    let bodies = [cup.body()];
    let told = |link: &str, making: Making| {
        let bytes = stl::write(&Notes { making, verdict: "passed".into(), ..notes("", link) }, &bodies);
        let header = String::from_utf8(bytes[..80].to_vec()).unwrap();
        (provenance(&bytes).map(|found| (found.link, found.making)), header.trim_end_matches('\0').to_owned())
    };
    let plain = Making::default();
    let sized = Making { size: Some(Size::Height(18.0)), craft: Some(Craft::Clay), ..MADE };
    let long = "1/second-order?".repeat(4);
    assert_eq!(told("1/bloor-wilson?a=6", plain).0, Some(("1/bloor-wilson?a=6".into(), Some(plain))));
    assert_eq!(told("1/x", sized).0, Some(("1/x".into(), Some(sized))));
    // The link counts for more, and a making by itself is read by people.
    assert_eq!(told("1/bloor-wilson?a=6", sized).0, Some(("1/bloor-wilson?a=6".into(), None)));
    let (found, header) = told(&long, sized);
    assert!(found.is_none() && header.ends_with("passed pot height=18 shrinkage=5 craft=clay"), "{header}");
}

#[test]
fn a_making_that_cannot_be_is_not_read() {
    let cup = cup();
    let making = Making { size: Some(Size::Width(7.0)), tolerance: Some(0.5), ..MADE };
    let text = String::from_utf8(obj::write(&Notes { making, ..notes("Vase", "1/x") }, &[cup.body()])).unwrap();
    let found = |text: &str| provenance(text.as_bytes()).map(|found| (found.link, found.making));
    assert_eq!(found(&text), Some(("1/x".into(), Some(making))));
    for (from, to) in [
        ("product: pot", "product: mug"),
        ("product: pot", "product: "),
        ("size: width 7", "size: depth 7"),
        ("size: width 7", "size: width 0"),
        ("size: width 7", "size: width -7"),
        ("size: width 7", "size: width 1e999"),
        ("size: width 7", "size: width NaN"),
        ("size: width 7", "size: 7"),
        ("shrinkage: 5", "shrinkage: 50"),
        ("shrinkage: 5", "shrinkage: -1"),
        ("shrinkage: 5", "shrinkage: inf"),
        ("shrinkage: 5", "shrinkage: five"),
        ("tolerance: 0.5", "tolerance: 0"),
        ("tolerance: 0.5", "craft: mud"),
    ] {
        assert!(text.contains(from), "{from}");
        assert_eq!(found(&text.replacen(from, to, 1)), Some(("1/x".into(), None)), "{to}");
    }
    // What another version says besides is passed over, and a file of one that did not say is still opened.
    let more = text.replacen("# pasu-product", "# pasu-lid: none\n# pasu-product", 1);
    assert_eq!(found(&more), Some(("1/x".into(), Some(making))));
    let less: String =
        text.lines().filter(|line| !line.contains("pasu-product")).map(|line| format!("{line}\n")).collect();
    assert_eq!(found(&less), Some(("1/x".into(), None)));
}

#[test]
fn files_can_be_kept_for_other_programs() {
    for (format, bytes) in files(&notes("Vase <& \"é\" 🏺>'s", "1/bloor-wilson?a=6&n1=5")) {
        if let Some(folder) = std::env::var_os("PASU_FILES") {
            std::fs::write(std::path::Path::new(&folder).join(format!("cup.{format}")), &bytes).unwrap();
        }
        assert!(bytes.len() > 1000, "{format}");
    }
}

#[test]
fn a_cup_of_step_is_as_far_off_as_it_says() {
    let (_, bytes) = &files(&notes("", "1/x"))[5];
    let text = std::str::from_utf8(bytes).unwrap();
    let (_, deviation) = text.split_once("'pasu-deviation: ").unwrap();
    let deviation: f64 = deviation.split(' ').next().unwrap().parse().unwrap();
    assert!(deviation > 0.0 && deviation <= 1e-3, "{deviation}");
    for (entity, count) in
        [("=PLANE(", 3), ("=ADVANCED_FACE(", 5), ("=EDGE_CURVE(", 6), ("=VERTEX_POINT(", 4), ("=CLOSED_SHELL(", 1)]
    {
        assert_eq!(text.matches(entity).count(), count, "{entity}");
    }
}

#[test]
fn a_section_has_the_area_of_the_clay() {
    let (_, bytes) = &files(&notes("", "1/x"))[6];
    let text = std::str::from_utf8(bytes).unwrap();
    let (_, path) = text.split_once("<path id=\"section-1\" d=\"").unwrap();
    let mut area = 0.0;
    for outline in path.split('"').next().unwrap().trim_end_matches('Z').split('Z') {
        let points: Vec<(f64, f64)> = outline
            .trim_start_matches('M')
            .split('L')
            .map(|point| point.split_once(' ').unwrap())
            .map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap()))
            .collect();
        for (i, (x, y)) in points.iter().enumerate() {
            let (next_x, next_y) = points[(i + 1) % points.len()];
            area += (x * next_y - next_x * y) / 2.0;
        }
    }
    assert!((area.abs() - (40.0 * 5.0 + 2.0 * 5.0 * 25.0)).abs() < 0.01, "{area}");
    let perimeter = 90.0 * 2.0 * 20.0 * libm::sin(PI / 90.0);
    assert!(text.contains(&format!("Rim unrolled, {perimeter:.1} once round")), "{perimeter}");
}

#[test]
fn what_is_cut_short_does_no_harm() {
    for (_, bytes) in files(&notes("Vase", "1/bloor-wilson?a=6")) {
        for length in (0..bytes.len()).step_by(1 + bytes.len() / 500).chain(0..bytes.len().min(300)) {
            let _ = provenance(&bytes[..length]);
        }
    }
}

#[test]
fn what_is_damaged_does_no_harm() {
    let files = files(&notes("Vase", "1/bloor-wilson?a=6"));
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    for (_, bytes) in files.iter().flat_map(|file| std::iter::repeat_n(file, 1000)) {
        let mut bytes = bytes.clone();
        for _ in 0..20 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // What is said of a package stands at its end, of anything else at its beginning.
            let place = (state >> 33) as usize % bytes.len().min(if state & 1 == 0 { 400 } else { usize::MAX });
            let at = if state & 2 == 0 { place } else { bytes.len() - 1 - place };
            bytes[at] = (state >> 20) as u8;
        }
        let _ = provenance(&bytes);
    }
}

proptest! {
    #[test]
    fn no_bytes_do_harm(bytes in prop::collection::vec(any::<u8>(), 0..400), kind in 0..8usize) {
        let starts: [&[u8]; 8] =
            [b"", b"PK\x03\x04", b"glTF", b"ply\n", b"# Pasu ", b"ISO-10303-21;", b"<?xml", b"PK\x03\x04PK\x05\x06"];
        let _ = provenance(&[starts[kind], &bytes].concat());
    }
}
