//! Lines along which the derivatives of a face jump: the knots of a thickness that had to be interpolated.

use core::f64::consts::TAU;

use super::face::{Face, FaceJet};
use super::sheet::Sheet;
use super::skin::Columns;

/// The lines along which the derivatives of a face jump, in coordinates `(s, v)` in which they are straight: `s` between two of [`Seams::along`] and `v` between two of
/// [`Seams::round`] the face is as smooth as the surface of the design.
///
/// A trimmed side of a wall has the coordinates of the whole, and begins at [`Seams::begins`]; every other face has its own, `s = a`.
#[derive(Debug)]
pub struct Seams<'a> {
    form: Form<'a>,
    along: Vec<f64>,
    round: Vec<f64>,
    crossings: Vec<f64>,
}

enum Form<'a> {
    Sheet { sheet: &'a Sheet, is_back: bool },
    Lines(&'a dyn Face),
}

impl core::fmt::Debug for Form<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter) -> core::fmt::Result {
        f.write_str(match self {
            Form::Sheet { .. } => "Sheet",
            Form::Lines(_) => "Lines",
        })
    }
}

/// Values of `v` with what the jets there have in common.
pub(crate) struct Places {
    places: Vec<f64>,
    columns: Option<Columns>,
}

impl<'a> Seams<'a> {
    pub(super) fn of_sheet(sheet: &'a Sheet, is_back: bool) -> Option<Seams<'a>> {
        let (along, round) = sheet.knots()?;
        Some(Seams { form: Form::Sheet { sheet, is_back }, along, round, crossings: sheet.crossings().to_vec() })
    }

    /// Of a face along which nothing jumps, cut into so many pieces that a short rule is good on each.
    pub(crate) fn across(face: &'a dyn Face, pieces: usize, round: Vec<f64>) -> Seams<'a> {
        let along = (0..=pieces).map(|i| i as f64 / pieces as f64).collect();
        Seams { form: Form::Lines(face), along, round: ascending(round), crossings: Vec::new() }
    }

    /// Values of `s` from 0 to 1.
    pub(crate) fn along(&self) -> &[f64] {
        &self.along
    }

    /// Values of `v` in [0, 2 pi), in ascending order.
    pub(crate) fn round(&self) -> &[f64] {
        &self.round
    }

    /// Values of `v` where the beginning of a trimmed face crosses a line of [`Self::along`].
    pub(crate) fn crossings(&self) -> &[f64] {
        &self.crossings
    }

    /// The least `s` of a column.
    pub(crate) fn begins(&self, v: f64) -> f64 {
        self.straight(0.0, v).min(self.straight(1.0, v))
    }

    /// Where `a` of the face is.
    pub(crate) fn straight(&self, a: f64, v: f64) -> f64 {
        match self.form {
            Form::Sheet { sheet, is_back } => {
                let (start, share) = (sheet.start(v).s, if is_back { 1.0 - a } else { a });
                if share == 1.0 { 1.0 } else { start + share * (1.0 - start) }
            }
            Form::Lines(_) => a,
        }
    }

    /// Columns at which jets are asked for.
    pub(crate) fn places(&self, places: Vec<f64>) -> Places {
        let columns = match self.form {
            Form::Sheet { sheet, .. } => Some(sheet.skin().columns_at(places.clone())),
            Form::Lines(_) => None,
        };
        Places { places, columns }
    }

    /// Position and derivatives with respect to `s` and `v`; that by `s` is turned, so that the two span the face in the sense of its own coordinates.
    pub(crate) fn jet(&self, s: f64, v: f64) -> FaceJet {
        match self.form {
            Form::Sheet { sheet, is_back } => turned(sheet.jet(s, v), is_back),
            Form::Lines(face) => face.jet(s, v),
        }
    }

    /// The same at one of several columns.
    pub(crate) fn jet_at(&self, s: f64, places: &Places, column: usize) -> FaceJet {
        match (&self.form, &places.columns) {
            (Form::Sheet { sheet, is_back }, Some(columns)) => turned(sheet.jet_at(s, columns, column), *is_back),
            _ => self.jet(s, places.places.get(column).copied().unwrap_or(0.0)),
        }
    }
}

fn turned(jet: super::sheet::SheetJet, is_back: bool) -> FaceJet {
    FaceJet { position: jet.position, da: if is_back { -jet.ds } else { jet.ds }, dv: jet.dv }
}

/// Ascending values of `v` within one turn, without those that follow within rounding.
pub(crate) fn ascending(mut places: Vec<f64>) -> Vec<f64> {
    const APART: f64 = 1e-9;
    places.iter_mut().for_each(|v| *v -= TAU * libm::floor(*v / TAU));
    places.sort_by(f64::total_cmp);
    places.dedup_by(|next, kept| *next - *kept < APART);
    places
}
