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
