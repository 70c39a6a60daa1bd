//! The TypeScript declarations, printed for a look by `cargo test --features typescript -- --nocapture`.
#![cfg(feature = "typescript")]

#[test]
fn every_field_is_declared() {
    let text = pasu::typescript();
    println!("{text}");
    for line in [
        "export type GlazeName = \"celadon\" | \"tenmoku\" | \"cobalt\" | \"tin-white\" | \"shino\" | \"copper-red\" | \"clear\" | \"bare\";",
        "export type ClayName = \"stoneware\" | \"porcelain\" | \"terracotta\" | \"black\";",
        "export type Unit = \"cm\" | \"mm\" | \"in\";",
        "export type Shape = SecondOrder | MixedOrder | FourthOrder | BloorWilson | BoundaryValue;",
        "  readonly kind: \"bloor-wilson\";",
        "  readonly R: readonly [number, number, number, number];",
        "  readonly n?: readonly [number, number];",
        "  readonly parts: readonly Part[];",
        "  readonly wall?: Wall;",
        "  readonly base: number;",
        "  readonly modes: readonly Mode<FourthOrderDatum>[];",
    ] {
        assert!(text.lines().any(|found| found == line), "{line}");
    }
    assert_eq!(text.matches('{').count(), text.matches('}').count());
}
