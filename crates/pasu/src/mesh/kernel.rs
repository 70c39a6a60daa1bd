//! One row of a mesh in single precision.
//!
//! A vertex is a sum of products of a row's coefficients with a column's cosines and sines. Where every `n` is whole, columns `v` and `-v` have the same sums but for the
//! sign of the sines, and columns half a turn apart but for the sign of the odd `n`: up to four columns are had from one set of sums.

use core::ops::Range;

use super::coefficients::{Coefficients, LEAST_SQUARE, Layout, Strand};
use super::lanes::{Lanes, write, write_reversed};
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
    /// For the columns of each block and those that share their sums, the lanes whose normals single precision does not hold.
    unsure: Vec<[u8; 4]>,
    /// How many more rows are to be asked normal by normal.
    n_wary: u32,
}

/// Position, `X_u` and `X_v` at four columns, component by component.
type Sums = [[Lanes; 3]; 3];

impl Circles {
    /// Makes the tables for a number of columns.
    pub(super) fn prepare(&mut self, coefficients: &Coefficients, is_closed: bool, turns: &Turns, n_columns: usize) {
        let n_steps = n_columns - 1;
        let fold = if folds(is_closed, n_columns) { Fold::Quartered } else { Fold::Open };
        let n_formed = match fold {
            Fold::Open => n_columns,
            Fold::Quartered => n_steps / 4 + 1,
        };
        let n_blocks = n_formed.div_ceil(4);
        self.n_harmonics = coefficients.harmonics.len();
        self.n_columns = n_columns;
        self.fold = fold;
        self.n_wary = 0;
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

    /// Writes positions and unit normals of one of the four rows, normals times `sign`; marks every column whose normal single precision does not hold and says whether there are any.
    #[inline(never)]
    pub(super) fn row(
        &mut self,
        coefficients: &Coefficients,
        row: usize,
        sign: f32,
        positions: &mut [f32],
        normals: &mut [f32],
        unsure: &mut [bool],
    ) -> bool {
        let (n_even, row) = (coefficients.n_even, row & 3);
        let at = |lanes: Lanes| Lanes::splat(lanes.to_array()[row]);
        let task = Task {
            constant: coefficients.constant.map(|pair| pair.map(at)),
            tilt: coefficients.tilt.map(at),
            steepest: at(coefficients.steepest),
            sign: Lanes::splat(sign),
            n_even,
            n_steps: self.n_columns - 1,
        };
        // A row of which all normals are plainly sure need not ask it of each. Where one is not, rows near it are the same.
        if self.n_wary == 0 {
            if self.columns::<WholeRow>(coefficients, row, &task, positions, normals) {
                self.close(positions, normals);
                return false;
            }
            self.n_wary = WARY_ROWS;
        }
        self.n_wary = self.n_wary.saturating_sub(1);
        let is_sure = self.columns::<EachNormal>(coefficients, row, &task, positions, normals);
        if !is_sure {
            self.mark(unsure);
        }
        self.close(positions, normals);
        !is_sure
    }

    /// Writes all columns of a row but the last of one that is folded, and says whether all normals are sure.
    fn columns<W: Watch>(
        &mut self,
        coefficients: &Coefficients,
        row: usize,
        task: &Task,
        positions: &mut [f32],
        normals: &mut [f32],
    ) -> bool {
        let strands = coefficients.strands.as_slice();
        match (coefficients.layout, self.fold) {
            (Layout::Split { z_is_sine: true }, Fold::Quartered) => {
                let layout = Split::<true> { strands, row };
                self.each_block(task, &layout, positions, normals, quartered_block::<_, W>)
            }
            (Layout::Split { z_is_sine: false }, Fold::Quartered) => {
                let layout = Split::<false> { strands, row };
                if coefficients.is_turned && W::IS_WHOLE {
                    self.each_block(task, &layout, positions, normals, turned_block::<_, W>)
                } else {
                    self.each_block(task, &layout, positions, normals, quartered_block::<_, W>)
                }
            }
            (_, fold) => {
                let layout = Both { strands, sine_strands: coefficients.sine_strands.as_slice(), row };
                match fold {
                    Fold::Quartered => self.each_block(task, &layout, positions, normals, quartered_block::<_, W>),
                    Fold::Open => self.each_block(task, &layout, positions, normals, open_block::<_, W>),
                }
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
    fn each_block<F: Form, W: Watch>(
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

    /// Marks the columns of the lanes that were found unsure.
    fn mark(&self, unsure: &mut [bool]) {
        let n_steps = self.n_columns - 1;
        for (block, slots) in self.unsure.iter().enumerate() {
            for (slot, lanes) in slots.iter().enumerate() {
                for lane in (0..4).filter(|lane| lanes >> lane & 1 == 1) {
                    let column = 4 * block + lane;
                    let column = match (self.fold, slot) {
                        (Fold::Quartered, 2) => column + n_steps / 2,
                        (Fold::Quartered, 1) => n_steps - column,
                        (Fold::Quartered, 3) => n_steps / 2 - column,
                        _ => column,
                    };
                    if let Some(unsure) = unsure.get_mut(column) {
                        *unsure = true;
                    }
                }
            }
        }
    }
}

/// How the sums of some of the harmonics are formed.
///
/// Every implementation is inlined into its loop over the columns, or the sums would go through memory.
trait Form {
    /// What the sums at `v` and at `-v` are had from.
    type Formed: Copy;
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> Self::Formed;
    fn added(a: Self::Formed, b: Self::Formed) -> Self::Formed;
    fn subtracted(a: Self::Formed, b: Self::Formed) -> Self::Formed;
    /// The sums at `v`.
    fn here(&self, formed: Self::Formed) -> Sums;
    /// What is at `v` and at `-v`.
    fn pair<W: Watch>(&self, task: &Task, formed: Self::Formed) -> [Place<W>; 2];
}

/// How it is known which normals single precision does not hold.
trait Watch: Copy {
    /// All normals are sure.
    const SURE: Self;
    /// Whether rows are asked as a whole, as most are: only these have loops for every kind of row.
    const IS_WHOLE: bool;
    /// What is seen of four normals, given `X_u`, `X_v` and the squared length of their product.
    fn look(task: &Task, du: [Lanes; 3], dv: [Lanes; 3], squared: Lanes) -> Self;
    fn and(self, other: Self) -> Self;
    fn is_sure(self) -> bool;
    /// Notes the lanes of a block that are unsure.
    fn keep(seen: [Self; 4], unsure: &mut [u8; 4]);
}

/// The lanes whose normals are unsure, as bits.
#[derive(Clone, Copy)]
struct EachNormal(u8);

impl Watch for EachNormal {
    const SURE: Self = EachNormal(0);
    const IS_WHOLE: bool = false;

    #[inline(always)]
    fn look(task: &Task, [ux, uy, uz]: [Lanes; 3], [vx, vy, vz]: [Lanes; 3], squared: Lanes) -> Self {
        let tilted = task.tilt[0] * (vx * vx + vy * vy + vz * vz) + task.tilt[1] * (ux * ux + uy * uy + uz * uz);
        // Not the other way round: what is not a number is unsure too.
        EachNormal(!((tilted + LEAST_SQUARE).simd_lt(squared).to_bitmask() as u8) & 15)
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        EachNormal(self.0 | other.0)
    }

    #[inline(always)]
    fn is_sure(self) -> bool {
        self.0 == 0
    }

    #[inline(always)]
    fn keep(seen: [Self; 4], unsure: &mut [u8; 4]) {
        *unsure = seen.map(|each| each.0);
    }
}

/// Lanes all of whose bits are set where no normal so far is so short that any could be unsure.
#[derive(Clone, Copy)]
struct WholeRow(Lanes);

impl Watch for WholeRow {
    const SURE: Self = WholeRow(ALL_BITS);
    const IS_WHOLE: bool = true;

    #[inline(always)]
    fn look(task: &Task, _du: [Lanes; 3], _dv: [Lanes; 3], squared: Lanes) -> Self {
        WholeRow(task.steepest.simd_lt(squared))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        WholeRow(self.0 & other.0)
    }

    #[inline(always)]
    fn is_sure(self) -> bool {
        self.0.to_bitmask() & 15 == 15
    }

    #[inline(always)]
    fn keep(_seen: [Self; 4], _unsure: &mut [u8; 4]) {}
}

const ALL_BITS: Lanes = Lanes::new([f32::from_bits(u32::MAX); 4]);

/// How many rows are asked normal by normal after one in which it mattered.
const WARY_ROWS: u32 = 16;

/// Positions and unit normals at four columns, and what was seen of these.
#[derive(Clone, Copy)]
struct Place<W> {
    position: [Lanes; 3],
    normal: [Lanes; 3],
    seen: W,
}

/// As [`Layout::Split`].
struct Split<'a, const Z_IS_SINE: bool> {
    strands: &'a [[Strand; 3]],
    row: usize,
}

impl<const Z_IS_SINE: bool> Form for Split<'_, Z_IS_SINE> {
    type Formed = Sums;

    #[inline(always)]
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> Sums {
        let strands = self.strands.get(harmonics.clone()).unwrap_or_default();
        split_sums::<Z_IS_SINE>(strands, circles.get(harmonics).unwrap_or_default(), self.row)
    }

    #[inline(always)]
    fn added(a: Sums, b: Sums) -> Sums {
        added(&a, &b)
    }

    #[inline(always)]
    fn subtracted(a: Sums, b: Sums) -> Sums {
        subtracted(&a, &b)
    }

    #[inline(always)]
    fn here(&self, formed: Sums) -> Sums {
        formed
    }

    /// At `-v` the sums of sines have the other sign, and half of what the two normals are made of is shared:
    /// with `z` of cosines all of it, with `z` of sines what `z_u` is not in.
    #[inline(always)]
    fn pair<W: Watch>(&self, task: &Task, sums: Sums) -> [Place<W>; 2] {
        let [[x, y, z], [xu, yu, zu], [xv, yv, zv]] = sums;
        let [[x0, xu0], [y0, _], [z0, zu0]] = task.constant;
        let (px, here_z) = (x0 + x, z0 + z);
        let here = [px, y0 + y, here_z];
        if !Z_IS_SINE {
            let (normal, seen) = task.normal(&sums);
            let there = Place { position: [px, y0 - y, here_z], normal: [normal[0], -normal[1], normal[2]], seen };
            return [Place { position: here, normal, seen }, there];
        }
        // X_u = (ux, uy, zu0 + zu), X_v = (xv, yv, zv) at v, (ux, -uy, zu0 - zu) and (-xv, yv, zv) at -v.
        let (ux, uy) = (xu0 + xu, yu);
        let (uz, other_uz) = (zu0 + zu, zu0 - zu);
        let (p, q) = (uy * zv, ux * zv);
        let nz = ux * yv - uy * xv;
        let nz_squared = nz * nz;
        let finished = |nx: Lanes, ny: Lanes, uz: Lanes| {
            let squared = nx * nx + ny * ny + nz_squared;
            (task.sign / squared.sqrt(), W::look(task, [ux, uy, uz], [xv, yv, zv], squared))
        };
        let (nx, ny) = (p - uz * yv, uz * xv - q);
        let (inverse, seen) = finished(nx, ny, uz);
        // The other way round than at v.
        let (other_nx, other_ny) = (p + other_uz * yv, other_uz * xv + q);
        let (other_inverse, other_seen) = finished(other_nx, other_ny, other_uz);
        let turned = -other_inverse;
        [
            Place { position: here, normal: [nx * inverse, ny * inverse, nz * inverse], seen },
            Place {
                position: [px, y0 - y, z0 - z],
                normal: [other_nx * turned, other_ny * turned, nz * other_inverse],
                seen: other_seen,
            },
        ]
    }
}

/// As [`Layout::Both`].
struct Both<'a> {
    strands: &'a [[Strand; 3]],
    sine_strands: &'a [[Strand; 3]],
    row: usize,
}

impl Form for Both<'_> {
    /// The sums of the cosine strands and those of the sine strands.
    type Formed = [Sums; 2];

    #[inline(always)]
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> [Sums; 2] {
        let circles = circles.get(harmonics.clone()).unwrap_or_default();
        let even = sums::<false>(self.strands.get(harmonics.clone()).unwrap_or_default(), circles, self.row);
        let odd = sums::<true>(self.sine_strands.get(harmonics).unwrap_or_default(), circles, self.row);
        [even, odd]
    }

    #[inline(always)]
    fn added(a: [Sums; 2], b: [Sums; 2]) -> [Sums; 2] {
        [added(&a[0], &b[0]), added(&a[1], &b[1])]
    }

    #[inline(always)]
    fn subtracted(a: [Sums; 2], b: [Sums; 2]) -> [Sums; 2] {
        [subtracted(&a[0], &b[0]), subtracted(&a[1], &b[1])]
    }

    #[inline(always)]
    fn here(&self, [even, odd]: [Sums; 2]) -> Sums {
        added(&even, &odd)
    }

    #[inline(always)]
    fn pair<W: Watch>(&self, task: &Task, [even, odd]: [Sums; 2]) -> [Place<W>; 2] {
        let mirrored = [minus(even[0], odd[0]), minus(even[1], odd[1]), minus(odd[2], even[2])];
        [task.place(&added(&even, &odd)), task.place(&mirrored)]
    }
}

/// What all blocks of a row share.
#[derive(Clone, Copy)]
struct Task {
    constant: [[Lanes; 2]; 3],
    tilt: [Lanes; 2],
    steepest: Lanes,
    sign: Lanes,
    n_even: usize,
    n_steps: usize,
}

impl Task {
    #[inline(always)]
    fn position(&self, sums: &Sums) -> [Lanes; 3] {
        let [[x, _], [y, _], [z, _]] = self.constant;
        plus([x, y, z], sums[0])
    }

