//! Links: what they look like, that they bring back the same design, and what damage is said to be.

use std::collections::BTreeMap;

use crate::support::documents::document;
use crate::support::golden::golden;
use crate::support::{corpus, design, design_of, design_of_case};
use pasu::Design;
use proptest::prelude::*;
use proptest::sample::Index;

const DINTS: &str = "1/bloor-wilson?a=6&n1=5";

fn packed() -> Design {
    design(
        r#"{ "pasu": 1, "title": "Two pots: 100 % & more", "parts": [
            { "name": "left", "shape": { "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] } },
            { "name": "right", "object": 1, "shape": { "kind": "mixed-order", "r": [1, 0.1, 0.6, 0.06], "rise": 4 },
              "place": { "shift": [3, 0, 0] } }
        ] }"#,
    )
}

fn refused(text: &str) -> (String, String, String) {
    match Design::parse(text) {
        Ok(design) => panic!("{text} opened as {}", design.to_json()),
        Err(error) => (error.code().as_str().into(), error.path().into(), error.message().into()),
    }
}

#[test]
fn readable_links_are_typed_by_hand() {
    for (shape, link) in [
        (r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] }"#, "1/second-order"),
        (r#"{ "kind": "mixed-order", "r": [1, 0.1, 0.6, 0.06], "rise": -0.01 }"#, "1/mixed-order?rise=-.01"),
        (
            r#"{ "kind": "fourth-order", "r0": 0.2, "r1": 0.8, "rm": 0.7, "h1": 2, "eta": [0.1, 0.1], "dz": [6, 6],
                 "s": [1, 1], "t": [16, 16], "w": [60, 60] }"#,
            "1/fourth-order?r0=.2&r1=.8&rm=.7&eta=.1,.1&t=16,16&w=60,60",
        ),
        (
            r#"{ "kind": "bloor-wilson", "a": 6, "r": [1, 0.1, 0.1, 0.8], "R": [-3, -0.5, -0.5, 2], "h": [3, 0.3],
                 "H": [-0.5, -0.7], "n1": 5 }"#,
            DINTS,
        ),
    ] {
        let design = design_of(shape);
        assert_eq!(design.link(), link);
        assert_eq!(Design::parse(link), Ok(design));
    }
    let look = "1/second-order?height=4&title=Dint%20vase%2C%20no%2E%201&unit=mm&glaze=tin-white&clay=black";
    let design = Design::parse(look).unwrap();
    assert_eq!(design.title(), Some("Dint vase, no. 1"));
    assert_eq!(design.link(), look);
    // Values that are the default anyway are not repeated.
    assert_eq!(Design::parse("1/second-order?height=3.60&s=1,1&unit=cm&n=1,8").unwrap().link(), "1/second-order");
}

#[test]
fn everything_else_is_packed() {
    let design = packed();
    let link = design.link();
    assert!(link.starts_with("1~") && link.bytes().skip(2).all(|b| b.is_ascii_alphanumeric() || b"-_".contains(&b)));
    assert_eq!(Design::parse(&link), Ok(design));
    for case in corpus() {
        let design = design_of_case(&case);
        assert_eq!(Design::parse(&design.link()).as_ref(), Ok(&design), "{}", case.name);
        assert_eq!(design.link().starts_with("1/"), case.family.is_some(), "{}", case.name);
    }
}

/// Links that have been sent open for ever: the golden file maps each to its document. It may grow; `PASU_BLESS=1 cargo
/// test -p pasu --test library links` adds the reference corpus to it. No line of it may ever change within a format version.
#[test]
fn links_of_this_version_are_golden() {
    let mut designs: Vec<Design> = corpus().iter().map(design_of_case).collect();
    designs
        .extend([packed(), Design::parse("1/second-order?title=Dint%20vase&unit=in&glaze=shino&clay=black").unwrap()]);
    let found: BTreeMap<String, String> = designs.iter().map(|design| (design.link(), design.to_json())).collect();
    let golden = golden!("links.json").beside(&found);
    for (link, document) in &golden {
        let design = Design::parse(link).unwrap();
        assert_eq!((&design.link(), &design.to_json()), (link, document));
    }
    assert!(found.keys().all(|link| golden.contains_key(link)));
}

