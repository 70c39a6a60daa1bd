//! One row of a mesh in single precision.
//!
//! A vertex is a sum of products of a row's coefficients with a column's cosines and sines. Where every `n` is whole, columns `v` and `-v` have the same sums but for the
//! sign of the sines, and columns half a turn apart but for the sign of the odd `n`: up to four columns are had from one set of sums.

use core::ops::Range;

use super::coefficients::{Coefficients, Layout, Strand};
use super::lanes::{Lanes, write, write_reversed};
use crate::surface::Turns;

/// Which columns share their sums.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Fold {
    /// None: the surface does not close, or there are too few columns.
    #[default]
    Open,
    /// `v` and `-v`.
    Mirrored,
    /// `v`, `-v` and both half a turn on.
    Quartered,
}

/// The fewest steps round the axis for which no block of a folded row reaches over the end of it.
const LEAST_FOLDED: usize = 12;

/// Cosines and sines of the columns whose sums are formed, four at a time.
#[derive(Debug, Default)]
pub(super) struct Circles {
    fold: Fold,
    n_columns: usize,
    /// Block by block, cosine and sine of each harmonic.
    pairs: Vec<[Lanes; 2]>,
    n_harmonics: usize,
    /// For the columns of each block and those that share their sums, the lanes whose normals single precision does not hold.
    unsure: Vec<[u8; 4]>,
}

/// Position, `X_u` and `X_v` at four columns, component by component.
type Sums = [[Lanes; 3]; 3];

impl Circles {
    /// Makes the tables for a number of columns.
    pub(super) fn prepare(&mut self, coefficients: &Coefficients, is_closed: bool, turns: &Turns, n_columns: usize) {
        let n_steps = n_columns - 1;
        let fold = if !is_closed || n_steps < LEAST_FOLDED {
            Fold::Open
        } else if n_steps % 2 == 1 {
            Fold::Mirrored
        } else {
            Fold::Quartered
        };
        let n_formed = match fold {
            Fold::Open => n_columns,
            Fold::Mirrored => n_steps / 2 + 1,
            Fold::Quartered => n_steps / 4 + 1,
        };
        let n_blocks = n_formed.div_ceil(4);
        self.n_harmonics = coefficients.harmonics.len();
        self.n_columns = n_columns;
        self.fold = fold;
        self.pairs.clear();
        self.pairs.resize(n_blocks * self.n_harmonics, [Lanes::ZERO; 2]);
        self.unsure.clear();
        self.unsure.resize(n_blocks, [0; 4]);
        for (index, harmonic) in coefficients.harmonics.iter().enumerate() {
            let mut walk = turns.walk(harmonic.n);
            for pair in self.pairs.iter_mut().skip(index).step_by(self.n_harmonics) {
                let lanes: [(f64, f64); 4] = core::array::from_fn(|_| walk.next().unwrap_or((1.0, 0.0)));
                *pair = [lanes.map(|(cos, _)| cos as f32).into(), lanes.map(|(_, sin)| sin as f32).into()];
            }
        }
    }

    /// Writes positions and unit normals of one of the four rows, normals times `sign`; calls `repair` with every column whose normal single precision does not hold.
    #[inline(never)]
    pub(super) fn row(
        &mut self,
        coefficients: &Coefficients,
        row: usize,
        sign: f32,
        positions: &mut [f32],
        normals: &mut [f32],
        repair: impl FnMut(usize),
    ) {
        let (n_even, row) = (coefficients.n_even, row & 3);
        let at = |lanes: Lanes| Lanes::splat(lanes.to_array()[row]);
        let task = Task {
            constant: coefficients.constant.map(|pair| pair.map(at)),
            tilt: coefficients.tilt.map(at),
            sign: Lanes::splat(sign),
            n_even,
            n_steps: self.n_columns - 1,
            is_mirrored: coefficients.is_mirrored,
            is_turned: coefficients.is_turned,
        };
        let strands = coefficients.strands.as_slice();
        let any = match coefficients.layout {
            Layout::Split { z_is_sine } => {
                let z_parity = Lanes::splat(if z_is_sine { -1.0 } else { 1.0 });
                self.fold(task, &Split { strands, row, z_is_sine, z_parity }, positions, normals)
            }
            Layout::Both => {
                let sine_strands = coefficients.sine_strands.as_slice();
                self.fold(task, &Both { strands, sine_strands, row }, positions, normals)
            }
        };
        if any != 0 {
            self.report(repair);
        }
        if self.fold != Fold::Open {
            // The seam has the same bits, down to the sign of 0.
            for array in [positions, normals] {
                let last = array.len() - 3;
                array.copy_within(0..3, last);
            }
        }
    }

