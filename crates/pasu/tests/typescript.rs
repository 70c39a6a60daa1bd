//! The TypeScript declarations of the design document, and the file of the npm package that they are written to.
#![cfg(feature = "typescript")]

#[test]
fn every_field_is_declared() {
    let text = pasu::typescript();
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

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../pasu-wasm/js/design.d.ts");

/// `PASU_BLESS=1 cargo test -p pasu --features typescript` writes the file anew.
#[test]
fn the_package_ships_what_is_generated() {
    let generated = pasu::typescript();
    if std::env::var_os("PASU_BLESS").is_some() {
        std::fs::write(FILE, &generated).unwrap();
    }
    assert_eq!(std::fs::read_to_string(FILE).unwrap(), generated);
}