    #[inline(always)]
    fn place<W: Watch>(&self, sums: &Sums) -> Place<W> {
        let (normal, seen) = self.normal(sums);
        Place { position: self.position(sums), normal, seen }
    }

    /// A position half a turn on, where what goes round the axis has the other sign.
    #[inline(always)]
    fn turned_position(&self, [x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
        let [[x0, _], [y0, _], _] = self.constant;
        [x0 + x0 - x, y0 + y0 - y, z]
    }

    /// The unit normal along `X_u x X_v`.
    #[inline(always)]
    fn normal<W: Watch>(&self, sums: &Sums) -> ([Lanes; 3], W) {
        let [[_, xu], [_, yu], [_, zu]] = self.constant;
        let [ux, uy, uz] = plus([xu, yu, zu], sums[1]);
        let [vx, vy, vz] = sums[2];
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let inverse = self.sign / squared.sqrt();
        (normal.map(|component| component * inverse), W::look(self, [ux, uy, uz], [vx, vy, vz], squared))
    }
}

/// The columns from `column` on, and no others.
#[inline(always)]
fn open_block<F: Form, W: Watch>(
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
fn quartered_block<F: Form, W: Watch>(
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
fn turned_block<F: Form, W: Watch>(
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

#[inline(always)]
fn added(a: &Sums, b: &Sums) -> Sums {
    [plus(a[0], b[0]), plus(a[1], b[1]), plus(a[2], b[2])]
}

#[inline(always)]
fn subtracted(a: &Sums, b: &Sums) -> Sums {
    [minus(a[0], b[0]), minus(a[1], b[1]), minus(a[2], b[2])]
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
fn split_sums<const Z_IS_SINE: bool>(strands: &[[Strand; 3]], circles: &[[Lanes; 2]], row: usize) -> Sums {
    let (first, second) = (usize::from(Z_IS_SINE), usize::from(!Z_IS_SINE));
    let products = |(strand, circle): (&[Strand; 3], &[Lanes; 2])| {
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row & 3]);
        let [cos, sin] = *circle;
        (
            (cos * at(0, 0), cos * at(0, 1), sin * at(0, 2)),
            (sin * at(1, 0), sin * at(1, 1), cos * at(1, 2)),
            (circle[first] * at(2, 0), circle[first] * at(2, 1), circle[second] * at(2, 2)),
        )
    };
    // The first products are where the sums start: nothing is added to 0.
    let mut pairs = strands.iter().zip(circles);
    let Some(pair) = pairs.next() else { return [[Lanes::ZERO; 3]; 3] };
    let ((mut x, mut xu, mut xv), (mut y, mut yu, mut yv), (mut z, mut zu, mut zv)) = products(pair);
    for pair in pairs {
        let ((dx, dxu, dxv), (dy, dyu, dyv), (dz, dzu, dzv)) = products(pair);
        x += dx;
        xu += dxu;
        xv += dxv;
        y += dy;
        yu += dyu;
        yv += dyv;
        z += dz;
        zu += dzu;
        zv += dzv;
    }
    [[x, y, z], [xu, yu, zu], [xv, yv, zv]]
}
