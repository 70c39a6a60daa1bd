//! Four columns of a row, and those that share their sums.

use super::doubt::Doubt;
use super::lanes::{Lanes, write, write_reversed};
use super::place::{Place, Task};
use super::split::Split;
use super::strands::Strand;
use super::sums::{added, subtracted, sums};

/// The strands of the cosines and those of the sines, of all components.
pub(super) struct Both<'a> {
    pub(super) strands: &'a [[Strand; 3]],
    pub(super) sine_strands: &'a [[Strand; 3]],
    pub(super) row: usize,
}

/// The columns from `column` on, and no others.
#[inline(always)]
pub(super) fn open_block<W: Doubt>(
    task: &Task,
    both: &Both,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 4] {
    let cosines = sums::<false>(both.strands, circles, both.row);
    let sines = sums::<true>(both.sine_strands, circles, both.row);
    let here = task.place(&added(&cosines, &sines));
    write(here.position, positions, column);
    write(here.normal, normals, column);
    [here.seen, W::SURE, W::SURE, W::SURE]
}

/// Those, the ones at `-v` and both half a turn on.
#[inline(always)]
pub(super) fn quartered_block<const Z_IS_SINE: bool, W: Doubt>(
    task: &Task,
    split: &Split<Z_IS_SINE>,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 4] {
    let even = split.form(0..task.n_even, circles);
    let odd = split.form(task.n_even..circles.len(), circles);
    let [first, second] = quarter(task.n_steps, column);
    let first = two_blocks(split.pair(task, added(&even, &odd)), first, positions, normals);
    let second = two_blocks(split.pair(task, subtracted(&even, &odd)), second, positions, normals);
    [first[0], first[1], second[0], second[1]]
}

/// Where the columns from `column` on are that share their sums: those and, from the last to the first, the ones that mirror them; then both half a turn on, where mirrored is
/// half a turn back.
#[inline(always)]
pub(super) fn quarter(n_steps: usize, column: usize) -> [[usize; 2]; 2] {
    let half = n_steps / 2;
    [[column, n_steps - column - 3], [column + half, half - column - 3]]
}

/// Writes four columns and those that mirror them.
#[inline(always)]
pub(super) fn two_blocks<W: Doubt>(
    [here, there]: [Place<W>; 2],
    [to, mirrored_to]: [usize; 2],
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 2] {
    write(here.position, positions, to);
    write(here.normal, normals, to);
    write_reversed(there.position, positions, mirrored_to);
    write_reversed(there.normal, normals, mirrored_to);
    [here.seen, there.seen]
}

/// The same where every `n` is odd and `z` is constant: half a turn on, the sums have the other sign.
#[inline(always)]
pub(super) fn turned_block<W: Doubt>(
    task: &Task,
    split: &Split<false>,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 4] {
    let half = task.n_steps / 2;
    let [here, there] = split.pair(task, split.form(0..circles.len(), circles));
    write(here.position, positions, column);
    write(here.normal, normals, column);
    write(task.turned_position(here.position), positions, column + half);
    write(turned(here.normal), normals, column + half);
    let (to, turned_to) = (task.n_steps - column - 3, half - column - 3);
    write_reversed(there.position, positions, to);
    write_reversed(there.normal, normals, to);
    write_reversed(task.turned_position(there.position), positions, turned_to);
    write_reversed(turned(there.normal), normals, turned_to);
    [here.seen, there.seen, here.seen, there.seen]
}

/// A normal half a turn on.
#[inline(always)]
fn turned([x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
    [-x, -y, z]
}
