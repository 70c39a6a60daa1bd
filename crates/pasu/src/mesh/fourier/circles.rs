//! One row of a mesh in single precision.
//!
//! A vertex is a sum of products of a row's coefficients with a column's cosines and sines. Where every `n` is whole, columns `v` and `-v` have the same sums but for the
//! sign of the sines, and columns half a turn apart but for the sign of the odd `n`: up to four columns are had from one set of sums.

use super::block::{Both, open_block, quartered_block, turned_block};
use super::doubt::{Doubt, EachNormal, Limits, WARY_ROWS, WholeRow};
use super::lanes::Lanes;
use super::place::Task;
use super::quarters::Quarters;
use super::split::Split;
use super::strands::{Layout, Strands};
use super::waves::Harmonic;
use crate::surface::Turns;

/// Which columns share their sums.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Fold {
    /// None: the surface does not close, or the number of steps round it is odd or very small.
    #[default]
    Open,
    /// `v`, `-v` and both half a turn on.
    Quartered,
}

/// The fewest steps round the axis for which no block of a folded row reaches over the end of it.
const LEAST_FOLDED: usize = 12;

/// Whether columns share their sums, as in [`Fold::Quartered`].
pub(super) fn folds(is_closed: bool, n_columns: usize) -> bool {
    let n_steps = n_columns - 1;
    is_closed && n_steps >= LEAST_FOLDED && n_steps.is_multiple_of(2)
}

/// Cosines and sines of the columns whose sums are formed, four at a time.
#[derive(Debug, Default)]
pub(super) struct Circles {
    fold: Fold,
    n_columns: usize,
    /// Block by block, cosine and sine of each harmonic.
    pairs: Vec<[Lanes; 2]>,
    n_harmonics: usize,
    /// For rows whose columns share sums of cosines and of sines.
    quarters: Quarters,
    /// For the columns of each block and those that share their sums, the lanes whose normals single precision does not hold.
    unsure: Vec<[u8; 4]>,
    /// How many more rows are to be asked normal by normal.
    n_wary: u32,
}

impl Circles {
    /// Makes the tables for a number of columns.
    pub(super) fn prepare(&mut self, harmonics: &[Harmonic], is_closed: bool, turns: &Turns, n_columns: usize) {
        let n_steps = n_columns - 1;
        let fold = if folds(is_closed, n_columns) { Fold::Quartered } else { Fold::Open };
        let n_formed = match fold {
            Fold::Open => n_columns,
            Fold::Quartered => n_steps / 4 + 1,
        };
        let n_blocks = n_formed.div_ceil(4);
        self.n_harmonics = harmonics.len();
        self.n_columns = n_columns;
        self.fold = fold;
        self.n_wary = 0;
        self.quarters.prepare();
        self.pairs.clear();
        self.pairs.resize(n_blocks * self.n_harmonics, [Lanes::ZERO; 2]);
        self.unsure.clear();
        self.unsure.resize(n_blocks, [0; 4]);
        for (index, harmonic) in harmonics.iter().enumerate() {
            let mut walk = turns.walk(harmonic.n);
            for pair in self.pairs.iter_mut().skip(index).step_by(self.n_harmonics) {
                let lanes: [(f64, f64); 4] = core::array::from_fn(|_| walk.next().unwrap_or((1.0, 0.0)));
                *pair = [lanes.map(|(cos, _)| cos as f32).into(), lanes.map(|(_, sin)| sin as f32).into()];
            }
        }
    }

    /// Writes positions and unit normals of one of the four rows, normals times `sign`; adds to `unsure` the columns whose normal single precision does not hold.
    #[inline(never)]
    pub(super) fn row(
        &mut self,
        strands: &Strands,
        row: usize,
        sign: f32,
        positions: &mut [f32],
        normals: &mut [f32],
        unsure: &mut Vec<usize>,
    ) {
        let row = row & 3;
        let at = |lanes: Lanes| Lanes::splat(lanes.to_array()[row]);
        let task = Task {
            constant: strands.constant.map(|pair| pair.map(at)),
            limits: Limits { tilt: strands.tilt.map(at), steepest: at(strands.steepest) },
            sign: Lanes::splat(sign),
            n_even: strands.n_even,
            n_steps: self.n_columns - 1,
        };
        let is_sure = self.write(strands, row, &task, positions, normals);
        if !is_sure {
            self.mark(unsure);
        }
        self.close(positions, normals);
    }

