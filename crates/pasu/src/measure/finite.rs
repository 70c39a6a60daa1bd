//! That no number of what is measured is without a value or an error.

use super::curvature::{CurvatureRange, Located};
use super::measures::{Body, Overhang, PartMeasures};
use super::quantity::Quantity;
use super::standing::Tipping;
use crate::error::{Code, Error, Result};

/// Refuses a body of which something is so large, or so small beside something else, that it has no finite value or error; `path` is where it is in the design.
///
/// # Errors
/// `overflow`, which says what cannot be measured.
pub(super) fn refuse_infinite(body: &Body, path: &str) -> Result<()> {
    let is_tip_finite = |tip: &Tipping| tip.degrees.is_finite() && tip.error.is_finite();
    refuse(
        path,
        [
            ("height", is_finite(&body.height) && body.bottom.is_finite() && body.top.is_finite()),
            ("width", is_finite(&body.width.least) && is_finite(&body.width.greatest)),
            ("area", is_finite(&body.area)),
            ("clay", body.clay.is_none_or(|clay| [clay.area, clay.volume, clay.mass].iter().all(is_finite))),
            ("water", is_water_finite(body)),
            (
                "footprint",
                body.footprint.as_ref().is_none_or(|foot| is_finite(&foot.area) && is_finite(&foot.hull_area)),
            ),
            ("tipping angle", [body.tipping.empty, body.tipping.full].iter().flatten().all(is_tip_finite)),
        ],
    )
}

/// As [`refuse_infinite`], of a part and all that is measured of it alone.
///
/// # Errors
/// As [`refuse_infinite`].
pub(super) fn refuse_infinite_part(part: &PartMeasures) -> Result<()> {
    let path = format!("parts[{}]", part.part);
    refuse_infinite(&part.body, &path)?;
    let is_steep = |Overhang { degrees, error, .. }: &Overhang| degrees.is_finite() && error.is_finite();
    let curvatures = [part.curvature.mean, part.curvature.gaussian];
    refuse(
        &path,
        [
            ("overhang", [part.overhang, part.overhang_inside].iter().flatten().all(is_steep)),
            ("curvature", curvatures.iter().all(is_range_finite)),
        ],
    )
}

/// Refuses the first of some quantities that is not finite.
fn refuse<const N: usize>(path: &str, told: [(&str, bool); N]) -> Result<()> {
    match told.into_iter().find(|(_, is_finite)| !is_finite) {
        None => Ok(()),
        Some((what, _)) => {
            let message = format!(
                "the {what} leaves the range of numbers: expected a surface whose lengths are more alike in size"
            );
            Err(Error::new(Code::Overflow, path, message))
        }
    }
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
