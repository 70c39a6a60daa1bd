//! Rows of which a component has both cosines and sines, where four columns share their sums.
//!
//! Sums of cosines and of sines, of even `n` and of odd `n`, are four times nine numbers at a time, and their arithmetic nine for each of the four columns: more than there are registers. So each
//! component is summed by itself, over some blocks of columns, into memory that stays in the first cache; positions and normals are made of that, column by column. What is
//! written to the mesh then waits for memory while the next sums are formed.

use super::block::quarter;
use super::doubt::{EachNormal, WholeRow};
use super::lanes::{Lanes, write, write_reversed};
use super::place::Task;
use super::strands::Strands;
use super::sums::Sums;

/// Blocks that are summed before they are written: 5 kB.
const WAITING: usize = 8;

/// What a harmonic adds to one component, the same in all lanes: to position, `X_u` and `X_v` with its cosine, then with its sine.
type Pair = [Lanes; 6];

/// The sums at `v` and `-v`, then those half a turn on.
type Quarter = [Sums; 4];

/// What the columns of one row are summed from, component by component, and the blocks that wait.
#[derive(Debug, Default)]
pub(super) struct Quarters {
    pairs: [Vec<Pair>; 3],
    waiting: Vec<Quarter>,
}

impl Quarters {
    /// Takes another surface: a component without waves has sums of 0 once for all.
    pub(super) fn prepare(&mut self) {
        self.waiting.clear();
        self.waiting.resize(WAITING, [[[Lanes::ZERO; 3]; 3]; 4]);
    }

    /// Takes one of four rows.
    #[inline(never)]
    pub(super) fn take(&mut self, strands: &Strands, row: usize) {
        for (axis, pairs) in self.pairs.iter_mut().enumerate() {
            pairs.clear();
            if strands.is_wavy[axis] {
                pairs.extend(strands.strands.iter().zip(&strands.sine_strands).map(|(cosine, sine)| {
                    let at = |lanes: Lanes| Lanes::splat(lanes.as_array()[row & 3]);
                    let ([a, b, c], [d, e, f]) = (cosine[axis].map(at), sine[axis].map(at));
                    [a, b, c, d, e, f]
                }));
            }
        }
    }

    /// Writes all columns of the row but the last, given cosine and sine of all harmonics, block by block; notes which normals are unsure, and says whether none is.
    pub(super) fn write(
        &mut self,
        task: &Task,
        circles: &[[Lanes; 2]],
        n_harmonics: usize,
        unsure: &mut [[u8; 4]],
        positions: &mut [f32],
        normals: &mut [f32],
    ) -> bool {
        let Quarters { pairs: [x, y, z], waiting } = self;
        let mut is_sure = true;
        for (index, unsure) in unsure.chunks_mut(WAITING).enumerate() {
            let circles = circles.get(index * WAITING * n_harmonics..).unwrap_or_default();
            component::<0>(task.n_even, x, circles, waiting);
            component::<1>(task.n_even, y, circles, waiting);
            component::<2>(task.n_even, z, circles, waiting);
            if !combine(task, waiting, 4 * WAITING * index, unsure, positions, normals) {
                is_sure &= look_again(task, waiting, unsure);
            }
        }
        is_sure
    }
}

/// The sums of one component at as many blocks as may wait, or as there are.
#[inline(never)]
fn component<const AXIS: usize>(n_even: usize, pairs: &[Pair], circles: &[[Lanes; 2]], waiting: &mut [Quarter]) {
    let n = pairs.len();
    // Without waves the sums stay 0.
    if n == 0 {
        return;
    }
    let (even_pairs, odd_pairs) = pairs.split_at(n_even.min(n));
    for (circles, to) in circles.chunks_exact(n).zip(waiting) {
        let (even_circles, odd_circles) = circles.split_at(even_pairs.len());
        let even = part(even_pairs, even_circles);
        let odd = part(odd_pairs, odd_circles);
        // Half a turn on, odd `n` have the other sign; at `-v` have it the sines in position and `X_u`, and the cosines, which have become sines there, in `X_v`.
        for (quantity, (kept, turned)) in [(0, 3), (1, 4), (5, 2)].into_iter().enumerate() {
            let (a, b) = (even[kept] + odd[kept], even[turned] + odd[turned]);
            let (c, d) = (even[kept] - odd[kept], even[turned] - odd[turned]);
            for (to, sum) in to.iter_mut().zip([a + b, a - b, c + d, c - d]) {
                to[quantity][AXIS] = sum;
            }
        }
    }
}