#[test]
fn links_survive_how_people_send_them() {
    let long = "1/bloor-wilson?a=6&n1=5&title=Dint%20vase";
    for link in [long, &packed().link()] {
        let design = Design::parse(link).unwrap();
        let encode = |text: &str, kept: &str| {
            text.chars()
                .map(|c| {
                    if c.is_ascii_alphanumeric() || kept.contains(c) {
                        c.to_string()
                    } else {
                        format!("%{:02X}", c as u32)
                    }
                })
                .collect::<String>()
        };
        let address = format!("https://example.org/pots/#{link}");
        let middle = link.len() / 2;
        for sent in [
            link.to_owned(),
            format!("#{link}"),
            format!("  {address}\n"),
            format!("<{address}>"),
            format!("\"{address}\","),
            format!("(see {address})."),
            format!("look: {address}!"),
            address.replace('&', "&amp;"),
            address.replace('&', "&amp;amp;"),
            encode(&address, ""),
            encode(&encode(&address, ""), ""),
            // As encodeURI and encodeURIComponent do.
            encode(&address, "#/?:&=,~-_.!*'()"),
            format!("https://example.org/pots/#{}", encode(link, "-_.!~*'()")),
            format!("https://example.org/a%20b/100%/#{link}"),
            format!("{}\r\n{}", &address[..24 + middle], &address[24 + middle..]),
            format!("> {} \n> > {}", &address[..24 + middle], &address[24 + middle..]),
            format!("{}\u{ad}{}", &link[..middle], &link[middle..]),
            format!("\u{feff}{}\u{200b}{}", &link[..middle], &link[middle..]),
            address.chars().map(|c| format!("{c}\n")).collect(),
        ] {
            assert_eq!(Design::parse(&sent).as_ref(), Ok(&design), "{sent}");
        }
    }
    let spaced: String = packed().link().chars().map(|c| format!("{c} ")).collect();
    assert_eq!(Design::parse(&spaced.replacen(' ', "", 2)), Ok(packed()));
}

