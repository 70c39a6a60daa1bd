//! Four columns at a time in single precision.

use wide::f32x4;

/// A quantity at four columns. Lane by lane its arithmetic is that of `f32`, whatever the instructions, so that every machine computes the same bits.
pub(super) type Lanes = f32x4;

/// Four vectors, component by component, as they follow each other in an array.
///
/// Six shuffles that use every lane of both operands: compilers leave these alone and browsers have one instruction for each.
#[inline(always)]
fn interleave([x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
    let (xy, yz, zx) = (shuffle::<0, 2, 4, 6>(x, y), shuffle::<1, 3, 5, 7>(y, z), shuffle::<0, 2, 5, 7>(z, x));
    in_order(xy, yz, zx)
}

/// Lanes `A` to `D` of the eight of both.
#[inline(always)]
fn shuffle<const A: usize, const B: usize, const C: usize, const D: usize>(a: Lanes, b: Lanes) -> Lanes {
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    {
        // Casts and one instruction: taking arrays apart and together again lets the compiler find shuffles of its own, which browsers translate badly.
        use core::arch::wasm32::{i32x4_shuffle, v128};
        let (a, b) = (bytemuck::cast::<Lanes, v128>(a), bytemuck::cast::<Lanes, v128>(b));
        bytemuck::cast(i32x4_shuffle::<A, B, C, D>(a, b))
    }
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    {
        let ([a, b, c, d], [e, f, g, h]) = (a.to_array(), b.to_array());
        let both = [a, b, c, d, e, f, g, h];
        Lanes::new([both[A], both[B], both[C], both[D]])
    }
}

/// The same with the order of the four columns turned round, at no more cost.
#[inline(always)]
fn interleave_reversed([x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
    let (xy, yz, zx) = (shuffle::<3, 1, 7, 5>(x, y), shuffle::<2, 0, 6, 4>(y, z), shuffle::<3, 1, 6, 4>(z, x));
    in_order(xy, yz, zx)
}

/// From columns 0 and 2 of x and y, 1 and 3 of y and z, 0 and 2 of z with 1 and 3 of x.
#[inline(always)]
fn in_order(xy: Lanes, yz: Lanes, zx: Lanes) -> [Lanes; 3] {
    [shuffle::<0, 2, 4, 6>(xy, zx), shuffle::<0, 2, 5, 7>(yz, xy), shuffle::<1, 3, 5, 7>(zx, yz)]
}

/// Writes the vectors of four columns from vertex `at` on, where there is room for them all.
#[inline(always)]
pub(super) fn write(vectors: [Lanes; 3], to: &mut [f32], at: usize) {
    put(interleave(vectors), to, at);
}

/// As [`write`], with the order of the four columns turned round.
#[inline(always)]
pub(super) fn write_reversed(vectors: [Lanes; 3], to: &mut [f32], at: usize) {
    put(interleave_reversed(vectors), to, at);
}

/// Nothing is called otherwise, not even to fail: browsers would keep every register of the loop round it in memory.
#[inline(always)]
fn put([a, b, c]: [Lanes; 3], to: &mut [f32], at: usize) {
    if let Some(to) = to.get_mut(3 * at..3 * at + 12).and_then(|to| to.as_mut_array::<12>()) {
        to[0..4].copy_from_slice(a.as_array());
        to[4..8].copy_from_slice(b.as_array());
        to[8..12].copy_from_slice(c.as_array());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_follow_each_other() {
        let component = |c: f32| Lanes::new([c, c + 1.0, c + 2.0, c + 3.0]);
        let vectors = [component(10.0), component(20.0), component(30.0)];
        let expected = [10.0, 20.0, 30.0, 11.0, 21.0, 31.0, 12.0, 22.0, 32.0, 13.0, 23.0, 33.0];
        let mut to = [0.0; 15];
        write(vectors, &mut to, 1);
        assert_eq!(to[3..], expected);
        write_reversed(vectors, &mut to, 0);
        assert_eq!(to[..6], [13.0, 23.0, 33.0, 12.0, 22.0, 32.0]);
        let mut short = [0.0; 14];
        write(vectors, &mut short, 1);
        assert_eq!(short, [0.0; 14]);
    }
}