/// The sums of some harmonics, in the order of [`Pair`].
///
/// A rolled loop over named sums: with sums in arrays, or the loop unrolled, compilers keep them in memory. The first products are where the sums start.
#[inline(always)]
fn part(pairs: &[Pair], circles: &[[Lanes; 2]]) -> [Lanes; 6] {
    let mut both = pairs.iter().zip(circles);
    let Some((pair, &[cos, sin])) = both.next() else { return [Lanes::ZERO; 6] };
    let (mut x, mut xu, mut xv) = (cos * pair[0], cos * pair[1], sin * pair[2]);
    let (mut y, mut yu, mut yv) = (sin * pair[3], sin * pair[4], cos * pair[5]);
    for (pair, &[cos, sin]) in both {
        x += cos * pair[0];
        xu += cos * pair[1];
        xv += sin * pair[2];
        y += sin * pair[3];
        yu += sin * pair[4];
        yv += cos * pair[5];
    }
    [x, xu, xv, y, yu, yv]
}

/// Positions and normals of the blocks from column `first` on; notes the lanes whose normal is so short that it could be unsure, and says whether none is.
#[inline(never)]
fn combine(
    task: &Task,
    waiting: &[Quarter],
    first: usize,
    unsure: &mut [[u8; 4]],
    positions: &mut [f32],
    normals: &mut [f32],
) -> bool {
    // A copy of its own, which no write through another reference can change.
    let task = *task;
    let mut any = 0;
    for (index, ([a, b, c, d], unsure)) in waiting.iter().zip(unsure).enumerate() {
        let [to, turned_to] = quarter(task.n_steps, first + 4 * index);
        let near = written(&task, a, to[0], write, positions, normals);
        let near_mirrored = written(&task, b, to[1], write_reversed, positions, normals);
        let far = written(&task, c, turned_to[0], write, positions, normals);
        let far_mirrored = written(&task, d, turned_to[1], write_reversed, positions, normals);
        *unsure = [near, near_mirrored, far, far_mirrored].map(WholeRow::short_lanes);
        any |= u32::from_ne_bytes(*unsure);
    }
    any == 0
}

/// Writes four columns with `write`, the position before the normal is formed: what waits for the other would leave the registers.
#[inline(always)]
fn written(
    task: &Task,
    sums: &Sums,
    to: usize,
    write: impl Fn([Lanes; 3], &mut [f32], usize),
    positions: &mut [f32],
    normals: &mut [f32],
) -> WholeRow {
    write(task.position(sums), positions, to);
    let (normal, seen) = task.normal(sums);
    write(normal, normals, to);
    seen
}

/// Asks the normals that were noted; says whether all are sure.
///
/// Not while they are written: few blocks are asked, and what is seldom done in a loop costs it registers.
#[inline(never)]
fn look_again(task: &Task, waiting: &[Quarter], unsure: &mut [[u8; 4]]) -> bool {
    let noted = waiting.iter().zip(unsure).flat_map(|(quarter, unsure)| quarter.iter().zip(unsure));
    let mut any = 0;
    for (sums, unsure) in noted.filter(|(_, unsure)| **unsure != 0) {
        *unsure = task.normal::<EachNormal>(sums).1.lanes();
        any |= *unsure;
    }
    any == 0
}
