//! Colours of one's own, a glaze for the inside and a glaze line: how documents and links write them, what is refused, and what files have of them.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use serde_json::Value;

use pasu::{Design, Format, Making, solid, write};

const CUP: &str = r#"{ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 }"#;

fn with_look(look: &str) -> String {
    format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {CUP}, "wall": {{ "thickness": 0.5, "base": 1 }}, "look": {look} }}] }}"#
    )
}

fn cup(look: &str) -> Design {
    Design::parse(&with_look(look)).unwrap()
}

fn written(look: &str) -> String {
    let design = cup(look);
    assert_eq!(Design::parse(&design.link()).as_ref(), Ok(&design), "{look}");
    let json = design.to_json();
    json.split_once(r#""look":"#).map_or_else(String::new, |(_, look)| look.trim_end_matches("}]}").to_owned())
}

#[test]
fn a_look_is_written_in_one_way() {
    assert_eq!(
        written(r##"{ "clay": "#AA5533", "line": 0.25, "inside": "#F0f0F0", "glaze": "#1f3F8f" }"##),
        r##"{"glaze":"#1f3f8f","inside":"#f0f0f0","line":0.25,"clay":"#aa5533"}"##
    );
    // Inside as outside, which may be left out: whichever way the outside is said.
    assert_eq!(written(r#"{ "inside": "celadon" }"#), "");
    assert_eq!(written(r##"{ "glaze": "#ABCDEF", "inside": "#abcdef" }"##), r##"{"glaze":"#abcdef""##.to_owned() + "}");
    // What is not there ends nowhere.
    assert_eq!(
        written(r#"{ "glaze": "bare", "inside": "clear", "line": 0.5 }"#),
        r#"{"glaze":"bare","inside":"clear"}"#
    );
    assert_eq!(written(r#"{ "line": 0 }"#), "");
    assert_eq!(written(r#"{ "line": 0.3333333333333333 }"#), r#"{"line":0.333333333333}"#);
}

#[test]
fn a_link_has_colours_without_their_sign() {
    let link = "1/second-order?glaze=1f3f8f&inside=tin-white&line=.25&clay=aa5533";
    let design = Design::parse(link).unwrap();
    assert_eq!(design.link(), link);
    assert_eq!(Design::parse("1/second-order?clay=AA5533&line=.250&inside=tin-white&glaze=1F3F8F"), Ok(design.clone()));
    assert!(
        design.to_json().contains(r##""look":{"glaze":"#1f3f8f","inside":"tin-white","line":0.25,"clay":"#aa5533"}"##)
    );
}

#[test]
fn what_is_no_colour_is_refused_where_it_stands() {
    let names = r##""celadon", "tenmoku", "cobalt", "tin-white", "shino", "copper-red", "clear", "bare" or "#rrggbb""##;
    for (look, code, path, message) in [
        (r##"{ "glaze": "#12345" }"##, "unknown-name", "glaze", format!(r##"expected {names}, found "#12345""##)),
        (r##"{ "inside": "#1234567" }"##, "unknown-name", "inside", format!(r##"expected {names}, found "#1234567""##)),
        (r##"{ "inside": "#12345é" }"##, "unknown-name", "inside", format!(r##"expected {names}, found "#12345é""##)),
        (
            r#"{ "clay": "celadon" }"#,
            "unknown-name",
            "clay",
            r##"expected "stoneware", "porcelain", "terracotta", "black" or "#rrggbb", found "celadon""##.into(),
        ),
        (r#"{ "glaze": 7 }"#, "wrong-type", "glaze", format!("expected {names}, found 7")),
        (r#"{ "line": 1.5 }"#, "out-of-range", "line", "expected a number from 0 to 1, found 1.5".into()),
        (r#"{ "line": -0.1 }"#, "out-of-range", "line", "expected a number from 0 to 1, found -0.1".into()),
    ] {
        let error = Design::parse(&with_look(look)).unwrap_err();
        let path = format!("parts[0].look.{path}");
        assert_eq!((error.code().as_str(), error.path(), error.message()), (code, path.as_str(), message.as_str()));
    }
    let error = Design::parse(&with_look(r#"{ "line": 1.5 }"#)).unwrap_err();
    let told: Vec<&str> = error.args().iter().map(|(name, _)| *name).collect();
    assert_eq!(told, ["found", "least", "greatest"]);
}

/// Blue outside, red inside, white clay: the glaze ends half way up.
const THREE: &str = r##"{ "glaze": "#0000ff", "inside": "#ff0000", "line": 0.5, "clay": "#ffffff" }"##;

/// A triangle of a PLY in which each has a colour of its own.
struct Painted {
    corners: [DVec3; 3],
    colour: &'static str,
}

fn painted(bytes: &[u8]) -> Vec<Painted> {
    let end = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    let count = |element: &str| -> usize {
        let line = header.lines().find_map(|line| line.strip_prefix(&format!("element {element} "))).unwrap();
        line.parse().unwrap()
    };
    let float = |at: usize| f64::from(f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()));
    let vertex = |index: u32| DVec3::from_array([0, 4, 8].map(|axis| float(end + 15 * index as usize + axis)));
    let faces = end + 15 * count("vertex");
    assert_eq!(bytes.len(), faces + 16 * count("face"));
    let triangles = bytes[faces..].chunks_exact(16).map(|face| Painted {
        corners: [1, 5, 9].map(|at| vertex(u32::from_le_bytes(face[at..at + 4].try_into().unwrap()))),
        colour: match [13, 14, 15].map(|channel| face[channel] > 150) {
            [true, true, true] => "clay",
            [true, false, false] => "red",
            [false, false, true] => "blue",
            other => panic!("{other:?}"),
        },
    });
    triangles.collect()
}

/// Six times the volume that triangles enclose.
fn volume(triangles: impl Iterator<Item = [DVec3; 3]>) -> f64 {
    triangles.map(|[a, b, c]| a.dot(b.cross(c))).sum()
}

#[test]
fn files_have_the_glaze_line_where_it_is() {
    let making = Making { tolerance: Some(0.005), ..Making::default() };
    let design = cup(THREE);
    let bytes = write(&design, Format::Ply, &making).unwrap();
    let triangles = painted(&bytes);
    let of = |colour: &str| {
        let own = triangles.iter().filter(|triangle| triangle.colour == colour);
        own.fold((f64::INFINITY, f64::NEG_INFINITY, 0.0), |(low, high, area), Painted { corners: [a, b, c], .. }| {
            let heights = [a.z, b.z, c.z];
            let own = (b - a).cross(c - a).length() / 2.0;
            (heights.into_iter().fold(low, f64::min), heights.into_iter().fold(high, f64::max), area + own)
        })
    };
    // A cup 40 mm high: blue down to 20 mm, the clay bare below it and under the base, red from the rim to the floor.
    let (low, high, area) = of("blue");
    assert_eq!((low, high), (20.0, 40.0));
    let rim = PI * (30.0 * 30.0 - 25.0 * 25.0);
    assert!((area / (TAU * 30.0 * 20.0 + rim) - 1.0).abs() < 1e-2, "{area}");
    assert_eq!((of("clay").0, of("clay").1), (0.0, 20.0));
    assert_eq!((of("red").0, of("red").1), (10.0, 40.0));

    // It is the same body, and what was divided is closed as before.
    let [plain] = <[_; 1]>::try_from(solid(&cup("{}"), &making).unwrap()).unwrap();
    let corner =
        |vertex: u32| DVec3::from_array([0, 1, 2].map(|axis| f64::from(plain.positions[3 * vertex as usize + axis])));
    let whole = volume(plain.indices.chunks_exact(3).map(|t| [corner(t[0]), corner(t[1]), corner(t[2])]));
    assert!((volume(triangles.iter().map(|triangle| triangle.corners)) / whole - 1.0).abs() < 1e-6);
    assert!(triangles.len() > plain.n_triangles());
    assert_eq!(pasu::open(&bytes), Some(design.link()));
}

/// A wavy pot whose outside the line runs through in every way that a triangle can be divided.
#[test]
fn triangles_of_a_wavy_pot_are_divided_along_the_line() {
    let look = THREE.replace("0.5", "0.37");
    let design = Design::parse(&format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "bloor-wilson", "a": 6, "r": [1, 0.1, 0.1, 0.8], "R": [-3, -0.5, -0.5, 2], "h": [3, 0.3],
            "H": [-0.5, -0.7], "n1": 5 }}, "place": {{ "scale": [3, 3, 3], "axis": [1, 0, 0], "angle": 0.3 }}, "wall": {{ "thickness": 0.2, "base": 0.3 }}, "look": {look} }}] }}"#
    ))
    .unwrap();
    let making = Making { tolerance: Some(0.02), ..Making::default() };
    let triangles = painted(&write(&design, Format::Ply, &making).unwrap());
    let heights = |colour: &str| {
        let own = triangles.iter().filter(|triangle| triangle.colour == colour).flat_map(|triangle| triangle.corners);
        own.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.z), high.max(p.z)))
    };
    let (line, top) = heights("blue");
    // What is bare ends where the glaze begins, and that is where it was asked for.
    assert_eq!(heights("clay").1, line);
    let foot = heights("clay").0;
    assert!(foot < line && line < top);
    // Every edge is that of two triangles, which pass it in opposite directions.
    let bits = |p: DVec3| p.to_array().map(f64::to_bits);
    let mut edges: BTreeMap<[[u64; 3]; 2], i32> = BTreeMap::new();
    for Painted { corners: [a, b, c], .. } in &triangles {
        for (from, to) in [(a, b), (b, c), (c, a)].map(|(from, to)| (bits(*from), bits(*to))) {
            *edges.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
    }
    assert!(edges.values().all(|sum| *sum == 0));
}

#[test]
fn every_format_with_colours_has_all_three() {
    let making = Making { tolerance: Some(0.02), ..Making::default() };
    let design = cup(THREE);
    let glb = write(&design, Format::Glb, &making).unwrap();
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let json: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    let names: Vec<&str> = json["materials"].as_array().unwrap().iter().map(|m| m["name"].as_str().unwrap()).collect();
    assert_eq!(names.len(), 3);
    for name in ["#0000ff on #ffffff", "#ff0000 on #ffffff", "#ffffff"] {
        assert!(names.contains(&name), "{names:?}");
    }
    let primitives = json["meshes"][0]["primitives"].as_array().unwrap();
    assert_eq!(primitives.len(), 3);
    assert!(primitives.iter().all(|one| one["attributes"] == primitives[0]["attributes"]));

    let text = String::from_utf8(write(&design, Format::Obj, &making).unwrap()).unwrap();
    for name in ["0000ff_on_ffffff", "ff0000_on_ffffff", "ffffff"] {
        assert!(text.contains(&format!("\nusemtl {name}\n")), "{name}");
    }
    // STL and the template have no colours, and the mesh as it was checked.
    assert_eq!(
        write(&design, Format::Stl, &making).unwrap().len(),
        write(&cup("{}"), Format::Stl, &making).unwrap().len()
    );
}

#[test]
fn step_has_the_colours_of_its_faces() {
    let making = Making { tolerance: Some(0.02), ..Making::default() };
    let of = |look: &str| String::from_utf8(write(&cup(look), Format::Step, &making).unwrap()).unwrap();
    let entity =
        |text: &str, id: &str| text.split(&format!("\n{id}=")).nth(1).unwrap().split(';').next().unwrap().to_owned();
    // The colour of a style, by the chain of entities that leads to it.
    let colour = |text: &str, style: &str| {
        let mut id = style.to_owned();
        loop {
            let found = entity(text, &id);
            if let Some(channels) = found.strip_prefix("COLOUR_RGB('',") {
                return channels.trim_end_matches(')').to_owned();
            }
            id = format!("#{}", found.rsplit('#').next().unwrap().trim_end_matches(')'));
        }
    };
    let text = of(THREE);
    let items = text.lines().filter(|line| line.contains("=OVER_RIDING_STYLED_ITEM("));
    let mut faces: Vec<(String, String)> = items
        .map(|line| {
            let mut ids = line.split('#').skip(2).map(|rest| format!("#{}", rest.split([',', ')']).next().unwrap()));
            let (style, face) = (ids.next().unwrap(), ids.next().unwrap());
            let kind = entity(&text, &face).split('\'').nth(1).unwrap().to_owned();
            (kind, colour(&text, &style))
        })
        .collect();
    faces.sort();
    faces.dedup();
    // What is round is several faces of STEP, of one colour.
    let (red, clay) = ("1.,0.,0.".to_owned(), "1.,1.,1.".to_owned());
    let expected = [("Floor", &red), ("Lining", &red), ("Underside", &clay)];
    assert_eq!(faces, expected.map(|(kind, colour)| (kind.to_owned(), colour.clone())));
    let whole = text.lines().find(|line| line.contains("=STYLED_ITEM(")).unwrap();
    let style = format!("#{}", whole.split('#').nth(2).unwrap().trim_end_matches([')', ',']));
    assert_eq!(colour(&text, style.split(')').next().unwrap()), "0.,0.,1.");
    // Where all is of one look nothing is said of its faces.
    assert!(!of("{}").contains("OVER_RIDING"));
}

/// A look that is the same everywhere changes no byte of a file but what the file says of itself: the goldens hold that.
#[test]
fn the_inside_alone_divides_nothing() {
    let making = Making { tolerance: Some(0.02), ..Making::default() };
    let of = |look: &str| write(&cup(look), Format::Obj, &making).unwrap();
    let vertices = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap().matches("\nv ").count();
    let [plain, inside] = [of("{}"), of(r#"{ "inside": "tin-white" }"#)];
    assert_eq!(vertices(&plain), vertices(&inside));
    let text = String::from_utf8(inside).unwrap();
    assert_eq!(text.matches("usemtl tin-white_on_stoneware").count(), 1);
    // The underside stays as it was.
    assert!(!text.contains("usemtl stoneware"));
}
