//! What a maker can make: walls that are too thin and walls that hang over, by the way in which the pot is made.

use glam::DVec3;

use super::craft::Craft;
use super::made::Finished;
use super::report::{Finding, Severity};
use crate::error::Args;
use crate::face::FaceKind;
use crate::measure::{hull, lean, least_width};
use crate::solid::{place, short};

/// The degrees that a wall may lean out over what is below it and be printed without support.
const SUPPORTED: f64 = 45.0;

/// The millimetres of a layer: what is no higher above the ground lies on it.
const LAYER: f64 = 0.2;

/// What leans out further is told where it is at least this part of its face.
const SHARE: f64 = 1e-3;

/// What stands in the way of making one part by a craft; `millimetres` is how many a model unit has. Where no craft is asked for it is that of a printer, and nothing is worse than a warning: not everything that is written is to be
/// printed.
pub(super) fn findings(made: &Finished, craft: Option<Craft>, millimetres: f64) -> Vec<Finding> {
    let by = craft.unwrap_or(Craft::Print);
    let mut found = Vec::new();
    found.extend(too_thin(made, by, craft.is_some(), millimetres));
    found.extend(too_thin_base(made, by, craft.is_some(), millimetres));
    if by == Craft::Print {
        let faces = [(FaceKind::Outer, "outside"), (FaceKind::Lining, "inside")];
        found.extend(faces.into_iter().filter_map(|(kind, side)| overhang(made, kind, side, millimetres)));
        found.extend(
            [FaceKind::Recess, FaceKind::Underside].into_iter().filter_map(|kind| ceiling(made, kind, millimetres)),
        );
    }
    found
}

fn too_thin(made: &Finished, craft: Craft, is_asked: bool, millimetres: f64) -> Option<Finding> {
    let of_pot = made.pot.as_ref().filter(|pot| pot.has_wall());
    let of_pot = of_pot.map(|pot| (pot.thickness().0, pot.thinned().map(|(_, at)| at)));
    let (thinnest, at) = of_pot.or(made.thinnest.map(|(thick, at)| (thick, Some(at))))?;
    let thinnest = thinnest * millimetres;
    let [least, safe] = craft.thinnest();
    if !(thinnest < safe) {
        return None;
    }
    let somewhere = at.map_or(String::new(), |at| format!(" at {}", place(at)));
    let why = match (craft, thinnest < least) {
        (Craft::Print, true) => {
            format!("a line of the usual nozzle is {least} mm wide, and what is thinner is not printed")
        }
        (Craft::Print, false) => format!("two lines of the usual nozzle are {safe} mm wide, and one breaks"),
        (Craft::Clay, true) => format!("clay of less than {least} mm does not stand"),
        (Craft::Clay, false) => format!("clay of less than {safe} mm warps and breaks"),
    };
    let severity = severity(is_asked && thinnest < least);
    let message = format!("the wall is only {} mm thick{somewhere}: {why}", short(thinnest));
    let (part, path) = (made.mesh.part, path(made, "wall.thickness"));
    let args = thin_args(craft, thinnest, [least, safe]);
    let at = at.map(|at| at.to_array());
    Some(Finding { code: "too-thin", severity, part, path, message, args, at, remedy: None })
}

fn too_thin_base(made: &Finished, craft: Craft, is_asked: bool, millimetres: f64) -> Option<Finding> {
    let thickness = made.pot.as_ref()?.base()? * millimetres;
    let [least, safe] = craft.thinnest_base();
    if !(thickness < safe) {
        return None;
    }
    let why = match (craft, thickness < least) {
        (Craft::Print, true) => format!("a layer is usually {least} mm, and what is thinner is not printed"),
        (Craft::Print, false) => format!("three layers are usually {safe} mm, and fewer leak and break"),
        (Craft::Clay, true) => format!("clay of less than {least} mm does not hold"),
        (Craft::Clay, false) => format!("clay of less than {safe} mm warps and breaks"),
    };
    let severity = severity(is_asked && thickness < least);
    let message = format!("the base is only {} mm thick: {why}", short(thickness));
    let (part, path) = (made.mesh.part, path(made, "wall.base"));
    let args = thin_args(craft, thickness, [least, safe]);
    Some(Finding { code: "thin-base", severity, part, path, message, args, at: None, remedy: None })
}

