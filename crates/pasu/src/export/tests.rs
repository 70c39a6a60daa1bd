//! Files of bodies made by hand: awkward titles, long links, damage. What files of real designs hold is tested in `tests/library/export.rs`.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use proptest::prelude::*;

use super::contents::{Body, Notes};
use super::step::{Boundary, Part};
use super::template::{Frame, Paper, Stand};
use super::{glb, obj, obj_materials, open, ply, provenance, step, stl, template, three_mf, zip};
use crate::design::{Clay, Glaze, Look, Unit};
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
            positions: (&self.positions).into(),
            indices: (&self.indices).into(),
            faces: self.faces.clone(),
            coats: Vec::new(),
            plain: Vec::new(),
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
const MADE: Making =
    Making { product: Product::Pot, size: None, shrinkage: 5.0, tolerance: None, craft: None, union: false };

fn notes(title: &str, link: &str) -> Notes {
    Notes {
        title: title.into(),
        link: link.into(),
        fingerprint: "0123456789abcdef".into(),
        verdict: "passed with warnings: thinned".into(),
        millimetres: 10.0,
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
    let frame = Frame { origin: DVec3::ZERO, axis: DVec3::Z, across: DVec3::X };
    let stand = || [Stand::new(frame, faces.iter().map(|face| face as &dyn Face), 10.0)];
    let drawn = |paper| template::write(notes, &bodies, &stand(), paper).unwrap();
    vec![
        ("stl", stl::write(notes, &bodies)),
        ("3mf", three_mf::write(notes, &bodies)),
        ("glb", glb::write(notes, &bodies)),
        ("obj", obj::write(notes, &bodies)),
        ("obj.zip", obj::package(notes, &bodies)),
        ("ply", ply::write(notes, &bodies)),
        ("step", step::write(notes, &[part], 10.0).unwrap()),
        ("svg", drawn(None)),
        ("a4.svg", drawn(Some(Paper::A4))),
        ("letter.svg", drawn(Some(Paper::Letter))),
    ]
}

fn file(format: &str, notes: &Notes) -> Vec<u8> {
    files(notes).into_iter().find(|(name, _)| *name == format).map(|(_, bytes)| bytes).unwrap()
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
    let bytes = file("step", &notes("", "1/x"));
    let text = std::str::from_utf8(&bytes).unwrap();
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
    let bytes = file("svg", &notes("", "1/x"));
    let text = std::str::from_utf8(&bytes).unwrap();
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
    // 40 mm across, in centimetres.
    assert!(text.contains(&format!("Rim unrolled, {:.2} once round<", 4.0 * PI)));
    assert!(text.contains("lower edge 1.5 above the foot"), "half of the wall is below a strip of so short a cup");
}

/// The text of a layer.
fn layer<'a>(text: &'a str, id: &str) -> &'a str {
    let (_, rest) = text.split_once(&format!("<g id=\"{id}\" inkscape:groupmode=\"layer\" inkscape:label=\"")).unwrap();
    rest.split_once("\n</g>\n<g id=\"").or_else(|| rest.split_once("\n</g>\n</svg>")).unwrap().0
}

#[test]
fn a_template_has_layers() {
    let bytes = file("svg", &notes("Vase", "1/x"));
    let text = std::str::from_utf8(&bytes).unwrap();
    let [grid, outline, words] = ["grid", "outline", "text"].map(|id| layer(text, id));
    assert!(grid.contains("<line ") && !grid.contains("<path ") && !grid.contains("<text "));
    for id in ["section-1", "rim-1", "strip-1"] {
        assert!(outline.contains(&format!("id=\"{id}\"")), "{id}");
    }
    assert!(!outline.contains("<line ") && !outline.contains("<text "), "what is cut out is the clay alone");
    assert!(words.contains(">Vase</text>") && words.contains("id=\"bar\"") && words.contains(">10 cm</text>"));
    assert_eq!(text.matches("<text ").count(), words.matches("<text ").count());
    for told in [
        "As large as designed, which allows for 5 % shrinkage. Lengths in centimetres",
        ">3 top<",
        ">0.5 floor<",
        ">0 foot<",
        "farthest from the axis: 2<",
    ] {
        assert!(words.contains(told), "{told}");
    }
}