#[test]
fn what_is_wrong_is_said_in_words() {
    let not = |text: &str| {
        format!(
            "This is neither a design nor a link to one: {text:?}; a link looks like #1/bloor-wilson?a=6, or #1~ and a long row of letters and digits."
        )
    };
    let damaged = |what: &str| {
        format!("This link is damaged or cut short ({what}); copy it once more, from its first to its last letter.")
    };
    let newer = |format: &str| {
        format!("This link was made by a newer version of Pasu (format {format}); this page reads format 1.")
    };
    let families = r#""second-order", "mixed-order", "fourth-order", "bloor-wilson" or "rings""#;
    for (link, code, path, message) in [
        ("#2/bloor-wilson?a=6", "unknown-version", "", newer("2")),
        ("https://example.org/#7~abc", "unknown-version", "", newer("7")),
        ("#12345678901234567890/x", "unknown-version", "", newer("12345678901234567890")),
        ("#0/second-order", "unknown-version", "", "expected a link of format 1, found format 0".into()),
        ("", "damaged-link", "", "There is nothing here to open; expected a design or a link.".into()),
        ("https://example.org/", "damaged-link", "", "This address has no design in it; expected one after a #.".into()),
        ("#about", "damaged-link", "", not("#about")),
        ("[1, 2]", "damaged-link", "", not("[1, 2]")),
        ("#1", "damaged-link", "", not("#1")),
        ("#1~", "damaged-link", "", damaged("its letters do not fit together")),
        ("#1~!!!a", "damaged-link", "", damaged("its letters do not fit together")),
        ("#1/second-order?height", "damaged-link", "", damaged("expected a name, = and a value, found \"height\"")),
        ("#1/second-order?height=4&", "damaged-link", "", damaged("expected a name, = and a value, found \"\"")),
        ("#1/second-order?title=%E4", "damaged-link", "", damaged("its % signs do not spell a text")),
        ("#1/second-order?title=50%", "damaged-link", "", damaged("a % sign without the two digits that belong to it")),
        (
            "#1/second-order?title=%2525252541",
            "damaged-link",
            "",
            damaged("its % signs do not fit together"),
        ),
        ("#1/teapot", "unknown-name", "parts[0].shape.kind", format!("expected {families}, found \"teapot\"")),
        ("#1/", "unknown-name", "parts[0].shape.kind", format!("expected {families}, found an empty text")),
        (
            "#1/boundary-value?span=1",
            "unknown-name",
            "parts[0].shape.kind",
            format!("expected {families}, found \"boundary-value\""),
        ),
        (
            "#1/octant",
            "unknown-name",
            "parts[0].shape.kind",
            format!("expected {families}, found \"octant\""),
        ),
        (
            "#1/bloor-wilson?b=1",
            "unknown-field",
            "parts[0].shape.b",
            "unknown field \"b\"; expected one of a, r, R, h, H, n1, title, unit, glaze, inside, line, clay".into(),
        ),
        (
            "#1/bloor-wilson?a=1&a=2",
            "duplicate",
            "parts[0].shape.a",
            "this field is given twice; expected it once".into(),
        ),
        ("#1/bloor-wilson?title=a&title=b", "duplicate", "title", "this field is given twice; expected it once".into()),
        (
            "#1/bloor-wilson?r=1,2,3",
            "wrong-type",
            "parts[0].shape.r",
            "expected a list of 4 numbers, found a list of 3".into(),
        ),
        (
            "#1/bloor-wilson?r=1,2,,3",
            "wrong-type",
            "parts[0].shape.r[2]",
            "expected a number, found an empty text".into(),
        ),
        ("#1/bloor-wilson?a=1,2", "wrong-type", "parts[0].shape.a", "expected a number, found \"1,2\"".into()),
        ("#1/bloor-wilson?a=1 2", "wrong-type", "parts[0].shape.a", "expected a number, found \"1 2\"".into()),
        ("#1/bloor-wilson?a=six", "wrong-type", "parts[0].shape.a", "expected a number, found \"six\"".into()),
        ("#1/bloor-wilson?a=NaN", "not-finite", "parts[0].shape.a", "expected a number, found NaN".into()),
        ("#1/bloor-wilson?a=-Infinity", "not-finite", "parts[0].shape.a", "expected a number, found -Infinity".into()),
        ("#1/bloor-wilson?a=1e999", "not-finite", "parts[0].shape.a", "expected a number, found Infinity".into()),
        (
            "#1/bloor-wilson?a=1e200",
            "overflow",
            "parts[0].shape",
            "these numbers are so large that their products cannot be computed".into(),
        ),
        (
            "#1/second-order?s=1,0",
            "out-of-range",
            "parts[0].shape.s[1]",
            "expected a number other than 0, found 0".into(),
        ),
        (
            "#1/second-order?glaze=pink",
            "unknown-name",
            "parts[0].look.glaze",
            "expected \"celadon\", \"tenmoku\", \"cobalt\", \"tin-white\", \"shino\", \"copper-red\", \"clear\", \"bare\" or \"#rrggbb\", found \"pink\"".into(),
        ),
        ("#1/second-order?unit=m", "unknown-name", "unit", "expected \"cm\", \"mm\" or \"in\", found \"m\"".into()),
    ] {
        assert_eq!(refused(link), (code.into(), path.into(), message), "{link}");
    }
}

#[test]
fn a_packed_link_opens_whole_or_not_at_all() {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    let design = packed();
    let link = design.link();
    let check = |text: String| {
        if let Ok(other) = Design::parse(&text) {
            assert_eq!(other, design, "{text}");
        }
    };
    for index in 2..link.len() {
        for letter in LETTERS {
            check(format!("{}{}{}", &link[..index], char::from(*letter), &link[index + 1..]));
        }
        // Left out, said twice, exchanged with its neighbour, cut short.
        check(format!("{}{}", &link[..index], &link[index + 1..]));
        check(format!("{}{}", &link[..index], &link[index - 1..]));
        check(format!(
            "{}{}{}{}",
            &link[..index - 1],
            &link[index..=index],
            &link[index - 1..index],
            &link[index + 1..]
        ));
        assert_eq!(refused(&link[..index]).0, "damaged-link");
    }
    for garbage in ["A", "AA", "AAAA", "abcdefgh", &link[2..]] {
        assert_eq!(refused(&format!("{link}{garbage}")).0, "damaged-link", "{garbage}");
    }
}

#[test]
fn a_packed_link_cannot_unfold_without_end() {
    let bomb = miniz_oxide::deflate::compress_to_vec_zlib(&vec![b' '; 3 << 20], 9);
    let link = format!("1~{}", base64::Engine::encode(&base64::engine::general_purpose::URL_SAFE_NO_PAD, bomb));
    let expected =
        ("too-large".into(), "".into(), "expected a design of at most 1048576 bytes of JSON, found more".into());
    assert_eq!(refused(&link), expected);
    assert_eq!(refused(&"x".repeat(3 << 20)).0, "too-large");
}