/// What is named of something too thin: what there can be at all, what holds, and of which of the two there is less.
fn thin_args(craft: Craft, thickness: f64, [least, safe]: [f64; 2]) -> Args {
    let what = match (craft, thickness < least) {
        (Craft::Print, true) => "not-printed",
        (Craft::Print, false) => "breaks-printed",
        (Craft::Clay, true) => "no-clay",
        (Craft::Clay, false) => "breaks-fired",
    };
    let lengths = [("thicknessMm", thickness), ("leastMm", least), ("safeMm", safe)];
    lengths.into_iter().map(|(name, length)| (name, length.into())).chain([("what", what.into())]).collect()
}

fn path(made: &Finished, field: &str) -> Option<String> {
    Some(made.path(field))
}

fn severity(is_impossible: bool) -> Severity {
    if is_impossible { Severity::Error } else { Severity::Warning }
}

/// The corners of the triangles of one kind of face, in millimetres.
fn triangles(made: &Finished, kind: FaceKind) -> impl Iterator<Item = [DVec3; 3]> + '_ {
    let mesh = &made.mesh;
    let point = |vertex: u32| {
        let from = 3 * vertex as usize;
        DVec3::from_array([0, 1, 2].map(|axis| f64::from(mesh.positions[from + axis])))
    };
    let faces = mesh.faces.iter().filter(move |(of, ..)| *of == kind);
    let indices = faces.flat_map(|&(_, first, count)| &mesh.indices[first as usize..(first + count) as usize]);
    let mut corners = indices.map(move |&vertex| point(vertex));
    core::iter::from_fn(move || Some([corners.next()?, corners.next()?, corners.next()?]))
}

/// Twice the area of a triangle, and by how many degrees it leans out.
fn sized_lean([a, b, c]: [DVec3; 3]) -> (f64, f64) {
    let normal = (b - a).cross(c - a);
    (normal.length(), lean(normal).to_degrees())
}

/// The steepest of the triangles of one kind of face that lean out further than can be printed.
fn overhang(made: &Finished, kind: FaceKind, side: &str, millimetres: f64) -> Option<Finding> {
    let (mut area, mut hanging, mut steepest) = (0.0, 0.0, (SUPPORTED, DVec3::ZERO));
    for corners in triangles(made, kind) {
        let (size, degrees) = sized_lean(corners);
        area += size;
        if degrees > SUPPORTED {
            hanging += size;
            if degrees > steepest.0 {
                steepest = (degrees, corners.into_iter().sum::<DVec3>() / (3.0 * millimetres));
            }
        }
    }
    if !(hanging > SHARE * area) {
        return None;
    }
    let (degrees, at) = steepest;
    let message = format!(
        "the {side} hangs over by {} degrees at {}: printers need support beyond {SUPPORTED} degrees",
        libm::round(degrees),
        place(at)
    );
    let args = Args::from([("what", side.into()), ("degrees", degrees.into()), ("greatest", SUPPORTED.into())]);
    let (part, severity, at) = (made.mesh.part, Severity::Note, Some(at.to_array()));
    Some(Finding { code: "overhang", severity, part, path: path(made, "shape"), message, args, at, remedy: None })
}