#[test]
fn templates_are_in_the_unit_of_the_design() {
    let made = |unit: Unit, millimetres: f64, shrinkage: f64| {
        let making = Making { shrinkage, ..MADE };
        String::from_utf8(file("svg", &Notes { unit, millimetres, making, ..notes("", "1/x") })).unwrap()
    };
    let told = |unit: Unit, millimetres: f64| made(unit, millimetres, 0.0);
    let inches = told(Unit::In, 25.4 * 1.000_000_000_1);
    for text in ["As large as designed. Lengths in inches", ">1.18 top<", ">4 in<"] {
        assert!(inches.contains(text), "{text}");
    }
    let millimetres = told(Unit::Mm, 1.0 / 0.88);
    for text in ["1.1364 times as large as designed. Lengths in millimetres", ">30 top<", ">100 mm<"] {
        assert!(millimetres.contains(text), "{text}");
    }
    // Nobody is to allow for the shrinkage of the clay once more.
    let shrinks = made(Unit::Cm, 10.0 / 0.88, 12.0);
    assert!(shrinks.contains("1.1364 times as large as designed, which allows for 12 % shrinkage. Lengths in"));
    for text in [inches, millimetres] {
        let words = text.split("<text ").skip(1).filter_map(|rest| rest.split('<').next()?.split_once('>'));
        for (_, word) in words.filter(|(_, word)| !word.contains("Pasu")) {
            for number in word.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|part| part.split_once('.'))
            {
                assert!(number.1.len() <= 4 && !number.1.ends_with('0'), "{word}");
            }
        }
    }
}

/// An outside 30 mm high whose rim rises and falls by `wave` mm `n` times, less sharply at the top by `flat`, and is wider than its foot of 20 mm by `flare`; in model units of 10 mm.
struct Lip {
    wave: f64,
    flat: f64,
    n: f64,
    flare: f64,
}

impl Sealed for Lip {}

impl Face for Lip {
    fn kind(&self) -> FaceKind {
        FaceKind::Outer
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        let out = DVec3::new(libm::cos(v), libm::sin(v), 0.0) / 10.0;
        let turn = self.n * (v - 1.0);
        let (radius, height) =
            (20.0 + a * self.flare, 30.0 + self.wave * (libm::cos(turn) - self.flat * libm::cos(2.0 * turn)));
        let position = radius * out + a * height * DVec3::Z / 10.0;
        FaceJet { position, da: self.flare * out + height * DVec3::Z / 10.0, dv: radius * DVec3::Z.cross(out) }
    }

    fn outward(&self) -> f64 {
        -1.0
    }
}

/// The template of a cup under such a rim.
fn under(lip: &Lip) -> String {
    let cup = cup();
    let frame = Frame { origin: DVec3::ZERO, axis: DVec3::Z, across: DVec3::X };
    let stand = Stand::new(frame, std::iter::once(lip as &dyn Face), 10.0);
    String::from_utf8(template::write(&notes("", "1/x"), &[cup.body()], &[stand], None).unwrap()).unwrap()
}

#[test]
fn sections_are_where_the_rim_is_highest_and_lowest() {
    let ids = |text: &str| ["section-1", "section-1-lowest"].map(|id| text.matches(&format!("id=\"{id}\"")).count());
    let level = under(&Lip { wave: 0.04, flat: 0.0, n: 2.0, flare: 0.0 });
    assert_eq!(
        (ids(&level), level.matches("Section through").count()),
        ([1, 0], 0),
        "nobody sees that it is not level"
    );
    let sloping = under(&Lip { wave: 3.0, flat: 0.0, n: 1.0, flare: 0.0 });
    assert_eq!(ids(&sloping), [1, 0]);
    // Of the two lines over a rim that is level one is where it is cut.
    assert_eq!([&level, &sloping].map(|text| text.matches(">section<").count()), [1, 0]);
    for told in
        ["Section through the rim's highest and lowest points", ">highest<", ">lowest<", ">2.7 rim at its lowest<"]
    {
        assert!(sloping.contains(told), "{told}");
    }
    let lobed = under(&Lip { wave: 3.0, flat: 0.0, n: 2.0, flare: 0.0 });
    assert_eq!(ids(&lobed), [1, 1]);
    for told in
        ["Section through the rim's highest point<", "Section through the rim's lowest point<", ">highest<", ">lowest<"]
    {
        assert!(lobed.contains(told), "{told}");
    }
    // The planes as they are seen from above: at 1, where the rim is highest, and a quarter turn from it.
    let dashed: Vec<[f64; 4]> = lobed
        .split("<line ")
        .filter(|line| line.contains("dasharray"))
        .map(|line| {
            ["x1=\"", "y1=\"", "x2=\"", "y2=\""]
                .map(|key| line.split_once(key).unwrap().1.split('"').next().unwrap().parse().unwrap())
        })
        .filter(|[x1, _, x2, _]| x1 != x2)
        .collect();
    let slopes: Vec<f64> = dashed.iter().map(|[x1, y1, x2, y2]| (y1 - y2) / (x2 - x1)).collect();
    let tangent = libm::tan(1.0);
    assert!(
        slopes.len() == 2 && (slopes[0] - tangent).abs() < 0.02 && (slopes[1] + 1.0 / tangent).abs() < 0.02,
        "{slopes:?}"
    );
}