/// Work that grew with the square of the length would take hours for these.
#[test]
fn hostile_texts_are_refused_at_once() {
    let many = |text: &str| text.repeat((1 << 20) / text.len());
    for text in [
        format!("1/second-order?{}", many("&amp;")),
        format!("1/second-order?&{}", many("amp;")),
        format!("1/second-order?{}", many("%25")),
        format!("1/second-order?{}", many("s=1,1&")),
        format!("1/second-order?height={}", many("9")),
        format!("1/second-order?r={}", many(",")),
        format!("1/{}\n{}", many(" "), many(">")),
        format!("1~{}", many("A")),
        format!("{{\"pasu\":1,{}", many("\"x\":null,")),
        format!("{{\"pasu\":{}", many("[")),
    ] {
        assert!(Design::parse(&text).is_err(), "{}", &text[..40]);
    }
}

/// What a link may be damaged by: its own letters, those of other links, of addresses and of sentences.
const LETTERS: &str =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_~/#?&=%+.,;:!<>()[]{}\"'\\ \n\u{ad}é漢🏺";

/// The checksum of a packed link (RFC 1950).
fn adler32(text: &str) -> u32 {
    let (a, b) =
        text.bytes().fold((1, 0), |(a, b), byte| ((a + u32::from(byte)) % 65521, (a + b + u32::from(byte)) % 65521));
    b << 16 | a
}

/// The text that a packed link holds, which is known to open.
fn held(link: &str) -> String {
    let digits: String =
        link.rsplit("1~").next().unwrap().chars().filter(|c| c.is_ascii_alphanumeric() || "-_".contains(*c)).collect();
    let bytes = base64::Engine::decode(&base64::engine::general_purpose::URL_SAFE_NO_PAD, digits).unwrap();
    String::from_utf8(miniz_oxide::inflate::decompress_to_vec_zlib(&bytes).unwrap()).unwrap()
}

/// A packed link opens whole or not at all, as far as its checksum can tell: digits that are damaged in just such a way that it stays the same are not noticed.
fn check(design: &Design, damaged: &str) -> Result<(), TestCaseError> {
    match Design::parse(damaged) {
        Ok(opened) if opened == *design => {}
        // What is opened need not be written as the text was that the link holds now.
        Ok(_) => prop_assert_eq!(adler32(&held(damaged)), adler32(&design.to_json()), "{}", damaged),
        Err(error) => {
            // It may look like a newer link (`11~...`), a readable one (`1/...`) or JSON (`{~...`).
            let codes = ["damaged-link", "unknown-version", "unknown-name", "not-json"];
            // Digits that are damaged and keep the checksum may leave a document that is refused, at a number or a list of one of its parts.
            let is_refused = damaged.starts_with("1~") && error.path().starts_with("parts[");
            prop_assert!(codes.contains(&error.code().as_str()) || is_refused, "{error:?}");
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn no_text_makes_it_panic(text in any::<String>(), link in "#?[12]?[/~]?(bloor-wilson|second-order)?[?&=,.a-zA-Z0-9%#~ \n-]{0,40}") {
        let _ = Design::parse(&text);
        if let Ok(design) = Design::parse(&link) {
            prop_assert_eq!(Design::parse(&design.link()), Ok(design));
        }
    }

    #[test]
    fn random_damage_is_noticed(
        value in document(),
        places in proptest::collection::vec((any::<Index>(), any::<Index>()), 20),
        garbage in "[A-Za-z0-9_-]{1,12}",
    ) {
        let design = value.design().unwrap().ordered();
        let link = design.link();
        prop_assume!(link.starts_with("1~"));
        for (place, letter) in places {
            let at = place.index(link.len());
            let letter = LETTERS.chars().nth(letter.index(LETTERS.chars().count())).unwrap();
            let (before, rest) = link.split_at(at);
            check(&design, &format!("{before}{letter}{}", &rest[1..]))?;
            check(&design, &format!("{before}{letter}{rest}"))?;
            check(&design, &format!("{before}{}", &rest[1..]))?;
            prop_assert_eq!(Design::parse(before).unwrap_err().code().as_str(), "damaged-link", "{}", before);
        }
        prop_assert_eq!(Design::parse(&format!("{link}{garbage}")).unwrap_err().code().as_str(), "damaged-link");
    }
}