/// What is built over air beneath a pot: the base within a foot ring, from one side of the ring to the other, and the underside of a pot that is tilted.
fn ceiling(made: &Finished, kind: FaceKind, millimetres: f64) -> Option<Finding> {
    let ground = made.mesh.positions.iter().skip(2).step_by(3).fold(f32::INFINITY, |least, z| least.min(*z));
    let ground = f64::from(ground);
    let is_over_air = |corners: &[DVec3; 3]| {
        sized_lean(*corners).1 > SUPPORTED && corners.iter().any(|corner| corner.z > ground + LAYER)
    };
    let corners: Vec<DVec3> = triangles(made, kind).filter(is_over_air).flatten().collect();
    let highest = corners.iter().copied().reduce(|one, other| if other.z > one.z { other } else { one })?;
    let height = highest.z - ground;
    let above = short(height);
    let mut args = Args::from([("heightMm", height.into())]);
    let (message, at, field) = if kind == FaceKind::Recess {
        let outline = hull(&corners.iter().map(|corner| corner.truncate()).collect::<Vec<_>>());
        let width = least_width(&outline);
        let wide = short(width);
        args.extend([("what", "within-ring".into()), ("widthMm", width.into())]);
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let message = format!(
            "the base within the foot ring is a ceiling, {wide} mm wide and {above} mm above the ground: printers bridge it or need support"
        );
        (message, middle, "wall.foot")
    } else {
        let message = format!("the underside is up to {above} mm above the ground: printers need support beneath it");
        args.extend([("what", "underside".into())]);
        (message, highest, "place")
    };
    let (part, severity, at) = (made.mesh.part, Severity::Note, Some((at / millimetres).to_array()));
    Some(Finding { code: "ceiling", severity, part, path: path(made, field), message, args, at, remedy: None })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::make::{Making, check};

    /// What is said of a cup of radius 30 mm and height 40 mm, whose rim is wider by `flare` millimetres.
    fn said(thickness: f64, base: f64, flare: f64, craft: Option<Craft>) -> Vec<(&'static str, Severity, String)> {
        let rim = 3.0 + flare / 10.0;
        let document = serde_json::json!({ "pasu": 1, "parts": [{
            "shape": { "kind": "second-order", "r": [rim, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
            "wall": { "thickness": thickness / 10.0, "base": base / 10.0 }
        }] });
        let design = Design::parse(&document.to_string()).unwrap();
        let report = check(&design, &Making { craft, ..Making::default() }).unwrap();
        report.findings.into_iter().map(|found| (found.code, found.severity, found.message)).collect()
    }

    #[test]
    fn walls_and_bases_are_held_against_both_thresholds_of_a_craft() {
        use Severity::{Error, Warning};
        // By craft: what there can be at all and what holds, for the wall and for the base.
        for (craft, [[wall, firm], [base, sound]]) in
            [(Craft::Print, [[0.4, 0.8], [0.2, 0.6]]), (Craft::Clay, [[1.0, 2.0], [1.0, 2.0]])]
        {
            for (thickness, bottom, expected) in [
                (firm + 1e-6, sound + 1e-6, None),
                (firm - 1e-6, 5.0, Some(("wall", Warning))),
                (wall + 1e-6, 5.0, Some(("wall", Warning))),
                (wall - 1e-6, 5.0, Some(("wall", Error))),
                (5.0, sound - 1e-6, Some(("base", Warning))),
                (5.0, base + 1e-6, Some(("base", Warning))),
                (5.0, base - 1e-6, Some(("base", Error))),
            ] {
                let found = said(thickness, bottom, 0.0, Some(craft));
                let told = found.iter().map(|(code, severity, message)| {
                    assert!(
                        message.starts_with(if *code == "too-thin" { "the wall" } else { "the base" }),
                        "{message}"
                    );
                    (if *code == "too-thin" { "wall" } else { "base" }, *severity)
                });
                assert_eq!(
                    told.collect::<Vec<_>>(),
                    expected.into_iter().collect::<Vec<_>>(),
                    "{craft:?} {thickness} {bottom}"
                );
            }
        }
    }

    #[test]
    fn what_is_not_to_be_printed_is_only_warned_of() {
        let found = said(0.3, 0.1, 0.0, None);
        assert!(found.len() == 2 && found.iter().all(|found| found.1 == Severity::Warning), "{found:?}");
    }

    #[test]
    fn a_tube_has_no_base_to_be_too_thin() {
        assert_eq!(said(5.0, 0.0, 0.0, Some(Craft::Print)), []);
    }

    /// What is said of what a pot of height 40 mm is built over, whose foot is an ellipse of radii `x` and `y` in centimetres.
    fn ceilings(
        [x, y]: [f64; 2],
        wall: &serde_json::Value,
        place: &serde_json::Value,
        making: &Making,
    ) -> Vec<Finding> {
        let document = serde_json::json!({ "pasu": 1, "parts": [{
            "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
            "wall": wall, "place": { "scale": [x / 3.0, y / 3.0, 1], "axis": place["axis"], "angle": place["angle"] },
        }] });
        let design = Design::parse(&document.to_string()).unwrap();
        let report = check(&design, making).unwrap();
        report.findings.into_iter().filter(|found| found.code == "ceiling").collect()
    }

    fn upright() -> serde_json::Value {
        serde_json::json!({ "axis": [0, 0, 1], "angle": 0 })
    }

    /// How wide a ceiling is said to be and how high, in millimetres; the corners of its mesh lie on the ring, so that they are a little nearer to each other than the ring is wide.
    fn ceiling_sizes(found: &Finding) -> [f64; 2] {
        let numbers = |word: &str| word.parse::<f64>().ok();
        let said: Vec<f64> = found.message.split(' ').filter_map(numbers).collect();
        let [wide, above] = said[..] else { panic!("{}", found.message) };
        [wide, above]
    }

    fn assert_said(found: &Finding, sizes: [f64; 2]) {
        for (said, size) in ceiling_sizes(found).into_iter().zip(sizes) {
            assert!((said - size).abs() < 2e-3 * size, "{said}, not {size}: {}", found.message);
        }
    }

    /// Within a ring 5 mm wide and 2.5 mm high; of a clay that shrinks by 37.5 percent a pot is made 1.6 times as large.
    #[test]
    fn the_ceiling_within_a_foot_ring_is_told_to_who_prints() {
        let ring = serde_json::json!({ "thickness": 0.3, "base": 0.5, "foot": [0.5, 0.25] });
        let made = |craft, shrinkage| Making { craft, shrinkage, ..Making::default() };
        let told = |making: &Making| ceilings([3.0, 3.0], &ring, &upright(), making);
        let [found] = &told(&made(None, 0.0))[..] else { panic!("one ceiling") };
        assert_eq!((found.severity, found.path.as_deref()), (Severity::Note, Some("parts[0].wall.foot")));
        assert_said(found, [50.0, 2.5]);
        let at = DVec3::from_array(found.at.unwrap());
        assert!(at.truncate().length() < 1e-3, "{at}");
        let [larger] = &told(&made(Some(Craft::Print), 37.5))[..] else { panic!("one ceiling") };
        assert_said(larger, [80.0, 4.0]);
        assert!((DVec3::from_array(larger.at.unwrap()) - at).length() < 1e-3);
        assert!(told(&made(Some(Craft::Clay), 0.0)).is_empty());
        let plain = serde_json::json!({ "thickness": 0.3, "base": 0.5 });
        assert!(ceilings([3.0, 3.0], &plain, &upright(), &made(None, 0.0)).is_empty());
    }

    /// How far printers have to bridge does not depend on how a pot is turned.
    #[test]
    fn a_ceiling_is_as_wide_as_the_ring_is_narrow_whichever_way_it_lies() {
        let ring = serde_json::json!({ "thickness": 0.3, "base": 0.5, "foot": [0.5, 0.25] });
        let wide = |angle: f64| {
            let turned = serde_json::json!({ "axis": [0, 0, 1], "angle": angle });
            let [found] = &ceilings([5.0, 3.0], &ring, &turned, &Making::default())[..] else { panic!("one ceiling") };
            ceiling_sizes(found)[0]
        };
        let upright = wide(0.0);
        assert!((45.0..=52.0).contains(&upright), "{upright}");
        for angle in [0.4, 0.785, 1.2] {
            assert!((wide(angle) - upright).abs() < 0.1, "{angle}: {} {upright}", wide(angle));
        }
    }

    /// A disc of radius 30 mm that is tilted by 0.3 rises over its lowest point by its diameter times the sine.
    #[test]
    fn the_underside_of_a_pot_that_is_tilted_is_told_to_who_prints() {
        let plain = serde_json::json!({ "thickness": 0.3, "base": 0.5 });
        let tilted = serde_json::json!({ "axis": [1, 0, 0], "angle": 0.3 });
        let [found] = &ceilings([3.0, 3.0], &plain, &tilted, &Making::default())[..] else { panic!("one underside") };
        assert_eq!(found.path.as_deref(), Some("parts[0].place"));
        let words = found.message.split("up to ").nth(1).and_then(|rest| rest.split(' ').next());
        let above: f64 = words.and_then(|word| word.parse().ok()).unwrap();
        assert!((above - 60.0 * libm::sin(0.3)).abs() < 0.05, "{}", found.message);
    }

    /// The flank of a straight cup leans out by the angle whose tangent is its flare over its height: 38 mm of flare over 40 are 43.5 degrees, 42 are 46.4.
    #[test]
    fn overhangs_beyond_45_degrees_are_told_to_who_prints() {
        let hangs = |flare, craft| said(5.0, 5.0, flare, craft).iter().any(|found| found.0 == "overhang");
        assert!(!hangs(38.0, Some(Craft::Print)) && hangs(42.0, Some(Craft::Print)) && hangs(42.0, None));
        assert!(!hangs(42.0, Some(Craft::Clay)));
    }
}
