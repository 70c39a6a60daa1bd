//! Everything that reads: documents, links, files.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use pasu::{Code, Design, Error, Shape, open};

/// Text as a document or a link, and as a shape.
pub(crate) fn document(input: &[u8]) -> bool {
    let text = String::from_utf8_lossy(input);
    if let Err(error) = Shape::parse(&text) {
        refusal(&error);
    }
    parsed(&text).is_some()
}

/// Text as what it is, and as the content of a packed link; bytes as the stream of one.
pub(crate) fn link(input: &[u8]) -> bool {
    let text = String::from_utf8_lossy(input);
    let is_link = parsed(&text).is_some();
    let packed = |stream: &[u8]| parsed(&format!("#1~{}", URL_SAFE_NO_PAD.encode(stream))).is_some();
    let is_content = packed(&compress_to_vec_zlib(input, 1));
    packed(input) || is_content || is_link
}

/// Bytes as a file, and the link in it.
pub(crate) fn file(input: &[u8]) -> bool {
    let Some(link) = open(input) else { return false };
    assert!(!link.is_empty() && link.is_ascii(), "{link:?}");
    parsed(&link);
    true
}

/// Reads a design, which is canonical: it stays what it is by way of its document and, but for the order of its parts, of its link, each to the byte.
pub(crate) fn parsed(text: &str) -> Option<Design> {
    let design = match Design::parse(text) {
        Ok(design) => design,
        Err(error) => {
            refusal(&error);
            return None;
        }
    };
    let (document, link, ordered) = (design.to_json(), design.link(), design.ordered());
    for (told, expected) in [(&document, &design), (&link, &ordered), (&format!("#{link}"), &ordered)] {
        let again = Design::parse(told).unwrap_or_else(|error| panic!("{told} is refused: {error}"));
        assert_eq!(again, *expected, "{told}");
        assert_eq!(again.to_json(), expected.to_json());
        assert_eq!(again.link(), link);
    }
    Some(design)
}

/// A refusal says whose mistake it is, and says it in words.
pub(crate) fn refusal(error: &Error) {
    assert_ne!(error.code(), Code::Bug, "{error}");
    assert!(error.message().len() > 10, "{error:?}");
    assert!(!error.path().starts_with('.'), "{error:?}");
}