/// The texts of a template, each with its left end, its base and about how wide it is.
fn texts(svg: &str) -> Vec<(f64, f64, f64, String)> {
    let attribute =
        |text: &str, name: &str| text.split_once(name)?.1.split_once('"').map(|(value, _)| value.to_owned());
    let of = |text: &str| {
        let number = |name: &str| attribute(text, name)?.parse::<f64>().ok();
        let (_, word) = text.split_once('<')?.0.split_once('>')?;
        let width = 0.5 * number("font-size=\"")? * word.chars().count() as f64;
        let before = match attribute(text, "text-anchor=\"")?.as_str() {
            "start" => 0.0,
            "middle" => 0.5 * width,
            _ => width,
        };
        Some((number("x=\"")? - before, number("y=\"")?, width, word.to_owned()))
    };
    svg.split("<text ").skip(1).filter_map(of).collect()
}

#[test]
fn no_text_of_a_rim_lies_on_another() {
    for (wave, n, flare) in [
        (3.0, 1.0, 0.0),
        (3.0, 2.0, 0.0),
        (3.0, 3.0, 0.0),
        (3.0, 2.0, -19.0),
        (3.0, 1.0, -19.9),
        (3.0, 3.0, 15.0),
        (0.0, 2.0, 0.0),
        (0.0, 2.0, -19.0),
    ] {
        let svg = under(&Lip { wave, flat: 0.1 * f64::from(wave > 0.0), n, flare });
        let all = texts(&svg);
        let there = if wave > 0.0 { "highest" } else { "section" };
        assert!(all.iter().any(|(.., word)| word == there), "{wave} {n} {flare}");
        for (index, (x, y, width, word)) in all.iter().enumerate() {
            for (other_x, other_y, other_width, other) in &all[..index] {
                let is_over = (y - other_y).abs() < 2.2 && x < &(other_x + other_width) && other_x < &(x + width);
                assert!(!is_over, "{n} {flare}: {word} on {other}");
            }
        }
    }
}

#[test]
fn a_rim_that_is_almost_flat_at_its_top_is_cut_through_it() {
    // Level to the micrometre for some degrees to either side.
    let text = under(&Lip { wave: 3.0, flat: 0.2499, n: 1.0, flare: 0.0 });
    assert!(text.contains("Section through the rim's highest and lowest points") && !text.contains("section-1-lowest"));
}

#[test]
fn a_strip_fits_a_body_that_is_narrower_than_its_rim() {
    let text = under(&Lip { wave: 0.0, flat: 0.0, n: 1.0, flare: 10.0 });
    // Half way up, where the radius is 25 mm.
    let told = format!("Rim unrolled, {:.2} once round at its lower edge and {:.2} along the rim", 5.0 * PI, 6.0 * PI);
    for told in [&told, "Lay the strip round the pot with its lower edge 1.5 above the foot"] {
        assert!(text.contains(told), "{told}");
    }
    let (_, path) = text.split_once("<path id=\"strip-1\" d=\"M").unwrap();
    let points: Vec<(f64, f64)> = path
        .split('Z')
        .next()
        .unwrap()
        .split('L')
        .map(|point| point.split_once(' ').unwrap())
        .map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap()))
        .collect();
    // The mantle of the cone between them, whose area is that of a trapezium bent round.
    let twice: f64 = points.iter().zip(points.iter().cycle().skip(1)).map(|((x, y), (u, v))| x * v - u * y).sum();
    let mantle = PI * (30.0 + 25.0) * libm::hypot(5.0, 15.0);
    assert!((twice.abs() / 2.0 - mantle).abs() < 1e-3 * mantle, "{} {mantle}", twice / 2.0);
    let lowest = points.iter().map(|(_, y)| *y).fold(f64::MIN, f64::max);
    assert!(points.iter().filter(|(_, y)| lowest - y < 0.5).count() < 200, "bent, and not straight");
}

