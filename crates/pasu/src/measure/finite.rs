//! That no number of what is measured is without a value or an error.

use super::curvature::{CurvatureRange, Located};
use super::measures::{Body, Overhang, PartMeasures};
use super::quantity::Quantity;
use crate::error::{Code, Error, Result};

/// Refuses a part of which something is so large, or so small beside something else, that it has no finite value or error.
///
/// # Errors
/// `overflow`, which says what cannot be measured.
pub(super) fn refuse_infinite(part: &PartMeasures) -> Result<()> {
    match infinite(part) {
        None => Ok(()),
        Some(what) => {
            let message = format!(
                "the {what} leaves the range of numbers: expected a surface whose lengths are more alike in size"
            );
            Err(Error::new(Code::Overflow, format!("parts[{}]", part.part), message))
        }
    }
}

/// What of a part is not finite.
fn infinite(part: &PartMeasures) -> Option<&'static str> {
    let body = &part.body;
    let overhangs = [part.overhang, part.overhang_inside];
    let curvatures = [part.curvature.mean, part.curvature.gaussian];
    let told = [
        ("height", is_finite(&body.height) && body.bottom.is_finite() && body.top.is_finite()),
        ("width", is_finite(&body.width.least) && is_finite(&body.width.greatest)),
        ("area", is_finite(&body.area)),
        ("clay", body.clay.is_none_or(|clay| [clay.area, clay.volume, clay.mass].iter().all(is_finite))),
        ("water", is_water_finite(body)),
        ("footprint", body.footprint.as_ref().is_none_or(|foot| is_finite(&foot.area) && is_finite(&foot.hull_area))),
        (
            "tipping angle",
            [body.tipping.empty, body.tipping.full]
                .iter()
                .flatten()
                .all(|tip| tip.degrees.is_finite() && tip.error.is_finite()),
        ),
        (
            "overhang",
            overhangs.iter().flatten().all(|Overhang { degrees, error, .. }| degrees.is_finite() && error.is_finite()),
        ),
        ("curvature", curvatures.iter().all(is_range_finite)),
    ];
    told.into_iter().find(|(_, is_finite)| !is_finite).map(|(what, _)| what)
}

fn is_finite(quantity: &Quantity) -> bool {
    quantity.value.is_finite() && quantity.error.is_finite()
}

fn is_water_finite(body: &Body) -> bool {
    body.capacity.is_none_or(|capacity| {
        let fill = capacity.fill.is_none_or(|fill| fill.level.is_finite() && is_finite(&fill.volume));
        is_finite(&capacity.brim) && is_finite(&capacity.spill.level) && capacity.floor.is_finite() && fill
    })
}

fn is_range_finite(range: &CurvatureRange) -> bool {
    let is_finite = |Located { value, error, .. }: &Located| value.is_finite() && error.is_finite();
    [range.least, range.greatest].iter().flatten().all(is_finite)
}