    /// Forms the sums of each block and writes the columns that are had from them. Returns whether any normal is unsure.
    fn fold(&mut self, task: Task, layout: &impl Form, positions: &mut [f32], normals: &mut [f32]) -> u8 {
        match self.fold {
            Fold::Quartered if task.is_turned => self.each_block(task, layout, positions, normals, turned_block),
            Fold::Quartered => self.each_block(task, layout, positions, normals, quartered_block),
            Fold::Mirrored => self.each_block(task, layout, positions, normals, mirrored_block),
            Fold::Open => self.each_block(task, layout, positions, normals, open_block),
        }
    }

    /// Every kind of fold and layout is a function of its own: in one large function browsers run out of registers.
    #[inline(never)]
    fn each_block<F: Form>(
        &mut self,
        task: Task,
        layout: &F,
        positions: &mut [f32],
        normals: &mut [f32],
        block: impl Fn(&Task, &F, &[[Lanes; 2]], usize, &mut [f32], &mut [f32]) -> [u8; 4],
    ) -> u8 {
        let n = self.n_harmonics;
        let mut any = 0;
        for (index, unsure) in self.unsure.iter_mut().enumerate() {
            let circles = self.pairs.get(index * n..index * n + n).unwrap_or_default();
            *unsure = block(&task, layout, circles, 4 * index, positions, normals);
            any |= unsure[0] | unsure[1] | unsure[2] | unsure[3];
        }
        any
    }

    /// The columns of the lanes that were found unsure.
    fn report(&self, mut repair: impl FnMut(usize)) {
        let n_steps = self.n_columns - 1;
        for (block, unsure) in self.unsure.iter().enumerate() {
            for (slot, lanes) in unsure.iter().enumerate() {
                for lane in (0..4).filter(|lane| lanes >> lane & 1 == 1) {
                    let column = 4 * block + lane;
                    let column = match (self.fold, slot) {
                        (Fold::Quartered, 1) => column + n_steps / 2,
                        (Fold::Quartered, 2) | (Fold::Mirrored, 1) => n_steps - column,
                        (Fold::Quartered, 3) => n_steps / 2 - column,
                        _ => column,
                    };
                    if column <= n_steps {
                        repair(column);
                    }
                }
            }
        }
    }
}

/// How the sums of some of the harmonics are formed.
trait Form {
    /// At `v` and at `-v`. Every implementation is inlined into its loop over the columns, or the sums would go through memory.
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> [Sums; 2];
}

/// As [`Layout::Split`].
struct Split<'a> {
    strands: &'a [[Strand; 3]],
    row: usize,
    z_is_sine: bool,
    /// What becomes of the sums of `z` at `-v`.
    z_parity: Lanes,
}

impl Form for Split<'_> {
    #[inline(always)]
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> [Sums; 2] {
        let strands = self.strands.get(harmonics.clone()).unwrap_or_default();
        let sums = split_sums(strands, circles.get(harmonics).unwrap_or_default(), self.row, self.z_is_sine);
        let [[x, y, z], [xu, yu, zu], [xv, yv, zv]] = sums;
        [sums, [[x, -y, z * self.z_parity], [xu, -yu, zu * self.z_parity], [-xv, yv, -zv * self.z_parity]]]
    }
}

/// As [`Layout::Both`].
struct Both<'a> {
    strands: &'a [[Strand; 3]],
    sine_strands: &'a [[Strand; 3]],
    row: usize,
}