#[test]
fn a_template_on_sheets_shows_all_of_it() {
    for (format, width, height, pitch) in [("a4.svg", 210.0, 297.0, 297.127), ("letter.svg", 215.9, 279.4, 279.4)] {
        let bytes = file(format, &notes("Vase & <pot>", "1/x"));
        let text = std::str::from_utf8(&bytes).unwrap();
        let n_sheets = text.matches("<inkscape:page ").count();
        assert!(n_sheets >= 1, "{format}");
        assert!(text.contains(&format!("@page{{size:{width}mm {height}mm;margin:0}}")));
        let (_, rest) = text.split_once(" height=\"").unwrap();
        let tall: f64 = rest.split("mm").next().unwrap().parse().unwrap();
        assert!((tall - pitch * n_sheets as f64).abs() < 1e-3 * n_sheets as f64, "{format} {tall}");
        for id in ["grid", "outline", "text"] {
            let drawn = layer(text, id);
            assert_eq!(drawn.matches(&format!("href=\"#whole-{id}\"")).count(), n_sheets, "{format} {id}");
        }
        assert_eq!(layer(text, "text").matches("href=\"#marks\"").count(), n_sheets);
        assert!(text.contains(&format!("Sheet {n_sheets} of {n_sheets}, ")));
        assert_eq!(text.matches("; lay cross on cross: Vase &amp; &lt;pot&gt;</text>").count(), n_sheets);
        // The drawing itself is that of the template on one page.
        let whole = file("svg", &notes("Vase & <pot>", "1/x"));
        let whole = std::str::from_utf8(&whole).unwrap();
        assert!(text.contains(layer(whole, "outline").split_once("\n").unwrap().1));
    }
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

#[test]
fn colours_are_those_of_clay_and_glaze() {
    let cup = cup();
    let bodies = [cup.body(), Body { look: Look::new(Glaze::Cobalt, Clay::Porcelain), ..cup.body() }];
    let text = String::from_utf8(obj::write(&notes("", "1/x"), &bodies)).unwrap();
    let library = obj_materials();
    let named: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("usemtl ")).collect();
    assert_eq!(named, ["celadon_on_stoneware", "cobalt_on_porcelain"]);
    assert_eq!(text.matches("mtllib pasu.mtl\n").count(), 1);
    let colours: Vec<[u8; 3]> = named
        .iter()
        .map(|name| {
            let (_, rest) = library.split_once(&format!("newmtl {name}\nKd ")).unwrap();
            let numbers: Vec<f64> = rest.lines().next().unwrap().split(' ').map(|x| x.parse().unwrap()).collect();
            [0, 1, 2].map(|i| libm::round(255.0 * numbers[i]) as u8)
        })
        .collect();
    assert_ne!(colours[0], colours[1]);
    assert!(colours[1][2] > 2 * colours[1][0], "cobalt is blue: {colours:?}");
    // Every name once, all of them words.
    let names: BTreeSet<&str> = library.lines().filter_map(|line| line.strip_prefix("newmtl ")).collect();
    assert_eq!((names.len(), library.matches("newmtl ").count()), (32, 32));
    assert!(names.iter().all(|name| !name.contains(char::is_whitespace)));

    let bytes = ply::write(&notes("", "1/x"), &bodies);
    let end = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    assert!(
        header
            .contains("property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face")
    );
    let n = cup.positions.len() / 3;
    for vertex in 0..2 * n {
        assert_eq!(bytes[end + 15 * vertex + 12..][..3], colours[vertex / n], "{vertex}");
    }

    // Both are in the package, and the bodies are the same.
    let package = obj::package(&notes("", "1/x"), &bodies);
    assert_eq!(zip::beginning_of(&package, "pasu.obj", usize::MAX >> 1).unwrap(), text.into_bytes());
    assert_eq!(zip::beginning_of(&package, "pasu.mtl", usize::MAX >> 1).unwrap(), library.into_bytes());
}

proptest! {
    #[test]
    fn no_bytes_do_harm(bytes in prop::collection::vec(any::<u8>(), 0..400), kind in 0..8usize) {
        let starts: [&[u8]; 8] =
            [b"", b"PK\x03\x04", b"glTF", b"ply\n", b"# Pasu ", b"ISO-10303-21;", b"<?xml", b"PK\x03\x04PK\x05\x06"];
        let _ = provenance(&[starts[kind], &bytes].concat());
    }
}
