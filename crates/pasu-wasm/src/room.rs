//! Room in memory before it is wanted.
//!
//! The allocator of Rust asks for memory 64 KiB at a time. Each time the engine makes a new buffer of all of it and hears of memory that its collector cannot free, so that V8 collects once for some tenths of a megabyte: for the five hundred parts of a scene as long again as what was asked. What is
//! allocated at once and given back stays with the allocator, and costs nothing until it is written to.

#[cfg(target_arch = "wasm32")]
use core::cell::Cell;

/// Pages of 64 KiB that are asked for at first: what hundreds of parts take where more than drawing is asked for, and what a pot takes where not.
#[cfg(target_arch = "wasm32")]
const FIRST: usize = if cfg!(feature = "making") { 1024 } else { 64 };

/// The most that are asked for at once.
#[cfg(target_arch = "wasm32")]
const MOST: usize = 4096;

#[cfg(target_arch = "wasm32")]
thread_local! {
    /// How many pages there were when some were asked for last.
    static KNOWN: Cell<usize> = const { Cell::new(0) };
}

/// Sees to it that there is room: for the first time, and again where what there was has been outgrown.
pub(crate) fn keep() {
    #[cfg(target_arch = "wasm32")]
    {
        let size = core::arch::wasm32::memory_size::<0>;
        let (known, pages) = (KNOWN.get(), size());
        if pages > known {
            let wanted = if known == 0 { FIRST } else { (pages / 2).min(MOST) };
            // Where there is no such memory there is what there was.
            let mut room: Vec<u8> = Vec::new();
            let _ = core::hint::black_box(&mut room).try_reserve_exact(wanted << 16);
            drop(room);
            KNOWN.set(size());
        }
    }
}
