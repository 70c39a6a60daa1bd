//! Four columns of a row, and those that share their sums.

use super::form::{Form, Task};
use super::lanes::{Lanes, write, write_reversed};
use super::watch::Watch;

/// The columns from `column` on, and no others.
#[inline(always)]
pub(super) fn open_block<F: Form, W: Watch>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 4] {
    let here = task.place(&layout.here(layout.form(0..circles.len(), circles)));
    write(here.position, positions, column);
    write(here.normal, normals, column);
    [here.seen, W::SURE, W::SURE, W::SURE]
}

/// Those, the ones at `-v` and both half a turn on.
#[inline(always)]
pub(super) fn quartered_block<F: Form, W: Watch>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 4] {
    let even = layout.form(0..task.n_even, circles);
    let odd = layout.form(task.n_even..circles.len(), circles);
    let (all, half) = (task.n_steps, task.n_steps / 2);
    let first = two_blocks(task, layout, F::added(even, odd), [column, all - column - 3], positions, normals);
    // Half a turn on and mirrored is mirrored and half a turn back.
    let second =
        two_blocks(task, layout, F::subtracted(even, odd), [column + half, half - column - 3], positions, normals);
    [first[0], first[1], second[0], second[1]]
}

/// The columns that the sums are of, and those that mirror them.
#[inline(always)]
fn two_blocks<F: Form, W: Watch>(
    task: &Task,
    layout: &F,
    formed: F::Formed,
    [to, mirrored_to]: [usize; 2],
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 2] {
    let [here, there] = layout.pair(task, formed);
    write(here.position, positions, to);
    write(here.normal, normals, to);
    write_reversed(there.position, positions, mirrored_to);
    write_reversed(there.normal, normals, mirrored_to);
    [here.seen, there.seen]
}

/// The same where every `n` is odd and `z` is constant: half a turn on, the sums have the other sign.
#[inline(always)]
pub(super) fn turned_block<F: Form, W: Watch>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [W; 4] {
    let half = task.n_steps / 2;
    let [here, there] = layout.pair(task, layout.form(0..circles.len(), circles));
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
