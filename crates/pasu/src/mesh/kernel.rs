//! One row of a mesh in single precision.
//!
//! A vertex is a sum of products of a row's coefficients with a column's cosines and sines. Where every `n` is whole, columns `v` and `-v` have the same sums but for the
//! sign of the sines, and columns half a turn apart but for the sign of the odd `n`: up to four columns are had from one set of sums.

use super::coefficients::{Coefficients, Layout, Strand};
use super::lanes::{Lanes, write, write_reversed};
use crate::surface::Turns;

/// Which columns share their sums.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fold {
    /// None: the surface does not close, or there are too few columns.
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
    fold: Option<Fold>,
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
        self.fold = Some(fold);
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
            is_mirrored: coefficients.is_mirrored,
            is_turned: coefficients.is_turned,
        };
        let strands = coefficients.strands.as_slice();
        let any = match coefficients.layout {
            Layout::Split { z_is_sine } => {
                let parity = Lanes::splat(if z_is_sine { -1.0 } else { 1.0 });
                let form = |from: usize, to: usize, circles: &[[Lanes; 2]]| {
                    let sums = split_sums(&strands[from..to], &circles[from..to], row, z_is_sine);
                    let [[x, y, z], [xu, yu, zu], [xv, yv, zv]] = sums;
                    let mirrored = [[x, -y, z * parity], [xu, -yu, zu * parity], [-xv, yv, -zv * parity]];
                    [sums, mirrored]
                };
                self.fold(task, form, positions, normals)
            }
            Layout::Both => {
                let sine_strands = coefficients.sine_strands.as_slice();
                let form = |from: usize, to: usize, circles: &[[Lanes; 2]]| {
                    let even = sums::<false>(&strands[from..to], &circles[from..to], row);
                    let odd = sums::<true>(&sine_strands[from..to], &circles[from..to], row);
                    let mirrored = [minus(even[0], odd[0]), minus(even[1], odd[1]), minus(odd[2], even[2])];
                    [[plus(even[0], odd[0]), plus(even[1], odd[1]), plus(even[2], odd[2])], mirrored]
                };
                self.fold(task, form, positions, normals)
            }
        };
        if any != 0 {
            self.report(repair);
        }
        if self.fold != Some(Fold::Open) {
            // The seam has the same bits, down to the sign of 0.
            for array in [positions, normals] {
                let last = array.len() - 3;
                array.copy_within(0..3, last);
            }
        }
    }

    /// Forms the sums of each block and writes the columns that are had from them. Returns whether any normal is unsure.
    #[inline(always)]
    fn fold(
        &mut self,
        task: Task,
        form: impl Fn(usize, usize, &[[Lanes; 2]]) -> [Sums; 2],
        positions: &mut [f32],
        normals: &mut [f32],
    ) -> u8 {
        let (n, n_steps) = (self.n_harmonics, self.n_columns - 1);
        let half = n_steps / 2;
        let mut any = 0;
        for (block, unsure) in self.unsure.iter_mut().enumerate() {
            let column = 4 * block;
            let circles = self.pairs.get(block * n..block * n + n).unwrap_or_default();
            if self.fold != Some(Fold::Quartered) {
                let [here, mirrored] = form(0, n, circles);
                let (normal, bad) = task.normal(&here);
                write(task.position(&here), positions, column);
                write(normal, normals, column);
                *unsure = [bad, 0, 0, 0];
                if self.fold == Some(Fold::Mirrored) {
                    let to = n_steps - column - 3;
                    let (normal, bad) = task.mirrored_normal(&mirrored, (normal, bad));
                    write_reversed(task.position(&mirrored), positions, to);
                    write_reversed(normal, normals, to);
                    unsure[1] = bad;
                }
            } else {
                let odd = form(task.n_even, n, circles);
                let even = if task.n_even > 0 { form(0, task.n_even, circles) } else { [[[Lanes::ZERO; 3]; 3]; 2] };
                let (to, turned_to) = (column, column + half);
                let here = added(&even[0], &odd[0]);
                let first = task.normal(&here);
                write(task.position(&here), positions, to);
                write(first.0, normals, to);
                let there = subtracted(&even[0], &odd[0]);
                let turned = task.turned_normal(&there, first);
                write(task.position(&there), positions, turned_to);
                write(turned.0, normals, turned_to);
                let (to, turned_to) = (n_steps - column - 3, half - column - 3);
                let here = added(&even[1], &odd[1]);
                let mirrored = task.mirrored_normal(&here, first);
                write_reversed(task.position(&here), positions, to);
                write_reversed(mirrored.0, normals, to);
                let there = subtracted(&even[1], &odd[1]);
                let both = if task.is_mirrored {
                    task.mirrored_normal(&there, turned)
                } else {
                    task.turned_normal(&there, mirrored)
                };
                write_reversed(task.position(&there), positions, turned_to);
                write_reversed(both.0, normals, turned_to);
                *unsure = [first.1, turned.1, mirrored.1, both.1];
            }
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
                        (Some(Fold::Quartered), 1) => column + n_steps / 2,
                        (Some(Fold::Quartered), 2) | (Some(Fold::Mirrored), 1) => n_steps - column,
                        (Some(Fold::Quartered), 3) => n_steps / 2 - column,
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

/// What all blocks of a row share.
#[derive(Clone, Copy)]
struct Task {
    constant: [[Lanes; 2]; 3],
    tilt: [Lanes; 2],
    sign: Lanes,
    n_even: usize,
    is_mirrored: bool,
    is_turned: bool,
}

impl Task {
    #[inline(always)]
    fn position(&self, sums: &Sums) -> [Lanes; 3] {
        let [[x, _], [y, _], [z, _]] = self.constant;
        plus([x, y, z], sums[0])
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

    /// The same half a turn on.
    #[inline(always)]
    fn turned_normal(&self, sums: &Sums, (normal, unsure): ([Lanes; 3], u8)) -> ([Lanes; 3], u8) {
        if self.is_turned { ([-normal[0], -normal[1], normal[2]], unsure) } else { self.normal(sums) }
    }
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
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row]);
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
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row]);
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
