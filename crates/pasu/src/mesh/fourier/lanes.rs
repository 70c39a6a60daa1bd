//! Four columns at a time in single precision.

use wide::f32x4;

/// A quantity at four columns. Lane by lane its arithmetic is that of `f32`, whatever the instructions, so that every machine computes the same bits.
pub(super) type Lanes = f32x4;

/// Two lanes of one operand and two of the other, numbered from 0 to 3 and from 4 to 7: one instruction.
///
/// Taking arrays apart and together again lets the compiler find shuffles of its own, which browsers translate badly; on a processor of which it knows no
/// more than SSE2 it writes number by number instead, and a mesh of few modes takes three times as long.
macro_rules! shuffle {
    ($a:expr, $b:expr, [$first:literal, $second:literal, $third:literal, $fourth:literal]) => {{
        let (a, b): (Lanes, Lanes) = ($a, $b);
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        {
            use core::arch::wasm32::{i32x4_shuffle, v128};
            let (a, b) = (bytemuck::cast::<Lanes, v128>(a), bytemuck::cast::<Lanes, v128>(b));
            bytemuck::cast::<v128, Lanes>(i32x4_shuffle::<$first, $second, $third, $fourth>(a, b))
        }
        #[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
        {
            use safe_arch::{m128, shuffle_abi_f32_all_m128};
            const WHICH: i32 = $first | $second << 2 | ($third - 4) << 4 | ($fourth - 4) << 6;
            let (a, b) = (bytemuck::cast::<Lanes, m128>(a), bytemuck::cast::<Lanes, m128>(b));
            bytemuck::cast::<m128, Lanes>(shuffle_abi_f32_all_m128::<WHICH>(a, b))
        }
        #[cfg(not(any(
            all(target_arch = "wasm32", target_feature = "simd128"),
            all(target_arch = "x86_64", target_feature = "sse")
        )))]
        {
            let ([a, b, c, d], [e, f, g, h]) = (a.to_array(), b.to_array());
            let both = [a, b, c, d, e, f, g, h];
            Lanes::new([both[$first], both[$second], both[$third], both[$fourth]])
        }
    }};
}

/// Four vectors, component by component, as they follow each other in an array.
///
/// Six shuffles that use every lane of both operands: compilers leave these alone and browsers have one instruction for each.
#[inline(always)]
fn interleave([x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
    in_order(shuffle!(x, y, [0, 2, 4, 6]), shuffle!(y, z, [1, 3, 5, 7]), shuffle!(z, x, [0, 2, 5, 7]))
}

/// The same with the order of the four columns turned round, at no more cost.
#[inline(always)]
fn interleave_reversed([x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
    in_order(shuffle!(x, y, [3, 1, 7, 5]), shuffle!(y, z, [2, 0, 6, 4]), shuffle!(z, x, [3, 1, 6, 4]))
}

/// From columns 0 and 2 of x and y, 1 and 3 of y and z, 0 and 2 of z with 1 and 3 of x.
#[inline(always)]
fn in_order(xy: Lanes, yz: Lanes, zx: Lanes) -> [Lanes; 3] {
    [shuffle!(xy, zx, [0, 2, 4, 6]), shuffle!(yz, xy, [0, 2, 5, 7]), shuffle!(zx, yz, [1, 3, 5, 7])]
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
