//! The packed link: base64url of the deflated canonical document.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::TINFLStatus;
use miniz_oxide::inflate::core::{DecompressorOxide, decompress, inflate_flags};

use super::damage::damaged;
use crate::design::document::Design;
use crate::design::limits::LINK_BYTES;
use crate::error::{Code, Error, Result};

/// The effort of the compressor. Equal designs have equal links only as long as it stays, with the version of
/// `miniz_oxide`; links made otherwise open all the same.
const EFFORT: u8 = 9;

/// # Errors
/// `too-large` for a design that a link does not hold: its reader would refuse it, and no address is so long.
#[inline]
pub(super) fn write(design: &Design) -> Result<String> {
    let document = design.to_json();
    if document.len() > LINK_BYTES {
        let message =
            format!("expected a design of at most {LINK_BYTES} bytes of JSON for a link, found {}", document.len());
        let error = Error::new(Code::TooLarge, "", message).with("what", "link").with("greatest", LINK_BYTES as f64);
        return Err(error.with("found", document.len() as f64));
    }
    Ok(URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(document.as_bytes(), EFFORT)))
}

/// Reads what follows `1~`. The checksum of the zlib format (RFC 1950) tells nearly every damage from a design.
#[inline]
pub(super) fn read(text: &str) -> Result<Design> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let bytes = URL_SAFE_NO_PAD.decode(text).map_err(|_| damaged("its letters do not fit together"))?;
    let document = String::from_utf8(inflated(&bytes)?).map_err(|_| damaged("it holds no text"))?;
    Design::from_json(&document)
}

fn inflated(bytes: &[u8]) -> Result<Vec<u8>> {
    let flags = inflate_flags::TINFL_FLAG_PARSE_ZLIB_HEADER | inflate_flags::TINFL_FLAG_USING_NON_WRAPPING_OUTPUT_BUF;
    let mut document = vec![0; LINK_BYTES];
    let (status, read, written) = decompress(&mut DecompressorOxide::new(), bytes, &mut document, 0, flags);
    match status {
        TINFLStatus::Done if read == bytes.len() => {
            document.truncate(written);
            Ok(document)
        }
        TINFLStatus::Done => Err(damaged("something was added to its end")),
        TINFLStatus::HasMoreOutput => Err(Error::new(
            Code::TooLarge,
            "",
            format!("expected a design of at most {LINK_BYTES} bytes of JSON, found more"),
        )),
        TINFLStatus::Adler32Mismatch => Err(damaged("its checksum is wrong")),
        _ => Err(damaged("its letters do not fit together")),
    }
}
