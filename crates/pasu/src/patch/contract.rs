//! What is asked of a patch.

use glam::DVec3;

use super::breaks::Breaks;
use super::cell::{Cell, Suprema};
use super::columns::{Columns, Spread};
use super::jet::SurfaceJet;
use super::row::Row;
use super::side::Side;

/// What is shown of a cell: the numbers of its row and column, its deviation and, where they are known by then, its suprema.
#[cfg(feature = "patchwork")]
pub(crate) type ShowCell<'a> = dyn FnMut([usize; 2], f64, Option<Suprema>) + 'a;

/// One piece `X(u, v)` over the unit square, before placement: smooth inside but for the knots that it names, creases on its sides.
///
/// Whatever is a patch can be meshed within a tolerance, measured and written as STEP: nothing above this room knows what a patch is made of.
pub(crate) trait Patch: core::fmt::Debug + Send + Sync {
    /// Value, first and second derivatives, to rounding.
    fn jet(&self, u: f64, v: f64) -> SurfaceJet;

    /// The value alone, to the bit that of the jet.
    fn position(&self, u: f64, v: f64) -> DVec3 {
        self.jet(u, v).position
    }

    /// The curve of one `u`, which shares what depends on `u` alone.
    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        Box::new(Pointwise { patch: self, u })
    }

    /// The same of what is smooth between two knots of constant `u`, creases or ends: at the second of them the side of smaller `u`, and where the patch has a closed form, its continuation beyond both.
    fn row_along(&self, u: f64, [low, high]: [f64; 2]) -> Box<dyn Row + '_> {
        self.row(u.min(high.next_down()).max(low))
    }

    /// Values of `v` for any number of rows, with what the jets there have in common.
    fn columns(&self, spread: Spread) -> Columns {
        Columns::plain(spread)
    }

    /// Suprema of `|X|`, `|X_uu|`, `|X_uv|`, `|X_vv|` on a cell, with the axes stretched by these factors.
    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema;

    /// Whether the suprema of a cell are the same whatever its `v`: then one cell tells of all in its row.
    fn is_alike_round(&self) -> bool {
        false
    }

    /// How far `X` and the two triangles of a cell are apart at most, either way, by the suprema of the cell, for a patch whose rows have them in common.
    fn deviation_by(&self, cell: Cell, suprema: &Suprema) -> f64 {
        suprema.deviation(cell.lengths())
    }

    /// The same, with the axes stretched.
    fn deviation(&self, cell: Cell, stretch: [f64; 3]) -> f64 {
        self.deviation_by(cell, &self.suprema(cell, stretch))
    }

    /// Of how many terms a place of it is the sum: many take longer than a place of a pot does.
    fn n_terms(&self) -> usize {
        1
    }

    /// Suprema and deviation of a cell at once.
    fn enclosed(&self, cell: Cell, stretch: [f64; 3]) -> (Suprema, f64) {
        (self.suprema(cell, stretch), self.deviation(cell, stretch))
    }

    /// Shows every cell between lines of constant `u` and of constant `v` by the numbers of its row and column, how far its triangles are off at most, and its suprema, and tells whether it did: a patch does not of which the cells of a row or column have nothing in common that takes long.
    #[cfg(feature = "patchwork")]
    fn shows_cells(&self, _lines: [&[f64]; 2], _stretch: [f64; 3], _show: &mut ShowCell) -> bool {
        false
    }

    /// What resolves it along `u` and along `v`.
    fn breaks(&self) -> [Breaks; 2];

    /// The sides `u = 0`, `u = 1`, `v = 0`, `v = 1`.
    fn sides(&self) -> [Side; 4];

    /// The limit of the unit normal along `X_u x X_v` from inside, where that product vanishes; `None` where the surface is a curve or a point all over.
    fn normal_limit(&self, u: f64, v: f64) -> Option<DVec3> {
        super::normal_limit::normal_limit(&self.jet(u, v), (u, v), |u, v| self.jet(u, v))
    }
}

/// The row of a patch whose points have nothing in common.
struct Pointwise<'a, P: ?Sized> {
    patch: &'a P,
    u: f64,
}

impl<P: Patch + ?Sized> Row for Pointwise<'_, P> {
    fn length(&self) -> f64 {
        1.0
    }

    fn jet(&self, v: f64) -> SurfaceJet {
        self.patch.jet(self.u, v)
    }
}
