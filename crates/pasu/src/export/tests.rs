//! Files of a cube, written by hand.

use super::contents::{Body, Notes};
use crate::design::Look;
use crate::solid::FaceKind;

#[rustfmt::skip]
const CUBE: [f32; 24] = [
    0.0, 0.0, 0.0, 20.0, 0.0, 0.0, 20.0, 20.0, 0.0, 0.0, 20.0, 0.0,
    0.0, 0.0, 20.0, 20.0, 0.0, 20.0, 20.0, 20.0, 20.0, 0.0, 20.0, 20.0,
];
#[rustfmt::skip]
const TRIANGLES: [u32; 36] = [
    0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7,
];

#[test]
fn dump() {
    let notes = Notes {
        title: "Vase <& \"é\" 🏺>".into(),
        link: "1/bloor-wilson?a=6&n1=5".into(),
        fingerprint: "0123456789abcdef".into(),
        verdict: "passed".into(),
        scale: "1 cm of the design is 10 mm here".into(),
    };
    let faces = (0..6).map(|i| (FaceKind::Outer, 6 * i, 6)).collect();
    let bodies = [Body { name: "part 1".into(), look: Look::default(), positions: &CUBE, indices: &TRIANGLES, faces }];
    for (name, bytes) in [
        ("stl", super::stl::write(&notes, &bodies)),
        ("3mf", super::three_mf::write(&notes, &bodies)),
        ("glb", super::glb::write(&notes, &bodies)),
        ("obj", super::obj::write(&notes, &bodies)),
        ("ply", super::ply::write(&notes, &bodies)),
    ] {
        assert_eq!(super::open(&bytes).as_deref(), Some(notes.link.as_str()), "{name}");
        std::fs::write(format!("/work/target-C/cube.{name}"), bytes).unwrap();
    }
}

/// A face of revolution: radius and height along `a`.
struct Turned(FaceKind, f64, fn(f64) -> (f64, f64));

impl crate::solid::Face for Turned {
    fn kind(&self) -> FaceKind {
        self.0
    }

    fn jet(&self, a: f64, v: f64) -> crate::solid::FaceJet {
        let (sin, cos) = (libm::sin(v), libm::cos(v));
        let (radius, z) = self.2(a);
        let (next, z1) = self.2(a + 1e-6);
        let (last, z0) = self.2(a - 1e-6);
        let (dr, dz) = ((next - last) / 2e-6, (z1 - z0) / 2e-6);
        let oval = 1.0 + 0.1 * libm::cos(3.0 * v);
        let doval = -0.3 * libm::sin(3.0 * v);
        crate::solid::FaceJet {
            position: glam::DVec3::new(radius * oval * cos, radius * oval * sin, z),
            da: glam::DVec3::new(dr * oval * cos, dr * oval * sin, dz),
            dv: radius * glam::DVec3::new(doval * cos - oval * sin, doval * sin + oval * cos, 0.0),
        }
    }

    fn outward(&self) -> f64 {
        self.1
    }
}

#[test]
fn dump_step() {
    // da x dv of an upright wall points inwards.
    let outer = Turned(FaceKind::Outer, -1.0, |a| (3.0 + libm::sin(3.0 * a), 10.0 * a));
    let rim = Turned(FaceKind::Rim, 1.0, |a| (2.7 + 0.3 * a + libm::sin(3.0), 10.0));
    let lining = Turned(FaceKind::Lining, 1.0, |a| (2.7 + libm::sin(0.3 + 2.7 * a), 1.0 + 9.0 * a));
    let floor = Turned(FaceKind::Floor, 1.0, |a| (a * (2.7 + libm::sin(0.3)), 1.0));
    let base = Turned(FaceKind::Underside, -1.0, |a| (3.0 * (1.0 - a), 0.2 * a));
    let notes = Notes {
        title: "Vase <& \"é\" 🏺>'s".into(),
        link: "1/bloor-wilson?a=6&n1=5".repeat(30),
        fingerprint: "0123456789abcdef".into(),
        verdict: "passed".into(),
        scale: "1 cm of the design is 10 mm here".into(),
    };
    let part = super::step::Part {
        name: "bödy".into(),
        look: Look::default(),
        path: "parts[0]".into(),
        faces: vec![&outer, &rim, &lining, &floor, &base],
    };
    let bytes = super::step::write(&notes, &[part], 10.0, 0.001).unwrap();
    assert_eq!(super::open(&bytes), Some(notes.link));
    std::fs::write("/work/target-C/cup.step", bytes).unwrap();
}