    /// Writes all columns of a row but the last of one that is folded, notes which normals are unsure, and says whether none is.
    fn write(
        &mut self,
        strands: &Strands,
        row: usize,
        task: &Task,
        positions: &mut [f32],
        normals: &mut [f32],
    ) -> bool {
        if (strands.layout, self.fold) == (Layout::Both, Fold::Quartered) {
            let Circles { quarters, pairs, unsure, n_harmonics, .. } = self;
            quarters.take(strands, row);
            return quarters.write(task, pairs, *n_harmonics, unsure, positions, normals);
        }
        // A row of which all normals are plainly sure need not ask it of each. Where one is not, rows near it are the same.
        if self.n_wary == 0 {
            if self.columns::<WholeRow>(strands, row, task, positions, normals) {
                return true;
            }
            self.n_wary = WARY_ROWS;
        }
        self.n_wary -= 1;
        self.columns::<EachNormal>(strands, row, task, positions, normals)
    }

    /// As [`Circles::write`], where a block is summed and written at once.
    fn columns<W: Doubt>(
        &mut self,
        strands: &Strands,
        row: usize,
        task: &Task,
        positions: &mut [f32],
        normals: &mut [f32],
    ) -> bool {
        let (cosines, sines) = (strands.strands.as_slice(), strands.sine_strands.as_slice());
        match (strands.layout, self.fold) {
            (Layout::Split { z_is_sine: true }, Fold::Quartered) => {
                let split = Split::<true> { strands: cosines, row };
                self.each_block(task, &split, positions, normals, quartered_block::<true, W>)
            }
            (Layout::Split { z_is_sine: false }, Fold::Quartered) => {
                let split = Split::<false> { strands: cosines, row };
                if strands.is_turned && W::IS_WHOLE {
                    self.each_block(task, &split, positions, normals, turned_block::<W>)
                } else {
                    self.each_block(task, &split, positions, normals, quartered_block::<false, W>)
                }
            }
            (Layout::Both, _) | (_, Fold::Open) => {
                let both = Both { strands: cosines, sine_strands: sines, row };
                self.each_block(task, &both, positions, normals, open_block::<W>)
            }
        }
    }

    /// The last column of a folded row: the seam has the same bits, down to the sign of 0.
    fn close(&self, positions: &mut [f32], normals: &mut [f32]) {
        if self.fold != Fold::Open {
            for array in [positions, normals] {
                let last = array.len() - 3;
                array.copy_within(0..3, last);
            }
        }
    }

    /// Every kind of fold and layout is a function of its own: in one large function browsers run out of registers.
    #[inline(never)]
    fn each_block<F, W: Doubt>(
        &mut self,
        task: &Task,
        layout: &F,
        positions: &mut [f32],
        normals: &mut [f32],
        block: impl Fn(&Task, &F, &[[Lanes; 2]], usize, &mut [f32], &mut [f32]) -> [W; 4],
    ) -> bool {
        let n = self.n_harmonics;
        // A copy of its own, which no write through another reference can change.
        let task = *task;
        let mut all = W::SURE;
        // The last columns of a row that is not folded need not be four.
        let n_whole = if self.fold == Fold::Open { self.n_columns / 4 } else { usize::MAX };
        let (mut last_positions, mut last_normals) = ([0.0; 12], [0.0; 12]);
        for (index, unsure) in self.unsure.iter_mut().enumerate() {
            let circles = self.pairs.get(index * n..index * n + n).unwrap_or_default();
            let (positions, normals, column) = if index < n_whole {
                (&mut *positions, &mut *normals, 4 * index)
            } else {
                (last_positions.as_mut_slice(), last_normals.as_mut_slice(), 0)
            };
            let seen = block(&task, layout, circles, column, positions, normals);
            W::keep(seen, unsure);
            all = all.and(seen[0].and(seen[1])).and(seen[2].and(seen[3]));
        }
        if n_whole < self.unsure.len() {
            for (array, last) in [(positions, last_positions), (normals, last_normals)] {
                for (to, value) in array.iter_mut().skip(12 * n_whole).zip(last) {
                    *to = value;
                }
            }
        }
        all.is_sure()
    }

    /// Adds the columns of the lanes that were found unsure. Some columns are in two blocks.
    #[inline(never)]
    fn mark(&self, unsure: &mut Vec<usize>) {
        let n_steps = self.n_columns - 1;
        for (block, slots) in self.unsure.iter().enumerate().filter(|(_, slots)| **slots != [0; 4]) {
            let [at, half] = [4 * block, n_steps / 2];
            // From where to which side the lanes of each slot go: of a row that is not folded only the first has any.
            let back = |from: usize| (from.wrapping_sub(at), true);
            let slots = slots.iter().zip([(at, false), back(n_steps), (at + half, false), back(half)]);
            for (lanes, (first, is_back)) in slots {
                let mut lanes = *lanes;
                while lanes != 0 {
                    let lane = lanes.trailing_zeros() as usize;
                    lanes &= lanes - 1;
                    let column = if is_back { first.wrapping_sub(lane) } else { first + lane };
                    if column < self.n_columns {
                        unsure.push(column);
                    }
                }
            }
        }
    }
}
