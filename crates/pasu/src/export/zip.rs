//! ZIP packages (APPNOTE 6.3): a writer of the few things that a 3MF needs, and a reader of one entry.

use miniz_oxide::deflate::core::{
    CompressorOxide, TDEFLFlush, TDEFLStatus, compress_to_output, create_comp_flags_from_zip_params,
};
use miniz_oxide::inflate::TINFLStatus;
use miniz_oxide::inflate::core::{DecompressorOxide, decompress, inflate_flags};

use super::crc32::crc32;
use crate::watch;

const LOCAL: [u8; 4] = *b"PK\x03\x04";
const CENTRAL: [u8; 4] = *b"PK\x01\x02";
const END: [u8; 4] = *b"PK\x05\x06";

/// Version 2.0 of the format: folders and deflate.
const NEEDS: u16 = 20;
/// Names are UTF-8.
const FLAGS: u16 = 1 << 11;
const STORED: u16 = 0;
const DEFLATED: u16 = 8;
/// 1 January 1980, the first day of ZIP: the same design makes the same bytes on any day.
const DATE: u16 = (1 << 5) | 1;
/// In a third of the time of the usual effort, for a few percent more bytes.
const EFFORT: i32 = 4;
/// Packed between two words to a watcher: about a millisecond.
const PIECE: usize = 1 << 16;

/// Files that are packed together.
#[derive(Default)]
pub(super) struct Package {
    bytes: Vec<u8>,
    directory: Vec<u8>,
    n_files: u16,
}

impl Package {
    /// Adds a file that deflate makes smaller. Sizes and offsets have 32 bits: the whole must stay below 4 GB.
    pub(super) fn add_text(&mut self, name: &str, contents: &[u8]) {
        self.add(name, contents, &deflated(contents), DEFLATED);
    }

    /// Adds a file that is packed already.
    pub(super) fn add_stored(&mut self, name: &str, contents: &[u8]) {
        self.add(name, contents, contents, STORED);
    }

    fn add(&mut self, name: &str, contents: &[u8], packed: &[u8], method: u16) {
        let mut fields = Vec::with_capacity(26);
        for short in [NEEDS, FLAGS, method, 0, DATE] {
            fields.extend_from_slice(&short.to_le_bytes());
        }
        for long in [crc32(&[contents]), packed.len() as u32, contents.len() as u32] {
            fields.extend_from_slice(&long.to_le_bytes());
        }
        fields.extend_from_slice(&(name.len() as u16).to_le_bytes());
        fields.extend_from_slice(&0u16.to_le_bytes());

        let offset = self.bytes.len() as u32;
        self.bytes.extend_from_slice(&LOCAL);
        self.bytes.extend_from_slice(&fields);
        self.bytes.extend_from_slice(name.as_bytes());
        self.bytes.extend_from_slice(packed);

        self.directory.extend_from_slice(&CENTRAL);
        self.directory.extend_from_slice(&NEEDS.to_le_bytes());
        self.directory.extend_from_slice(&fields);
        // No comment, disk 0, no attributes.
        self.directory.extend_from_slice(&[0; 10]);
        self.directory.extend_from_slice(&offset.to_le_bytes());
        self.directory.extend_from_slice(name.as_bytes());
        self.n_files += 1;
    }

    /// The package.
    pub(super) fn finish(mut self) -> Vec<u8> {
        let offset = self.bytes.len() as u32;
        self.bytes.append(&mut self.directory);
        let length = self.bytes.len() as u32 - offset;
        self.bytes.extend_from_slice(&END);
        self.bytes.extend_from_slice(&[0; 4]);
        for _ in 0..2 {
            self.bytes.extend_from_slice(&self.n_files.to_le_bytes());
        }
        self.bytes.extend_from_slice(&length.to_le_bytes());
        self.bytes.extend_from_slice(&offset.to_le_bytes());
        self.bytes.extend_from_slice(&[0; 2]);
        self.bytes
    }
}

/// Deflate without a wrapper, piece by piece: the bytes are those of the whole at once.
fn deflated(contents: &[u8]) -> Vec<u8> {
    let mut packer = CompressorOxide::new(create_comp_flags_from_zip_params(EFFORT, 0, 0));
    let mut packed = Vec::with_capacity(contents.len() / 4);
    let mut rest = contents;
    loop {
        watch::work(2 * PIECE as u64);
        let (piece, after) = rest.split_at(rest.len().min(PIECE));
        let flush = if after.is_empty() || watch::is_stopped() { TDEFLFlush::Finish } else { TDEFLFlush::None };
        let (status, taken) = compress_to_output(&mut packer, piece, flush, |bytes| {
            packed.extend_from_slice(bytes);
            true
        });
        if status != TDEFLStatus::Okay {
            return packed;
        }
        rest = &rest[taken..];
    }
}

/// The beginning of the file `name` of a package, at most `most` bytes of it. `None` for whatever is no package, has no such file or is damaged before its first bytes.
pub(super) fn beginning_of(package: &[u8], name: &str, most: usize) -> Option<Vec<u8>> {
    // The end record is followed by a comment of at most 65535 bytes.
    let tail = package.len().saturating_sub(22 + 0xffff);
    let end = tail + package[tail..].windows(4).rposition(|window| window == END)?;
    let mut at = long(package, end + 16)? as usize;
    for _ in 0..short(package, end + 10)? {
        if package.get(at..at + 4)? != CENTRAL {
            return None;
        }
        let name_length = usize::from(short(package, at + 28)?);
        let found = package.get(at + 46..at + 46 + name_length)?;
        if found.eq_ignore_ascii_case(name.as_bytes()) {
            let length = long(package, at + 20)? as usize;
            return unpacked(package, long(package, at + 42)? as usize, short(package, at + 10)?, length, most);
        }
        at += 46 + name_length + usize::from(short(package, at + 30)?) + usize::from(short(package, at + 32)?);
    }
    None
}

fn unpacked(package: &[u8], local: usize, method: u16, length: usize, most: usize) -> Option<Vec<u8>> {
    if package.get(local..local.checked_add(4)?)? != LOCAL {
        return None;
    }
    let start = local + 30 + usize::from(short(package, local + 26)?) + usize::from(short(package, local + 28)?);
    let packed = package.get(start..start.checked_add(length)?)?;
    match method {
        STORED => Some(packed[..packed.len().min(most)].to_vec()),
        DEFLATED => {
            // Deflate makes nothing smaller than a 1032nd.
            let mut bytes = vec![0; most.min(packed.len().saturating_mul(1032))];
            let flags = inflate_flags::TINFL_FLAG_USING_NON_WRAPPING_OUTPUT_BUF;
            let (status, _, written) = decompress(&mut DecompressorOxide::new(), packed, &mut bytes, 0, flags);
            bytes.truncate(written);
            matches!(status, TINFLStatus::Done | TINFLStatus::HasMoreOutput).then_some(bytes)
        }
        _ => None,
    }
}

fn short(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_le_bytes(bytes.get(at..at.checked_add(2)?)?.try_into().ok()?))
}

fn long(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}