impl Form for Both<'_> {
    #[inline(always)]
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> [Sums; 2] {
        let circles = circles.get(harmonics.clone()).unwrap_or_default();
        let even = sums::<false>(self.strands.get(harmonics.clone()).unwrap_or_default(), circles, self.row);
        let odd = sums::<true>(self.sine_strands.get(harmonics).unwrap_or_default(), circles, self.row);
        let mirrored = [minus(even[0], odd[0]), minus(even[1], odd[1]), minus(odd[2], even[2])];
        [added(&even, &odd), mirrored]
    }
}

/// What all blocks of a row share.
#[derive(Clone, Copy)]
struct Task {
    constant: [[Lanes; 2]; 3],
    tilt: [Lanes; 2],
    sign: Lanes,
    n_even: usize,
    n_steps: usize,
    is_mirrored: bool,
    is_turned: bool,
}

impl Task {
    #[inline(always)]
    fn position(&self, sums: &Sums) -> [Lanes; 3] {
        let [[x, _], [y, _], [z, _]] = self.constant;
        plus([x, y, z], sums[0])
    }

    /// The position half a turn on, where the sums have the other sign and `z` has none.
    #[inline(always)]
    fn turned_position(&self, sums: &Sums) -> [Lanes; 3] {
        let [[x, _], [y, _], [z, _]] = self.constant;
        [x - sums[0][0], y - sums[0][1], z]
    }

    /// The unit normal along `X_u x X_v` and the lanes that single precision does not hold, as bits.
    #[inline(always)]
    fn normal(&self, sums: &Sums) -> ([Lanes; 3], u8) {
        let [[_, xu], [_, yu], [_, zu]] = self.constant;
        let [ux, uy, uz] = plus([xu, yu, zu], sums[1]);
        let [vx, vy, vz] = sums[2];
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let tilted = self.tilt[0] * (vx * vx + vy * vy + vz * vz) + self.tilt[1] * (ux * ux + uy * uy + uz * uz);
        let inverse = self.sign / squared.sqrt();
        (normal.map(|component| component * inverse), unsure(tilted, squared))
    }

    /// The same at `-v`.
    #[inline(always)]
    fn mirrored_normal(&self, sums: &Sums, (normal, unsure): ([Lanes; 3], u8)) -> ([Lanes; 3], u8) {
        if self.is_mirrored { ([normal[0], -normal[1], normal[2]], unsure) } else { self.normal(sums) }
    }
}

/// The columns from `column` on, and no others.
#[inline(always)]
fn open_block<F: Form>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [u8; 4] {
    let [here, _] = layout.form(0..circles.len(), circles);
    let first = task.normal(&here);
    write(task.position(&here), positions, column);
    write(first.0, normals, column);
    [first.1, 0, 0, 0]
}

/// Those and the ones at `-v`.
#[inline(always)]
fn mirrored_block<F: Form>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [u8; 4] {
    let [here, mirrored] = layout.form(0..circles.len(), circles);
    let first = task.normal(&here);
    write(task.position(&here), positions, column);
    write(first.0, normals, column);
    let to = task.n_steps - column - 3;
    let second = task.mirrored_normal(&mirrored, first);
    write_reversed(task.position(&mirrored), positions, to);
    write_reversed(second.0, normals, to);
    [first.1, second.1, 0, 0]
}

/// Those and the ones half a turn on.
#[inline(always)]
fn quartered_block<F: Form>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [u8; 4] {
    let half = task.n_steps / 2;
    let odd = layout.form(task.n_even..circles.len(), circles);
    let even = layout.form(0..task.n_even, circles);
    let here = added(&even[0], &odd[0]);
    let first = task.normal(&here);
    write(task.position(&here), positions, column);
    write(first.0, normals, column);
    let there = subtracted(&even[0], &odd[0]);
    let turned = task.normal(&there);
    write(task.position(&there), positions, column + half);
    write(turned.0, normals, column + half);
    let (to, turned_to) = (task.n_steps - column - 3, half - column - 3);
    let here = added(&even[1], &odd[1]);
    let second = task.mirrored_normal(&here, first);
    write_reversed(task.position(&here), positions, to);
    write_reversed(second.0, normals, to);
    let there = subtracted(&even[1], &odd[1]);
    let both = task.mirrored_normal(&there, turned);
    write_reversed(task.position(&there), positions, turned_to);
    write_reversed(both.0, normals, turned_to);
    [first.1, turned.1, second.1, both.1]
}

