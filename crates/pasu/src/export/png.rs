//! Pictures as PNG (ISO 15948).

use miniz_oxide::deflate::compress_to_vec_zlib;

use super::crc32::crc32;

const SIGNATURE: [u8; 8] = *b"\x89PNG\r\n\x1a\n";
/// Eight bits for each of red, green, blue and alpha; deflate, adaptive filters, not interlaced.
const RGBA: [u8; 5] = [8, 6, 0, 0, 0];
/// Each byte less the one of the pixel above.
const UP: u8 = 2;

/// A picture of rows of red, green, blue, alpha.
pub(super) fn png(width: usize, pixels: &[[u8; 4]]) -> Vec<u8> {
    let mut filtered = Vec::with_capacity(pixels.len() * 4 + pixels.len() / width.max(1));
    for (index, row) in pixels.chunks_exact(width).enumerate() {
        filtered.push(UP);
        for (column, pixel) in row.iter().enumerate() {
            let above = if index == 0 { [0; 4] } else { pixels[(index - 1) * width + column] };
            filtered.extend(pixel.iter().zip(above).map(|(byte, above)| byte.wrapping_sub(above)));
        }
    }
    let mut header = Vec::new();
    header.extend_from_slice(&(width as u32).to_be_bytes());
    header.extend_from_slice(&((pixels.len() / width) as u32).to_be_bytes());
    header.extend_from_slice(&RGBA);
    let mut bytes = SIGNATURE.to_vec();
    for (kind, data) in [(b"IHDR", header), (b"IDAT", compress_to_vec_zlib(&filtered, 9)), (b"IEND", Vec::new())] {
        bytes.extend_from_slice(&(data.len() as u32).to_be_bytes());
        bytes.extend_from_slice(kind);
        bytes.extend_from_slice(&data);
        bytes.extend_from_slice(&crc32(&[kind, &data]).to_be_bytes());
    }
    bytes
}
