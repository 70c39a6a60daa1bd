//! The TypeScript declarations of documents and answers, the tables of the document, and the files of the npm package and the page that they are written to.
#![cfg(feature = "typescript")]

#[test]
fn every_field_is_declared() {
    let text = pasu::typescript();
    for line in [
        "export type GlazeName = \"celadon\" | \"tenmoku\" | \"cobalt\" | \"tin-white\" | \"shino\" | \"copper-red\" | \"clear\" | \"bare\";",
        "export type ClayName = \"stoneware\" | \"porcelain\" | \"terracotta\" | \"black\";",
        "export type Unit = \"cm\" | \"mm\" | \"in\";",
        "export type Shape =",
        "  | Octant;",
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

#[test]
fn answers_leave_nothing_out() {
    let text = pasu::typescript_of_answers();
    for line in [
        "export interface Measures extends BodyMeasures {",
        "  readonly unit: Unit;",
        "  readonly parts: readonly PartMeasures[];",
        "  readonly centre: { readonly empty: Centre | null; readonly full: Centre | null };",
        "  readonly hull: readonly (readonly [x: number, y: number])[];",
        "  readonly capacityReason: string | null;",
        "  readonly severity: \"error\" | \"warning\" | \"note\";",
        "  readonly genus: number | null;",
    ] {
        assert!(text.lines().any(|found| found == line), "{line}");
    }
    assert!(!text.contains("?:"));
}

/// `PASU_BLESS=1 cargo test -p pasu --features typescript` writes the files anew.
#[test]
fn package_and_page_have_what_is_generated() {
    for (name, generated) in [
        ("crates/pasu-wasm/js/design.d.ts", pasu::typescript()),
        ("crates/pasu-wasm/js/answers.d.ts", pasu::typescript_of_answers()),
        ("web/src/document/families.gen.ts", pasu::typescript_of_sliders()),
        ("web/src/document/blend/tables.gen.ts", pasu::typescript_of_blends()),
        ("web/src/document/tables.gen.ts", pasu::typescript_of_tables()),
        ("web/src/render/materials.gen.ts", pasu::typescript_of_materials()),
    ] {
        let file = format!("{}/../../{name}", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("PASU_BLESS").is_some() {
            std::fs::write(&file, &generated).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&file).unwrap(), generated, "{name}");
    }
}