/// The same where every `n` is odd and `z` is constant: half a turn on, the sums have the other sign.
#[inline(always)]
fn turned_block<F: Form>(
    task: &Task,
    layout: &F,
    circles: &[[Lanes; 2]],
    column: usize,
    positions: &mut [f32],
    normals: &mut [f32],
) -> [u8; 4] {
    let half = task.n_steps / 2;
    let [here, mirrored] = layout.form(0..circles.len(), circles);
    let first = task.normal(&here);
    write(task.position(&here), positions, column);
    write(first.0, normals, column);
    write(task.turned_position(&here), positions, column + half);
    write(turned(first.0), normals, column + half);
    let (to, turned_to) = (task.n_steps - column - 3, half - column - 3);
    let second = task.mirrored_normal(&mirrored, first);
    write_reversed(task.position(&mirrored), positions, to);
    write_reversed(second.0, normals, to);
    write_reversed(task.turned_position(&mirrored), positions, turned_to);
    write_reversed(turned(second.0), normals, turned_to);
    [first.1, first.1, second.1, second.1]
}

/// A normal half a turn on.
#[inline(always)]
fn turned([x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
    [-x, -y, z]
}

#[inline(always)]
fn added(a: &Sums, b: &Sums) -> Sums {
    [plus(a[0], b[0]), plus(a[1], b[1]), plus(a[2], b[2])]
}

#[inline(always)]
fn subtracted(a: &Sums, b: &Sums) -> Sums {
    [minus(a[0], b[0]), minus(a[1], b[1]), minus(a[2], b[2])]
}

#[inline(always)]
fn unsure(tilted: Lanes, squared: Lanes) -> u8 {
    // Not the other way round: what is not a number is unsure too.
    !(tilted.simd_lt(squared).to_bitmask() as u8) & 15
}

#[inline(always)]
fn plus(a: [Lanes; 3], b: [Lanes; 3]) -> [Lanes; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn minus(a: [Lanes; 3], b: [Lanes; 3]) -> [Lanes; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The sums of strands that all go with cosines, or all with sines.
///
/// A rolled loop over named sums: with sums in arrays, or the loop unrolled, compilers keep them in memory.
#[inline(always)]
fn sums<const SINE: bool>(strands: &[[Strand; 3]], circles: &[[Lanes; 2]], row: usize) -> Sums {
    let (mut x, mut xu, mut xv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (mut y, mut yu, mut yv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (mut z, mut zu, mut zv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    for (strand, &[cos, sin]) in strands.iter().zip(circles) {
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row & 3]);
        let (a, b) = if SINE { (sin, cos) } else { (cos, sin) };
        x += a * at(0, 0);
        xu += a * at(0, 1);
        xv += b * at(0, 2);
        y += a * at(1, 0);
        yu += a * at(1, 1);
        yv += b * at(1, 2);
        z += a * at(2, 0);
        zu += a * at(2, 1);
        zv += b * at(2, 2);
    }
    [[x, y, z], [xu, yu, zu], [xv, yv, zv]]
}

/// The sums of strands that go with cosines in `x`, with sines in `y`, and with either in `z`.
#[inline(always)]
fn split_sums(strands: &[[Strand; 3]], circles: &[[Lanes; 2]], row: usize, z_is_sine: bool) -> Sums {
    let (mut x, mut xu, mut xv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (mut y, mut yu, mut yv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (mut z, mut zu, mut zv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (first, second) = (usize::from(z_is_sine), usize::from(!z_is_sine));
    for (strand, circle) in strands.iter().zip(circles) {
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row & 3]);
        let [cos, sin] = *circle;
        x += cos * at(0, 0);
        xu += cos * at(0, 1);
        xv += sin * at(0, 2);
        y += sin * at(1, 0);
        yu += sin * at(1, 1);
        yv += cos * at(1, 2);
        z += circle[first] * at(2, 0);
        zu += circle[first] * at(2, 1);
        zv += circle[second] * at(2, 2);
    }
    [[x, y, z], [xu, yu, zu], [xv, yv, zv]]
}
